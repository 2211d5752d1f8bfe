// Live streaming: a reader restores the data of the run; damaged messages are dropped; nothing stops the run.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <numeric>
#include <random>
#include <scree/mesh_v1_t.hpp>
#include <scree/state_v1_t.hpp>
#include <set>
#include <thread>

#include "io/live/channel.h"
#include "io/live/crc32.h"
#include "io/live/encode.h"
#include "io/live/live_publisher.h"
#include "io/live/live_reader.h"
#include "io/live/live_sink.h"
#include "io/live/quantise.h"
#include "io/live/split.h"
#include "tests/unit/io/live_strip.h"

namespace scree::io::live_test {
namespace {

using namespace std::chrono_literals;
using namespace test;

// --- names --------------------------------------------------------------------------------------------------------

TEST(LiveChannel, name_for_any_run_fits_and_is_clean) {
  EXPECT_EQ(channel_name("staged-slope", LiveKind::state), "SCREE_staged-slope_STATE");
  EXPECT_EQ(channel_name("my run/2.toml", LiveKind::event), "SCREE_my-run-2-toml_EVENT");
  EXPECT_EQ(channel_name("", LiveKind::info), "SCREE_run_INFO");
  const std::string first(200, 'a'), second = first + "b";
  for (const LiveKind kind : kLiveKinds) {
    EXPECT_LE(channel_name(first, kind).size(), kMaxChannel);
    EXPECT_NE(channel_name(first, kind), channel_name(second, kind));
    EXPECT_EQ(channel_kind(channel_name(first, kind)), kind);
  }
  EXPECT_EQ(channel_run(channel_run(first)), channel_run(first));
  EXPECT_EQ(channel_kind("OTHER_x_STATE"), std::nullopt);
  EXPECT_EQ(channel_kind("SCREE_x_LATE"), std::nullopt);
}

TEST(LiveUrl, bad_ones_are_refused_and_name_what_is_accepted) {
  for (const char* bad :
       {"tcpq://127.0.0.1:7700", "", "udpm", "memq", "memq://x", "http://localhost", "udpm://127.0.0.1:7667",
        "udpm://239.255.76.67", "udpm://239.255.76.67:0", "udpm://239.255.76.67:99999", "udpm://no:7667",
        "udpm://239.255.76.67:7667?ttl=7", "udpm://239.255.76.67:7667?ttl=x", "udpm://239.255.76.67:7667?speed=2",
        "file://", "file:///no/such/folder/x.lcm", "file:///", "file:///tmp/x.lcm?mode=r"}) {
    const auto wrong = check_live_url(bad);
    ASSERT_TRUE(wrong) << bad;
    EXPECT_NE(wrong->find("accepted: udpm://"), std::string::npos) << *wrong;
    coupling::LivePlan plan;
    plan.url = bad;
    EXPECT_THROW(LiveSink(plan, {"x"}, {}), std::invalid_argument) << bad;
  }
  for (const char* good : {"udpm://239.255.76.67:7667?ttl=0", "udpm://", "udpm://239.255.76.67:7667", "memq://",
                           "udpm://224.1.2.3:7000?ttl=1&recv_buf_size=2000000"})
    EXPECT_EQ(check_live_url(good), std::nullopt) << good;
  EXPECT_EQ(parse_live_url("udpm://", LiveSide::sender).lcm, "udpm://239.255.76.67:7667?ttl=0");
}

TEST(LiveUrl, file_that_is_no_log_is_not_overwritten) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("scree-live-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "case.toml") << "title = 'mine'\n";
  EXPECT_TRUE(check_live_url("file://" + (folder / "case.toml").string()));
  EXPECT_FALSE(check_live_url("file://" + (folder / "new.lcm").string()));
  EXPECT_FALSE(std::filesystem::exists(folder / "new.lcm")) << "a check leaves nothing behind";
  std::filesystem::remove_all(folder);
}

// --- parts --------------------------------------------------------------------------------------------------------

TEST(LiveCrc32, check_value_of_the_standard_is_met) {
  const std::string_view text = "123456789";
  EXPECT_EQ(crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}), 0xCBF43926U);
}

