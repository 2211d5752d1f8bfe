#include "io/results/atomic_file.h"

#include <fcntl.h>
#include <sys/sendfile.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include "io/results/file_error.h"

namespace scree::io {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw FileError(path, what + ": " + std::strerror(errno));
}

/// Writes the entries of the folder to the disk; false: failed.
bool folder_is_kept(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool kept = ::fsync(descriptor) == 0;
  ::close(descriptor);
  return kept;
}

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)), temporary_(path_.string() + ".tmp") {
  descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path_, "cannot make the file");
}

AtomicFile::~AtomicFile() {
  ::close(descriptor_);
  if (!in_place_) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = ::write(descriptor_, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path_, "cannot write");
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

void AtomicFile::copy(const AtomicFile& from, std::int64_t bytes) {
  off_t at = 0;
  while (at < bytes) {
    const ssize_t n = ::sendfile(descriptor_, from.descriptor_, &at, static_cast<std::size_t>(bytes - at));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path_, "cannot write");
    if (n == 0) throw FileError(path_, "was made shorter by another program");
  }
}

void AtomicFile::commit() {
  if (::fsync(descriptor_) != 0) fail(path_, "cannot write");
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, "cannot put the new file in place");
  in_place_ = true;
  if (!folder_is_kept(path_)) fail(path_, "cannot put the new file in place");
}

void write_atomically(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace scree::io
