// One folder a run: its file names, and the rules for making it.
#pragma once

#include <filesystem>

#include "io/results/file_error.h"

namespace scree::io {

/// Names inside a run folder.
///   run.vtkhdf    frames, histories, ledger, events, provenance     run.xmf   its frames for ParaView
///   history.csv   monitors    energy.csv   ledger    summary.json   what the run ended with    run.log   messages
///   checkpoint.<n>.scree   the last two checkpoints (io/checkpoint)
///   run.vtkhdf.undo        while it runs, or was killed: what run.vtkhdf was at the last checkpoint (undo_log.h)
class RunFolder {
 public:
  /// Makes the folder and its parents. An empty folder is used as it is; an earlier run is cleared of the files that
  /// runs write (other files in it stay) if `overwrite`; a folder with anything else in it is never touched.
  /// @throws FileError when refused or impossible; nothing has been made or removed then, but for missing parents
  ///         that could be made before the failure
  [[nodiscard]] static RunFolder create(const std::filesystem::path& path, bool overwrite);
  /// An earlier run, for reading.   @throws FileError if there is no run.vtkhdf in it
  [[nodiscard]] static RunFolder open(const std::filesystem::path& path);
  /// True for a folder that holds run.vtkhdf, or nothing but files that runs write (a run that ended before its
  /// results).
  [[nodiscard]] static bool is_run(const std::filesystem::path& path);

  /// An earlier run, to go on with: a folder that can be written in.   @throws FileError
  [[nodiscard]] static RunFolder reopen(const std::filesystem::path& path);
  /// Gives a damaged file another name in its folder, "run.damaged.vtkhdf".
  /// @return it; empty where there is no such file   @throws FileError
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
