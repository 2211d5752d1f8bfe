// Live streaming of blocks: as affine maps if their motion is affine, else as displacements.
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

namespace scree::io::live_maps_test {
namespace {

using namespace std::chrono_literals;
using namespace test;

/// The frame received, and the numbers of maps and of loose points sent.
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
  // Displacements reach 70 m: tolerance of a few relative round-offs of 6e-8.
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

}  // namespace
}  // namespace scree::io::live_maps_test
