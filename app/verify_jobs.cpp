#include "app/verify_jobs.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "app/own_folder.h"
#include "app/signals.h"
#include "app/sweep/process_pool.h"
#include "app/verify/report_json.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;

const char* option_of(Tier tier) {
  return tier == Tier::quick ? "--quick" : tier == Tier::full ? "--full" : "--exhaustive";
}

std::string last_line(const fs::path& log) {
  std::ifstream in(log);
  std::string line, last;
  while (std::getline(in, line))
    if (!line.empty()) last = line;
  return last;
}

/// The cases in the order in which they begin: those that take longest first.
class Queue {
 public:
  Queue(const std::vector<std::string>& names, const fs::path& library, Tier tier) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const Expected expected = read_expected(library / names[i] / "expected.toml");
      const double minutes = tier == Tier::quick ? 0.0 : expected.minutes;
      (expected.cores > 1 ? alone_ : shared_).push_back({i, minutes});
    }
    for (auto* list : {&shared_, &alone_})
      std::stable_sort(list->begin(), list->end(), [](const Item& a, const Item& b) { return a.minutes < b.minutes; });
  }
  [[nodiscard]] bool empty() const { return shared_.empty() && alone_.empty(); }
  /// The case that begins next and whether alone; none: it has to wait for those that run.
  struct Next {
    std::size_t which = 0;
    bool alone = false;
  };
  std::optional<Next> take(std::size_t busy, std::size_t jobs) {
    std::vector<Item>& list = shared_.empty() ? alone_ : shared_;
    const bool alone = &list == &alone_;
    if (list.empty() || busy >= (alone ? 1 : jobs)) return std::nullopt;
    const std::size_t which = list.back().which;
    list.pop_back();
    return Next{which, alone};
  }

 private:
  struct Item {
    std::size_t which = 0;
    double minutes = 0.0;
  };
  std::vector<Item> shared_, alone_;  // in reverse order: the last item begins first
};

/// The report of a process that left none. It has no title: it may be the case file that cannot be read.
CaseReport report_of_failure(const std::string& name, const std::string& why) {
  CaseReport out;
  out.name = name;
  out.rows.push_back({"evaluation of the case", "every case has to be evaluated", "a report", 0.0, false, why, false});
  return out;
}

}  // namespace

std::optional<std::vector<CaseReport>> evaluate_in_processes(const VerifyCommand& command,
                                                             const std::vector<std::string>& names,
                                                             const fs::path& library,
                                                             const std::function<void(const CaseReport&)>& see) {
  const int all = command.threads > 0 ? command.threads : omp_get_max_threads();
  const auto jobs = static_cast<std::size_t>(command.jobs);
  Queue queue(names, library, command.tier);
  const OwnFolder folder("verify");
  const auto table = [&](std::size_t i) { return folder.path() / (names[i] + ".json"); };
  const auto log = [&](std::size_t i) { return folder.path() / (names[i] + ".log"); };
  const auto report_of = [&](const ProcessPool::Ended& ended) {
    if (fs::exists(table(ended.run))) return read_json_report(table(ended.run)).at(0);
    const std::string why = fmt::format("exit code {}: {}", ended.exit_code, last_line(log(ended.run)));
    return report_of_failure(names[ended.run], why);
  };
  std::vector<CaseReport> reports(names.size());
  take_signals_of_runs();
  Signals signals(false);
  ProcessPool pool;
  while (!queue.empty() || pool.running() > 0) {
    if (signals.stop_requested()) return std::nullopt;
    while (const auto next = queue.take(pool.running(), jobs)) {
      const int threads = next->alone ? all : std::max(1, all / command.jobs);
      pool.start(next->which,
                 {"cases", "verify", names[next->which], option_of(command.tier), "--threads", std::to_string(threads),
                  "--table", table(next->which).string()},
                 log(next->which));
      if (next->alone) break;
    }
    while (const auto ended = pool.poll()) {
      reports[ended->run] = report_of(*ended);
      see(reports[ended->run]);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return reports;
}

}  // namespace scree::app
