// A disc is excavated from a square with unequal principal in-situ stresses: displacements and stresses against the
// solution of Kirsch.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "tests/support/circle.h"
#include "tests/support/schemes.h"

namespace scree::test::kirsch_test {
namespace {

using namespace coupling;

constexpr double kRadius = 1.0, kHalf = 20.0, kStress = 4e6, kRatio = 0.5, kYoung = 10e9, kPoisson = 0.25;
constexpr int kCorners = 64;

/// Displacement of a point by the excavation, plane strain, p vertical and K p horizontal, angle from the horizontal:
///   u_r = -p a^2/(4 G r) [(1 + K) - (1 - K)(4 (1 - nu) - a^2/r^2) cos 2t],
///   u_t = -p a^2/(4 G r) (1 - K)(2 (1 - 2 nu) + a^2/r^2) sin 2t.
/// @source [Timoshenko1951], chapter 4 (Kirsch), less the displacements without the hole
Vec2 kirsch(const Vec2& x) {
  const double r = x.norm(), t = std::atan2(x.y(), x.x()), g = kYoung / (2.0 * (1.0 + kPoisson)),
               f = kStress * kRadius * kRadius / (4.0 * g * r), a2 = kRadius * kRadius / (r * r);
  const double ur = -f * ((1.0 + kRatio) - (1.0 - kRatio) * (4.0 * (1.0 - kPoisson) - a2) * std::cos(2.0 * t)),
               ut = -f * (1.0 - kRatio) * (2.0 * (1.0 - 2.0 * kPoisson) + a2) * std::sin(2.0 * t);
  return ur * x / r + ut * quarter_turn() * x / r;
}

/// Stress at a point of an axis: component along the axis (radial) and across it (hoop).
Vec2 kirsch_stress(double r, bool upright) {
  const double a2 = kRadius * kRadius / (r * r), c = upright ? -1.0 : 1.0;  // cos 2t
  const double mean = 0.5 * kStress * (1.0 + kRatio), half = 0.5 * kStress * (1.0 - kRatio);
  return {-(mean * (1.0 - a2) - half * (1.0 - 4.0 * a2 + 3.0 * a2 * a2) * c),
          -(mean * (1.0 + a2) + half * (1.0 + 3.0 * a2 * a2) * c)};
}

struct Look final : Sink {
  void history(const HistoryView& h) override {
    displacement[std::lround(h.time)].assign(h.displacement.begin(), h.displacement.end());
    stress.assign(h.stress.begin(), h.stress.end());
  }
  std::map<long, std::vector<double>> displacement;  // by time [s]
  std::vector<double> stress;
};

TEST(Excavation, circle_in_a_square_under_two_stresses_moves_and_bears_as_kirsch_says) {
  Scene scene(kYoung, kPoisson, 2600.0);
  scene.model.gravity = {0.0, 0.0};
  InitialStress in_situ;
  in_situ.stress = Vec2(-kRatio * kStress, -kStress).asDiagonal();
  scene.model.materials[0].initial_stress = in_situ;
  JointLaw& joint = scene.model.joints[0];  // the disc is bonded to the rock
  joint.normal_stiffness = 1000.0 * kYoung / kRadius;
  joint.cohesion = joint.residual_cohesion = joint.tensile_strength = 1e12;
  const BlockId rock =
      scene.add("rock", {rectangle(-kHalf, -kHalf, kHalf, kHalf).outer, {circle(kRadius, kCorners, true, 0.5)}});
  const BlockId disc = scene.add("disc", {circle(kRadius, kCorners, false, 0.5), {}});
  const Ring& outer = scene.model.blocks[0].polygon.outer;
  for (std::int32_t e = 0; e < 4; ++e) {
    const Vec2 d = (outer[static_cast<std::size_t>(e + 1) % 4] - outer[static_cast<std::size_t>(e)]).normalized();
    scene.model.tractions.push_back({{rock, {0, e}, 0.0, 1.0}, in_situ.stress * Vec2(d.y(), -d.x()), FunctionId{}});
  }
  // Supports where symmetry prevents the motion anyway: they carry no force.
  scene.model.point_supports.push_back({rock, {0.0, kHalf}, true, false, 1e9});
  scene.model.point_supports.push_back({rock, {0.0, -kHalf}, true, false, 1e9});
  scene.model.point_supports.push_back({rock, {kHalf, 0.0}, false, true, 1e9});
  std::vector<Vec2> at;
  for (const double r : {1.003, 1.5, 2.0, 3.0})
    for (const double t : {0.0, 0.25, 0.5})
      at.push_back(r * Vec2(std::cos(t * std::numbers::pi), std::sin(t * std::numbers::pi)));
  for (const Vec2& x : at) scene.model.monitors.push_back({"m", rock, x});
  for (const bool there : {true, false}) {
    Stage& stage = scene.stage("nmm", Integrator::implicit, 3.0, 1.0, 0.16);
    stage.rest = true;
    if (there) continue;
    stage.construction.absent = {disc};
    stage.construction.release = 1.0;
  }
  scene.plan.output.history_every = scene.plan.output.every = ticks(3.0);
  Look look;
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(look);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const double scale = kirsch({0.0, kRadius}).norm();
  double worst = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto moved = [&](long time) {
      return Vec2(look.displacement.at(time)[2 * i], look.displacement.at(time)[2 * i + 1]);
    };
    const Vec2 u = moved(6) - moved(3), exact = kirsch(at[i]);
    std::printf("r %.2f, %3.0f degrees: u (%.4f %.4f) mm of (%.4f %.4f) mm\n", at[i].norm(),
                std::atan2(at[i].y(), at[i].x()) * 180.0 / std::numbers::pi, 1e3 * u.x(), 1e3 * u.y(), 1e3 * exact.x(),
                1e3 * exact.y());
    worst = std::max(worst, (u - exact).norm());
  }
  std::printf("largest error of a displacement: %.4f of the crown's\n", worst / scale);
  EXPECT_LT(worst, 0.03 * scale);
  for (const std::size_t i : {3U, 5U, 6U, 8U}) {  // the two axes at 1.5 a and 2 a
    const bool upright = i % 3 == 2;
    const Vec2 exact = kirsch_stress(at[i].norm(), upright);
    const double radial = look.stress[3 * i + (upright ? 1 : 0)], hoop = look.stress[3 * i + (upright ? 0 : 1)];
    std::printf("r %.2f, %s: radial %.3f of %.3f MPa, hoop %.3f of %.3f MPa\n", at[i].norm(), upright ? "up" : "level",
                1e-6 * radial, 1e-6 * exact.x(), 1e-6 * hoop, 1e-6 * exact.y());
    EXPECT_NEAR(radial, exact.x(), 0.03 * kStress);
    EXPECT_NEAR(hoop, exact.y(), 0.03 * kStress);
  }
}

}  // namespace
}  // namespace scree::test::kirsch_test
