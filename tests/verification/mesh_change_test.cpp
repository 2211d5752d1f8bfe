// Another mesh for the same block: what of a wave, of a state at rest and of the momenta goes on.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "coupling/stages/setup.h"
#include "coupling/transfer/transfer.h"
#include "tests/support/scene.h"

namespace scree::test {
namespace {

using coupling::Column;
using coupling::Driver;
using coupling::HistoryView;
using coupling::Integrator;
using coupling::RunEnd;
using coupling::Stage;
using coupling::TransferRow;

const coupling::Methods& methods() {
  static const coupling::Methods all = coupling::standard_methods();
  return all;
}

/// Peaks of velocity and stress along the bar at a monitor, and the books.
struct Passed {
  double velocity = 0.0, stress = 0.0, closure = 0.0;
  std::vector<TransferRow> rows;
};

constexpr double kLength = 1.0;  // of the pulse in the bar [m]

/// A pulse sin^2 of 1 m runs along a bar of 4 m; when its middle is at 1.5 m the block takes the stages that follow, one
/// after the other at the same instant but the last, and the wave is measured at 3 m.
/// @param sizes  cover sizes of the NMM; 0: DDA
Passed pass(const std::vector<double>& sizes, Kinematics kinematics, Integrator integrator = Integrator::explicit_) {
  Scene scene(62.5e9, 0.0, 2500.0);
  Model& model = scene.model;
  model.plane = Plane::stress;
  model.gravity.setZero();
  const double speed = 5000.0;
  const BlockId bar = scene.add("bar", rectangle(0.0, 0.0, 4.0, 0.1));
  model.functions.push_back({"pulse", TimeFunction::Shape::sine_squared, 1.0, 0.0, kLength / speed, 0.0, {}, {}});
  model.tractions.push_back({{bar, {0, 3}, 0.0, 1.0}, Vec2(1e6, 0.0), FunctionId{0}});
  model.monitors.push_back({"behind", bar, Vec2(3.0, 0.05)});
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const bool first = i == 0, last = i + 1 == sizes.size();
    const double duration = (first && last ? 3.9 : first ? 2.0 : last ? 1.9 : 1e-3) / speed;
    Stage& stage = scene.stage(sizes[i] > 0.0 ? "nmm" : "dda", integrator, duration, std::nullopt, sizes[i]);
    stage.kinematics = kinematics;
    if (integrator == Integrator::implicit) stage.dt = 2e-7;
  }
  scene.plan.output.history_every = ticks(2e-6);
  struct Peaks final : coupling::Sink {
    double velocity = 0.0, stress = 0.0;
    void history(const HistoryView& view) override {
      velocity = std::max(velocity, view.velocity[0]);
      stress = std::max(stress, -view.stress[0]);
    }
  } peaks;
  Driver run(model, scene.plan, methods());
  run.add_sink(peaks);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  return {peaks.velocity, peaks.stress, run.state().ledger.relative_closure(), run.transfers()};
}

void expect_clean(const Passed& p) {
  EXPECT_LT(p.closure, 1e-9);
  for (const TransferRow& row : p.rows) {
    EXPECT_LT(row.mass_error, 1e-12);
    EXPECT_LT(row.momentum_error, 1e-12);
    EXPECT_LT(row.angular_error, 1e-12);
    EXPECT_LT(row.energy_error, 1e-10);
  }
}

TEST(MeshChange, a_wave_in_flight_goes_on) {
  std::printf("covers a pulse   h'/h     peak v   peak stress   T'/T     U'/U     closure\n");
  for (const double covers : {10.0, 20.0, 40.0})
    for (const double ratio : {0.7, 0.5, 2.0}) {
      const double h = kLength / covers;
      if (ratio * h > 0.07 * covers / 20.0 && ratio > 1.0 && covers < 20.0) continue;
      const Kinematics kinematics = ratio == 0.5 ? Kinematics::corotational : Kinematics::linear;
      const Passed one = pass({h}, kinematics), changed = pass({h, ratio * h}, kinematics);
      std::printf("%10.0f %12.1f %10.4f %10.4f %11.4f %8.4f    %.0e\n", covers, ratio, changed.velocity / one.velocity,
                  changed.stress / one.stress,
                  changed.rows.empty() ? 0.0 : changed.rows[0].after.kinetic / changed.rows[0].before.kinetic,
                  changed.rows.empty() ? 0.0 : changed.rows[0].after.elastic / changed.rows[0].before.elastic,
                  changed.closure);
      expect_clean(changed);
    }
}

}  // namespace
}  // namespace scree::test
