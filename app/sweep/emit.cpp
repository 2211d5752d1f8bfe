#include "app/sweep/emit.h"

#include <fmt/format.h>

#include "app/sweep/parameters.h"
#include "io/text/printable.h"

namespace scree::app {
namespace {

/// A text as a literal of Python.
std::string python_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out + '"';
}

/// Comments stay on their line.
std::string comment(const Workflow& w) { return io::printable_line(w.title); }

}  // namespace

std::string shell_word(std::string_view text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string_view::npos) return std::string(text);
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string shell_words(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + shell_word(word);
  return out;
}

std::string snakemake_workflow(const Workflow& w) {
  const std::string width = std::to_string(run_name(1, w.runs).size());
  return fmt::format(R"(# {}: {} runs. Use: snakemake --snakefile THIS_FILE --cores {}
COMMAND = {}
RUNS = [f"{{n:0{}d}}" for n in range(1, {})]

workdir: {}


# Has no output: a table is made anew each time, also of runs that failed.
rule table:
    input: expand("ended/{{run}}", run=RUNS)
    params: command=lambda wildcards: COMMAND
    shell: "{{params.command}} --collect"


# A run that failed has an outcome too, which the table tells.
rule run:
    output: touch("ended/{{run}}")
    wildcard_constraints: run="[0-9]+"
    params: command=lambda wildcards: COMMAND
    threads: {}
    shell: "{{params.command}} --only {{wildcards.run}}"
)",
                     comment(w), w.runs, w.jobs * static_cast<std::size_t>(w.threads),
                     python_text(shell_words(w.command)), width, w.runs + 1, python_text(w.folder.string()), w.threads);
}

std::string gnu_parallel_script(const Workflow& w) {
  return fmt::format(R"(#!/bin/sh
# {}: {} runs by GNU parallel, {} at a time or $JOBS, then the table.
set -u
if [ $# -eq 1 ]; then
  exec {} --only "$1"
fi
script=$(realpath "$0") || exit
seq 1 {} | parallel --quote --jobs "${{JOBS:-{}}}" sh "$script" {{}}
exec {} --collect
)",
                     comment(w), w.runs, w.jobs, shell_words(w.command), w.runs, w.jobs, shell_words(w.command));
}

std::string slurm_script(const Workflow& w, std::string_view array) {
  const std::string at_once = w.jobs > 0 ? fmt::format("%{}", w.jobs) : "";
  return fmt::format(R"(#!/bin/sh
# {}
#SBATCH --job-name=scree-sweep
#SBATCH --array={}{}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={}
#SBATCH --signal=B:TERM@60
#SBATCH --output={}
exec {} --only "$SLURM_ARRAY_TASK_ID"
)",
                     comment(w), array, at_once, w.threads, shell_word((w.folder / "logs" / "slurm-%a.log").string()),
                     shell_words(w.command));
}

std::string array_text(const std::vector<std::size_t>& numbers) {
  std::string out;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    out += fmt::format("{}{}", out.empty() ? "" : ",", numbers[i]);
    if (last > i) out += fmt::format("-{}", numbers[last]);
    i = last + 1;
  }
  return out;
}

}  // namespace scree::app
