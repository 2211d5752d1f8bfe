// The checkpoints of a run folder: writes them in turn, keeps the last two, finds the newest that is whole.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "coupling/stages/checkpoint.h"
#include "io/checkpoint/checkpoint_file.h"
#include "io/results/results_sink.h"
#include "io/results/run_folder.h"

namespace scree::io {

/// checkpoint.<n>.scree in a run folder, oldest first.
[[nodiscard]] std::vector<std::filesystem::path> checkpoint_files(const RunFolder& folder);

struct FoundCheckpoint {
  StoredCheckpoint stored;
  std::filesystem::path path;
};

/// The newest checkpoint that is whole, of this version and of the case that the folder's run.vtkhdf is of (where that
/// can still be read).
/// @param refused  told why newer ones are not taken
/// @throws FileError when there is none
[[nodiscard]] FoundCheckpoint newest_checkpoint(const RunFolder& folder, const std::string& version,
                                                const std::function<void(const std::string&)>& refused);

/// Nobody else writes in a run folder while this lives.
class FolderLock {
 public:
  /// @throws FileError when another program holds it
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int fd_;
};

/// Writes a checkpoint after so many seconds or steps. Results so far are brought to the disk before.
/// @throws FileError from keep(): the checkpoints that there were stay
class Checkpoints final : public coupling::Keeper {
 public:
  struct Every {
    double seconds = 60.0;   // of wall time; 0: not by the clock
    std::int64_t steps = 0;  // 0: not by steps
  };
  /// @param results  of the same run, outlives this   @param from  where the run goes on, stays until two newer ones
  ///                 are there; null: it begins
  Checkpoints(RunFolder folder, RunRecord run, ResultsSink& results, Every every,
              const FoundCheckpoint* from = nullptr);

  bool due(std::int64_t step) override;
  void keep(const coupling::Checkpoint& checkpoint) override;
  /// The last one written; empty: none yet.
  [[nodiscard]] const std::filesystem::path& last() const { return last_; }

 private:
  using Clock = std::chrono::steady_clock;
  RunFolder folder_;
  RunRecord run_;
  ResultsSink* results_;
  Every every_;
  std::filesystem::path last_;
  std::int64_t number_ = 0;                                // of the next one
  std::int64_t step_ = 0;                                  // of the last one
  std::pair<std::int64_t, std::int32_t> written_{-1, -1};  // step and stage of the last one of this program
  Clock::time_point time_ = Clock::now();
};

}  // namespace scree::io
