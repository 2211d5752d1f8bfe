// The motion of level ground by d'Alembert, against the characteristics of a string of cells.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "model/free_field.h"
#include "tests/support/scene.h"

namespace scree::test::ground_history_test {
namespace {

constexpr double kDensity = 2000.0, kHeight = 8.0, kBottom = -3.0, kStart = 0.07;

/// A slow and a fast oscillation, 100 samples per second; the acceleration ends at zero, the velocity need not.
GroundMotion record(const Vec2& direction, Between between = Between::linear) {
  std::vector<double> t, a;
  for (int i = 0; i <= 30; ++i) {
    const double s = std::sin(std::numbers::pi * i / 30.0);
    t.push_back(1.0 + 0.01 * i);  // the record's own time
    a.push_back(s * s * (std::sin(0.7 * i) + 0.3 * std::cos(2.0 * i)));
  }
  GroundMotion::Setting setting;
  setting.name = "record";
  setting.start = kStart;
  setting.between = between;
  return {t, a, direction.normalized(), setting};
}

Scene ground(const GroundMotion& motion) {
  Scene scene(2e8, 0.25, kDensity);
  scene.add("ground", rectangle(0.0, kBottom, 4.0, kBottom + kHeight));
  scene.model.motions.push_back(motion);
  return scene;
}

/// A string of cells: upgoing and downgoing waves advance unchanged by one cell per travel time through a cell.
struct String {
  static constexpr int kCells = 96;
  const GroundMotion* motion;
  int axis;
  double speed, part;
  bool rigid;
  std::vector<double> up = std::vector<double>(kCells + 1, 0.0), down = up;  // v - s/z and v + s/z, z = rho c
  double time = 0.0;                                                         // since the first sample
  [[nodiscard]] double dt() const { return kHeight / kCells / speed; }
  void step() {
    time += dt();
    const double u = part * motion->velocity(kStart + time)[axis];
    const double arrives = up[kCells - 1], returns = down[1];
    for (std::size_t i = kCells; i > 0; --i) up[i] = up[i - 1];
    for (std::size_t i = 0; i < kCells; ++i) down[i] = down[i + 1];
    up[kCells] = down[kCells] = arrives;  // s = 0
    down[0] = returns;
    up[0] = rigid ? 2.0 * u - returns : 2.0 * u;  // v = u, or v - s/z twice the wave
  }
  [[nodiscard]] double velocity(std::size_t i) const { return 0.5 * (up[i] + down[i]); }
  [[nodiscard]] double stress(std::size_t i) const { return 0.5 * (down[i] - up[i]); }
};

double value(const std::vector<double>& time, const std::vector<double>& table, double t) {
  TimeFunction f;
  f.shape = TimeFunction::Shape::table;
  f.time = time;
  f.table = table;
  return f.value(t);
}

class GroundHistories : public testing::TestWithParam<std::tuple<bool, Between>> {};
INSTANTIATE_TEST_SUITE_P(bases, GroundHistories,
                         testing::Combine(testing::Bool(), testing::Values(Between::linear, Between::constant)));

TEST_P(GroundHistories, are_those_of_a_string_of_cells) {
  const auto [rigid, between] = GetParam();
  const Scene scene = ground(record({3.0, 4.0}, between));
  const GroundMotion& motion = scene.model.motions[0];
  const FreeField field{kBottom, kBottom + kHeight, MotionId{0}, rigid, 0.5};
  const Elasticity law = scene.model.elasticity_of(BlockId{0});
  for (const int axis : {0, 1}) {
    String string{&motion, axis, std::sqrt((axis == 0 ? law.mu : law.p_modulus()) / kDensity), 0.5, rigid};
    std::vector<GroundHistory> table;
    for (int i = 0; i <= String::kCells; i += 16)
      table.push_back(
          ground_history(scene.model, field, MaterialId{0}, axis, kBottom + kHeight * i / String::kCells, 0.6));
    double worst = 0.0, largest = 0.0;
    while (string.time + string.dt() < 0.59) {
      string.step();
      for (std::size_t k = 0; k < table.size(); ++k) {
        const double v = string.velocity(16 * k), s = string.stress(16 * k);
        worst = std::max({worst, std::abs(value(table[k].time, table[k].velocity, string.time) - v),
                          std::abs(value(table[k].time, table[k].stress, string.time) - s)});
        largest = std::max(largest, std::abs(v));
      }
    }
    std::printf("%s base, axis %d: %zu times, within %.1e of the largest velocity\n", rigid ? "rigid" : "compliant",
                axis, table[0].time.size(), worst / largest);
    EXPECT_GT(largest, 0.0);
    EXPECT_LT(worst, (between == Between::linear ? 1e-4 : 1e-3) * largest);
  }
}

TEST(GroundHistory, of_a_motion_across_its_axis_is_empty) {
  const Scene scene = ground(record({1.0, 0.0}));
  const FreeField field{kBottom, kBottom + kHeight, MotionId{0}, false, 1.0};
  EXPECT_FALSE(ground_history(scene.model, field, MaterialId{0}, 0, 0.0, 1.0).time.empty());
  EXPECT_TRUE(ground_history(scene.model, field, MaterialId{0}, 1, 0.0, 1.0).time.empty());
}

TEST(FreeFieldSides, have_dashpots_and_tractions_over_their_whole_length) {
  Scene scene = ground(record({1.0, 1.0}));
  scene.stage("nmm", coupling::Integrator::explicit_, 1.0, std::nullopt);
  add_free_field(scene.model, {{BlockId{0}, {0, 1}, 0.0, 1.0}}, {kBottom, kBottom + kHeight, MotionId{0}, false, 1.0},
                 0.9);
  ASSERT_EQ(scene.model.viscous_edges.size(), 1U);
  EXPECT_FALSE(scene.model.viscous_edges[0].motion.valid());
  double length = 0.0;
  for (const EdgeTraction& t : scene.model.tractions) {
    EXPECT_TRUE(of_free_field(scene.model, t.function));
    EXPECT_EQ(scene.model.functions[t.function.index()].start, kStart);
    EXPECT_LE(scene.model.functions[t.function.index()].end(), kStart + 0.9);
    length += t.span.s1 - t.span.s0;
  }
  EXPECT_NEAR(length, 4.0, 1e-12);  // velocity and stress, along x and y
}

}  // namespace
}  // namespace scree::test::ground_history_test
