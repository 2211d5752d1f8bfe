// Messages for the page: a run sends on the memory queue; the slots are decoded by the documented layout.
#include "io/serve/live_site.h"

#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "io/live/live_field.h"
#include "io/serve/control_bridge.h"
#include "tests/unit/io/live_strip.h"

namespace scree::io::test::live_site_test {
namespace {

using namespace std::chrono_literals;
using Json = nlohmann::json;

struct Message {
  Json head;
  std::map<std::string, std::vector<double>> arrays;
};

std::uint32_t word(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  std::uint32_t out = 0;
  for (unsigned k = 0; k < 4; ++k) out |= static_cast<std::uint32_t>(bytes.at(at + k)) << 8U * k;
  return out;
}

Message decoded(const Slot& slot) {
  const std::vector<std::uint8_t>& bytes = *slot.message;
  const std::size_t begin = 4 + word(bytes, 0);
  Message out{Json::parse(bytes.begin() + 4, bytes.begin() + static_cast<std::ptrdiff_t>(begin)), {}};
  if (bytes.size() == begin) return out;
  const std::size_t count = word(bytes, begin);
  std::size_t at = begin + 4 + 24 * count;
  for (std::size_t a = 0; a < count; ++a) {
    const std::size_t head = begin + 4 + 24 * a;
    std::vector<double>& values = out.arrays[reinterpret_cast<const char*>(&bytes[head])];
    const std::size_t length = word(bytes, head + 20);
    if (word(bytes, head + 16) == 2) {  // bytes
      for (std::size_t i = 0; i < length; ++i) values.push_back(static_cast<double>(bytes.at(at + i)));
      at += length;
      continue;
    }
    for (std::size_t i = 0; i < length; ++i) {
      std::uint32_t bits = 0;
      for (unsigned k = 0; k < 4; ++k) bits |= static_cast<std::uint32_t>(bytes.at(at + k * length + i)) << 8U * k;
      values.push_back(word(bytes, head + 16) == 0 ? static_cast<double>(std::bit_cast<float>(bits))
                                                   : static_cast<double>(std::bit_cast<std::int32_t>(bits)));
    }
    at += 4 * length;
  }
  EXPECT_EQ(at, bytes.size());
  return out;
}

enum Place : std::size_t {
  run_slot,
  mesh_slot,
  frame_slot,
  rows_slot,
  status_slot,
  events_slot,
  answer_slot,
  model_slot,
  detail_slot
};

/// Polls the site like a server until a condition holds.
template <class Holds>
bool refreshed(LiveSite& site, Holds&& holds) {
  for (int i = 0; i < 500; ++i) {
    site.refresh();
    if (holds(site.slots())) return true;
    std::this_thread::sleep_for(10ms);
  }
  return false;
}
/// Like refreshed(), while the run sends a frame repeatedly, because the sink skips frames on a busy machine.
template <class Holds>
bool refreshed_with(LiveSite& site, LiveSink& sink, const FrameView& frame, Holds&& holds) {
  return refreshed(site, [&](std::span<const Slot> slots) {
    if (holds(slots)) return true;
    sink.frame(frame);
    return false;
  });
}
bool all_known(std::span<const Slot> slots) {
  return std::all_of(slots.begin(), slots.begin() + answer_slot, [](const Slot& s) { return s.version > 0; });
}

bool all_but_events_known(std::span<const Slot> slots) {
  return std::all_of(slots.begin(), slots.begin() + events_slot, [](const Slot& s) { return s.version > 0; });
}

/// A run that has begun, far from the origin of its coordinates, and the page that receives it.
struct Trip {
  std::shared_ptr<LiveBus> bus = memory_bus();
  LiveSite site{bus, ""};
  Strip strip{30};
  LiveSink sink{plan_at(1000.0).live, {"trip", "0.1.0"}, {}, bus};
  explicit Trip(int monitors) {
    Model model = model_with_monitors(monitors);
    model.origin = {7.0, -3.0};
    sink.begin(model, plan_at(1000.0));
  }
};

TEST(LiveSite, waits_until_something_streams) {
  LiveSite site(memory_bus(), "late <b>");
  EXPECT_TRUE(site.refresh());
  const std::span<const Slot> slots = site.slots();
  ASSERT_EQ(slots.size(), 9U);
  EXPECT_TRUE(slots[run_slot].first && slots[mesh_slot].first && slots[frame_slot].paced);
  const Json status = decoded(slots[status_slot]).head;
  EXPECT_EQ(status["status"], "waiting");
  EXPECT_EQ(status["run"], "late <b>");
  EXPECT_EQ(slots[frame_slot].version, 0U);
  const auto page = site.find("/");
  ASSERT_TRUE(page);
  const std::string html(page->body->begin(), page->body->end());
  EXPECT_NE(html.find("<title>late &lt;b&gt;</title>"), std::string::npos);
  EXPECT_NE(html.find("data-source=\"live\""), std::string::npos);
  for (const char* path : {"/run.json", "/frame/0", "/mesh/0", "/history", "/live"})
    EXPECT_FALSE(site.find(path)) << path;
}

TEST(LiveSite, frames_rows_and_events_are_those_of_the_run) {
  Trip trip(2);
  LiveSite& site = trip.site;
  Strip& strip = trip.strip;
  LiveSink& sink = trip.sink;
  sink.event({coupling::EventKind::stage_start, 0.0, "only </script>", nullptr});
  const std::vector<double> at{5.0e5 + 3.0, 4.0e6 + 2.0, 5.0e5 + 4.0, 4.0e6 + 2.0}, u{1.0, 2.0, 0.5, 0.25},
      v{0.1, 0.2, 0.3, 0.4};
  sink.history({0.0, 0, at, u, v, {}, &strip.state.ledger, &strip.stats});
  ASSERT_TRUE(refreshed_with(site, sink, strip.frame, all_known));
  const Json run = decoded(site.slots()[run_slot]).head;
  EXPECT_EQ(run["title"], "a strip");
  EXPECT_EQ(run["run"], "trip");
  EXPECT_EQ(run["control"], false);
  EXPECT_EQ(run["blocks"], 10);
  EXPECT_EQ(run["materials"], 2);
  const double x0 = run["origin"][0].get<double>() - 7.0, y0 = run["origin"][1].get<double>() + 3.0;  // the base

  const std::uint64_t before = site.slots()[frame_slot].version, mesh_before = site.slots()[mesh_slot].version;
  strip.move(0.25);
  ASSERT_TRUE(refreshed_with(site, sink, strip.frame, [&](auto slots) { return slots[frame_slot].version > before; }));
  EXPECT_EQ(site.slots()[mesh_slot].version, mesh_before) << "a mesh is sent once";
  const Message mesh = decoded(site.slots()[mesh_slot]), frame = decoded(site.slots()[frame_slot]);
  EXPECT_EQ(mesh.head["mesh"], frame.head["mesh"]);
  EXPECT_EQ(mesh.head["methods"], (Json{"nmm", "dda"}));
  EXPECT_EQ(frame.head["stage"], "only");
  EXPECT_EQ(frame.head["field"], "speed");
  EXPECT_DOUBLE_EQ(frame.head["time"], 0.25);
  const auto& origin = mesh.arrays.at("origin");
  const auto& displacement = frame.arrays.at("displacement");
  ASSERT_EQ(displacement.size(), strip.position.size());
  for (std::size_t i = 0; i < displacement.size(); ++i)  // 16 bits of 1 m; float32 of the base
    EXPECT_NEAR(origin[i] + displacement[i] + (i % 2 == 0 ? x0 : y0), strip.position[i], 1e-4) << i;
  EXPECT_EQ(frame.arrays.at("scalar").size(), 30U);
  EXPECT_EQ(mesh.arrays.at("block")[7], 2.0);
  EXPECT_EQ(mesh.arrays.at("offsets").back(), 120.0);

  const Json rows = decoded(site.slots()[rows_slot]).head;
  EXPECT_EQ(rows["monitors"]["list"][1]["name"], "m1");
  EXPECT_DOUBLE_EQ(rows["monitors"]["list"][1]["u"][1], 0.25);
  EXPECT_NEAR(rows["monitors"]["list"][0]["at"][0].get<double>() + x0, 5.0e5 + 2.0, 1e-6);
  EXPECT_TRUE(rows["ledger"]["columns"].size() > 5);
  const Json events = decoded(site.slots()[events_slot]).head["list"];
  EXPECT_EQ(events.back()[2], "only </script>");
  EXPECT_EQ(decoded(site.slots()[status_slot]).head["status"], "running");
  sink.end({}, strip.frame);
  EXPECT_TRUE(refreshed(site, [](auto slots) { return decoded(slots[status_slot]).head["status"] == "done"; }));
}

TEST(LiveSite, places_are_exact_where_the_page_was_open_before_the_first_frame) {
  Trip trip(1);
  LiveSite& site = trip.site;
  Strip& strip = trip.strip;
  LiveSink& sink = trip.sink;
  const std::vector<double> at{5.0e5 + 3.0, 4.0e6 + 2.0}, u{1.0, 2.0}, v{0.1, 0.2};
  ASSERT_TRUE(refreshed(site, [&](auto slots) {  // the run computes: so far only its name is known
    sink.history({0.0, 0, at, u, v, {}, &strip.state.ledger, &strip.stats});
    return decoded(slots[status_slot]).head["status"] == "running";
  }));
  EXPECT_EQ(site.slots()[rows_slot].version, 0U) << "rows count from where the mesh is";
  ASSERT_TRUE(refreshed_with(site, sink, strip.frame, all_but_events_known));
  const Json run = decoded(site.slots()[run_slot]).head;
  const double x0 = run["origin"][0].get<double>() - 7.0, y0 = run["origin"][1].get<double>() + 3.0;
  EXPECT_LT(std::hypot(x0 - 5.0e5, y0 - 4.0e6), 3.0) << "float32 of a survey's coordinates is good for 0.25 m";
  const std::vector<double> origin = decoded(site.slots()[mesh_slot]).arrays.at("origin");
  for (std::size_t i = 0; i < origin.size(); ++i)
    EXPECT_NEAR(origin[i] + (i % 2 == 0 ? x0 : y0), strip.origin[i], 1e-6) << i;
  const Json rows = decoded(site.slots()[rows_slot]).head;
  EXPECT_NEAR(rows["monitors"]["list"][0]["at"][0].get<double>() + x0, 5.0e5 + 2.0, 1e-6);
  sink.end({}, strip.frame);
}

TEST(LiveSite, names_and_what_is_drawn_over_blocks_come_with_the_frames) {
  const auto bus = memory_bus();
  LiveSite site(bus, "");
  Strip strip(6);
  LiveSink sink(plan_at(1000.0).live, {"trip"}, {}, bus);
  Model model = model_with_monitors(0);
  model.materials = {{"rock", 2600.0, 5e9, 0.25}};
  model.blocks.resize(2);
  for (Block& block : model.blocks) block.material = MaterialId(0);
  model.blocks[1].name = "<b>second";
  sink.begin(model, plan_at(1000.0));
  ASSERT_TRUE(refreshed_with(site, sink, strip.frame, [](auto slots) {
    return slots[model_slot].version > 0 && slots[detail_slot].version > 0;
  }));
  EXPECT_TRUE(site.slots()[model_slot].first);
  EXPECT_TRUE(site.slots()[detail_slot].paced);
  const Json named = decoded(site.slots()[model_slot]).head;
  EXPECT_EQ(named["blocks"][1]["name"], "<b>second");
  EXPECT_EQ(named["materials"][0]["young"], 5e9);
  const Message detail = decoded(site.slots()[detail_slot]);
  EXPECT_EQ(detail.head["mesh"], decoded(site.slots()[mesh_slot]).head["mesh"]);
  // The stress at a point is the mean over the cells around it; cell c has -1000 c.
  const std::vector<double>& stress = detail.arrays.at("stress");
  ASSERT_EQ(stress.size(), 3 * strip.origin.size() / 2);
  EXPECT_EQ(stress[0], 0.0);
  EXPECT_EQ(stress[3 * 4], -1500.0) << "between the cells 1 and 2";
  EXPECT_TRUE(detail.arrays.at("c.state").empty());
  sink.end({}, strip.frame);
}

TEST(LiveSite, frames_name_the_field_that_they_carry_from_the_first_on) {
  const auto bus = memory_bus();
  LiveSite site(bus, "");
  Strip strip(6);
  LiveSink sink(plan_at(1000.0).live, {"trip"}, {}, bus);
  sink.begin(model_with_monitors(0), plan_at(1000.0));
  ASSERT_TRUE(refreshed_with(site, sink, strip.frame, [](auto slots) { return slots[frame_slot].version > 0; }));
  for (const LiveField field : {LiveField::sxx, LiveField::speed, LiveField::mean_stress}) {
    sink.set_field(field);
    ASSERT_TRUE(refreshed_with(site, sink, strip.frame, [&](auto slots) {
      return decoded(slots[frame_slot]).head["field"] == name(field);
    })) << name(field);
    // Frames with that name contain the values of that field.
    RawFrame raw;
    raw.mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(strip.mesh));
    raw.field = field;
    ASSERT_TRUE(take_source(raw, strip.frame));
    const std::vector<float> values = cell_values(raw);
    EXPECT_EQ(decoded(site.slots()[frame_slot]).arrays.at("scalar"), std::vector<double>(values.begin(), values.end()));
  }
  sink.end({}, strip.frame);
}

TEST(LiveSite, takes_no_texts_without_a_token) {
  LiveSite site(memory_bus(), "");
  for (const char* text : {"", "pause", " pause", "0 pause"}) EXPECT_FALSE(site.take(text)) << text;
}

// ------------------------------------------------------------------------------------------------- commands

TEST(ControlBridge, takes_commands_with_the_token_alone) {
  const std::string token = new_token();
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, new_token());
  ControlBridge bridge("memq://", token);  // never opened: no message may leave this program
  const std::string other(32, '0');
  for (const std::string& text : {std::string(),        token,
                                  std::string("pause"), "pause " + token,
                                  other + " pause",     token.substr(1) + " pause",
                                  token + "0 pause",    token + " pause 1",
                                  token + " who",       token + " step 0",
                                  token + " step x",    token + " step 1 2",
                                  token + " field",     token + " field colour",
                                  token + " rate",      token + " rate -1",
                                  token + " paus",      token + "  pause",
                                  token + " step nan",  token + " rm -rf"})
    EXPECT_FALSE(bridge.take(text, "")) << text;
  EXPECT_FALSE(bridge.answer());
  EXPECT_TRUE(bridge.take(token + " step 3", ""));
  std::optional<SharedBytes> answer;
  for (int i = 0; i < 500 && !answer; ++i) {
    answer = bridge.answer();
    std::this_thread::sleep_for(10ms);
  }
  ASSERT_TRUE(answer);
  const Json told = decoded({1, *answer}).head;
  EXPECT_EQ(told["kind"], "answer");
  EXPECT_EQ(told["command"], "step 3");
  EXPECT_EQ(told["result"], "failed");
  EXPECT_EQ(told["reason"], "no run is heard yet");
  EXPECT_FALSE(bridge.answer()) << "told once";
}

