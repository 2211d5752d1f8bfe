// The screen of `scree watch`: its content is correct, fits and is harmless for any input from the run or the network.
#include "io/watch/dashboard.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <thread>

#include "io/live/live_sink.h"
#include "io/results/file_error.h"
#include "io/watch/dashboard_source.h"

namespace scree::io::dashboard_test {
namespace {

Dashboard full() {
  Dashboard run;
  run.source = "udpm://239.255.76.67:7667?ttl=0";
  run.run = "slope";
  run.title = "A slope";
  run.version = "0.1.0";
  run.status = "running";
  run.stage = "shock";
  run.integrator = "explicit";
  run.time = 1.5;
  run.end_time = 6.0;
  run.rate = 0.5;
  run.step_rate = 6000.0;
  run.time_left = 9.0;
  run.steps = 9000;
  run.cuts = 1;
  run.passes = 18000;
  run.contacts = 54;
  run.blocks = 21;
  run.cells = 500;
  run.unknowns = 1200;
  run.frame_time = 1.45;
  run.contact = {2e-5, 3.5e6, "wedge corner 2 on toe edge 1", "toe corner 0 on base edge 4"};
  run.ledger = Dashboard::Ledger{1.5,
                                 {{"kinetic", "energy", 60.0},
                                  {"elastic", "energy", 20.0},
                                  {"reservoir", "energy", 0.0},
                                  {"gravity", "work", 160.0},
                                  {"friction", "dissipated", 79.0},
                                  {"contact_damping", "dissipated", 1.0},
                                  {"update_elastic", "scheme", -40.0}},
                                 1e-13,
                                 200.0,
                                 5e-16};
  run.monitors_time = 1.49;
  for (int i = 0; i < 12; ++i) run.monitors.push_back({"m" + std::to_string(i), 10.0 + i, 2.0, 3.0, 4.0, 0.0, -0.25});
  for (int i = 0; i < 30; ++i) run.events.push_back({0.05 * i, "warning", "word " + std::to_string(i)});
  Dashboard::Received received;
  received.messages = 123;
  received.malformed = 4;
  received.frames = 29;
  received.mesh_after = 0.4;
  run.received = received;
  return run;
}

std::string text(const std::vector<std::string>& lines) {
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

/// The only line that contains a word.
std::string line_with(const std::vector<std::string>& lines, std::string_view word) {
  const auto has = [word](const std::string& line) { return line.find(word) != std::string::npos; };
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), has), 1) << word << "\n" << text(lines);
  const auto found = std::find_if(lines.begin(), lines.end(), has);
  return found == lines.end() ? std::string{} : *found;
}

