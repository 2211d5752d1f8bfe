// MODEL and DETAIL messages: names, contacts, stress and bolts of a stream, intact and damaged.
#include "io/live/live_detail.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <random>
#include <set>
#include <thread>

#include "io/live/decode.h"
#include "io/live/live_model.h"
#include "io/live/parts.h"
#include "io/live/send_pieces.h"
#include "tests/unit/io/live_strip.h"

namespace scree::io::test::live_detail_test {
namespace {

using coupling::ContactMemory;
using coupling::ContactStatus;
using coupling::ContactView;

/// Contact points along the strip: every third open, the others slipping and sticking in turn, some failed.
class Points {
 public:
  explicit Points(std::size_t count) : memory_(count) {
    for (std::size_t i = 0; i < count; ++i) {
      ContactMemory& m = memory_[i];
      m.key.block_p = static_cast<std::int32_t>(i % 7), m.key.block_e = static_cast<std::int32_t>(i % 5);
      m.status = i % 3 == 0 ? ContactStatus::open : i % 3 == 1 ? ContactStatus::slip : ContactStatus::stick;
      m.failed = i % 6 == 1;
      m.joint = static_cast<std::int32_t>(i % 2);
      m.fn = 10.0 * static_cast<double>(i), m.ft = -3.0 * static_cast<double>(i), m.slip = 0.25;
      position_.insert(position_.end(), {5.0e5 + 0.01 * static_cast<double>(i), 4.0e6 - 0.5});
      normal_.insert(normal_.end(), {0.6, 0.8});
    }
    view_ = {position_, normal_, memory_};
  }
  Points(const Points&) = delete;
  Points& operator=(const Points&) = delete;
  [[nodiscard]] const ContactView* view() const { return &view_; }

