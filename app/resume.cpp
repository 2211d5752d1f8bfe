// `scree resume`: continues a run that was stopped, killed or ended early.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "app/built_from.h"
#include "app/output.h"
#include "app/session.h"
#include "app/signals.h"
#include "io/results/provenance.h"
#include "io/results/regular_file.h"
#include "io/results/sha256.h"
#include "io/results/undo_log.h"

namespace scree::app {
namespace {

/// The case of a run as it was, with the files that it names.
io::Case stored_case(const io::RunRecord& run, const std::filesystem::path& folder) {
  const std::vector<std::string> methods = method_names();
  try {
    io::Case c = io::read_case_text(run.case_text, run.case_path, run.overrides, methods, complain_line);
    for (std::size_t i = 0; i < run.files.size(); ++i)
      if (i >= c.files.size() || digest_of_file(c.files[i]) != run.file_digests[i])
        throw io::FileError(
            i < c.files.size() ? c.files[i] : std::filesystem::path(run.files[i]),
            "has changed since the run in " + folder.string() + " began; resuming requires the original file");
    return c;
  } catch (const io::CaseError& e) {
    throw io::FileError(folder, std::string("cannot resume: its case can no longer be read as it was (a file that it "
                                            "names may be missing)\n") +
                                    e.what());
  }
}

void warn(const std::string& text) { complain("warning: {}\n", text); }

}  // namespace

std::string digest_of_file(const std::filesystem::path& file) {
  io::require_regular(file);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in.is_open() || in.bad()) throw io::FileError(file, "cannot read the file that the case names");
  return io::sha256(bytes);
}

io::RunRecord record_of(const io::Case& c, const RunOptions& options, const std::string& name) {
  io::RunRecord run;
  run.version = SCREE_VERSION;
  run.commit = built_from();
  run.instruction_set = io::instruction_set();
  run.name = name;
  run.command_line = options.command_line;
  run.case_path = std::filesystem::absolute(c.path).string();
  run.case_text = c.text;
  run.overrides = c.overrides;
  for (const std::filesystem::path& file : c.files) {
    run.files.push_back(std::filesystem::absolute(file).string());
    run.file_digests.push_back(digest_of_file(file));
  }
  run.audit = options.audit;
  if (options.until) run.until = *options.until;
  return run;
}

coupling::Checkpoint end_of_run(const std::filesystem::path& run, const io::Case& c, const RunOptions& options) {
  const io::FoundCheckpoint found = io::newest_checkpoint(io::RunFolder::reopen(run), SCREE_VERSION, warn);
  const io::RunRecord& was = found.stored.run;
  const auto refuse = [&](const std::string& why) { throw io::FileError(run, "cannot be started from: " + why); };
  const auto settings = [](std::vector<std::string> set) {
    std::erase_if(set, [](const std::string& option) { return option.starts_with("reduction.factor="); });
    return set;
  };
  if (was.case_text != c.text) refuse("it is a run of another case file");
  if (settings(was.overrides) != settings(options.set)) refuse("it has other --set options than this run");
  if (record_of(c, options, {}).file_digests != was.file_digests) refuse("a file that its case names has changed");
  const coupling::Checkpoint& end = found.stored.checkpoint;
  const auto stage = static_cast<std::size_t>(end.state.stage);
  if (!end.ended && end.state.time < end.stage_end)
    refuse("its last checkpoint is within a stage, " + place_of(end.state));
  if (stage + 1 >= c.plan.stages.size()) refuse("no stage of this run comes after its last one");
  return end;
}

std::string place_of(const coupling::State& state) {
  return fmt::format("t = {:.6g} s, step {}", seconds(state.time), state.step);
}

int resume(const ResumeOptions& options) {
  take_signals_of_runs();
  OpenFolder open{io::RunFolder::reopen(options.run), nullptr};
  open.lock = std::make_unique<io::FolderLock>(options.run);
  io::UndoLog::roll_back(open.folder.results());  // to what it was at the last checkpoint
  const io::FoundCheckpoint from = io::newest_checkpoint(open.folder, SCREE_VERSION, warn);
  const io::RunRecord& run = from.stored.run;
  const coupling::State& state = from.stored.checkpoint.state;
  if (run.commit != built_from() || run.instruction_set != io::instruction_set())
    warn(fmt::format(
        "the run was made by another build of Scree {} (commit {}, {}): results may differ in the last bits from "
        "those of an uninterrupted run",
        run.version, run.commit.empty() ? "unknown" : run.commit, run.instruction_set));
  if (options.until && *options.until < seconds(state.time)) {
    complain("error: --until {:g}: the last checkpoint is at {} already\n", *options.until, place_of(state));
    return kUsage;
  }
  io::Case c = stored_case(run, options.run);
  RunOptions as;  // options with which the run was started
  as.case_file = run.case_path;
  as.quiet = options.quiet;
  as.audit = run.audit;
  as.live = options.live;
  as.threads = options.threads;
  as.until = options.until;
  if (!as.until && std::isfinite(run.until)) as.until = run.until;
  as.set = run.overrides;
  as.command_line = run.command_line;
  if (!options.quiet)
    say("going on with {} from {}: {}\n", options.run.string(), from.path.filename().string(), place_of(state));
  return carry_out(c, as, options.name.empty() ? run.name : options.name, [&] { return std::move(open); },
                   {&from, nullptr});
}

}  // namespace scree::app
