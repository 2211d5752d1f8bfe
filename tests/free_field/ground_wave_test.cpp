// The motion of level ground by d'Alembert, against a grid of springs and masses whose waves are exact.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "model/free_field.h"

namespace scree::test {
namespace {

constexpr double kDensity = 2000.0, kHeight = 8.0, kBottom = -3.0, kPulse = 0.05;
const Elasticity kLaw{1.2e8, 8e7};

double pulse(double t) {
  if (t < 0.0 || t > kPulse) return 0.0;
  const double s = std::sin(std::numbers::pi * t / kPulse);
  return 0.1 * s * s * (1.0 + 0.5 * std::sin(40.0 * t));
}

/// Velocities at the nodes and stresses of the cells of a string, one after another in time: at steps of the time that
/// a wave takes through a cell, central differences are exact for it.
struct Grid {
  static constexpr int kCells = 64;
  double speed, h = kHeight / kCells, dt = h / speed;
  bool rigid;
  std::vector<double> v = std::vector<double>(kCells + 1, 0.0), s = std::vector<double>(kCells, 0.0);  // v at t, s at t
  double time = 0.0;

  Grid(double c, bool is_rigid) : speed(c), rigid(is_rigid) {}
  /// Characteristics: v + s/z goes down and v - s/z goes up, unchanged, with z = rho c; s is kept a node, too.
  std::vector<double> node_s = std::vector<double>(kCells + 1, 0.0);
  void step() {
    const double z = kDensity * speed;
    std::vector<double> up(kCells + 1), down(kCells + 1);
    for (int i = 0; i <= kCells; ++i) {
      up[i] = v[i] - node_s[i] / z;
      down[i] = v[i] + node_s[i] / z;
    }
    time += dt;
    for (int i = 0; i <= kCells; ++i) {
      const double from_below = i > 0 ? up[i - 1] : 0.0, from_above = i < kCells ? down[i + 1] : 0.0;
      if (i == kCells) {  // free
        v[i] = from_below;
        node_s[i] = 0.0;
      } else if (i == 0) {  // v - s/z is twice the wave that comes up, or v is the base's
        v[i] = rigid ? pulse(time) : 0.5 * (2.0 * pulse(time) + from_above);
        node_s[i] = z * (from_above - v[i]);
      } else {
        v[i] = 0.5 * (from_below + from_above);
        node_s[i] = 0.5 * z * (from_above - from_below);
      }
    }
  }
};

class GroundWaves : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(bases, GroundWaves, testing::Values(false, true));

TEST_P(GroundWaves, equal_those_of_a_string_at_the_time_of_a_wave_through_its_cells) {
  const bool rigid = GetParam();
  const FreeField ground{kBottom, kBottom + kHeight, rigid};
  for (const bool shear : {true, false}) {
    const double speed = std::sqrt((shear ? kLaw.mu : kLaw.p_modulus()) / kDensity);
    Grid grid(speed, rigid);
    double worst = 0.0, worst_stress = 0.0, largest = 0.0, across = 0.0;
    for (int n = 0; n < 6 * Grid::kCells; ++n) {
      grid.step();
      for (int i = 0; i <= Grid::kCells; ++i) {
        const auto wave = [&](double delay) {
          const double u = pulse(grid.time - delay);
          return shear ? Vec2(u, 0.0) : Vec2(0.0, u);
        };
        const GroundWave w = ground_wave(ground, kLaw, kDensity, kBottom + i * grid.h, grid.time, wave);
        const auto at = static_cast<std::size_t>(i);
        const double v = shear ? w.velocity.x() : w.velocity.y(), s = shear ? w.stress(0, 1) : w.stress(1, 1);
        worst = std::max(worst, std::abs(v - grid.v[at]));
        worst_stress = std::max(worst_stress, std::abs(s - grid.node_s[at]));
        largest = std::max(largest, std::abs(grid.v[at]));
        const double side = shear ? std::max(std::abs(w.stress(0, 0)), std::abs(w.stress(1, 1)))
                                  : std::abs(w.stress(0, 0) - kLaw.lambda / kLaw.p_modulus() * w.stress(1, 1));
        across = std::max(across, side);
      }
    }
    std::printf("%s base, %s: v within %.1e, stress within %.1e of the largest\n", rigid ? "rigid" : "compliant",
                shear ? "shear" : "pressure", worst / largest, worst_stress / (kDensity * speed * largest));
    EXPECT_GT(largest, 0.15);
    EXPECT_LT(worst, 1e-11 * largest);  // round-off of times
    EXPECT_LT(worst_stress, 1e-11 * kDensity * speed * largest);
    EXPECT_LT(across, 1e-11 * kDensity * speed * largest);
  }
}

TEST(GroundWave, is_at_rest_before_the_first_wave_arrives) {
  const FreeField ground{0.0, kHeight, true};
  const double c = std::sqrt(kLaw.mu / kDensity);
  const auto wave = [](double) { return Vec2(1.0, 0.0); };
  EXPECT_EQ(ground_wave(ground, kLaw, kDensity, 4.0, 0.99 * 4.0 / c, wave).velocity.x(), 0.0);
  EXPECT_EQ(ground_wave(ground, kLaw, kDensity, 4.0, -1.0, wave).velocity.x(), 0.0);
}

}  // namespace
}  // namespace scree::test
