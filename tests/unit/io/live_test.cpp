// Live streaming: what a reader puts together is what the run had; anything damaged is dropped; nothing stops the run.
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
#include "io/live/live_publisher.h"
#include "io/live/live_reader.h"
#include "io/live/live_sink.h"
#include "io/live/quantise.h"
#include "io/live/split.h"
#include "io/live/take_apart.h"

namespace scree::io {
namespace {

using namespace std::chrono_literals;
using coupling::FrameView;
using coupling::MeshView;

/// A strip of n quadrilaterals that moves, with the views a driver would give.
struct Strip {
  std::vector<double> origin, position, velocity, stress;
  std::vector<std::int32_t> offsets{0}, connectivity, block, material, method;
  MeshView mesh;
  FrameView frame;
  coupling::RunStats stats;
  coupling::State state;

  explicit Strip(std::int32_t cells, std::uint32_t id = 7) {
    for (std::int32_t i = 0; i <= cells; ++i)
      for (int j = 0; j < 2; ++j) origin.insert(origin.end(), {5.0e5 + 0.1 * i, 4.0e6 + 0.1 * j});  // as in a survey
    for (std::int32_t c = 0; c < cells; ++c) {
      for (const std::int32_t p : {2 * c, 2 * c + 2, 2 * c + 3, 2 * c + 1}) connectivity.push_back(p);
      offsets.push_back(4 * (c + 1));
      block.push_back(c / 3);
      material.push_back(c % 2);
      method.push_back(c % 2);
    }
    mesh.id = id;
    mesh.offsets = offsets;
    mesh.connectivity = connectivity;
    mesh.cell_block = block;
    mesh.cell_material = material;
    mesh.cell_method = method;
    mesh.origin = origin;
    mesh.methods = {"nmm", "dda"};
    move(0.0);
  }
  Strip(const Strip&) = delete;
  Strip& operator=(const Strip&) = delete;

  void move(double t) {
    position = origin;
    velocity.clear();
    for (std::size_t p = 0; p < origin.size() / 2; ++p) {
      const double phase = 0.37 * static_cast<double>(p);
      position[2 * p] += t * std::sin(phase);
      position[2 * p + 1] -= 2.0 * t * std::cos(phase);
      velocity.insert(velocity.end(), {std::sin(phase), -2.0 * std::cos(phase)});
    }
    stress.assign(3 * block.size(), 0.0);
    for (std::size_t c = 0; c < block.size(); ++c)
      stress[3 * c] = -1000.0 * static_cast<double>(c), stress[3 * c + 1] = 500.0;
    frame.time = t;
    frame.end_time = 10.0;
    frame.step = static_cast<std::int64_t>(1000 * t);
    frame.stage_name = "only";
    frame.position = position;
    frame.velocity = velocity;
    frame.stress = stress;
    frame.mesh = &mesh;
    frame.stats = &stats;
    frame.state = &state;
    stats.steps = frame.step;
    state.ledger.set(coupling::Column::kinetic, 12.5 * t);
  }
};

Model model_with_monitors(int count) {
  Model model;
  model.title = "a strip";
  for (int i = 0; i < count; ++i) model.monitors.push_back({"m" + std::to_string(i), BlockId(0), {0.0, 0.0}});
  return model;
}

coupling::Plan plan_at(double rate) {
  coupling::Plan plan;
  plan.live.enabled = true;
  plan.live.url = "memq://";
  plan.live.rate = rate;
  plan.stages.emplace_back();
  plan.stages[0].duration = ticks(10.0);
  return plan;
}

std::shared_ptr<LiveBus> memory_bus() {
  std::string why;
  return LiveBus::open("memq://", LiveSide::sender, why);
}

/// Every message of a sink, recorded on a bus of its own.
struct Recorder {
  std::shared_ptr<LiveBus> bus = memory_bus();
  std::vector<std::pair<std::string, Bytes>> messages;