TEST(LiveQuantise, random_displacements_come_back_within_half_a_step) {
  std::mt19937 random(4);
  std::vector<double> dx(1000), dy(1000);
  for (std::size_t i = 0; i < dx.size(); ++i) {
    dx[i] = 1e-3 * static_cast<double>(random() % 100000U) - 30.0;
    dy[i] = 1e-5 * static_cast<double>(random() % 100000U);
  }
  const Quantised q = quantise(dx, dy);
  for (std::size_t i = 0; i < dx.size(); ++i) {
    const double bound = 0.5 * q.scale * (1.0 + 1e-9);  // 1e-9: rounding of the arithmetic itself
    EXPECT_LE(std::abs(restore(q.base[0], q.scale, q.dx[i]) - dx[i]), bound);
    EXPECT_LE(std::abs(restore(q.base[1], q.scale, q.dy[i]) - dy[i]), bound);
  }
}

TEST(LiveQuantise, not_finite_numbers_spoil_only_themselves) {
  constexpr double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> dx{1.0, inf, 2.0, nan}, dy{0.0, 0.0, -inf, 1.0};
  const Quantised q = quantise(dx, dy);
  EXPECT_DOUBLE_EQ(restore(q.base[0], q.scale, q.dx[0]), 1.0);
  EXPECT_TRUE(std::isnan(restore(q.base[0], q.scale, q.dx[1])));
  EXPECT_TRUE(std::isnan(restore(q.base[1], q.scale, q.dy[2])));
  const std::vector<double> none(3, nan), all_huge{-1.7e308, 1.7e308, 0.0};
  EXPECT_TRUE(std::isnan(restore(0.0, 0.0, quantise(none, none).dx[0])));
  EXPECT_TRUE(std::isfinite(quantise(all_huge, all_huge).scale));
}

TEST(LiveCellValues, fields_are_those_of_the_cell) {
  Strip strip(2);
  RawFrame raw;
  raw.mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(strip.mesh));
  raw.source = std::vector<double>(strip.origin.size(), 0.0);
  raw.source[0] = 3.0;  // corner 0 belongs to the first cell alone
  raw.source[1] = 4.0;
  EXPECT_EQ(cell_values(raw), (std::vector<float>{1.25F, 0.0F}));
  raw.source = strip.stress;
  raw.field = LiveField::mean_stress;
  EXPECT_EQ(cell_values(raw), (std::vector<float>{250.0F, -250.0F}));
  // By hand: a Mohr circle with its centre at -1 and radius 5.
  raw.source = {2.0, -4.0, 4.0, 0.0, 0.0, 0.0};
  const auto first = [&](LiveField field) {
    raw.field = field;
    return cell_values(raw)[0];
  };
  EXPECT_EQ(first(LiveField::s1), 4.0F);
  EXPECT_EQ(first(LiveField::s3), -6.0F);
  EXPECT_EQ(first(LiveField::shear), 5.0F);
  EXPECT_EQ(first(LiveField::sxx), 2.0F);
  EXPECT_EQ(first(LiveField::syy), -4.0F);
  EXPECT_EQ(first(LiveField::sxy), 4.0F);
}

TEST(LiveCellValues, joint_states_are_the_worst_of_a_blocks_closed_contacts) {
  Strip strip(6);  // three cells per block
  RawFrame raw;
  raw.mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(strip.mesh));
  raw.field = LiveField::joint;
  using Status = coupling::ContactStatus;
  const auto add = [&](std::int32_t p, std::int32_t e, Status status, std::int32_t failed) {
    coupling::ContactMemory c;
    c.key.block_p = p, c.key.block_e = e;
    c.status = status, c.failed = failed;
    strip.state.contacts.memory.push_back(c);
    EXPECT_TRUE(take_source(raw, strip.frame));
    return cell_values(raw);
  };
  EXPECT_EQ(add(0, 1, Status::open, 1), std::vector<float>(6, 0.0F)) << "open contacts say nothing";
  EXPECT_EQ(add(0, 1, Status::stick, 1), std::vector<float>(6, 1.0F));
  EXPECT_EQ(add(1, 99, Status::slip, 0), (std::vector<float>{1, 1, 1, 2, 2, 2})) << "block 99 has no cells";
  EXPECT_EQ(add(99, 0, Status::slip, 1), (std::vector<float>{3, 3, 3, 2, 2, 2}));
  EXPECT_EQ(add(0, 1, Status::stick, 0), (std::vector<float>{3, 3, 3, 2, 2, 2}));
}

TEST(LiveCellValues, names_and_numbers_of_fields_fit) {
  for (std::size_t i = 0; i < kLiveFields; ++i) {
    const auto field = static_cast<LiveField>(i);
    EXPECT_EQ(live_field(name(field)), field);
    EXPECT_EQ(live_field(static_cast<double>(i)), field);
  }
  EXPECT_FALSE(live_field("colour"));
  for (const double wrong : {-1.0, 0.5, static_cast<double>(kLiveFields), std::nan("")})
    EXPECT_FALSE(live_field(wrong));
}

