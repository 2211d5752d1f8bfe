// The folder of a run: its file names, and the rules for making it.
#pragma once

#include <filesystem>

#include "io/results/file_error.h"

namespace scree::io {

/// Names inside a run folder.
///   run.vtkhdf    frames, histories, ledger, events, provenance     run.xmf   the frames for ParaView
///   history.csv   monitors    energy.csv   ledger    summary.json   final values of the run    run.log   messages
///   checkpoint.<n>.scree   the last two checkpoints (io/checkpoint)
///   run.vtkhdf.undo        while the run goes on, or after it was killed: restores run.vtkhdf as of the last
///                          checkpoint (undo_log.h)
class RunFolder {
 public:
  /// Makes the folder and its parents. An empty folder is used as it is; an earlier run is cleared of the files that
  /// runs write (other files in it stay) if `overwrite`; a folder that is neither is never changed.
  /// @throws FileError when refused or impossible; nothing has been made or removed then, except missing parents that
  ///         could be made before the failure, and files of the earlier run that could be removed before it
  [[nodiscard]] static RunFolder create(const std::filesystem::path& path, bool overwrite);
  /// An earlier run, for reading.   @throws FileError if there is no run.vtkhdf in it
  [[nodiscard]] static RunFolder open(const std::filesystem::path& path);
  /// True for a folder that contains run.vtkhdf, or only files that runs write (a run that ended before it had
  /// results).
  [[nodiscard]] static bool is_run(const std::filesystem::path& path);

  /// An earlier run that is to be continued: a folder with write permission.   @throws FileError
  [[nodiscard]] static RunFolder reopen(const std::filesystem::path& path);
  /// Gives a damaged file another name in its folder, "run.damaged.vtkhdf".
  /// @return the new path; empty where there is no such file   @throws FileError
  static std::filesystem::path set_aside(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path results() const { return path_ / "run.vtkhdf"; }
  [[nodiscard]] std::filesystem::path xdmf() const { return path_ / "run.xmf"; }
  [[nodiscard]] std::filesystem::path history() const { return path_ / "history.csv"; }
  [[nodiscard]] std::filesystem::path energy() const { return path_ / "energy.csv"; }
  [[nodiscard]] std::filesystem::path summary() const { return path_ / "summary.json"; }
  [[nodiscard]] std::filesystem::path log() const { return path_ / "run.log"; }

 private:
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace scree::io
