// Replay of a stored run on the stream: the last screen of a viewer equals that of a viewer of the run.
#include "io/live/live_replay.h"

#include <gtest/gtest.h>

#include <thread>

#include "io/results/file_error.h"
#include "io/watch/dashboard_source.h"
#include "tests/unit/io/live_strip.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::live_replay_test {
namespace {

using namespace std::chrono_literals;
using namespace test;

/// The last screen of a viewer of the messages of `play`, without the last line, which counts messages.
template <class Play>
std::vector<std::string> last_screen(Play&& play) {
  const std::shared_ptr<LiveBus> bus = memory_bus();
  auto reader = std::make_unique<LiveReader>(bus, "");
  const LiveReader& seen = *reader;
  LiveDashboard watch(std::move(reader), "memq://");
  play(bus);
  for (int i = 0; i < 500 && (watch.refresh().run.empty() || !has_ended(watch.refresh())); ++i)
    std::this_thread::sleep_for(10ms);
  Dashboard end = watch.refresh();
  EXPECT_TRUE(has_ended(end));
  EXPECT_EQ(seen.counts().malformed, 0);
  EXPECT_TRUE(seen.frame());
  EXPECT_TRUE(!seen.frame() || seen.frame()->header.time == 2.0);
  end.rate = end.step_rate = std::nullopt;  // rates depend on the sender
  std::vector<std::string> lines = render(end, 100, 60);
  lines.pop_back();
  std::erase_if(lines, [](const std::string& line) { return line.starts_with("steps "); });  // play() ends with another
  return lines;
}

TEST(LiveReplay, viewer_of_the_replay_ends_with_the_screen_of_the_run) {
  const Scratch scratch;
  const fs::path folder = scratch.path() / "small";
  {
    ResultsSink sink(RunFolder::create(folder, false), provenance());
    SmallRun().play(sink);
  }
  const auto live = last_screen([&](const std::shared_ptr<LiveBus>& bus) {
    LiveSink sink(plan_at(1000.0).live, {"small", "1.2.3"}, {}, bus);
    SmallRun run;
    run.stats.blocks = run.stats.elements = 2;
    run.play(sink);
  });
  EXPECT_GE(live.size(), 15U);
  for (const double speed : {0.0, 50.0}) {
    const auto again = last_screen([&](const std::shared_ptr<LiveBus>& bus) {
      LiveReplay replay(folder, "memq://", "", bus);
      const ReplayCounts counts = replay.run(speed, {}, {});
      EXPECT_TRUE(counts.complete);
      EXPECT_EQ(counts.frames, 5);
    });
    EXPECT_EQ(again, live) << "speed " << speed;
  }
}

TEST(LiveReplay, at_its_own_speed_it_takes_its_time_and_can_be_stopped) {
  const Scratch scratch;
  const fs::path folder = scratch.path() / "small";
  {
    ResultsSink sink(RunFolder::create(folder, false), provenance());
    SmallRun().play(sink);
  }
  LiveReplay replay(folder, "memq://", "", memory_bus());
  EXPECT_EQ(replay.name(), "small");
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(replay.run(10.0, {}, {}).complete);  // 2 s of the run in 0.2 s
  EXPECT_GE(std::chrono::steady_clock::now() - start, 200ms);
  const auto again = std::chrono::steady_clock::now();
  const ReplayCounts stopped = replay.run(0.01, [&] { return std::chrono::steady_clock::now() - again > 400ms; }, {});
  EXPECT_FALSE(stopped.complete);
  EXPECT_EQ(stopped.sent, 1);
}

TEST(LiveReplay, folder_that_is_no_run_is_refused) {
  const Scratch scratch;
  EXPECT_THROW(LiveReplay(scratch.path(), "memq://", ""), FileError);
}

}  // namespace
}  // namespace scree::io::live_replay_test