// --- the whole way ------------------------------------------------------------------------------------------------

TEST(LiveRoundTrip, frame_on_memory_queue_equals_the_runs_to_quantisation) {
  const auto bus = memory_bus();
  LiveReader reader(bus, "trip");
  Strip strip(300);
  coupling::Plan plan = plan_at(1000.0);
  LiveSink sink(plan.live, {"trip", "0.1.0", "abc"}, {}, bus);
  Model model = model_with_monitors(600);
  model.origin = {5.0e5, 4.0e6};
  sink.begin(model, plan);
  sink.frame(strip.frame);  // the mesh begins
  strip.move(0.25);
  sink.event({coupling::EventKind::stage_start, 0.0, "only", nullptr});
  coupling::TransferRow row;
  row.block = BlockId(3);
  row.from = "nmm";
  row.to = "dda";
  row.energy_error = 1e-12;
  sink.event({coupling::EventKind::transfer, 0.25, "block 3", &row});
  std::vector<double> xy(1200);
  std::iota(xy.begin(), xy.end(), 0.0);
  sink.history({0.25, ticks(0.25), xy, xy, xy, {}, &strip.state.ledger, &strip.stats});
  sink.frame(strip.frame);
  sink.end({coupling::RunEnd::Status::interrupted, "by hand"}, strip.frame);
  ASSERT_TRUE(
      reader.wait(5s, [](const LiveAssembly& a) { return a.info() && a.info()->status != "running" && a.frame(); }));

  const auto frame = reader.frame();
  ASSERT_EQ(frame->position.size(), strip.position.size());
  // Displacements span 0.5 to 1 m: the quantisation step is at most 1 m / 65534, the error half of that.
  for (std::size_t i = 0; i < strip.position.size(); ++i)
    EXPECT_NEAR(frame->position[i], strip.position[i], 0.51 / 65534.0);
  EXPECT_EQ(frame->header.time, 0.25);
  EXPECT_EQ(frame->header.step, 250);
  ASSERT_EQ(frame->scalar.size(), strip.block.size());
  const auto speed = [&](std::size_t p) { return std::hypot(strip.velocity[2 * p], strip.velocity[2 * p + 1]); };
  EXPECT_FLOAT_EQ(frame->scalar[0], static_cast<float>((speed(0) + speed(1) + speed(2) + speed(3)) / 4.0));
  const LiveMesh& mesh = *frame->mesh;
  EXPECT_EQ(mesh.id, 7);
  EXPECT_EQ(mesh.offsets, strip.offsets);
  EXPECT_EQ(mesh.connectivity, strip.connectivity);
  EXPECT_EQ(mesh.block, strip.block);
  EXPECT_EQ(mesh.material, strip.material);
  EXPECT_EQ(mesh.method, strip.method);
  EXPECT_EQ(mesh.methods, strip.mesh.methods);

  const std::vector<event_v1_t> events = reader.take_events();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].kind, "stage_start");
  EXPECT_EQ(events[1].text, "block 3");
  EXPECT_EQ(events[1].block, 3);
  EXPECT_EQ(events[1].to_method, "dda");
  EXPECT_EQ(events[1].energy_error, 1e-12);
  const auto history = reader.history();
  ASSERT_TRUE(history);
  EXPECT_EQ(history->names[599], "m599");
  EXPECT_EQ(history->position, xy);
  EXPECT_EQ(history->velocity, xy);
  const auto energy = reader.energy();
  ASSERT_TRUE(energy);
  ASSERT_EQ(energy->columns, coupling::kColumns);
  EXPECT_EQ(energy->name[0], "kinetic");
  EXPECT_EQ(energy->value[0], 12.5 * 0.25);
  EXPECT_EQ(energy->closure, strip.state.ledger.closure());
  const auto info = reader.info();
  EXPECT_EQ(info->status, "interrupted");
  EXPECT_EQ(info->reason, "by hand");
  EXPECT_EQ(info->title, "a strip");
  EXPECT_EQ(info->case_hash, "abc");
  EXPECT_EQ(info->origin[0], 5.0e5);
  EXPECT_EQ(info->origin[1], 4.0e6);
  EXPECT_NEAR(info->bounds[0], 5.0e5, 1e-4);  // float32 of half the width
  EXPECT_EQ(reader.counts().malformed, 0);
}

