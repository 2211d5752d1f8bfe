// A free block spins for a hundred turns: area and energy stay constant, the classical incremental update grows.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tests/support/nmm_block.h"
#include "tests/support/schemes.h"

namespace scree::test::spin_test {
namespace {

using std::numbers::pi;

/// Slope of the least-squares line through the values, times their number, over their mean: relative total change.
double trend(const std::vector<double>& y) {
  const auto n = static_cast<double>(y.size());
  double sum = 0.0, moment = 0.0, square = 0.0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double x = static_cast<double>(i) - 0.5 * (n - 1.0);
    sum += y[i];
    moment += x * y[i];
    square += x * x;
  }
  return n * moment / square / (sum / n);
}

/// Means over each turn of samples at equal steps.
struct TurnMeans {
  std::size_t samples;  // per turn
  double sum = 0.0;
  std::size_t count = 0;
  std::vector<double> means;
  void add(double x) {
    sum += x;
    if (++count < samples) return;
    means.push_back(sum / static_cast<double>(samples));
    sum = 0.0;
    count = 0;
  }
};

constexpr double kSpin = 2.0 * pi;  // one turn per second
constexpr int kTurns = 100;

TEST(Spin, hundred_turns_keep_area_and_energy) {
  Scene scene(4e8, 0.25, 2000.0);  // c_p about 500 m/s: centrifugal stretch of some 1e-5
  scene.model.gravity.setZero();
  const BlockId id = scene.add("spinner", rectangle(-0.5, -0.5, 0.5, 0.5));
  scene.model.initial_velocities.push_back({id, Vec2::Zero(), kSpin});
  scene.stage("nmm", coupling::Integrator::explicit_, kTurns, std::nullopt, 0.3);
  scene.plan.stages[0].control.max_displacement = 0.05;
  scene.plan.output.every = scene.plan.output.history_every = ticks(1.0 / 64.0);
  coupling::Driver run(scene.model, scene.plan, methods());
  TurnMeans area{64, 0.0, 0, {}}, energy{64, 0.0, 0, {}};
  Watch watch;
  watch.see = [&](const coupling::FrameView& frame) {
    double sum = 0.0;
    const auto& mesh = *frame.mesh;
    for (std::size_t c = 0; c + 1 < mesh.offsets.size(); ++c)
      for (std::int32_t i = mesh.offsets[c]; i < mesh.offsets[c + 1]; ++i) {
        const auto at = [&](std::int32_t k) {
          const auto p = 2 * static_cast<std::size_t>(mesh.connectivity[static_cast<std::size_t>(k)]);
          return Vec2(frame.position[p], frame.position[p + 1]);
        };
        sum += 0.5 * cross(at(i), at(i + 1 < mesh.offsets[c + 1] ? i + 1 : mesh.offsets[c]));
      }
    if (frame.tick == 0) return;
    area.add(sum);
    const coupling::Ledger& ledger = frame.state->ledger;  // the energy that central difference conserves
    energy.add(ledger[coupling::Column::kinetic] + ledger[coupling::Column::elastic] +
               ledger[coupling::Column::shadow]);
  };
  run.add_sink(watch);
  const coupling::RunEnd end = run.run();
  ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
  ASSERT_EQ(area.means.size(), static_cast<std::size_t>(kTurns));
  std::printf("100 turns: change of the means a turn, area %.1e, energy %.1e (area stretched by %.1e)\n",
              trend(area.means), trend(energy.means), area.means[0] - 1.0);
  EXPECT_LT(std::abs(trend(area.means)), 1e-8);
  EXPECT_LT(std::abs(trend(energy.means)), 1e-8);
  EXPECT_GT(area.means[0] - 1.0, 1e-6);  // the block is stretched, not rigid
}

/// The classical update ([Qu2013] 2.4) sums the small strains of each step in fixed axes and moves the mesh. Stresses
/// do not rotate with the rock, and the rotation of each step counts as a stretch.
TEST(Spin, classical_incremental_update_grows) {
  const NmmBlock block(rectangle(-0.5, -0.5, 0.5, 0.5), {.mass = MassKind::lumped, .cover_size = 0.3},
                       {"rock", 2000.0, 4e6, 0.25});
  const auto& elements = block.pool.elements();
  std::vector<double> q = block.q, v(q.size()), f(q.size()), a(q.size());
  AffineMotion m;
  m.Fdot = kSpin * quarter_turn();
  block.pool.place(0, m, q, v);
  std::vector<Mat2> stress(elements.size(), Mat2::Zero());
  const auto area_now = [&] {
    double sum = 0.0;
    for (std::size_t e = 0; e < elements.size(); ++e) sum += elements.area(e) * elements.gradient(e, q).determinant();
    return sum;
  };
  const double h = 1e-3;
  double at_turn_one = 0.0, at_turn_three = 0.0;
  for (int step = 0; step < 3000; ++step) {
    std::fill(f.begin(), f.end(), 0.0);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const Mat2 F = elements.gradient(e, q);
      const nmm::Gradients now = F.inverse().transpose() * elements.gradients(e);  // on the current mesh
      for (int k = 0; k < 3; ++k) {
        const Vec2 force = elements.area(e) * F.determinant() * stress[e] * now.col(k);
        const auto i = 2 * static_cast<std::size_t>(elements.cover(e)[static_cast<std::size_t>(k)]);
        f[i] -= force.x();
        f[i + 1] -= force.y();
      }
    }
    block.pool.mass_solve(q, f, a);
    for (std::size_t i = 0; i < q.size(); ++i) v[i] += h * a[i];
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const Mat2 L = elements.gradient(e, v) * elements.gradient(e, q).inverse();
      stress[e] += block.law().stress(0.5 * h * (L + L.transpose()));
    }
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += h * v[i];
    if (step == 999) at_turn_one = area_now();
    if (step == 2999) at_turn_three = area_now();
  }
  std::printf("classical update: area %.4f after one turn, %.4f after three\n", at_turn_one, at_turn_three);
  EXPECT_GT(std::abs(at_turn_one - 1.0), 1e-3);
  EXPECT_GT(std::abs(at_turn_three - 1.0), std::abs(at_turn_one - 1.0));
}

}  // namespace
}  // namespace scree::test::spin_test