std::size_t columns(const std::string& line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

TEST(Dashboard, facts_of_a_run_are_shown_with_their_units) {
  const auto lines = render(full(), 120, 60);
  const std::string all = text(lines);
  EXPECT_EQ(lines[0].substr(0, 18), "scree watch  slope");
  EXPECT_EQ(lines[0].substr(113), "running");
  EXPECT_EQ(lines[1], "A slope");
  for (const char* fact :
       {" 25.0 %  1.500 of 6 s  9 s left", "shock, explicit", "rate 0.5 s/s, 6000 steps/s", "9000, 1 cut ",
        "2.0 open-close passes a step", "21 blocks, 500 elements", "1200 unknowns",
        "54 closed, deepest 2e-05 m  wedge corner 2 on toe edge 1", "strongest 3.5e+06 N  toe corner 0 on base edge 4",
        "ENERGY [J] at 1.500 s", "closes to 5.0e-16 of 200 J moved", "MONITORS at 1.490 s",
        "123 messages, 4 malformed  mesh after 0.4 s, frame 29 at 1.450 s"})
    EXPECT_NE(all.find(fact), std::string::npos) << fact << "\n" << all;
}

TEST(Dashboard, energy_bars_are_as_long_as_their_terms_and_sums_are_right) {
  const auto lines = render(full(), 97, 60);  // 97 - 21 - 11 - 1 = 64 columns of bar for the largest, 160 J
  const auto bar = [&](std::string_view word) {
    const std::string line = line_with(lines, word);
    return line.substr(std::min<std::size_t>(33, line.size()));
  };
  EXPECT_EQ(bar("  gravity"), std::string(64, '#'));
  EXPECT_EQ(bar("work done"), std::string(64, '#'));
  EXPECT_EQ(bar("energy held"), std::string(32, '#'));
  EXPECT_EQ(bar("  kinetic"), std::string(24, '#'));
  EXPECT_EQ(bar("dissipated"), std::string(32, '#'));
  EXPECT_EQ(bar("  update elastic"), std::string(16, '-')) << "a negative term has bars of its own";
  EXPECT_EQ(line_with(lines, "energy held").substr(21, 11), "         80");
  EXPECT_EQ(line_with(lines, "of the schemes").substr(21, 11), "        -40");
  EXPECT_EQ(text(lines).find("reservoir"), std::string::npos) << "zero terms take no line";
}

TEST(Dashboard, monitor_row_has_position_distance_and_speed) {
  const std::string line = line_with(render(full(), 80, 60), "  m11 ");
  EXPECT_EQ(line, "  m11                                 21.000       2.000           5        0.25");
}

TEST(Dashboard, every_size_is_kept_to_and_has_its_foot) {
  const Dashboard run = full();
  for (int width = 40; width <= 200; width += 3)
    for (int height = 10; height <= 70; ++height) {
      const auto lines = render(run, width, height);
      ASSERT_LE(lines.size(), static_cast<std::size_t>(height)) << width << " x " << height;
      for (const std::string& line : lines) ASSERT_LE(columns(line), static_cast<std::size_t>(width)) << line;
      ASSERT_EQ(lines.back().substr(0, 12), "123 messages") << width << " x " << height;
    }
}

TEST(Dashboard, terminal_of_80_by_24_shows_all_sections_and_says_what_is_left_out) {
  const auto lines = render(full(), 80, 24);
  const std::string all = text(lines);
  for (const char* part : {"energy held", "work done on it", "dissipated", "of the schemes", "m0 ", "word 29",
                           "smaller)", " of 12)", " of 30)"})
    EXPECT_NE(all.find(part), std::string::npos) << part << "\n" << all;
  EXPECT_EQ(lines.size(), 24U);
}

TEST(Dashboard, small_terms_give_way_first) {
  Dashboard run = full();
  run.monitors.clear();
  run.events.clear();
  const std::size_t all_rows = render(run, 80, 60).size();
  const std::string most = text(render(run, 80, static_cast<int>(all_rows) - 1));
  EXPECT_NE(most.find("(and 1 smaller)"), std::string::npos) << most;
  EXPECT_EQ(most.find("contact damping"), std::string::npos) << most;
  EXPECT_NE(most.find("friction"), std::string::npos) << most;
}

TEST(Dashboard, step_cuts_in_a_row_take_one_line) {
  Dashboard run = full();
  run.events.clear();
  run.events.push_back({0.0, "stage_start", "first"});
  for (int i = 1; i <= 7; ++i) run.events.push_back({0.1 * i, "step_cut", "cut " + std::to_string(i)});
  run.events.push_back({0.8, "stage_start", "second"});
  run.events.push_back({0.9, "step_cut", "cut 8"});
  const auto lines = render(run, 100, 60);
  EXPECT_EQ(line_with(lines, "0.700 s"), "     0.700 s  step cut      7 in a row, the last: cut 7");
  EXPECT_EQ(line_with(lines, "0.900 s"), "     0.900 s  step cut      cut 8");
  EXPECT_EQ(text(lines).find("cut 6"), std::string::npos);
  EXPECT_EQ(line_with(lines, "EVENTS"), "EVENTS");
}

TEST(Dashboard, text_from_the_network_cannot_steer_the_terminal) {
  Dashboard run = full();
  const std::string evil =
      "a\033[2Jb\nc\x9B"
      "1md\xC2\x9B"
      "e\xFF\x7F";
  run.run = run.title = run.stage = run.reason = run.status = evil;
  run.monitors[0].name = run.events.back().kind = run.events.back().text = evil;
  run.ledger->terms[0].name = run.contact->depth_at = run.source = run.version = evil;
  for (const auto& line : render(run, 100, 60))
    for (std::size_t i = 0; i < line.size(); ++i) {
      const auto c = static_cast<unsigned char>(line[i]);
      ASSERT_GE(c, 0x20U) << line;
      ASSERT_NE(c, 0x7FU) << line;
      ASSERT_LT(c, 0x80U) << "nothing of it is a whole character beyond ASCII: " << line;
    }
  EXPECT_EQ(shown(evil, 99), "a?[2Jb?c?1md??e??");
}

TEST(Dashboard, long_and_foreign_names_are_cut_by_characters) {
  EXPECT_EQ(shown("Böschung", 8), "Böschung");
  EXPECT_EQ(shown("Böschung", 7), "Böschu~");
  EXPECT_EQ(shown("äöü", 2), "ä~");
  EXPECT_EQ(shown("x", 0), "");
  EXPECT_EQ(shown("\xE2\x82", 5), "??") << "half a character";
  Dashboard run = full();
  run.monitors[0].name = std::string(300, 'x');
  run.monitors[1].name = "Hangfuß";
  const auto lines = render(run, 80, 60);
  EXPECT_EQ(line_with(lines, "xxx").substr(30), "x~      10.000       2.000           5        0.25");
  EXPECT_EQ(columns(line_with(lines, "Hangfuß")), 80U);
}

TEST(Dashboard, numbers_that_are_not_finite_do_not_break_the_screen) {
  Dashboard run = full();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  run.ledger->terms[0].value = nan;
  run.ledger->terms[3].value = inf;
  run.monitors[0].x = run.monitors[0].vx = nan;
  run.time = run.end_time = run.rate.emplace(nan);
  run.time_left = inf;
  run.received->silent = nan;
  for (const std::string& line : render(run, 80, 24)) EXPECT_LE(columns(line), 80U);
  EXPECT_FALSE(render_line(run).empty());
}

TEST(Dashboard, run_that_falls_silent_is_told_apart_from_one_that_ended) {
  Dashboard run = full();
  run.received->silent = 7.0;
  EXPECT_NE(render(run, 80, 24)[0].find("silent for 7 s"), std::string::npos);
  run.status = "done";
  EXPECT_EQ(render(run, 80, 24)[0].find("silent"), std::string::npos);
}

TEST(Dashboard, nothing_heard_yet_says_so) {
  Dashboard run;
  run.source = "udpm://239.255.76.67:7667?ttl=0";
  run.received.emplace();
  run.received->waited = 2.5;
  const std::string all = text(render(run, 80, 24));
  EXPECT_NE(all.find("waiting for a run on udpm://239.255.76.67:7667?ttl=0, 3 s"), std::string::npos) << all;
  EXPECT_NE(all.find("no mesh yet"), std::string::npos);
}

TEST(Dashboard, line_for_logs_has_time_stage_and_ledger) {
  EXPECT_EQ(render_line(full()),
            "1.500/6 s  shock  running  9000 steps  0.5 s/s  9 s left  held 80 J  ledger 5e-16  4 malformed");
}

TEST(DashboardSource, stream_is_followed_and_malformed_messages_are_counted) {
  std::string why;
  const std::shared_ptr<LiveBus> bus = LiveBus::open("memq://", LiveSide::sender, why);
  ASSERT_TRUE(bus) << why;
  LiveDashboard watch(std::make_unique<LiveReader>(bus, ""), "memq://");
  EXPECT_TRUE(watch.refresh().run.empty());
  bus->publish("SCREE_x_INFO", Bytes(100, 7));

  Model model;
  model.origin = {5.0e5, 4.0e6};
  model.monitors.push_back({"crest", BlockId(0), {0.0, 0.0}});
  coupling::Plan plan;
  plan.live.rate = 1000.0;
  plan.stages.emplace_back();
  plan.stages[0].duration = ticks(10.0);
  LiveSink sink(plan.live, {"x", "0.1.0"}, {}, bus);
  sink.begin(model, plan);
  coupling::State state;
  state.ledger.set(coupling::Column::kinetic, 5.0);
  const std::vector<double> position{1.0, 2.0}, displacement{3.0, 4.0}, velocity{0.5, 0.0};
  const coupling::RunStats stats;
  sink.history({2.5, ticks(2.5), position, displacement, velocity, {}, &state.ledger, &stats});
  sink.event({coupling::EventKind::step_cut, 2.0, "too long", nullptr});
  coupling::FrameView last;
  last.time = 3.0;
  last.stage_name = "only";
  last.state = &state;
  sink.end({coupling::RunEnd::Status::not_converged, "stuck"}, last);

  const auto start = std::chrono::steady_clock::now();
  while (watch.refresh().status != "not converged" &&
         std::chrono::steady_clock::now() - start < std::chrono::seconds(5))
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const Dashboard& run = watch.refresh();
  EXPECT_EQ(run.status, "not converged");
  EXPECT_EQ(run.reason, "stuck");
  EXPECT_EQ(run.run, "x");
  EXPECT_EQ(run.time, 3.0);
  EXPECT_EQ(run.end_time, 10.0);
  ASSERT_TRUE(run.ledger);
  EXPECT_EQ(run.ledger->terms.at(0).name, "kinetic");
  EXPECT_EQ(run.ledger->terms.at(0).value, 5.0);
  ASSERT_EQ(run.monitors.size(), 1U);
  EXPECT_EQ(run.monitors[0].x, 5.0e5 + 1.0) << "where the case has it";
  EXPECT_EQ(run.monitors[0].y, 4.0e6 + 2.0);
  EXPECT_EQ(run.monitors[0].uy, 4.0);
  ASSERT_EQ(run.events.size(), 1U);
  EXPECT_EQ(run.events[0].text, "too long");
  EXPECT_EQ(run.received->malformed, 1);
}

TEST(DashboardSource, folder_that_is_no_run_is_refused) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("scree-watch-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  EXPECT_THROW((void)stored_dashboard(folder), FileError);
  EXPECT_THROW((void)stored_dashboard(folder / "none"), FileError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace scree::io::dashboard_test