TEST(LiveRoundTrip, mesh_of_another_stage_replaces_the_first) {
  const auto bus = memory_bus();
  LiveReader reader(bus, "");
  Strip first(10, 1), second(20, 2);
  LiveSink sink(plan_at(1000.0).live, {"two"}, {}, bus);
  sink.begin(model_with_monitors(0), plan_at(1000.0));
  sink.frame(first.frame);
  ASSERT_TRUE(reader.wait(5s, [](const LiveAssembly& a) { return a.frame() != nullptr; }));
  EXPECT_EQ(reader.frame()->mesh->cells(), 10U);
  sink.end({}, second.frame);
  ASSERT_TRUE(reader.wait(5s, [](const LiveAssembly& a) { return a.frame()->mesh->id == 2; }));
  EXPECT_EQ(reader.frame()->position.size(), 84U);
  EXPECT_EQ(reader.counts().early, 0);
}

TEST(LiveKeyframes, viewer_that_comes_late_gets_everything_while_the_run_stands_still) {
  Recorder recorder;  // records the messages; the viewer below gets only those sent after its start
  Strip strip(10);
  const coupling::Plan plan = plan_at(1000.0);
  LiveSink sink(plan.live, {"late"}, {}, recorder.bus);
  sink.begin(model_with_monitors(2), plan);
  sink.event({coupling::EventKind::stage_start, 0.0, "only", nullptr});
  for (int i = 0; i < 15; ++i) sink.event({coupling::EventKind::step_cut, 0.0, std::to_string(i), nullptr});
  sink.frame(strip.frame);
  const std::vector<double> xy(4, 1.5);
  sink.history({0.25, ticks(0.25), xy, xy, xy, {}, &strip.state.ledger, &strip.stats});
  std::this_thread::sleep_for(500ms);
  recorder.drain();
  recorder.messages.clear();
  std::this_thread::sleep_for(2s);  // a long step: the run passes nothing to the sink
  recorder.drain();
  LiveAssembly late;
  for (const auto& [channel, bytes] : recorder.messages) EXPECT_TRUE(late.take(channel, bytes)) << channel;
  ASSERT_TRUE(late.frame());
  EXPECT_EQ(late.frame()->header.sequence, 0);
  ASSERT_TRUE(late.history());
  EXPECT_EQ(late.history()->position, xy);
  EXPECT_TRUE(late.energy());
  ASSERT_TRUE(late.info());
  EXPECT_EQ(late.info()->status, "running");
  const auto events = late.take_events();
  ASSERT_EQ(events.size(), 1 + LivePublisher::kEventsAgain);
  EXPECT_EQ(events.front().text, "only") << "cuts do not crowd out a stage";
  EXPECT_EQ(events[1].text, "5");
  EXPECT_EQ(events.back().text, "14");
  sink.end({}, strip.frame);
}

TEST(LiveKeyframes, things_sent_again_are_not_news) {
  Strip strip(3);
  LiveAssembly assembly;
  const auto messages = short_run(strip, 0.5);
  for (int round = 0; round < 3; ++round)
    for (auto [channel, bytes] : messages) {
      stamp(bytes, 1000 + round);
      EXPECT_TRUE(assembly.take(channel, bytes)) << channel;
    }
  EXPECT_EQ(assembly.counts().frames, 1);
  EXPECT_EQ(assembly.counts().events, 1);
  EXPECT_EQ(assembly.counts().incomplete, 0);
  EXPECT_EQ(assembly.take_events().size(), 1U);
  EXPECT_EQ(assembly.info()->header.utime, 1002);
}

TEST(LiveContacts, worst_ones_are_named_in_info) {
  const auto bus = memory_bus();
  LiveReader reader(bus, "");
  Strip strip(3);
  const auto contact = [](std::int32_t p, std::int32_t e, coupling::ContactStatus status, double gap, double fn) {
    coupling::ContactMemory c;
    c.key = {p, 0, 2, 0, e, 0, 1};
    c.status = status;
    c.gap = gap;
    c.fn = fn;
    return c;
  };
  using enum coupling::ContactStatus;
  strip.state.contacts.memory = {contact(0, 1, open, -9.0, 9e9), contact(1, 0, stick, -2e-6, 5.0),
                                 contact(0, 5, slip, -1e-6, 7.0)};
  Model model = model_with_monitors(0);
  model.blocks.resize(2);
  model.blocks[0].name = "toe";
  model.blocks[1].name = "wedge";
  LiveSink sink(plan_at(1000.0).live, {"c"}, {}, bus);
  sink.begin(model, plan_at(1000.0));
  sink.end({}, strip.frame);
  ASSERT_TRUE(reader.wait(5s, [](const LiveAssembly& a) { return a.info() && a.info()->status == "done"; }));
  const auto info = reader.info();
  EXPECT_EQ(info->contact_depth, 2e-6);
  EXPECT_EQ(info->contact_depth_at, "wedge corner 2 on toe edge 1");
  EXPECT_EQ(info->contact_force, 7.0);
  EXPECT_EQ(info->contact_force_at, "toe corner 2 on block 5 edge 1");
}