 private:
  std::vector<double> position_, normal_;
  std::vector<ContactMemory> memory_;
  ContactView view_;
};

Model named_model() {
  Model model = model_with_monitors(0);
  model.materials = {{"rock", 2600.0, 5e9, 0.25}, {"<b>clay", 2000.0, 1e8, 0.3}};
  model.joints.resize(2);
  model.joints[0].name = "bedding", model.joints[0].friction = 0.5;
  model.joints[1].name = "fault \x1b[2J", model.joints[1].tensile_strength = std::numeric_limits<double>::infinity();
  for (int b = 0; b < 3; ++b) {
    Block block;
    block.name = "block " + std::to_string(b);
    block.material = MaterialId(b % 2);
    block.polygon.outer = {{3.0 * b, 0.0}, {3.0 * b + 2.0, 0.0}, {3.0 * b + 2.0, 1.0}, {3.0 * b, 1.0}};
    model.blocks.push_back(block);
  }
  model.block_supports.push_back({BlockId(1), {}});
  model.point_supports.push_back({BlockId(0), {0.0, 1.0}, true, false, {}});
  EdgeSupport edge;
  edge.span = {BlockId(2), {0, 0}, 0.25, 1.0};
  edge.held << 0.0, 0.0, 0.0, 1.0;
  model.edge_supports.push_back(edge);
  JointWater water;
  water.line = {{-1.0, 0.5}, {4.0, 0.75}, {9.0, 0.25}};
  water.joints = {JointId(1)};
  model.waters.push_back(water);
  return model;
}

/// Feeds an assembly all messages of a run that ends with this frame.
LiveAssembly assembled(Recorder& recorder, const Model& model, const FrameView& frame) {
  LiveSink sink(plan_at(1000.0).live, {"named"}, {}, recorder.bus);
  sink.begin(model, plan_at(1000.0));
  sink.end({}, frame);
  recorder.drain();
  LiveAssembly assembly;
  for (const auto& [channel, bytes] : recorder.messages) {
    EXPECT_LE(bytes.size(), kMaxMessage) << channel;
    EXPECT_TRUE(assembly.take(channel, bytes)) << channel;
  }
  return assembly;
}

TEST(LiveDetail, a_stream_names_what_its_model_is_made_of) {
  Recorder recorder;
  Strip strip(9);
  const LiveAssembly assembly = assembled(recorder, named_model(), strip.frame);
  ASSERT_TRUE(assembly.model());
  const model_v1_t& m = *assembly.model();
  EXPECT_EQ(m.block, (std::vector<std::string>{"block 0", "block 1", "block 2"}));
  EXPECT_EQ(m.block_material, (std::vector<std::int32_t>{0, 1, 0}));
  EXPECT_EQ(m.held, (std::vector<std::uint8_t>{0, 1, 0}));
  EXPECT_EQ(m.material[1], "<b>clay");
  EXPECT_EQ(m.law[0], "bedding");
  EXPECT_NEAR(m.friction_deg[0], 28.6479, 1e-4);
  EXPECT_TRUE(std::isinf(m.tensile_strength[1]));
  EXPECT_EQ(m.fix_x, (std::vector<std::uint8_t>{1}));
  EXPECT_EQ(m.fix_y, (std::vector<std::uint8_t>{0}));
  EXPECT_DOUBLE_EQ(m.edge_x0[0], 6.5);  // a quarter along the lower edge of the third block
  EXPECT_DOUBLE_EQ(m.edge_x1[0], 8.0);
  EXPECT_EQ(m.edge_fixed[0], 0) << "it slides along";
  EXPECT_EQ(m.water_x, (std::vector<double>{-1.0, 4.0, 9.0}));
  EXPECT_EQ(m.water_law, (std::vector<std::int32_t>{1}));
}

TEST(LiveDetail, contacts_stress_and_bolts_of_an_instant_arrive_whole) {
  for (const std::size_t count : {std::size_t{4}, std::size_t{9000}}) {  // in one message, and in several
    Recorder recorder;
    Strip strip(9);
    strip.move(0.5);
    Points points(count);
    strip.frame.contacts = points.view();
    const std::vector<double> nodes{5.0e5, 4.0e6, 5.0e5 + 1.0, 4.0e6 + 2.0}, force{1500.0, -20.0};
    const std::vector<std::int32_t> bolt{0, 0};
    coupling::BoltsView bolts;
    bolts.position = nodes, bolts.node_force = force, bolts.bolt = bolt;
    strip.frame.bolts = &bolts;
    const LiveAssembly assembly = assembled(recorder, named_model(), strip.frame);
    ASSERT_TRUE(assembly.detail());
    EXPECT_DOUBLE_EQ(assembly.detail()->header.time, 0.5);
    const detail_v1_t& d = assembly.detail()->data;
    ASSERT_EQ(d.state.size(), count - (count + 2) / 3) << "open points stay away";
    const std::size_t one = 0;  // the point 1 of the run, the first that is closed
    EXPECT_EQ(d.state[one], 1 + 4) << "slipping, failed";
    EXPECT_EQ(d.state[one + 1], 2);
    EXPECT_EQ(d.corner[one], 1);
    EXPECT_EQ(d.edge[one], 1);
    EXPECT_EQ(d.law[one], 1);
    EXPECT_EQ(d.fn[one], 10.0F);
    EXPECT_EQ(d.ft[one], -3.0F);
    EXPECT_EQ(d.slip[one], 0.25F);
    EXPECT_NEAR(d.base[0] + static_cast<double>(d.x[one]), 5.0e5 + 0.01, 1e-6) << "rounded about the base, not about 0";
    EXPECT_EQ(d.ny[one], 0.8F);
    ASSERT_EQ(d.xx.size(), 9U);
    EXPECT_EQ(d.xx[4], -4000.0F);
    EXPECT_EQ(d.yy[4], 500.0F);
    ASSERT_EQ(d.bolt.size(), 2U);
    EXPECT_EQ(d.node_force[0], 1500.0F);
    EXPECT_NEAR(d.base[1] + static_cast<double>(d.node_y[1]), 4.0e6 + 2.0, 1e-6);
  }
}

TEST(LiveDetail, many_contacts_come_less_often_than_frames) {
  Recorder recorder;
  Strip strip(9);
  Points points(30000);  // 1.2 MB of closed contacts: two messages in three seconds
  strip.frame.contacts = points.view();
  LiveSink sink(plan_at(1000.0).live, {"large"}, {}, recorder.bus);
  sink.begin(named_model(), plan_at(1000.0));
  for (int i = 0; i < 20; ++i) {
    strip.move(0.01 * i);
    sink.frame(strip.frame);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const auto details = [&] {
    recorder.drain();
    std::set<std::int64_t> numbers;
    for (const auto& [channel, bytes] : recorder.messages)
      if (channel_kind(channel) == LiveKind::detail) numbers.insert(unseal<part_v1_t>(bytes)->header.sequence);
    return numbers.size();
  };
  EXPECT_LE(details(), 1U);
  sink.end({}, strip.frame);
  EXPECT_EQ(details(), 2U) << "the last instant is always sent";
}

TEST(LiveDetail, damaged_wholes_are_refused_and_end_nothing) {
  Strip strip(6);
  const LiveMesh mesh = LiveMesh::copy(strip.mesh);
  Points points(40);
  strip.frame.contacts = points.view();
  const Bytes model = seal(live_model(named_model())), detail = seal(live_detail(strip.frame, mesh.base));
  std::mt19937 random(5);
  int refused = 0;
  const auto look = [&](const Bytes& bytes) {  // run under asan: must not read out of bounds
    const auto m = unseal<model_v1_t>(bytes, LiveAssembly::kMaxMesh);
    const auto d = unseal<detail_v1_t>(bytes, LiveAssembly::kMaxMesh);
    if (!(m && holds_together(*m)) && !(d && holds_together(*d, mesh))) ++refused;
  };
  for (const Bytes& good : {model, detail})
    for (std::size_t i = 0; i + 8 < good.size(); ++i)
      for (const std::uint8_t value : std::initializer_list<std::uint8_t>{0x00, 0x01, 0x7F, 0x80, 0xFF}) {
        Bytes bad = good;
        bad[i] = value;
        if (random() % 7 == 0) bad.resize(8 + random() % bad.size());
        write_crc(bad);
        look(bad);
      }
  EXPECT_GT(refused, 1000);
  detail_v1_t other = live_detail(strip.frame, mesh.base);
  other.corner[3] = -1;
  EXPECT_FALSE(holds_together(other, mesh));
  other = live_detail(strip.frame, mesh.base);
  other.xx.pop_back(), other.yy.pop_back(), other.xy.pop_back();
  other.cells -= 1;
  EXPECT_FALSE(holds_together(other, mesh)) << "stress of another mesh";
  model_v1_t named = live_model(named_model());
  named.block_material[0] = 2;
  EXPECT_FALSE(holds_together(named));
}

TEST(LiveDetail, parts_come_together_in_any_order_and_once) {
  Bytes whole(200000);
  std::mt19937 random(3);
  for (std::uint8_t& byte : whole) byte = static_cast<std::uint8_t>(random());
  std::vector<part_v1_t> parts;
  header_v1_t header{};
  header.sequence = 4;
  send_pieces<part_v1_t>(header, whole, [&](const Bytes& bytes) {
    EXPECT_LE(bytes.size(), kMaxMessage);
    parts.push_back(*unseal<part_v1_t>(bytes));
  });
  ASSERT_EQ(parts.size(), 4U);
  PartAssembly assembly;
  for (const std::size_t i : {2U, 0U, 2U, 3U}) EXPECT_TRUE(assembly.put(part_v1_t(parts[i]), 1U << 20U));
  EXPECT_FALSE(assembly.take()) << "one is missing";
  EXPECT_TRUE(assembly.put(part_v1_t(parts[1]), 1U << 20U));
  EXPECT_EQ(assembly.take(), whole);
  EXPECT_FALSE(assembly.take());
  for (part_v1_t& p : parts) EXPECT_TRUE(assembly.put(part_v1_t(p), 1U << 20U));
  EXPECT_FALSE(assembly.take()) << "sent again for late viewers";
  part_v1_t wrong = parts[1];
  wrong.header.sequence = 5;
  wrong.first += 1;
  EXPECT_FALSE(assembly.put(part_v1_t(wrong), 1U << 20U));
  EXPECT_FALSE(assembly.put(part_v1_t(parts[0]), 100000)) << "larger than anything may be";
}

}  // namespace
}  // namespace scree::io::test::live_detail_test
