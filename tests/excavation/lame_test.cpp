// A disc is excavated from a ring under in-situ stress: displacement of the wall against the solution of Lame.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "tests/support/circle.h"
#include "tests/support/schemes.h"

namespace scree::test::lame_test {
namespace {

using namespace coupling;

constexpr double kIn = 1.0, kOut = 3.0, kStress = 2e6, kYoung = 2e9, kPoisson = 0.25, kCover = 0.12;
constexpr int kCorners = 72;

/// Mean inward displacement of the monitors of a wall, at every sample.
struct Look final : Sink {
  void history(const HistoryView& h) override {
    double sum = 0.0;
    for (std::size_t k = 0; k < 8; ++k) {
      const Vec2 x(h.position[2 * k], h.position[2 * k + 1]), u(h.displacement[2 * k], h.displacement[2 * k + 1]);
      sum -= u.dot((x - u).normalized()) / 8.0;
    }
    inward[std::lround(h.time)] = sum;  // one entry for the end of a stage and the start of the next
  }
  std::map<long, double> inward;  // by time [s]
};

TEST(Excavation, wall_of_a_disc_that_leaves_moves_in_as_lame_says_at_every_part_released) {
  // In-situ stress -p everywhere, pressure p outside; the disc is removed and (1 - lambda) of its force is kept:
  //   u(a) = -lambda p_i a (1 + nu)/E [(1 - 2 nu) a^2 + b^2]/(b^2 - a^2), plane strain.
  // The joint between disc and rock, of stiffness k_n a = 1000 E, has closed before by p/k_n: p_i is 1e-3 less than p.
  Scene scene(kYoung, kPoisson, 2600.0);
  scene.model.gravity = {0.0, 0.0};
  InitialStress in_situ;
  in_situ.stress = -kStress * Mat2::Identity();
  scene.model.materials[0].initial_stress = in_situ;
  scene.model.joints[0].normal_stiffness = 1000.0 * kYoung / kIn;
  const BlockId rock = scene.add("rock", {circle(kOut, kCorners, false), {circle(kIn, kCorners, true)}});
  const BlockId disc = scene.add("disc", {circle(kIn, kCorners, false), {}});
  for (std::int32_t e = 0; e < kCorners; ++e) {
    const Ring& r = scene.model.blocks[0].polygon.ring(0);
    const auto i = static_cast<std::size_t>(e);
    const Vec2 d = (r[(i + 1) % r.size()] - r[i]).normalized();
    scene.model.tractions.push_back({{rock, {0, e}, 0.0, 1.0}, -kStress * Vec2(d.y(), -d.x()), FunctionId{}});
  }
  // Supports without reaction: they prevent drift, and rotation under loads of fixed direction.
  scene.model.point_supports.push_back({rock, {-2.0, 0.0}, false, true, 1e9});
  scene.model.point_supports.push_back({rock, {2.0, 0.0}, false, true, 1e9});
  scene.model.point_supports.push_back({rock, {0.0, 2.0}, true, false, 1e9});
  for (int k = 0; k < 8; ++k) {
    const double angle = std::numbers::pi / 4.0 * k + 0.1;
    scene.model.monitors.push_back({"wall", rock, 1.0005 * kIn * Vec2(std::cos(angle), std::sin(angle))});
  }
  // Fraction released at the end of each stage; -1: the disc is present.
  const std::vector<double> released = {-1.0, 0.0, 0.5, 1.0};
  for (const double part : released) {
    Stage& stage = scene.stage("nmm", Integrator::implicit, 3.0, 0.5, kCover);
    stage.rest = true;
    if (part < 0.0) continue;
    stage.construction.absent = {disc};
    stage.construction.release = part;
    stage.construction.release_time = part == 0.5 ? ticks(1.0) : 0;
  }
  scene.plan.output.history_every = scene.plan.output.every = ticks(3.0);
  Look look;
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(look);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const auto at_end = [&](int stage) { return look.inward.at(3 * (stage + 1)); };
  const double whole = kStress * kIn * (1.0 + kPoisson) / kYoung * ((1.0 - 2.0 * kPoisson) * kIn * kIn + kOut * kOut) /
                       (kOut * kOut - kIn * kIn);
  const double before = at_end(0);
  std::printf("inward before %.3e, held %.3e, half %.6f, whole %.6f of %.6f m: %.4f %.4f of Lame\n", before,
              at_end(1) - before, at_end(2) - before, at_end(3) - before, whole, (at_end(2) - before) / (0.5 * whole),
              (at_end(3) - before) / whole);
  EXPECT_LT(std::abs(at_end(1) - before), 1e-6 * whole);  // the kept forces equal those of the contacts
  EXPECT_NEAR((at_end(2) - before) / (0.5 * whole), 1.0, 0.01);
  EXPECT_NEAR((at_end(3) - before) / whole, 1.0, 0.01);
  const Ledger& ledger = run.state().ledger;
  std::printf("excavated %.6g J, support_release %.6g J, closure %.1e\n", ledger[Column::excavated],
              ledger[Column::support_release], std::abs(ledger.closure()) / ledger.moved());
  EXPECT_LT(ledger[Column::support_release], 0.0);  // the wall moves against them
  EXPECT_LT(std::abs(ledger.closure()), 1e-12 * ledger.moved());
}

}  // namespace
}  // namespace scree::test::lame_test