// --- the run is not held up ---------------------------------------------------------------------------------------

TEST(LiveRate, frames_are_taken_at_most_at_the_rate_of_the_plan) {
  Recorder recorder;
  Strip strip(10);
  LiveSink sink(plan_at(20.0).live, {"rate"}, {}, recorder.bus);
  sink.begin(model_with_monitors(0), plan_at(20.0));
  const auto start = std::chrono::steady_clock::now();
  int offered = 0;
  while (std::chrono::steady_clock::now() - start < 500ms) {
    sink.frame(strip.frame);
    ++offered;
    std::this_thread::sleep_for(1ms);
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  sink.end({}, strip.frame);
  EXPECT_LE(sink.frames_sent(), static_cast<std::int64_t>(20.0 * wall) + 2);  // 2: the first and the last frame
  EXPECT_GE(sink.frames_sent(), 2);
  EXPECT_EQ(sink.frames_sent() + sink.frames_skipped(), offered + 1);
}

TEST(LiveRate, sink_reads_nothing_after_the_call_and_does_not_wait) {
  const auto bus = memory_bus();
  LiveReader reader(bus, "");
  Strip strip(50000);
  LiveSink sink(plan_at(1e6).live, {"fast"}, {}, bus);
  sink.begin(model_with_monitors(0), plan_at(1e6));
  double longest = 0.0;
  for (int i = 0; i < 50; ++i) {
    strip.move(0.01 * i);
    const auto start = std::chrono::steady_clock::now();
    sink.frame(strip.frame);
    longest = std::max(longest, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    std::fill(strip.position.begin(), strip.position.end(), std::nan(""));  // the sink must not read these any more
    std::fill(strip.velocity.begin(), strip.velocity.end(), std::nan(""));
  }
  strip.move(0.6);
  sink.end({}, strip.frame);
  ASSERT_TRUE(reader.wait(20s, [](const LiveAssembly& a) { return a.frame() && a.frame()->header.time == 0.6; }));
  for (const double x : reader.frame()->position) ASSERT_TRUE(std::isfinite(x));
  EXPECT_GT(sink.frames_skipped(), 0) << "a copy of 3 MB may not take more than a hundredth of the time";
  EXPECT_LT(longest, 0.25) << "one copy; the bound leaves room for a loaded machine";
}

TEST(LiveFile, log_of_a_run_is_read_back) {
  const std::string path =
      (std::filesystem::temp_directory_path() / ("scree-" + std::to_string(getpid()) + ".lcm")).string();
  Strip strip(100);
  coupling::Plan plan = plan_at(1000.0);
  plan.live.url = "file://" + path;
  {
    LiveSink sink(plan.live, {"logged"}, [](const std::string& text) { ADD_FAILURE() << text; });
    sink.begin(model_with_monitors(1), plan);
    strip.move(0.5);
    sink.end({}, strip.frame);
  }
  std::string why;
  const auto reader = LiveReader::open("file://" + path + "?speed=0", "logged", why);
  ASSERT_TRUE(reader) << why;
  EXPECT_TRUE(
      reader->wait(5s, [](const LiveAssembly& a) { return a.frame() && a.info() && a.info()->status == "done"; }));
  std::filesystem::remove(path);
}

TEST(LiveFile, log_that_cannot_be_made_gives_one_warning_and_the_run_goes_on) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("scree-gone-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  Strip strip(10);
  coupling::Plan plan = plan_at(1000.0);
  plan.live.url = "file://" + (folder / "x.lcm").string();
  int warnings = 0;
  LiveSink sink(plan.live, {"gone"}, [&](const std::string&) { ++warnings; });
  std::filesystem::remove_all(folder);  // removed between the check and the start
  sink.begin(model_with_monitors(0), plan);
  for (int i = 0; i < 20; ++i) {
    sink.frame(strip.frame);
    std::this_thread::sleep_for(2ms);
  }
  sink.end({}, strip.frame);
  EXPECT_EQ(warnings, 1);
  EXPECT_EQ(sink.frames_sent(), 0);
}

}  // namespace
}  // namespace scree::io::live_test
