#include "io/results/run_folder.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/results/regular_file.h"

namespace scree::io {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 6> kNames{"run.vtkhdf", "run.xmf",      "history.csv",
                                                 "energy.csv", "summary.json", "run.log"};
constexpr std::string_view kCheckpoint = "checkpoint";  // beginning of the names of checkpoints
// run.vtkhdf while it is written anew, and the log that restores it as of the last checkpoint (UndoLog).
constexpr std::array<std::string_view, 3> kBeside{"run.vtkhdf.new", "run.vtkhdf.undo", "run.vtkhdf.undo.tmp"};
constexpr std::string_view kDamaged = ".damaged";  // in names of files that were put aside

bool belongs_to_runs(const fs::path& file) {
  const std::string name = file.filename().string();
  for (const std::string_view known : kNames)
    if (name == known) return true;
  if (name.find(kDamaged) != std::string::npos || std::find(kBeside.begin(), kBeside.end(), name) != kBeside.end())
    return true;
  return name.starts_with(kCheckpoint);
}

[[noreturn]] void fail(const fs::path& path, const std::string& what) {
  throw FileError(path, what + ": " + std::strerror(errno));
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

/// Refuses pipes, devices and folders in place of the files, also temporary ones, that a run reads or writes.
void refuse_odd_files(const fs::path& folder) {
  constexpr std::string_view kTemporary = ".tmp";
  std::error_code error;
  for (fs::directory_iterator it(folder, error), last; !error && it != last; it.increment(error)) {
    std::string name = it->path().filename().string();
    if (name.ends_with(kTemporary)) name.resize(name.size() - kTemporary.size());
    if (belongs_to_runs(name)) require_regular(it->path());
  }
}

void clear_earlier_run(const fs::path& folder) {
  for (const fs::path& file : run_files(folder)) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw FileError(file, "cannot remove the file of an earlier run: " + error.message());
  }
}

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
    throw FileError(path,
                    "holds an earlier run; choose another folder (--out), replace that run (--overwrite), or go on "
                    "with it (scree resume)");
  }
  if (::access(path.c_str(), W_OK | X_OK) != 0) fail(path, "cannot write in the run folder");
  refuse_odd_files(path);
  clear_earlier_run(path);
  return RunFolder(path);
}

RunFolder RunFolder::open(const fs::path& path) {
  RunFolder folder(path);
  refuse_odd_files(path);
  std::error_code error;
  if (!fs::is_regular_file(folder.results(), error))
    throw FileError(path, "is not a run folder: there is no run.vtkhdf in it");
  return folder;
}

RunFolder RunFolder::reopen(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) throw FileError(path, "there is no such run folder");
  if (!fs::is_directory(path, error)) throw FileError(path, "is not a folder");
  if (::access(path.c_str(), W_OK | X_OK) != 0) fail(path, "cannot write in the run folder");
  refuse_odd_files(path);
  return RunFolder(path);
}

fs::path RunFolder::set_aside(const fs::path& file) {
  const auto name = [&](int n) {
    return file.parent_path() / (file.stem().string() + std::string(kDamaged) + (n > 1 ? std::to_string(n) : "") +
                                 file.extension().string());
  };
  int n = 1;
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  while (fs::exists(name(n), error)) ++n;
  fs::rename(file, name(n), error);
  if (error) throw FileError(file, "cannot put the damaged file aside: " + error.message());
  return name(n);
}

bool RunFolder::is_run(const fs::path& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return false;
  if (fs::is_regular_file(path / kNames.front(), error)) return true;
  const std::size_t entries =
      static_cast<std::size_t>(std::distance(fs::directory_iterator(path, error), fs::directory_iterator()));
  return entries > 0 && entries == run_files(path).size();
}

}  // namespace scree::io
