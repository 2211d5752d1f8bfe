// `scree sweep`: a case with many values of its keys.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <optional>

#include "app/commands.h"
#include "app/output.h"
#include "app/session.h"
#include "app/signals.h"
#include "app/sweep/checked_case.h"
#include "app/sweep/emit.h"
#include "app/sweep/make_runs.h"
#include "app/sweep/parameter_table.h"
#include "app/sweep/process_pool.h"
#include "app/sweep/result_table.h"
#include "app/sweep/slurm.h"
#include "app/sweep/sweep_folder.h"
#include "app/sweep/sweep_plots.h"
#include "io/case/suggest.h"
#include "io/checkpoint/checkpoints.h"
#include "io/results/atomic_file.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;

/// A sweep whose runs have been checked.
struct Sweep {
  const SweepCommand* command = nullptr;
  SweepRecord record;
  std::string title;              // of the case
  std::vector<std::size_t> runs;  // to be made
  fs::path path;                  // of its folder, absolute
  std::size_t jobs = 1;           // at a time

  [[nodiscard]] std::string run_text(std::size_t run) const {
    return fmt::format("run {} ({})", run_name(run, record.runs()), fmt::join(record.parameters.overrides(run), ", "));
  }
};

fs::path absolute_path(const fs::path& path) {
  const fs::path full = fs::absolute(path).lexically_normal();
  return full.has_filename() ? full : full.parent_path();
}

/// Number of a run; empty where the text is not the number of one.
std::optional<std::size_t> run_number(const std::string& text, std::size_t runs) {
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc{} || read.ptr != end || number < 1 || number > runs) return std::nullopt;
  return number;
}

/// What is wrong with the options as a whole; empty: nothing.
std::string usage_error(const SweepCommand& c) {
  if (c.params.empty() && c.table.empty())
    return "nothing varies: give --param KEY=A:B:N, --param KEY=V1,V2,... or --table FILE";
  const std::vector<std::string> kinds{"snakemake", "gnu-parallel"};
  if (!c.emit.empty() && std::find(kinds.begin(), kinds.end(), c.emit.front()) == kinds.end())
    return fmt::format("--emit: {}\n  allowed: {}\n  hint: {}", c.emit.front(), fmt::join(kinds, ", "),
                       io::did_you_mean(c.emit.front(), kinds, "give the kind, then the file"));
  if (c.no_wait && c.on != "slurm") return "--no-wait: only a Slurm job can run without waiting (--on slurm)";
  return {};
}

Sweep checked_sweep(const SweepCommand& c) {
  Sweep sweep;
  sweep.command = &c;
  SweepRecord& record = sweep.record;
  record.case_file = absolute_path(c.case_file).string();
  record.set = c.set;
  for (const std::string& library : c.load) record.load.push_back(absolute_path(library).string());
  record.until = c.until;
  record.parameters = c.table.empty() ? parameter_grid(c.params) : read_parameter_table(c.table);
  sweep.runs.resize(record.runs());
  std::iota(sweep.runs.begin(), sweep.runs.end(), 1);
  if (!c.only.empty()) {
    const std::optional<std::size_t> only = run_number(c.only, record.runs());
    sweep.runs.clear();
    if (!only) return sweep;
    sweep.runs.push_back(*only);
  }
  std::vector<std::size_t> checked = sweep.runs;
  if (c.collect) checked.resize(1);  // all were checked when the sweep began, and the record shows changes
  const std::vector<std::string> methods = method_names();
  CheckedCase found = check_runs(c.case_file, c.set, record.parameters, checked, methods, complain_line);
  record.case_sha256 = std::move(found.sha256);
  record.files = std::move(found.files);
  sweep.title = std::move(found.title);
  sweep.path = absolute_path(c.out.empty() ? fs::path("runs") / (case_name(c.case_file) + "-sweep") : c.out);
  sweep.jobs = c.jobs > 0 ? c.jobs : static_cast<std::size_t>(std::max(1, omp_get_num_procs() / c.threads));
  return sweep;
}

