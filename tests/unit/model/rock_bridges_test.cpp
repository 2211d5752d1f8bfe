// Rock bridges: random networks of difficult kinds lose no area, dead ends are treated as the option states, and the
// statistics of the draws match the input.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "model/block_cutting.h"
#include "model/random.h"

namespace scree::rock_bridges_test {
namespace {

double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }

double area_of(const Polygon& p) {
  double area = 0.0;
  for (std::size_t r = 0; r < p.rings(); ++r) area += signed_area(p.ring(r));
  return area;
}

Domain slope() {
  Domain d;
  d.outline.outer = {{0, 0}, {40, 0}, {40, 8}, {22, 8}, {14, 25}, {0, 25}};
  d.material = MaterialId{0};
  d.least_width = 0.01;
  return d;
}

JointSet set_of(double dip, double spacing, std::uint64_t seed) {
  JointSet s;
  s.dip_deg.mean = dip;
  s.spacing.mean = spacing;
  s.joint = JointId{0};
  s.seed = seed;
  return s;
}

/// A domain with two or three sets: dense, nearly parallel, through one point, with dead ends and scatter.
Domain random_domain(Random& random, int number) {
  Domain d = slope();
  const double dip = between(random, 0.0, 180.0);
  const int sets = 2 + number % 2;
  for (int k = 0; k < sets; ++k) {
    const bool parallel = number % 3 == 0 && k == 1;
    JointSet s = set_of(std::fmod(parallel ? dip + between(random, 0.05, 3.0) : dip + 61.0 * k, 180.0),
                        between(random, number % 5 == 0 ? 0.9 : 1.6, 4.0),
                        1000 * static_cast<unsigned>(number) + static_cast<unsigned>(k));
    if (number % 4 == 1) s.origin = Vec2(10.0, 10.0);  // triple points
    if (number % 4 != 1) s.spacing.deviation = 0.25 * s.spacing.mean;
    s.length = Spread{between(random, 3.0, 9.0), 0.8, number % 2 == 0 ? Distribution::normal : Distribution::lognormal};
    const double persistence = between(random, 0.5, 0.95);
    s.gap = Spread{s.length->mean * (1.0 - persistence) / persistence, 0.0,
                   number % 3 == 1 ? Distribution::exponential : Distribution::normal};
    if (number % 3 == 2)
      s.fisher_k = between(random, 30.0, 400.0);
    else
      s.dip_deg.deviation = between(random, 0.0, 6.0);
    d.network.sets.push_back(s);
  }
  d.dead_ends = static_cast<DeadEnds>(number % 3);
  return d;
}

TEST(RockBridges, three_hundred_random_networks_lose_no_area_and_match_what_was_asked) {
  Random random(2024);
  int off = 0, means = 0;
  double density = 0.0, asked = 0.0;
  std::int64_t extended = 0, kept = 0, blocks = 0;
  for (int number = 0; number < 300; ++number) {
    const Domain d = random_domain(random, number);
    const Cutting cut = cut_blocks(d);
    double area = 0.0;
    for (const Block& b : cut.blocks) {
      EXPECT_GT(area_of(b.polygon), 0.0);
      area += area_of(b.polygon);
    }
    ASSERT_NEAR(area, area_of(d.outline), 1e-9 * area) << number;
    for (const Crack& c : cut.cracks)
      EXPECT_TRUE(contains(cut.blocks[c.block.index()].polygon, 0.5 * (c.from + c.to))) << number;
    EXPECT_TRUE(d.dead_ends != DeadEnds::drop || cut.cracks.empty()) << number;
    if (d.dead_ends == DeadEnds::keep) kept += cut.report.cracks_kept;
    extended += cut.report.ends_extended;
    blocks += cut.report.blocks;
    ASSERT_EQ(cut.sets.size(), d.network.sets.size());
    for (const SetStatistics& s : cut.sets) {
      const auto count = [&](const Sample& drawn, const Moments1& of) {
        if (drawn.n < 12 || !(of.deviation > 0.0)) return;
        ++means;
        off += std::abs(drawn.mean() - of.mean) > 2.5758 * of.deviation / std::sqrt(double(drawn.n)) ? 1 : 0;
      };
      count(s.drawn_dip, s.fisher_k > 0.0 ? Moments1{s.dip_deg.mean, fisher_deviation_deg(s.fisher_k)}
                                          : drawn_moments(s.dip_deg, false));
      count(s.drawn_spacing, drawn_moments(s.spacing, true));
      count(s.drawn_length, drawn_moments(s.length, true));
      count(s.drawn_gap, drawn_moments(s.gap, true));
      if (d.dead_ends != DeadEnds::extend) density += s.density(), asked += s.asked_density();
    }
  }
  std::printf(
      "300 networks: %ld blocks, %ld cracks kept, %ld ends extended; %d of %d means off at 99 %%; density %.4f of "
      "%.4f\n",
      static_cast<long>(blocks), static_cast<long>(kept), static_cast<long>(extended), off, means, density, asked);
  EXPECT_GT(kept, 1000);
  EXPECT_GT(extended, 1000);
  EXPECT_GT(means, 1500);
  // At 99 % a hundredth of the means is off by chance; the limit is four standard deviations above that.
  EXPECT_LT(off, 0.01 * means + 4.0 * std::sqrt(0.01 * means));
  EXPECT_NEAR(density, asked, 0.02 * asked);
}

TEST(RockBridges, extended_lines_cut_what_they_ended_in) {
  // A line of 2 m in a square of 10 m that another line divides: kept, a crack of 2 m; extended, three blocks.
  Domain d;
  d.outline.outer = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  d.material = MaterialId{0};
  d.network.traces = {{{{4, 5}, {6, 5}}, JointId{0}}, {{{8, -1}, {8, 11}}, JointId{0}}};
  const Cutting kept = cut_blocks(d);
  EXPECT_EQ(kept.blocks.size(), 2u);
  EXPECT_NEAR(kept.report.crack_length, 2.0, 1e-9);
  d.dead_ends = DeadEnds::extend;
  const Cutting extended = cut_blocks(d);
  EXPECT_EQ(extended.blocks.size(), 3u);
  EXPECT_EQ(extended.report.cracks_kept, 0);
  EXPECT_EQ(extended.report.ends_extended, 2);
  EXPECT_NEAR(extended.report.extended_length, 4.0 + 2.0, 1e-8);
  d.dead_ends = DeadEnds::drop;
  const Cutting dropped = cut_blocks(d);
  EXPECT_EQ(dropped.blocks.size(), 2u);
  EXPECT_TRUE(dropped.cracks.empty());
  EXPECT_EQ(dropped.report.cracks_trimmed, 1);
}

TEST(RockBridges, fisher_scatter_is_that_of_poles_in_space) {
  // Large K: the apparent dip is normal with the deviation 1/sqrt(K).
  EXPECT_NEAR(fisher_deviation_deg(1000.0), 180.0 / std::numbers::pi / std::sqrt(1000.0), 0.01);
  Domain d = slope();
  d.outline.outer = {{0, 0}, {400, 0}, {400, 400}, {0, 400}};
  JointSet s = set_of(40.0, 0.25, 5);
  s.fisher_k = 25.0;
  d.network.sets = {s};
  std::vector<SetStatistics> drawn;
  (void)draw_lines(d.network, d.outline, &drawn);
  const double deviation = fisher_deviation_deg(25.0);
  ASSERT_GT(drawn[0].drawn_dip.n, 1500);
  EXPECT_NEAR(drawn[0].drawn_dip.deviation(), deviation,
              4.0 * deviation / std::sqrt(2.0 * double(drawn[0].drawn_dip.n)));
  EXPECT_NEAR(drawn[0].drawn_dip.mean(), 40.0, 4.0 * deviation / std::sqrt(double(drawn[0].drawn_dip.n)));
}

}  // namespace
}  // namespace scree::rock_bridges_test
