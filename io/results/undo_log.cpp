#include "io/results/undo_log.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "io/results/atomic_file.h"
#include "io/results/byte_hash.h"

namespace scree::io {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kPage = 4096;
constexpr std::array<char, 8> kMagic{'S', 'C', 'R', 'U', 'N', 'D', 'O', '1'};

/// Head of the log.
struct Head {
  std::array<char, 8> magic = kMagic;
  std::uint64_t length = 0;  // of the file
  std::uint64_t hash = 0;    // of the two above
  [[nodiscard]] std::uint64_t right_hash() const {
    ByteHash h;
    h.add(magic.data(), magic.size());
    h.add(&length, sizeof length);
    return h.value();
  }
};

/// Precedes every stretch of pages.
struct Stretch {
  std::uint64_t at = 0, size = 0;  // in the file
  std::uint64_t hash = 0;          // of the two above and the bytes
  [[nodiscard]] std::uint64_t right_hash(const char* bytes) const {
    ByteHash h;
    h.add(&at, sizeof at);
    h.add(&size, sizeof size);
    h.add(bytes, size);
    return h.value();
  }
};

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw FileError(path, "cannot " + what + ": " + std::strerror(errno));
}

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] int release() { return std::exchange(fd_, -1); }

 private:
  int fd_;
};

/// Reads `size` bytes; false if that fails.
bool read_all(int fd, void* data, std::size_t size, std::uint64_t at) {
  auto* to = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t n = ::pread(fd, to, size, static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      if (n == 0) errno = EIO;  // shorter than stated
      return false;
    }
    to += n;
    at += static_cast<std::uint64_t>(n);
    size -= static_cast<std::size_t>(n);
  }
  return true;
}

bool write_all(int fd, const void* data, std::size_t size) {
  const auto* from = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t n = ::write(fd, from, size);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    from += n;
    size -= static_cast<std::size_t>(n);
  }
  return true;
}

std::uint64_t size_of(int fd, const fs::path& path) {
  struct stat s {};
  if (::fstat(fd, &s) != 0) fail(path, "look at the file");
  return static_cast<std::uint64_t>(s.st_size);
}

}  // namespace

fs::path UndoLog::path_of(const fs::path& file) { return file.string() + ".undo"; }

UndoLog::~UndoLog() {
  if (log_ >= 0) ::close(log_);
}

void UndoLog::start(int descriptor) {
  const fs::path path = path_of(file_);
  Head head;
  head.length = size_of(descriptor, file_);
  head.hash = head.right_hash();
  write_atomically(path, {reinterpret_cast<const char*>(&head), sizeof head});
  Descriptor log(path, O_WRONLY | O_APPEND);
  if (log.get() < 0) fail(path, "open the file");
  if (log_ >= 0) ::close(log_);
  log_ = log.release();
  source_ = descriptor;
  length_ = head.length;
  has_.clear();
}

void UndoLog::save(std::uint64_t at, std::uint64_t size) {
  if (log_ < 0 || at >= length_) return;
  const std::uint64_t last = (std::min(at + size, length_) + kPage - 1) / kPage;
  for (std::uint64_t page = at / kPage, end = page; page < last; page = end) {
    end = page + 1;
    if (has_.contains(page)) continue;
    while (end < last && !has_.contains(end)) ++end;
    Stretch s;
    s.at = page * kPage;
    s.size = std::min(end * kPage, length_) - s.at;
    record_.resize(sizeof s + s.size);
    char* bytes = record_.data() + sizeof s;
    if (!read_all(source_, bytes, s.size, s.at)) fail(file_, "read back what is overwritten");
    s.hash = s.right_hash(bytes);
    std::memcpy(record_.data(), &s, sizeof s);
    if (!write_all(log_, record_.data(), record_.size())) fail(path_of(file_), "write");
    for (std::uint64_t stored = page; stored < end; ++stored) has_.insert(stored);
  }
}

void UndoLog::remove() {
  if (log_ < 0) return;
  ::close(log_);
  log_ = -1;
  std::error_code error;
  fs::remove(path_of(file_), error);
  if (error) throw FileError(path_of(file_), "cannot remove the file: " + error.message());
}

namespace {

/// Calls see(stretch, bytes) for the stretches of a log up to the first one that is not complete: it was just being
/// stored, and the file was not yet overwritten there.   @param length  of the file at start()
template <class See>
void for_stretches(int log, const fs::path& path, std::uint64_t length, See&& see) {
  const std::uint64_t size = size_of(log, path);
  std::vector<char> bytes;
  Stretch s;
  for (std::uint64_t at = sizeof(Head); at + sizeof s <= size; at += sizeof s + s.size) {
    if (!read_all(log, &s, sizeof s, at)) fail(path, "read");
    if (s.size > size - at - sizeof s || s.at > length || s.size > length - s.at) return;
    bytes.resize(s.size);
    if (!read_all(log, bytes.data(), s.size, at + sizeof s)) fail(path, "read");
    if (s.hash != s.right_hash(bytes.data())) return;
    see(s, bytes);
  }
}

/// The head of a log.   @return false: there is none
bool read_head(int log, const fs::path& path, Head& head) {
  return size_of(log, path) >= sizeof head && read_all(log, &head, sizeof head, 0) && head.magic == kMagic &&
         head.hash == head.right_hash();
}

/// True if a log has all that a file now lacks at its end: HDF5 shortens its files at times.
bool has_lost_end(int log, const fs::path& path, std::uint64_t length, std::uint64_t now) {
  if (now >= length) return true;
  std::uint64_t there = 0;  // no page is stored twice
  for_stretches(log, path, length, [&](const Stretch& s, const std::vector<char>&) {
    const std::uint64_t end = s.at + s.size;
    if (end > now) there += end - std::max(s.at, now);
  });
  return there == length - now;
}

}  // namespace

bool UndoLog::roll_back(const fs::path& file) {
  const fs::path path = path_of(file);
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return false;
  {
    const Descriptor log(path, O_RDONLY), target(file, O_RDWR);
    if (log.get() < 0) fail(path, "open the file");
    Head head;
    if (target.get() >= 0 && read_head(log.get(), path, head) &&
        has_lost_end(log.get(), path, head.length, size_of(target.get(), file))) {
      for_stretches(log.get(), path, head.length, [&](const Stretch& s, const std::vector<char>& bytes) {
        if (::lseek(target.get(), static_cast<off_t>(s.at), SEEK_SET) < 0 ||
            !write_all(target.get(), bytes.data(), bytes.size()))
          fail(file, "bring the file back to what it was");
      });
      if (::ftruncate(target.get(), static_cast<off_t>(head.length)) != 0 || ::fsync(target.get()) != 0)
        fail(file, "bring the file back to what it was");
    }
  }
  fs::remove(path, error);
  if (error) throw FileError(path, "cannot remove the file: " + error.message());
  return true;
}

}  // namespace scree::io