PoolHooks hooks_of(const Sweep& sweep, Signals& signals) {
  PoolHooks hooks;
  hooks.stop = [&signals] { return signals.stop_requested(); };
  if (sweep.command->quiet) return hooks;
  hooks.note = [](const std::string& text) { say("{}\n", text); };
  hooks.ended = [&sweep](std::size_t run, const RunOutcome& outcome, double seconds) {
    say("{}: {}, {:.1f} s{}{}\n", sweep.run_text(run), outcome.status, seconds, outcome.reason.empty() ? "" : ": ",
        outcome.reason);
  };
  return hooks;
}

/// Makes the table and its plots, and reports the runs that are not done.
int tabulate(const Sweep& sweep, const SweepFolder& folder) {
  const ResultTable table = collect(folder, sweep.record, sweep.title, sweep.command->blocks);
  io::write_atomically(folder.csv(), csv_text(table));
  write_h5(table, folder.h5());
  io::write_atomically(folder.costs(), costs_text(folder, table));
  const std::size_t plots = draw_sweep_plots(table, folder.plots());
  std::size_t not_done = 0;
  for (std::size_t run = 1; run <= table.runs(); ++run) {
    const RunOutcome& outcome = table.outcomes[run - 1];
    if (outcome.state == RunOutcome::State::done) continue;
    ++not_done;
    complain("error: {}: {}{}{}\n", sweep.run_text(run), outcome.status, outcome.reason.empty() ? "" : ": ",
             outcome.reason);
  }
  if (!sweep.command->quiet)
    say("{} of {} runs are done; table in {}{}\n", table.runs() - not_done, table.runs(), folder.csv().string(),
        plots > 0 ? fmt::format(", {} plots in {}", plots, folder.plots().string()) : std::string());
  return not_done == 0 ? kDone : kFailed;
}

int interrupted(const Sweep& sweep, std::size_t left) {
  complain("interrupted: {} of {} runs have not ended; the same command goes on with them:\n  {}\n", left,
           sweep.record.runs(), shell_words(sweep.command->words));
  return kInterrupted;
}

int make_all(const Sweep& sweep) {
  const SweepFolder folder = SweepFolder::open(sweep.path, sweep.record);
  const io::FolderLock lock(sweep.path);
  if (!sweep.command->quiet)
    say("{} runs of {}, {} at a time, in {}\n", sweep.runs.size(), sweep.command->case_file.string(), sweep.jobs,
        sweep.path.string());
  Signals signals(!sweep.command->quiet);
  const PoolCounts counts =
      make_runs(folder, sweep.record, sweep.runs, {sweep.jobs, sweep.command->threads}, hooks_of(sweep, signals));
  return counts.left > 0 ? interrupted(sweep, counts.left) : tabulate(sweep, folder);
}

int make_one(const Sweep& sweep) {
  const SweepFolder folder = SweepFolder::reopen(sweep.path, sweep.record);
  Signals signals(!sweep.command->quiet);
  const PoolCounts counts =
      make_runs(folder, sweep.record, sweep.runs, {1, sweep.command->threads}, hooks_of(sweep, signals));
  if (counts.left > 0) return kInterrupted;
  if (counts.without_outcome == 0) return kDone;  // a failure is an outcome, which the table contains
  complain("error: {} has no outcome: {}\n", sweep.run_text(sweep.runs.front()),
           first_error(folder.log(sweep.runs.front())));
  return kFailed;
}