  Recorder() {
    bus->subscribe("SCREE_.*", [this](std::string_view channel, std::span<const std::uint8_t> bytes) {
      messages.emplace_back(channel, Bytes(bytes.begin(), bytes.end()));
    });
  }
  void drain() {
    while (bus->handle(0) == LiveBus::Got::message) {
    }
  }
};

/// All messages of a short run. The mesh begins at t = 0; only the last frame is sent.
std::vector<std::pair<std::string, Bytes>> short_run(Strip& strip, double t) {
  Recorder recorder;
  LiveSink sink(plan_at(0.0).live, {"short"}, {}, recorder.bus);
  sink.begin(model_with_monitors(2), plan_at(0.0));
  strip.move(0.0);
  sink.frame(strip.frame);
  strip.move(t);
  sink.event({coupling::EventKind::stage_start, 0.0, "only", nullptr});
  sink.end({}, strip.frame);
  recorder.drain();
  return recorder.messages;
}

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

TEST(LiveCellValues, both_fields_are_means_of_the_cell) {
  Strip strip(2);
  RawFrame raw;
  raw.mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(strip.mesh));
  raw.source = std::vector<double>(strip.origin.size(), 0.0);
  raw.source[0] = 3.0;  // corner 0 belongs to the first cell alone
  raw.source[1] = 4.0;
  EXPECT_EQ(cell_values(raw, LiveField::speed), (std::vector<float>{1.25F, 0.0F}));
  raw.source = strip.stress;
  EXPECT_EQ(cell_values(raw, LiveField::mean_stress), (std::vector<float>{250.0F, -250.0F}));
}

// --- the whole way ------------------------------------------------------------------------------------------------

TEST(LiveRoundTrip, frame_on_memory_queue_equals_the_runs_to_quantisation) {
  const auto bus = memory_bus();
  LiveReader reader(bus, "trip");
  Strip strip(300);
  coupling::Plan plan = plan_at(1000.0);
  LiveSink sink(plan.live, {"trip", "0.1.0", "abc"}, {}, bus);
  sink.begin(model_with_monitors(600), plan);
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
  sink.history({0.25, ticks(0.25), xy, xy, xy, &strip.state.ledger, &strip.stats});
  sink.frame(strip.frame);
  sink.end({coupling::RunEnd::Status::interrupted, "by hand"}, strip.frame);
  ASSERT_TRUE(
      reader.wait(5s, [](const LiveAssembly& a) { return a.info() && a.info()->status != "running" && a.frame(); }));

  const auto frame = reader.frame();
  ASSERT_EQ(frame->position.size(), strip.position.size());
  // Displacements span 0.5 to 1 m: a step is 1 m / 65534 at most, and the error half of it.
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
  Recorder recorder;  // keeps what passes; the viewer below sees only what came after its start
  Strip strip(10);
  const coupling::Plan plan = plan_at(1000.0);
  LiveSink sink(plan.live, {"late"}, {}, recorder.bus);
  sink.begin(model_with_monitors(2), plan);
  sink.event({coupling::EventKind::stage_start, 0.0, "only", nullptr});
  for (int i = 0; i < 15; ++i) sink.event({coupling::EventKind::step_cut, 0.0, std::to_string(i), nullptr});
  sink.frame(strip.frame);
  const std::vector<double> xy(4, 1.5);
  sink.history({0.25, ticks(0.25), xy, xy, xy, &strip.state.ledger, &strip.stats});
  std::this_thread::sleep_for(500ms);
  recorder.drain();
  recorder.messages.clear();
  std::this_thread::sleep_for(2s);  // one step that takes long: nothing is handed over
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
  strip.state.contacts = {contact(0, 1, open, -9.0, 9e9), contact(1, 0, stick, -2e-6, 5.0),
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

/// Strip whose blocks have points of their own, as DDA and NMM bodies do: `blocks` of `cells` quadrilaterals each.
struct Blocks {
  std::vector<double> origin, position, velocity, stress;
  std::vector<std::int32_t> offsets{0}, connectivity, block, zero;
  MeshView mesh;
  FrameView frame;

  Blocks(std::int32_t blocks, std::int32_t cells) {
    for (std::int32_t b = 0; b < blocks; ++b) {
      const auto first = static_cast<std::int32_t>(origin.size() / 2);
      for (std::int32_t i = 0; i <= cells; ++i)
        for (int j = 0; j < 2; ++j) origin.insert(origin.end(), {5.0e5 + 4.0 * b + 3.0 * i / cells, 4.0e6 + 2.0 * j});
      for (std::int32_t c = 0; c < cells; ++c) {
        for (const std::int32_t p : {2 * c, 2 * c + 2, 2 * c + 3, 2 * c + 1}) connectivity.push_back(first + p);
        offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
        block.push_back(100 - b);  // in no order
      }
    }
    zero.assign(block.size(), 0);
    velocity.assign(origin.size(), 0.0);
    stress.assign(3 * block.size(), 0.0);
    mesh.id = 3;
    mesh.offsets = offsets;
    mesh.connectivity = connectivity;
    mesh.cell_block = block;
    mesh.cell_material = zero;
    mesh.cell_method = zero;
    mesh.origin = origin;
    mesh.methods = {"any"};
    move([](std::size_t, double x, double y) { return std::array{x, y}; });
  }
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;
  template <class Where>
  void move(Where&& where) {
    position.resize(origin.size());
    for (std::size_t p = 0; p < origin.size() / 2; ++p) {
      const auto [x, y] = where(p, origin[2 * p] - 5.0e5, origin[2 * p + 1] - 4.0e6);
      position[2 * p] = 5.0e5 + x;
      position[2 * p + 1] = 4.0e6 + y;
    }
    frame.position = position;
    frame.velocity = velocity;
    frame.stress = stress;
    frame.mesh = &mesh;
  }
  [[nodiscard]] LiveFrame live(const std::shared_ptr<const LiveMesh>& its_mesh) const {
    LiveFrame f;
    f.mesh = its_mesh;
    f.header.topology_id = 3;
    f.position = position;
    f.scalar.assign(block.size(), 0.0F);
    return f;
  }
};

/// What comes out at the far end, and how many maps and loose points travelled.
struct Travelled {
  std::shared_ptr<const LiveFrame> frame;
  std::int32_t maps = 0, loose = 0;
};
Travelled travel(const LiveFrame& frame) {
  Travelled result;
  LiveAssembly assembly;
  send_mesh(frame.header, encode_mesh(*frame.mesh), [&](const Bytes& b) { assembly.take("SCREE_x_TOPO", b); });
  send_frame(frame, [&](const Bytes& b) {
    const auto message = unseal<state_v1_t>(b);
    ASSERT_TRUE(message);
    result.maps = message->total_maps;
    result.loose = message->total_points;
    EXPECT_TRUE(assembly.take("SCREE_x_STATE", b));
  });
  result.frame = assembly.frame();
  return result;
}

TEST(LiveMaps, block_that_turns_far_travels_as_a_map_and_arrives_in_float32) {
  Blocks blocks(5, 4);
  const auto mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(blocks.mesh, blocks.position));
  const double c = std::cos(2.5), s = std::sin(2.5);
  blocks.move([&](std::size_t, double x, double y) { return std::array{30.0 + c * x - s * y, s * x + 1.001 * c * y}; });
  const Travelled far = travel(blocks.live(mesh));
  EXPECT_EQ(far.maps, 5);
  EXPECT_EQ(far.loose, 0);
  ASSERT_TRUE(far.frame);
  // Displacements reach 70 m: a few units of 6e-8 each.
  for (std::size_t i = 0; i < blocks.position.size(); ++i)
    EXPECT_NEAR(far.frame->position[i], blocks.position[i], 4.0 * 70.0 * 0x1p-24);
}

TEST(LiveMaps, block_deformed_before_the_mesh_began_still_has_a_map) {
  Blocks blocks(1, 4);
  const auto bend = [](double x, double y) { return std::array{x, y + 0.05 * x * x}; };
  blocks.move([&](std::size_t, double x, double y) { return bend(x, y); });
  const auto mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(blocks.mesh, blocks.position));
  blocks.move([&](std::size_t, double x, double y) {
    const auto [bx, by] = bend(x, y);
    return std::array{-by, bx};
  });
  EXPECT_EQ(travel(blocks.live(mesh)).maps, 1);
  const auto undeformed = std::make_shared<const LiveMesh>(LiveMesh::copy(blocks.mesh));
  EXPECT_EQ(travel(blocks.live(undeformed)).maps, 0) << "the same motion is not affine from where the model had it";
}

TEST(LiveMaps, block_that_bends_travels_as_displacements_and_spoils_no_other) {
  Blocks blocks(3, 4);
  const auto mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(blocks.mesh, blocks.position));
  blocks.move([&](std::size_t p, double x, double y) {
    const bool second = p >= 10 && p < 20, third = p >= 20;
    return std::array{x + (third ? 0.5 : 0.0), y + (second ? 0.01 * x * x : 0.0)};
  });
  const Travelled far = travel(blocks.live(mesh));
  EXPECT_EQ(far.maps, 2);
  EXPECT_EQ(far.loose, 10);
  ASSERT_TRUE(far.frame);
  for (std::size_t i = 0; i < blocks.position.size(); ++i)  // the bend spans 0.33 m at most
    EXPECT_NEAR(far.frame->position[i], blocks.position[i], i / 2 >= 10 && i / 2 < 20 ? 0.34 / 65534.0 : 1e-7);
}

