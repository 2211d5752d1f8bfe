#include <fmt/format.h>

#include <csignal>

#include "app/commands.h"
#include "app/output.h"
#include "coupling/plan.h"
#include "io/live/live_replay.h"

namespace scree::app {
namespace {

volatile std::sig_atomic_t stop_signal = 0;
extern "C" void on_replay_signal(int signal) { stop_signal = signal; }

}  // namespace

int replay(const ReplayOptions& options) {
  const std::string url = options.live.empty() ? coupling::LivePlan{}.url : options.live;
  auto wrong = io::check_live_url(url);
  if (!wrong && url.starts_with("memq:")) wrong = "memq:// reaches no other program; use udpm:// or file://";
  if (wrong) {
    complain("error: --live={}: {}\n", url, *wrong);
    return kUsage;
  }
  stop_signal = 0;
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, on_replay_signal);
  io::LiveReplay run(options.run, url, options.name);
  say("{}: {} frames, {:.6g} to {:.6g} s, to {}\n", run.name(), run.times().size(), run.times().front(),
      run.times().back(), url);
  const io::ReplayCounts counts = run.run(
      options.speed, [] { return stop_signal != 0; }, [](const std::string& text) { complain("warning: {}\n", text); });
  say("{} of {} frames sent\n", counts.sent, counts.frames);
  return counts.complete ? kDone : kInterrupted;
}

}  // namespace scree::app
