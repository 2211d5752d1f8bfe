#include "app/fos/trial_pool.h"

#include <chrono>
#include <map>
#include <set>
#include <system_error>
#include <thread>

#include "app/sweep/process_pool.h"
#include "io/results/file_error.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kGlance{10};
constexpr int kFilesExit = 5;  // exit code of `scree resume` where no checkpoint can be used

std::vector<std::string> arguments_of(const FosFolder& folder, const FosRecord& record, const WantedRun& run,
                                      bool goes_on, int threads) {
  const fs::path path = folder.run(run.name);
  std::vector<std::string> out;
  if (goes_on) {
    out = {"resume", path.string()};
  } else {
    out = {"run", record.case_file, "--out", path.string()};
    std::error_code error;
    if (fs::exists(path, error) && !fs::is_empty(path, error)) out.emplace_back("--overwrite");
    if (!run.start_from.empty()) out.insert(out.end(), {"--start-from", folder.run(run.start_from).string()});
    for (const std::string& option : run.set) out.insert(out.end(), {"--set", option});
  }
  for (const std::string& library : record.load) out.insert(out.end(), {"--load", library});
  out.insert(out.end(), {"--threads", std::to_string(threads), "--quiet"});
  return out;
}

}  // namespace

RunOutcome outcome_of(const FosFolder& folder, const FosRecord& record, const WantedRun& run) {
  return run_outcome(folder.run(run.name), folder.log(run.name), run.set, record.case_sha256);
}

bool make_trials(const FosFolder& folder, const FosRecord& record, const std::vector<WantedRun>& runs, std::size_t jobs,
                 int threads, const TrialPoolHooks& hooks) {
  struct Started {
    Clock::time_point since;
    bool goes_on = false;
  };
  ProcessPool processes;
  std::map<std::size_t, Started> started;
  std::set<std::size_t> cannot_resume;
  std::vector<std::size_t> queue;
  for (std::size_t i = runs.size(); i-- > 0;)
    if (!outcome_of(folder, record, runs[i]).ended()) queue.push_back(i);
  bool asked = false;
  while (!queue.empty() || processes.running() > 0) {
    const bool stop = hooks.stop && hooks.stop();
    if (stop && !asked) processes.terminate();
    asked = stop;
    if (stop && processes.running() == 0) return false;
    while (!stop && !queue.empty() && processes.running() < jobs) {
      const std::size_t i = queue.back();
      queue.pop_back();
      const bool goes_on = !cannot_resume.contains(i) && has_checkpoint(folder.run(runs[i].name));
      processes.start(i, arguments_of(folder, record, runs[i], goes_on, threads), folder.log(runs[i].name));
      started[i] = {Clock::now(), goes_on};
    }
    while (const auto ended = processes.poll()) {
      const RunOutcome now = outcome_of(folder, record, runs[ended->run]);
      const Started& how = started.at(ended->run);
      if (how.goes_on && !now.ended() && ended->exit_code == kFilesExit && !stop) {
        cannot_resume.insert(ended->run);
        queue.push_back(ended->run);
        continue;
      }
      if (!now.ended() && !stop && ended->exit_code != 4)
        throw io::FileError(folder.run(runs[ended->run].name), "the run ended without an outcome: " + now.reason);
      if (hooks.ended)
        hooks.ended(runs[ended->run].name, now, std::chrono::duration<double>(Clock::now() - how.since).count());
    }
    if (processes.running() > 0) std::this_thread::sleep_for(kGlance);
  }
  return !asked;
}

}  // namespace scree::app
