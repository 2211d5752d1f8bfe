#include "io/results/run_folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace scree::io {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 6> kNames{"run.vtkhdf", "run.xmf",      "history.csv",
                                                 "energy.csv", "summary.json", "run.log"};
constexpr std::string_view kCheckpoint = "checkpoint";  // all checkpoints begin with it

bool belongs_to_runs(const fs::path& file) {
  const std::string name = file.filename().string();
  for (const std::string_view known : kNames)
    if (name == known) return true;
  return name.starts_with(kCheckpoint);
}

/// Files that runs write, in a folder.
std::vector<fs::path> run_files(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder, error), last; !error && it != last; it.increment(error))
    if (it->is_regular_file(error) && belongs_to_runs(it->path())) found.push_back(it->path());
  if (error) throw FileError(folder, "cannot list the folder: " + error.message());
  return found;
}

void clear_earlier_run(const fs::path& folder) {
  for (const fs::path& file : run_files(folder)) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw FileError(file, "cannot remove the file of an earlier run: " + error.message());
  }
}

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw FileError(path, what + ": " + std::strerror(errno));
}

/// A file descriptor that is closed when left.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_;
};

/// Removes a temporary file unless it was renamed.
struct Temporary {
  fs::path path;
  bool keep = false;
  ~Temporary() {
    if (!keep) ::unlink(path.c_str());
  }
};

}  // namespace

RunFolder RunFolder::create(const fs::path& path, bool overwrite) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    fs::create_directories(path, error);
    if (error) throw FileError(path, "cannot make the run folder: " + error.message());
  } else if (error) {
    throw FileError(path, "cannot look at the run folder: " + error.message());
  } else if (!fs::is_directory(status)) {
    throw FileError(path, "is not a folder; choose another place for the run");
  } else if (const bool empty = fs::is_empty(path, error); error) {
    throw FileError(path, "cannot list the folder: " + error.message());
  } else if (!empty && !is_run(path)) {
    throw FileError(path, "has files in it that are not of a run; choose an empty or a new folder");
  } else if (!empty && !overwrite) {
    throw FileError(path, "holds an earlier run; choose another folder, or allow overwriting");
  }
  if (::access(path.c_str(), W_OK | X_OK) != 0) fail(path, "cannot write in the run folder");
  clear_earlier_run(path);
  return RunFolder(path);
}

RunFolder RunFolder::open(const fs::path& path) {
  RunFolder folder(path);
  std::error_code error;
  if (!fs::is_regular_file(folder.results(), error))
    throw FileError(path, "is not a run folder: there is no run.vtkhdf in it");
  return folder;
}

bool RunFolder::is_run(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return false;
  if (fs::is_regular_file(path / kNames.front(), error)) return true;
  const std::size_t entries =
      static_cast<std::size_t>(std::distance(fs::directory_iterator(path, error), fs::directory_iterator()));
  return entries > 0 && entries == run_files(path).size();
}

void write_atomically(const fs::path& path, std::string_view text) {
  Temporary temporary{path.string() + ".tmp"};
  Descriptor file(temporary.path, O_WRONLY | O_CREAT | O_TRUNC);
  if (file.get() < 0) fail(path, "cannot make the file");
  while (!text.empty()) {
    const ssize_t n = ::write(file.get(), text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(path, "cannot write");
    text.remove_prefix(static_cast<std::size_t>(n));
  }
  if (::fsync(file.get()) != 0) fail(path, "cannot write");
  if (!file.close()) fail(path, "cannot write");
  if (::rename(temporary.path.c_str(), path.c_str()) != 0) fail(path, "cannot put the new file in place");
  temporary.keep = true;
  const Descriptor folder(path.has_parent_path() ? path.parent_path() : fs::path("."), O_RDONLY | O_DIRECTORY);
  if (folder.get() < 0 || ::fsync(folder.get()) != 0) fail(path, "cannot put the new file in place");
}

}  // namespace scree::io
