// A run that is set up: what `scree run` and `scree resume` have in common.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "io/case/read_case.h"
#include "io/checkpoint/checkpoints.h"
#include "io/results/run_folder.h"

namespace scree::app {

/// A run folder locked by this process.
struct OpenFolder {
  io::RunFolder folder;
  std::unique_ptr<io::FolderLock> lock;
};

/// Where a run begins; both null: at the start.
struct Beginning {
  const io::FoundCheckpoint* resumed = nullptr;  // of the run itself
  const coupling::Checkpoint* after = nullptr;   // at the end of another run: results begin after it
};

/// Carries out a case, from the start or from a checkpoint, and prints the outcome.
/// @param open_folder  called after everything else has been found to be in order
/// @return exit code
int carry_out(io::Case& c, const RunOptions& options, const std::string& name,
              const std::function<OpenFolder()>& open_folder, const Beginning& beginning);

/// Names of the methods that cases may use.
[[nodiscard]] std::vector<std::string> method_names();
/// Name of a case: of its file, or of its folder where the file is called case.toml.
[[nodiscard]] std::string case_name(const std::filesystem::path& case_file);
/// The end of a run of the same case, as a starting point: the case file, the files that it names and the options must
/// be the same, except for reduction.factor.   @throws FileError where they are not, or the run has not ended well
[[nodiscard]] coupling::Checkpoint end_of_run(const std::filesystem::path& run, const io::Case& c,
                                              const RunOptions& options);
/// SHA-256 of a file that a case names.   @throws FileError where it cannot be read
[[nodiscard]] std::string digest_of_file(const std::filesystem::path& file);
/// The record of a run in its checkpoints.   @throws FileError where a file that the case names cannot be read
[[nodiscard]] io::RunRecord record_of(const io::Case& c, const RunOptions& options, const std::string& name);
/// "t = 0.5 s, step 120".
[[nodiscard]] std::string place_of(const coupling::State& state);

}  // namespace scree::app
