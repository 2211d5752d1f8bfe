#include "io/checkpoint/checkpoints.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <system_error>
#include <utility>

#include "io/results/h5_read.h"
#include "io/results/sha256.h"

namespace scree::io {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kBefore = "checkpoint.", kAfter = ".scree", kTemporary = ".tmp";

/// Number of a checkpoint; empty for other files.
std::optional<std::int64_t> number_of(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(kBefore) || !name.ends_with(kAfter)) return std::nullopt;
  const char *begin = name.data() + kBefore.size(), *end = name.data() + name.size() - kAfter.size();
  std::int64_t number = 0;
  const auto [rest, error] = std::from_chars(begin, std::max(begin, end), number);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

/// Hash of the case of the results in a run folder; empty where they cannot be read.
std::string case_of(const RunFolder& folder) {
  try {
    return h5::text_attribute(h5::File::open(folder.results()), "/provenance", "case_sha256");
  } catch (const FileError&) {
    return {};
  }
}

}  // namespace

std::vector<fs::path> checkpoint_files(const RunFolder& folder) {
  std::error_code error;
  std::vector<std::pair<std::int64_t, fs::path>> found;
  for (fs::directory_iterator it(folder.path(), error), last; !error && it != last; it.increment(error))
    if (const auto number = number_of(it->path())) found.emplace_back(*number, it->path());
  if (error) throw FileError(folder.path(), "cannot list the folder: " + error.message());
  std::sort(found.begin(), found.end());
  std::vector<fs::path> files;
  files.reserve(found.size());
  for (auto& [number, file] : found) files.push_back(std::move(file));
  return files;
}

FoundCheckpoint newest_checkpoint(const RunFolder& folder, const std::string& version,
                                  const std::function<void(const std::string&)>& refused) {
  const std::vector<fs::path> files = checkpoint_files(folder);
  const std::string wanted = case_of(folder);
  std::string why = "there is no checkpoint in it: the run was stopped before its first step; start it again";
  for (auto file = files.rbegin(); file != files.rend(); ++file) {
    try {
      StoredCheckpoint stored = read_checkpoint(*file, version);
      if (!wanted.empty() && sha256(stored.run.case_text) != wanted)
        throw FileError(*file, "cannot go on from this checkpoint: it is of another case than run.vtkhdf beside it");
      return {std::move(stored), *file};
    } catch (const FileError& e) {
      refused(e.what());
      why = "no checkpoint in it can be used";
    }
  }
  throw FileError(folder.path(), "cannot resume: " + why);
}

FolderLock::FolderLock(const fs::path& folder) : fd_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  // On a file system without locks nothing is locked.
  if (fd_ >= 0 && ::flock(fd_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(fd_);
    throw FileError(folder, "another run is writing in this folder");
  }
}

FolderLock::~FolderLock() {
  if (fd_ >= 0) ::close(fd_);
}

Checkpoints::Checkpoints(RunFolder folder, RunRecord run, ResultsSink& results, Every every,
                         const FoundCheckpoint* from)
    : folder_(std::move(folder)), run_(std::move(run)), results_(&results), every_(every) {
  if (from != nullptr) {
    last_ = from->path;
    step_ = from->stored.checkpoint.state.step;
  }
  for (const fs::path& file : checkpoint_files(folder_)) number_ = number_of(file).value_or(-1) + 1;
  // Removes temporary files of a run that was killed.
  std::error_code ignored;
  for (fs::directory_iterator it(folder_.path(), ignored), end; !ignored && it != end; it.increment(ignored)) {
    const std::string name = it->path().filename().string();
    if (name.starts_with(kBefore) && name.ends_with(kTemporary)) fs::remove(it->path(), ignored);
  }
}

bool Checkpoints::due(std::int64_t step) {
  return (every_.steps > 0 && step - step_ >= every_.steps) ||
         (every_.seconds > 0.0 && std::chrono::duration<double>(Clock::now() - time_).count() >= every_.seconds);
}

void Checkpoints::keep(const coupling::Checkpoint& checkpoint) {
  const std::pair place{checkpoint.state.step, checkpoint.state.stage};
  if (place == written_) return;  // a run that is stopped before its next step: already written
  step_ = place.first;
  const fs::path path = folder_.path() / (std::string(kBefore) + std::to_string(number_) + std::string(kAfter));
  write_checkpoint(path, run_, results_->mark(), checkpoint);
  ++number_;
  for (const fs::path& file : checkpoint_files(folder_)) {
    std::error_code error;
    if (file != path && file != last_) fs::remove(file, error);
    if (error) throw FileError(file, "cannot remove an old checkpoint: " + error.message());
  }
  last_ = path;
  written_ = place;
  time_ = Clock::now();  // the time of writing does not count
}

}  // namespace scree::io