TEST(LiveMaps, point_that_is_not_finite_makes_its_block_loose) {
  Blocks blocks(2, 2);
  const auto mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(blocks.mesh, blocks.position));
  blocks.position[3] = std::nan("");
  const Travelled far = travel(blocks.live(mesh));
  EXPECT_EQ(far.maps, 1);
  ASSERT_TRUE(far.frame);
  EXPECT_TRUE(std::isnan(far.frame->position[3]));
  EXPECT_EQ(far.frame->position[2], blocks.position[2]);
}

TEST(LiveMaps, maps_that_do_not_make_up_the_mesh_are_refused) {
  Blocks blocks(2, 2);
  const auto mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(blocks.mesh, blocks.position));
  const LiveFrame frame = blocks.live(mesh);
  const auto verdict = [&](const std::function<void(state_v1_t&)>& spoil) {
    LiveAssembly assembly;
    send_mesh(frame.header, encode_mesh(*mesh), [&](const Bytes& b) { assembly.take("SCREE_x_TOPO", b); });
    bool taken = false;
    send_frame(frame, [&](const Bytes& b) {
      auto message = unseal<state_v1_t>(b);
      spoil(*message);
      taken = assembly.take("SCREE_x_STATE", seal(*message));
    });
    return taken && assembly.frame() != nullptr;
  };
  EXPECT_TRUE(verdict([](state_v1_t&) {}));
  EXPECT_FALSE(verdict([](state_v1_t& m) { m.body = {0, 0}; }));
  EXPECT_FALSE(verdict([](state_v1_t& m) { m.body = {1, 0}; }));
  EXPECT_FALSE(verdict([](state_v1_t& m) { m.body = {0, 2}; }));
  EXPECT_FALSE(verdict([](state_v1_t& m) { m.body = {-1, 1}; }));
  EXPECT_FALSE(verdict([](state_v1_t& m) {
    m.total_maps = m.maps = 1;
    for (auto* list : {&m.ux, &m.uy, &m.xx, &m.xy, &m.yx, &m.yy}) list->resize(1);
    m.body.resize(1);
  }));
}

