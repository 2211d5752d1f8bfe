// A disc is excavated from a ring of bonded blocks: the displacement of the wall converges to the solution of Lame with
// stiffer joints and smaller blocks.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "tests/support/schemes.h"

namespace scree::test::bonded_blocks_test {
namespace {

using namespace coupling;

constexpr double kIn = 1.0, kOut = 3.0, kStress = 1e5, kYoung = 2e9, kPoisson = 0.25;
/// How the ring is cut. Triangles, since quadrilaterals of uniform strain tied at both ends of every side lock.
struct Cut {
  int sectors, rings;
  /// Size d of the blocks at the wall [m].
  [[nodiscard]] double size() const { return 2.0 * std::numbers::pi * kIn / sectors; }
};

/// A corner of a polygon that has the area of the circle.
Vec2 polar(const Cut& cut, double radius, int sector) {
  const double step = 2.0 * std::numbers::pi / cut.sectors, angle = step * sector,
               r = radius * std::sqrt(step / std::sin(step));
  return r * Vec2(std::cos(angle), std::sin(angle));
}

/// Inward displacement of the wall by the excavation over that of Lame, for joints of dimensionless stiffness k_n d/E.
double wall_over_lame(const Cut& cut, double ratio) {
  Scene scene(kYoung, kPoisson, 2600.0);
  scene.model.gravity = {0.0, 0.0};
  InitialStress in_situ;
  in_situ.stress = -kStress * Mat2::Identity();
  scene.model.materials[0].initial_stress = in_situ;
  JointLaw& joint = scene.model.joints[0];
  joint.normal_stiffness = ratio * kYoung / cut.size();
  joint.cohesion = joint.residual_cohesion = joint.tensile_strength = 1e12;
  const double growth = std::pow(kOut / kIn, 1.0 / cut.rings);
  Ring core;
  for (int s = 0; s < cut.sectors; ++s) core.push_back(polar(cut, kIn, s));
  const BlockId disc = scene.add("disc", {core, {}});
  for (int k = 0; k < cut.rings; ++k)
    for (int s = 0; s < cut.sectors; ++s) {
      const double r0 = kIn * std::pow(growth, k), r1 = r0 * growth;
      const Vec2 p[4] = {polar(cut, r0, s), polar(cut, r1, s), polar(cut, r1, s + 1), polar(cut, r0, s + 1)};
      const bool other = (k + s) % 2 == 1;
      const Ring first = other ? Ring{p[1], p[2], p[3]} : Ring{p[0], p[1], p[2]},
                 second = other ? Ring{p[0], p[1], p[3]} : Ring{p[0], p[2], p[3]};
      for (const Ring& triangle : {first, second}) {
        const BlockId b = scene.add("b", {triangle, {}});
        for (std::int32_t e = 0; e < 3; ++e) {
          const Vec2 from = triangle[static_cast<std::size_t>(e)], to = triangle[static_cast<std::size_t>(e + 1) % 3];
          if (k == 0 && std::max(from.norm(), to.norm()) < 1.01 * kIn)
            scene.model.monitors.push_back({"wall", b, 0.5 * (from + to)});
          if (std::min(from.norm(), to.norm()) < kOut) continue;
          const Vec2 d = (to - from).normalized();
          scene.model.tractions.push_back({{b, {0, e}, 0.0, 1.0}, -kStress * Vec2(d.y(), -d.x()), FunctionId{}});
        }
      }
    }
  // Points of the outer edge that move only radially by symmetry.
  const auto hold = [&](int s, bool fix_x) {
    for (std::size_t b = 1; b < scene.model.blocks.size(); ++b)
      for (const Vec2& x : scene.model.blocks[b].polygon.outer)
        if ((x - polar(cut, kOut, s)).norm() < 1e-9) {
          scene.model.point_supports.push_back({BlockId{static_cast<std::int32_t>(b)}, x, fix_x, !fix_x, 1e9});
          return;
        }
  };
  hold(0, false);
  hold(cut.sectors / 2, false);
  hold(cut.sectors / 4, true);
  for (const bool there : {true, false}) {
    Stage& stage = scene.stage("dda", Integrator::implicit, 3.0, 0.25);
    stage.rest = true;
    if (there) continue;
    stage.construction.absent = {disc};
    stage.construction.release = 1.0;
  }
  scene.plan.output.history_every = scene.plan.output.every = ticks(3.0);
  struct Look final : Sink {
    void history(const HistoryView& h) override {
      double sum = 0.0;
      for (std::size_t k = 0; k < count; ++k) {
        const Vec2 x(h.position[2 * k], h.position[2 * k + 1]), u(h.displacement[2 * k], h.displacement[2 * k + 1]);
        sum -= u.dot((x - u).normalized()) / static_cast<double>(count);
      }
      inward[std::lround(h.time)] = sum;
    }
    std::map<long, double> inward;  // by time [s]
    std::size_t count = 0;
  } look;
  look.count = scene.model.monitors.size();
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(look);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  EXPECT_LT(std::abs(run.state().ledger.closure()), 1e-12 * run.state().ledger.moved());
  const double lame = kStress * kIn * (1.0 + kPoisson) / kYoung * ((1.0 - 2.0 * kPoisson) * kIn * kIn + kOut * kOut) /
                      (kOut * kOut - kIn * kIn);
  return (look.inward.at(6) - look.inward.at(3)) / lame;
}

TEST(Excavation, bonded_blocks_come_to_lame_as_their_joints_get_stiffer) {
  // A joint closes by p/k_n where its blocks shorten by p d/E: u = u_limit + c E/(k_n d). The limit is that of elements
  // of constant strain, which converges to Lame with smaller elements.
  const Cut coarse{24, 8}, fine{48, 16};
  const std::vector<double> ratios = {3.0, 10.0, 30.0, 100.0, 300.0};
  std::vector<double> found;
  std::printf("k_n d/E  wall over Lame, %d blocks\n", 2 * coarse.sectors * coarse.rings + 1);
  for (const double ratio : ratios) {
    found.push_back(wall_over_lame(coarse, ratio));
    std::printf("%7.0f  %.4f\n", ratio, found.back());
  }
  const double of_coarse = found[4] - 0.5 * (found[3] - found[4]), slope = 100.0 * (found[3] - of_coarse),
               of_fine = wall_over_lame(fine, 300.0) - slope / 300.0;
  std::printf("  limit  %.4f; %.4f of %d blocks\n", of_coarse, of_fine, 2 * fine.sectors * fine.rings + 1);
  EXPECT_GT(slope, 0.0);
  EXPECT_NEAR(found[2], of_coarse + slope / ratios[2], 1e-3);
  EXPECT_NEAR(found[1], of_coarse + slope / ratios[1], 5e-3);  // the next power of E/(k_n d) contributes
  EXPECT_NEAR(of_fine, 1.0, 0.01);
  EXPECT_LT(std::abs(of_fine - 1.0), 0.5 * std::abs(of_coarse - 1.0));
}

}  // namespace
}  // namespace scree::test::bonded_blocks_test
