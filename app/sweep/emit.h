// The runs of a sweep as a workflow for other programs: Snakemake, GNU parallel, a job array of Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scree::app {

/// A sweep for other programs to start. `command` with "--only N" makes run N, with "--collect" the table; it may be
/// started from any folder.
struct Workflow {
  std::vector<std::string> command;  // program and arguments
  std::filesystem::path folder;      // of the sweep, absolute
  std::string title;                 // for comments and the name of jobs
  std::size_t runs = 0, jobs = 0;    // jobs: at a time
  int threads = 1;                   // per run
};

enum class WorkflowKind { snakemake, gnu_parallel };

/// A word, quoted so that a POSIX shell reads it unchanged.
[[nodiscard]] std::string shell_word(std::string_view text);
[[nodiscard]] std::string shell_words(const std::vector<std::string>& words);

/// The text of a Snakefile: a rule for each run, whose mark in <folder>/ended shows that it has an outcome, and the
/// table as the first target.
[[nodiscard]] std::string snakemake_workflow(const Workflow& w);
/// A shell script that passes the runs to GNU parallel and makes the table; $JOBS in place of the number of jobs.
[[nodiscard]] std::string gnu_parallel_script(const Workflow& w);
/// A batch script: a task of the job array for each run of a list such as 1-64.
[[nodiscard]] std::string slurm_script(const Workflow& w, std::string_view array);

/// "1-4,7,9-12".   @pre the numbers increase
[[nodiscard]] std::string array_text(const std::vector<std::size_t>& numbers);

}  // namespace scree::app