/// The sweep as another program starts it.
Workflow workflow_of(const Sweep& sweep) {
  const SweepCommand& c = *sweep.command;
  Workflow w;
  w.command = {this_program().string(), "sweep", sweep.record.case_file};
  if (!c.table.empty()) w.command.insert(w.command.end(), {"--table", absolute_path(c.table).string()});
  const auto add_each = [&w](const char* option, const std::vector<std::string>& values) {
    for (const std::string& value : values) w.command.insert(w.command.end(), {option, value});
  };
  add_each("--param", c.params);
  add_each("--set", c.set);
  add_each("--load", sweep.record.load);
  add_each("--block", c.blocks);
  if (c.until) w.command.insert(w.command.end(), {"--until", fmt::format("{}", *c.until)});
  w.command.insert(w.command.end(),
                   {"--threads-per-run", std::to_string(c.threads), "--out", sweep.path.string(), "--quiet"});
  w.folder = sweep.path;
  w.title = fmt::format("Sweep of {}", sweep.record.case_file);
  w.runs = sweep.record.runs();
  w.jobs = sweep.jobs;
  w.threads = c.threads;
  return w;
}

int emit(const Sweep& sweep) {
  const SweepFolder folder = SweepFolder::open(sweep.path, sweep.record);
  const fs::path file = sweep.command->emit[1];
  const Workflow w = workflow_of(sweep);
  const bool parallel = sweep.command->emit[0] == "gnu-parallel";
  io::write_atomically(file, parallel ? gnu_parallel_script(w) : snakemake_workflow(w));
  const std::string quoted = shell_word(file.string());
  if (!sweep.command->quiet)
    say("{} runs; start them with: {}\n", w.runs,
        parallel ? "sh " + quoted : fmt::format("snakemake --snakefile {} --cores {}", quoted, sweep.jobs));
  return kDone;
}

/// Runs that have no outcome yet.
std::vector<std::size_t> pending(const Sweep& sweep, const SweepFolder& folder) {
  std::vector<std::size_t> out;
  for (const std::size_t run : sweep.runs)
    if (!run_outcome(folder.run(run), folder.log(run), sweep.record.overrides(run), sweep.record.case_sha256).ended())
      out.push_back(run);
  return out;
}

int make_on_slurm(const Sweep& sweep) {
  const SweepFolder folder = SweepFolder::open(sweep.path, sweep.record);
  const std::vector<std::size_t> runs = pending(sweep, folder);
  if (runs.empty()) return tabulate(sweep, folder);
  Workflow w = workflow_of(sweep);
  w.jobs = sweep.command->jobs;
  const fs::path script = sweep.path / "sweep.sbatch";
  io::write_atomically(script, slurm_script(w, array_text(runs)));
  const std::string how = shell_words(w.command) + " --collect";
  Signals signals(!sweep.command->quiet);
  const Submission s = submit(
      script, !sweep.command->no_wait, [&signals] { return signals.stop_requested(); },
      [&](const std::string& job) {
        if (!sweep.command->quiet) say("job {} of Slurm makes {} runs\n", job, runs.size());
      });
  if (s.job.empty() && !s.stopped) {
    complain("error: sbatch refused the job (exit code {}): {}\n", s.exit_code, s.errors);
    return kFailed;
  }
  if (s.stopped) {
    complain("interrupted: job {} goes on (scancel {} ends it); when it has ended, collect with:\n  {}\n", s.job, s.job,
             how);
    return kInterrupted;
  }
  if (sweep.command->no_wait) {
    if (!sweep.command->quiet) say("when it has ended, collect with:\n  {}\n", how);
    return kDone;
  }
  return tabulate(sweep, folder);
}

}  // namespace

int sweep(const SweepCommand& command) {
  take_signals_of_runs();
  if (const std::string wrong = usage_error(command); !wrong.empty()) {
    complain("error: {}\n", wrong);
    return kUsage;
  }
  const Sweep sweep = checked_sweep(command);
  if (sweep.runs.empty()) {
    complain("error: --only {}: there is no such run\n  allowed: 1 to {}\n", command.only, sweep.record.runs());
    return kUsage;
  }
  if (!command.emit.empty()) return emit(sweep);
  if (command.collect) return tabulate(sweep, SweepFolder::reopen(sweep.path, sweep.record));
  if (!command.only.empty()) return make_one(sweep);
  return command.on == "slurm" ? make_on_slurm(sweep) : make_all(sweep);
}

}  // namespace scree::app
