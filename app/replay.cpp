#include <fmt/format.h>

#include <csignal>

#include "app/commands.h"
#include "app/output.h"
#include "app/signals.h"
#include "coupling/plan.h"
#include "io/live/live_replay.h"

namespace scree::app {
int replay(const ReplayOptions& options) {
  const std::string url = options.live.empty() ? coupling::LivePlan{}.url : options.live;
  auto wrong = io::check_live_url(url);
  if (!wrong && url.starts_with("memq:")) wrong = "memq:// reaches no other program; use udpm:// or file://";
  if (wrong) {
    complain("error: --live={}: {}\n", url, *wrong);
    return kUsage;
  }
  take_signals_of_loops({SIGINT, SIGTERM});
  io::LiveReplay run(options.run, url, options.name);
  say("{}: {} frames, {:.6g} to {:.6g} s, to {}\n", run.name(), run.times().size(), run.times().front(),
      run.times().back(), url);
  const io::ReplayCounts counts =
      run.run(options.speed, loop_is_to_end, [](const std::string& text) { complain("warning: {}\n", text); });
  say("{} of {} frames sent\n", counts.sent, counts.frames);
  return counts.complete ? kDone : kInterrupted;
}

}  // namespace scree::app