TEST(LiveChunks, mesh_of_100000_points_makes_no_message_above_60_kb) {
  Strip strip(50000);
  const auto messages = short_run(strip, 0.5);
  LiveAssembly assembly;
  std::int64_t state_messages = 0;
  for (const auto& [channel, bytes] : messages) {
    EXPECT_LE(bytes.size(), 60000U) << channel;
    EXPECT_TRUE(assembly.take(channel, bytes)) << channel;
    if (channel_kind(channel) == LiveKind::state) ++state_messages;
  }
  EXPECT_EQ(state_messages, frame_chunks(0, 100002, 50000));
  ASSERT_TRUE(assembly.frame());
  // Each chunk has its own scale; displacements span 2 m at most, so the error is below half of 2 m / 65534.
  for (std::size_t i = 0; i < strip.position.size(); ++i)
    ASSERT_NEAR(assembly.frame()->position[i], strip.position[i], 1.01 / 65534.0);
}

TEST(LiveChunks, lost_chunk_loses_its_frame_only_and_the_next_one_completes) {
  Strip strip(20000);
  const std::vector<std::pair<std::string, Bytes>> messages = short_run(strip, 0.5);
  LiveAssembly assembly;
  int states = 0;
  for (const auto& [channel, bytes] : messages)
    if (channel_kind(channel) != LiveKind::state || ++states != 2) assembly.take(channel, bytes);
  EXPECT_FALSE(assembly.frame());

  LiveFrame next;
  next.mesh = assembly.mesh();
  next.header.session = assembly.info()->header.session;
  next.header.topology_id = 7;
  next.header.sequence = 1;
  next.position.assign(strip.position.size(), 0.0);
  next.scalar.assign(strip.block.size(), 0.0F);
  send_frame(next, [&](const Bytes& bytes) { assembly.take("SCREE_short_STATE", bytes); });
  ASSERT_TRUE(assembly.frame());
  EXPECT_EQ(assembly.counts().incomplete, 1);
  EXPECT_EQ(assembly.counts().frames, 1);
}