TEST(LiveSite, another_mesh_and_another_session_take_the_place_of_the_first) {
  const auto bus = memory_bus();
  LiveSite site(bus, "");
  Strip first(6, 1), second(12, 2);
  std::int64_t session = 0;
  {
    LiveSink sink(plan_at(1000.0).live, {"one"}, {}, bus);
    sink.begin(model_with_monitors(0), plan_at(1000.0));
    ASSERT_TRUE(refreshed_with(site, sink, first.frame, [](auto slots) { return slots[frame_slot].version > 0; }));
    session = decoded(site.slots()[run_slot]).head["session"];
    sink.event({coupling::EventKind::warning, 0.0, "of the first", nullptr});
    ASSERT_TRUE(refreshed(site, [](auto slots) { return slots[events_slot].version > 0; }));
    ASSERT_TRUE(refreshed_with(site, sink, second.frame, [](auto slots) { return slots[mesh_slot].version == 2; }));
    EXPECT_EQ(decoded(site.slots()[mesh_slot]).arrays.at("block").size(), 12U);
    EXPECT_EQ(decoded(site.slots()[frame_slot]).head["mesh"], decoded(site.slots()[mesh_slot]).head["mesh"]);
    EXPECT_EQ(decoded(site.slots()[run_slot]).head["blocks"], 4);
    sink.end({}, second.frame);
  }
  LiveSink sink(plan_at(1000.0).live, {"two"}, {}, bus);
  sink.begin(model_with_monitors(0), plan_at(1000.0));
  ASSERT_TRUE(refreshed_with(site, sink, first.frame,
                             [](auto slots) { return decoded(slots[run_slot]).head["run"] == "two"; }));
  EXPECT_GT(decoded(site.slots()[run_slot]).head["session"].get<std::int64_t>(), session);
  EXPECT_EQ(decoded(site.slots()[mesh_slot]).arrays.at("block").size(), 6U);
  sink.event({coupling::EventKind::warning, 0.0, "of the second", nullptr});
  ASSERT_TRUE(refreshed(site, [&](auto slots) { return decoded(slots[events_slot]).head["session"] > session; }));
  const Json events = decoded(site.slots()[events_slot]).head["list"];
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0][2], "of the second");
  sink.end({}, first.frame);
}

}  // namespace
}  // namespace scree::io::test::live_site_test
