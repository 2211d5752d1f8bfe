// Which blocks of a partitioned stage take explicit steps, by what they are and by how they move.
#include <gtest/gtest.h>

#include "coupling/bodies/partition.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::partition_sides_test {
namespace {

using namespace coupling;

/// Three separate blocks of 1, 4 and 1 m2.
struct Three {
  Scene scene{1e8, 0.2, 2500.0};
  Partition partition;
  Three() {
    scene.add("small", rectangle(0, 0, 1, 1));
    scene.add("large", rectangle(5, 0, 7, 2));
    scene.add("other", rectangle(10, 0, 11, 1));
    scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  }
  /// Sides after one evaluation, with the first block moving.
  [[nodiscard]] std::vector<char> look(std::vector<char> sides, const Vec2& velocity, const Mat2& gradient) const {
    ByHand hand(scene.model, scene.plan.stages[0]);
    hand.move(0, velocity, gradient);
    const std::vector<char> fixed = settled_sides(scene.model, partition);
    (void)change_sides(*hand.setup, hand.state, partition, fixed, sides);
    return sides;
  }
};

TEST(PartitionSides, lists_come_before_the_region_and_that_before_the_area) {
  Three three;
  three.partition.explicit_area = 2.0;
  EXPECT_EQ(first_sides(three.scene.model, three.partition), (std::vector<char>{1, 0, 1}));
  three.partition.explicit_region = {{4, -1}, {8, -1}, {8, 3}, {4, 3}};
  EXPECT_EQ(first_sides(three.scene.model, three.partition), (std::vector<char>{1, 1, 1}));
  three.partition.implicit_blocks = {BlockId{1}, BlockId{2}};
  EXPECT_EQ(first_sides(three.scene.model, three.partition), (std::vector<char>{1, 0, 0}));
  three.partition.explicit_region = {{4, -1}, {6, -1}, {6, 3}, {4, 3}};
  three.partition.implicit_blocks.clear();
  EXPECT_EQ(first_sides(three.scene.model, three.partition), (std::vector<char>{1, kDivided, 1}));
}

TEST(PartitionSides, strain_rate_is_the_largest_principal_one) {
  Three three;
  three.partition.strain_rate = {1.0, 0.5};
  Mat2 shear = Mat2::Zero();  // principal strain rates +-g/2
  for (const auto& [g, side] : {std::pair(1.9, char{0}), std::pair(2.1, char{1})}) {
    shear(0, 1) = g;
    EXPECT_EQ(three.look({0, 0, 0}, {0.0, 0.0}, shear)[0], side) << g;
  }
  Mat2 spin = 5.0 * quarter_turn();
  EXPECT_EQ(three.look({0, 0, 0}, {0.0, 0.0}, spin)[0], 0);
}

TEST(PartitionSides, block_changes_above_one_bound_and_back_below_the_other) {
  Three three;
  three.partition.speed = {2.0, 1.0};
  const Mat2 still = Mat2::Zero();
  EXPECT_EQ(three.look({0, 0, 0}, {1.5, 0.0}, still)[0], 0);
  EXPECT_EQ(three.look({0, 0, 0}, {2.5, 0.0}, still)[0], 1);
  EXPECT_EQ(three.look({1, 0, 0}, {1.5, 0.0}, still)[0], 1);
  EXPECT_EQ(three.look({1, 0, 0}, {0.5, 0.0}, still)[0], 0);
}

}  // namespace
}  // namespace scree::test::partition_sides_test