TEST(LiveChunks, mesh_lost_in_part_is_completed_by_the_next_sending) {
  Strip strip(20000);
  const auto messages = short_run(strip, 0.5);
  LiveAssembly assembly;
  int part = 0;
  for (const auto& [channel, bytes] : messages)
    if (channel_kind(channel) == LiveKind::topo && part++ % 2 == 0) assembly.take(channel, bytes);
  EXPECT_FALSE(assembly.mesh());
  part = 0;
  for (const auto& [channel, bytes] : messages)
    if (channel_kind(channel) == LiveKind::topo && part++ % 2 == 1) assembly.take(channel, bytes);
  ASSERT_TRUE(assembly.mesh());
  EXPECT_EQ(assembly.mesh()->points(), 40002U);
}

// --- damage -------------------------------------------------------------------------------------------------------

TEST(LiveDamage, message_with_any_byte_changed_is_dropped_and_counted) {
  Strip strip(10);
  for (const auto& [channel, bytes] : short_run(strip, 0.5)) {
    LiveAssembly assembly;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      Bytes bad = bytes;
      bad[i] ^= 0x10U;
      EXPECT_FALSE(assembly.take(channel, bad)) << channel << " byte " << i;
    }
    EXPECT_EQ(assembly.counts().malformed, static_cast<std::int64_t>(bytes.size()));
  }
}

TEST(LiveDamage, forged_lengths_under_a_right_crc_are_dropped) {
  std::vector<std::pair<std::string, Bytes>> meshes, messages;
  Strip strip(10);
  for (auto& message : short_run(strip, 0.5))
    (channel_kind(message.first) == LiveKind::topo ? meshes : messages).push_back(message);
  Blocks blocks(3, 2);  // with maps
  LiveFrame frame = blocks.live(std::make_shared<const LiveMesh>(LiveMesh::copy(blocks.mesh)));
  frame.header.session = unseal<info_v1_t>(messages.back().second)->header.session;
  send_mesh(frame.header, encode_mesh(*frame.mesh),
            [&](const Bytes& b) { meshes.emplace_back("SCREE_short_TOPO", b); });
  send_frame(frame, [&](const Bytes& b) { messages.emplace_back("SCREE_short_STATE", b); });
  messages.insert(messages.end(), meshes.begin(), meshes.end());

  std::mt19937 random(11);
  std::set<LiveKind> taken;
  for (const auto& message : messages)
    for (const auto& mesh : meshes) {
      const std::string& channel = message.first;
      const Bytes& bytes = message.second;
      LiveAssembly assembly;
      std::int64_t dropped = 0;
      const auto forge = [&](Bytes bad) {
        write_crc(bad);
        // Each forgery meets a mesh; one that passes for a later session makes the assembly forget it.
        if (!assembly.mesh() || assembly.frame()) {
          assembly = LiveAssembly{};
          assembly.take(mesh.first, mesh.second);
        }
        if (assembly.take(channel, bad))  // it hit a number; must not crash (run under asan)
          taken.insert(*channel_kind(channel));
        else
          ++dropped;
      };
      for (std::size_t i = 0; i + 4 < bytes.size(); ++i)  // every place where a length could stand
        for (const std::uint32_t value :
             {0x7FFFFFFFU, 0x40000000U, 0x20000001U, 0xFFFFFFFFU, 0x80000000U, 0U, 1U, 100000U}) {
          Bytes bad = bytes;
          for (std::size_t k = 0; k < 4; ++k) bad[i + k] = static_cast<std::uint8_t>(value >> (24U - 8U * k));
          forge(std::move(bad));
        }
      for (int trial = 0; trial < 2000; ++trial) {
        Bytes bad = bytes;
        if (trial % 2 == 0) bad.resize(4 + random() % bad.size());
        for (int k = 0; k < 3; ++k) bad[random() % bad.size()] = static_cast<std::uint8_t>(random());
        forge(std::move(bad));
      }
      EXPECT_GT(dropped, 1000) << channel;
    }
  EXPECT_TRUE(taken.contains(LiveKind::state)) << "forgeries of frames must come as far as their mesh";
}

