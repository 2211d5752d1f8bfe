// Blocks whose motion is known.
#include "app/fos/block_modes.h"

#include <gtest/gtest.h>

namespace scree::app::block_modes_test {
namespace {

BlockMotion motion(Vec2 displacement, double rotation, double slip, bool touches = true) {
  BlockMotion m;
  m.displacement = std::move(displacement);
  m.rotation = rotation;
  m.radius = 2.0;
  m.slip = slip;
  m.area = 1.0;
  m.touches = touches;
  return m;
}

Mode mode_of(const BlockMotion& m, double seconds = 0.0) {
  std::vector<BlockMotion> all{m};
  name_modes(all, seconds, {0.0, -10.0});
  return all[0].mode;
}

TEST(BlockModes, single_blocks) {
  EXPECT_EQ(mode_of(motion({0.01, -0.005}, 0.0, 0.011)), Mode::slides);
  EXPECT_EQ(mode_of(motion({0.01, -0.005}, 1e-4, 0.011)), Mode::slides);     // a tilt of 2 % of the way
  EXPECT_EQ(mode_of(motion({0.01, -0.001}, -0.0055, 0.0)), Mode::topples);   // about a corner
  EXPECT_EQ(mode_of(motion({0.01, -0.001}, -0.0055, 0.01)), Mode::topples);  // and slips against neighbours
  EXPECT_EQ(mode_of(motion({0.01, -0.001}, -0.002, 0.0)), Mode::topples);    // turns slowly, but nothing slips
  EXPECT_EQ(mode_of(motion({0.01, -0.001}, -0.002, 0.008)), Mode::slides_and_topples);
  EXPECT_EQ(mode_of(motion({0.0, -0.01}, 0.0, 0.0, false)), Mode::falls);      // touches nothing
  EXPECT_EQ(mode_of(motion({0.0, -0.0045}, 0.0, 0.0045), 0.03), Mode::falls);  // g t^2/2, along a wall
  EXPECT_EQ(mode_of(motion({0.002, -0.001}, 0.0, 0.002), 0.03), Mode::slides);
  EXPECT_EQ(mode_of(motion({0.0, 0.0}, 0.0, 0.0)), Mode::stands);
}

TEST(BlockModes, of_many_the_one_with_most_way_leads) {
  std::vector<BlockMotion> all{motion({0.001, 0.0}, 0.0, 0.001), motion({0.1, 0.0}, 0.06, 0.0),
                               motion({0.02, 0.0}, 0.0, 0.02)};
  name_modes(all, 0.0, {0.0, -10.0});
  EXPECT_EQ(all[0].mode, Mode::stands);  // a hundredth of the farthest
  EXPECT_EQ(all[1].mode, Mode::topples);
  EXPECT_EQ(all[2].mode, Mode::slides);
  EXPECT_EQ(leading_mode(all), Mode::topples);
  all[2].area = 10.0;
  EXPECT_EQ(leading_mode(all), Mode::slides);
  EXPECT_EQ(leading_mode({}), Mode::stands);
}

}  // namespace
}  // namespace scree::app::block_modes_test
