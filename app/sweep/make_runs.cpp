#include "app/sweep/make_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <set>
#include <system_error>
#include <thread>

#include "app/sweep/process_pool.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kGlance{10}, kWait{200};  // between polls of the processes; of a busy folder
constexpr int kFilesExit = 5;                   // exit code of `scree resume` where no checkpoint can be used
constexpr int kBadCase = 3, kNotConverged = 4;  // of runs that would end the same way each time

class Pool {
 public:
  Pool(const SweepFolder& folder, const SweepRecord& record, const PoolSettings& settings, const PoolHooks& hooks)
      : folder_(&folder), record_(&record), settings_(settings), hooks_(&hooks) {}

  PoolCounts make(std::span<const std::size_t> runs) {
    for (const std::size_t run : runs)
      if (const RunOutcome now = outcome(run); now.ended())
        count(now);
      else
        queue_.push_back(run);
    bool asked_to_end = false;
    while (!queue_.empty() || processes_.running() > 0) {
      const bool stop = hooks_->stop && hooks_->stop();
      if (stop && !asked_to_end) processes_.terminate();
      asked_to_end = stop;
      if (stop && processes_.running() == 0) break;
      if (!stop) fill();
      while (const auto ended = processes_.poll()) see(*ended, stop);
      if (processes_.running() > 0)
        std::this_thread::sleep_for(kGlance);
      else if (!queue_.empty())
        std::this_thread::sleep_for(kWait);
    }
    counts_.left = queue_.size() + interrupted_;
    return counts_;
  }

 private:
  [[nodiscard]] RunOutcome outcome(std::size_t run) const {
    return run_outcome(folder_->run(run), folder_->log(run), record_->overrides(run), record_->case_sha256);
  }
  void count(const RunOutcome& o) { ++(o.state == RunOutcome::State::done ? counts_.done : counts_.failed); }
  void tell(std::size_t run, const RunOutcome& o, double seconds) const {
    if (hooks_->ended) hooks_->ended(run, o, seconds);
  }

  /// Starts runs while there is room, those in busy folders last.
  void fill() {
    for (std::size_t tries = queue_.size(); tries > 0 && processes_.running() < settings_.jobs; --tries) {
      const std::size_t run = queue_.front();
      queue_.pop_front();
      if (is_busy(folder_->run(run))) {
        if (waited_for_.insert(run).second && hooks_->note)
          hooks_->note(fmt::format("run {} is being computed by another program; waiting for it", run));
        queue_.push_back(run);
      } else if (const RunOutcome now = outcome(run); now.ended()) {  // ended by that program
        count(now);
        tell(run, now, 0.0);
      } else {
        start(run);
      }
    }
  }

  void start(std::size_t run) {
    const fs::path path = folder_->run(run);
    const bool goes_on = !cannot_resume_.contains(run) && has_checkpoint(path);
    std::vector<std::string> arguments;
    if (goes_on) {
      arguments = {"resume", path.string()};
    } else {
      arguments = {"run", record_->case_file, "--out", path.string(), "--name", folder_->stream_name(run)};
      std::error_code error;
      if (fs::exists(path, error) && !fs::is_empty(path, error)) arguments.emplace_back("--overwrite");
      for (const std::string& option : record_->overrides(run)) arguments.insert(arguments.end(), {"--set", option});
      if (record_->until) arguments.insert(arguments.end(), {"--until", fmt::format("{}", *record_->until)});
    }
    for (const std::string& library : record_->load) arguments.insert(arguments.end(), {"--load", library});
    arguments.insert(arguments.end(), {"--threads", std::to_string(settings_.threads), "--quiet"});
    processes_.start(run, arguments, folder_->log(run));
    started_[run] = {Clock::now(), goes_on};
  }

  void see(const ProcessPool::Ended& ended, bool stop) {
    const RunOutcome now = outcome(ended.run);
    const auto& [since, went_on] = started_.at(ended.run);
    const double seconds = std::chrono::duration<double>(Clock::now() - since).count();
    if (now.ended()) {
      count(now);
      tell(ended.run, now, seconds);
    } else if (stop) {
      ++interrupted_;
    } else if (went_on && ended.exit_code == kFilesExit) {
      cannot_resume_.insert(ended.run);
      if (hooks_->note)
        hooks_->note(
            fmt::format("run {} cannot go on and begins anew: {}", ended.run, first_error(folder_->log(ended.run))));
      queue_.push_front(ended.run);
    } else {
      ++(ended.exit_code == kBadCase || ended.exit_code == kNotConverged ? counts_.failed : counts_.without_outcome);
      tell(ended.run, now, seconds);
    }
  }

  struct Started {
    Clock::time_point since;
    bool goes_on = false;
  };
  const SweepFolder* folder_;
  const SweepRecord* record_;
  PoolSettings settings_;
  const PoolHooks* hooks_;
  ProcessPool processes_;
  std::deque<std::size_t> queue_;
  std::map<std::size_t, Started> started_;
  std::set<std::size_t> cannot_resume_, waited_for_;
  std::size_t interrupted_ = 0;
  PoolCounts counts_;
};

}  // namespace

PoolCounts make_runs(const SweepFolder& folder, const SweepRecord& record, std::span<const std::size_t> runs,
                     const PoolSettings& settings, const PoolHooks& hooks) {
  return Pool(folder, record, settings, hooks).make(runs);
}

}  // namespace scree::app