TEST(LiveDamage, layouts_describe_the_generated_types) {
  Strip strip(3);
  const Bytes mesh = encode_mesh(LiveMesh::copy(strip.mesh));
  EXPECT_TRUE(fits(layout<mesh_v1_t>(), std::span(mesh).subspan(8)));
  EXPECT_TRUE(decode_mesh(mesh, LiveAssembly::kMaxMesh));
  std::set<LiveKind> seen;
  LiveAssembly assembly;
  for (const auto& [channel, bytes] : short_run(strip, 0.5)) {
    EXPECT_TRUE(assembly.take(channel, bytes)) << channel;
    seen.insert(*channel_kind(channel));
  }
  EXPECT_TRUE(seen.contains(LiveKind::info) && seen.contains(LiveKind::topo) && seen.contains(LiveKind::state) &&
              seen.contains(LiveKind::energy) && seen.contains(LiveKind::event));
}

TEST(LiveDamage, mesh_with_indices_out_of_range_is_refused) {
  Strip strip(3);
  LiveMesh mesh = LiveMesh::copy(strip.mesh);
  mesh.connectivity[5] = 8;  // points 0 to 7
  EXPECT_FALSE(decode_mesh(encode_mesh(mesh), LiveAssembly::kMaxMesh));
  mesh = LiveMesh::copy(strip.mesh);
  mesh.method[1] = 2;
  EXPECT_FALSE(decode_mesh(encode_mesh(mesh), LiveAssembly::kMaxMesh));
  mesh = LiveMesh::copy(strip.mesh);
  mesh.offsets[1] = -1;
  EXPECT_FALSE(decode_mesh(encode_mesh(mesh), LiveAssembly::kMaxMesh));
}

TEST(LiveDamage, later_session_replaces_an_earlier_one) {
  Strip strip(3);
  const auto first = short_run(strip, 0.5), second = short_run(strip, 0.75);
  LiveAssembly assembly;
  for (const auto& [channel, bytes] : first) assembly.take(channel, bytes);
  for (const auto& [channel, bytes] : second) assembly.take(channel, bytes);
  for (const auto& [channel, bytes] : first) EXPECT_FALSE(assembly.take(channel, bytes));
  EXPECT_EQ(assembly.frame()->header.time, 0.75);
  EXPECT_EQ(assembly.counts().other, static_cast<std::int64_t>(first.size()));
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
  EXPECT_LE(sink.frames_sent(), static_cast<std::int64_t>(20.0 * wall) + 2);  // + the first and the last
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
    std::fill(strip.position.begin(), strip.position.end(), std::nan(""));  // poison what the sink may no longer see
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
  std::filesystem::remove_all(folder);  // between the check and the start
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
}  // namespace scree::io
