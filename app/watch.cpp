#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/commands.h"
#include "app/output.h"
#include "app/screen.h"
#include "app/signals.h"
#include "coupling/plan.h"
#include "io/live/live_url.h"
#include "io/watch/dashboard.h"
#include "io/watch/dashboard_source.h"

namespace scree::app {
namespace {

using SteadyClock = std::chrono::steady_clock;

void print(const io::Dashboard& run) {
  const TerminalSize size = terminal_size();
  for (const std::string& line : io::render(run, size.width, size.height)) say("{}\n", line);
}

/// On a terminal a screen, redrawn when something changed; elsewhere one line per second.
class Display {
 public:
  Display() {
    if (isatty(STDOUT_FILENO) != 0) screen_ = std::make_unique<Screen>();
  }
  void show(const io::Dashboard& run) {
    if (screen_) {
      const TerminalSize size = terminal_size();
      screen_->draw(io::render(run, size.width, size.height), size);
    } else if (SteadyClock::now() >= next_) {
      next_ = SteadyClock::now() + std::chrono::seconds(1);
      line(run);
    }
  }
  /// Restores the terminal and prints the last screen on it; elsewhere prints the last line.
  void close(const io::Dashboard& run) {
    if (screen_) {
      screen_ = nullptr;
      print(run);
    } else {
      line(run);
    }
  }

 private:
  void line(const io::Dashboard& run) {
    std::string text = io::render_line(run);
    if (text == last_) return;
    say("{}\n", text);
    last_ = std::move(text);
  }

  std::unique_ptr<Screen> screen_;
  SteadyClock::time_point next_{};
  std::string last_;
};

/// Whether the data suffice for one screen: they are complete, or the time in which everything is sent again is over.
bool complete(const io::Dashboard& run, double since_info) {
  constexpr double kKeyframe = 2.5;  // s
  return !run.run.empty() && ((run.ledger && run.frame_time) || since_info > kKeyframe);
}

int watch_live(const WatchOptions& options, const std::string& url) {
  take_signals_of_loops({SIGINT, SIGTERM, SIGHUP});  // so that the terminal is put back
  const SteadyClock::time_point start = SteadyClock::now();
  std::string why;
  auto reader = io::LiveReader::open(url, options.run, why);
  if (!reader) {
    complain("error: {}\n", why);
    return kFiles;
  }
  io::LiveDashboard source(std::move(reader), url, start);
  const auto passed = [](SteadyClock::time_point since) {
    return std::chrono::duration<double>(SteadyClock::now() - since).count();
  };
  std::unique_ptr<Display> display = options.once ? nullptr : std::make_unique<Display>();
  std::optional<SteadyClock::time_point> info_at;
  const auto leave = [&](const io::Dashboard& run, int code) {
    if (display)
      display->close(run);
    else
      print(run);
    return code;
  };
  for (;;) {
    const bool ended = source.ended();  // read first: messages before the end are still shown
    const io::Dashboard& run = source.refresh();
    const bool known = !run.run.empty();
    if (known && !info_at) info_at = SteadyClock::now();
    if (loop_is_to_end()) return leave(run, kInterrupted);
    if (known && io::has_ended(run)) return leave(run, kDone);
    if (known && (ended || (options.once && complete(run, passed(*info_at))))) return leave(run, kDone);
    if (options.seconds && passed(start) >= *options.seconds) {
      if (known) return leave(run, kDone);
      break;
    }
    if (ended || (options.timeout > 0.0 && run.received->silent >= options.timeout)) break;
    if (display) display->show(run);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  const io::Dashboard& run = source.refresh();
  if (display) display->close(run);
  if (run.run.empty())
    complain("error: no data from {} on {} for {:.0f} s\n  does it stream? scree run CASE --live\n",
             options.run.empty() ? "any run" : fmt::format("a run '{}'", options.run), url, run.received->waited);
  else
    complain("error: {} has been silent for {:.0f} s; it may have been killed\n", run.run, run.received->silent);
  return kFiles;
}

}  // namespace

int watch(const WatchOptions& options) {
  const std::string& source = options.source;
  if (source.find("://") != std::string::npos || source.empty()) {
    const std::string url = source.empty() ? coupling::LivePlan{}.url : source;
    auto wrong = io::check_live_url(url, io::LiveSide::receiver);
    if (!wrong && url.starts_with("memq:")) wrong = "memq:// reaches no other program; use udpm:// or file://";
    if (wrong) {
      complain("error: {}: {}\n", url, *wrong);
      return kUsage;
    }
    return watch_live(options, url);
  }
  const bool name_only = source.find('/') == std::string::npos && options.run.empty();
  if (!std::filesystem::exists(source) && name_only) {  // the name of a run that streams
    WatchOptions named = options;
    named.run = source;
    return watch_live(named, coupling::LivePlan{}.url);
  }
  print(io::stored_dashboard(source));
  return kDone;
}

}  // namespace scree::app
