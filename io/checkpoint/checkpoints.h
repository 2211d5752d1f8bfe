// The checkpoints of a run folder: writes them in turn, keeps the last two, finds the newest that is complete.
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

/// The files checkpoint.<n>.scree of a run folder, oldest first.
[[nodiscard]] std::vector<std::filesystem::path> checkpoint_files(const RunFolder& folder);

struct FoundCheckpoint {
  StoredCheckpoint stored;
  std::filesystem::path path;
};

/// The newest checkpoint that is complete, of this version and of the same case as run.vtkhdf in the folder (if that
/// can still be read).
/// @param refused  called with the reason for each newer checkpoint that is not used
/// @throws FileError when there is none
[[nodiscard]] FoundCheckpoint newest_checkpoint(const RunFolder& folder, const std::string& version,
                                                const std::function<void(const std::string&)>& refused);

/// Excludes other programs from writing in a run folder during its lifetime.
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

/// Writes a checkpoint after a given number of seconds or steps. The results so far are written to the disk before it.
/// @throws FileError from keep(): the earlier checkpoints stay
class Checkpoints final : public coupling::Keeper {
 public:
  struct Every {
    double seconds = 60.0;   // of wall time; 0: independent of wall time
    std::int64_t steps = 0;  // 0: independent of steps
  };
  /// @param results  of the same run, outlives this   @param from  checkpoint from which the run is resumed; it stays
  ///                 until two newer ones exist; null: the run starts
  Checkpoints(RunFolder folder, RunRecord run, ResultsSink& results, Every every,
              const FoundCheckpoint* from = nullptr);

  bool due(std::int64_t step) override;
  void keep(const coupling::Checkpoint& checkpoint) override;
  /// The last checkpoint written, or resumed from; empty: none yet.
  [[nodiscard]] const std::filesystem::path& last() const { return last_; }

 private:
  using Clock = std::chrono::steady_clock;
  RunFolder folder_;
  RunRecord run_;
  ResultsSink* results_;
  Every every_;
  std::filesystem::path last_;
  std::int64_t number_ = 0;                                // of the next checkpoint
  std::int64_t step_ = 0;                                  // of the last checkpoint
  std::pair<std::int64_t, std::int32_t> written_{-1, -1};  // step and stage of the last one written by this object
  Clock::time_point time_ = Clock::now();
};

}  // namespace scree::io
