// One continuum, two integrators: a block of which one half takes explicit steps and the other implicit ones.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "tests/support/schemes.h"

namespace scree::test {
namespace {

using namespace scree::coupling;

/// How far the nodes of seams lie apart now, at most [m].
double largest_gap(const Setup& setup, std::span<const double> q) {
  double most = 0.0;
  for (const Body& b : setup.bodies()) {
    const std::int32_t first = setup.pool_first(static_cast<std::size_t>(b.pool));
    for (const Pool::Seam& s : setup.pool_of(b).seams(b.index))
      for (std::size_t d = 0; d < 2; ++d)
        most = std::max(most, std::abs(q[2 * static_cast<std::size_t>(first + s.explicit_node) + d] -
                                       q[2 * static_cast<std::size_t>(first + s.implicit_node) + d]));
  }
  return most;
}

std::size_t seams_of(const Driver& run) {
  std::size_t count = 0;
  for (const Body& b : run.setup().bodies()) count += run.setup().pool_of(b).seams(b.index).size();
  return count;
}

void print_ledger(const Ledger& l) {
  for (int c = 0; c < kColumns; ++c)
    if (const double x = l[static_cast<Column>(c)]; x != 0.0)
      std::printf("  %-18s %.6g\n", info(static_cast<Column>(c)).name.data(), x);
}

struct Plate {
  double spin, dt, turns;
  std::int32_t substeps;
};

/// A plate of 2 m that spins freely, its left half explicit.
Scene spinning_plate(const Plate& p) {
  Scene scene(1e9, 0.2, 2500.0);
  const BlockId plate = scene.add("plate", rectangle(-1.0, -1.0, 1.0, 1.0));
  scene.model.initial_velocities.push_back({plate, Vec2(0.0, 0.0), p.spin});
  Stage& stage = scene.stage("nmm", Integrator::partitioned, p.turns * 2.0 * std::numbers::pi / p.spin, p.dt, 0.25);
  stage.partition.explicit_region = {{-2.0, -2.0}, {0.0, -2.0}, {0.0, 2.0}, {-2.0, 2.0}};
  stage.partition.substeps = p.substeps;
  return scene;
}

TEST(Divided, a_spinning_plate_loses_what_the_implicit_half_takes_and_its_halves_stay_together) {
  const bool full = std::getenv("SCREE_FULL") != nullptr;
  for (const Plate& p : {Plate{50.0, 1e-4, full ? 20.0 : 2.0, 1}, Plate{50.0, 2e-4, full ? 20.0 : 2.0, 4}}) {
    const Scene scene = spinning_plate(p);
    Driver run(scene.model, scene.plan, methods());
    double apart = 0.0;
    Watch watch;
    watch.see = [&](const FrameView& f) { apart = std::max(apart, largest_gap(run.setup(), f.state->q)); };
    run.add_sink(watch);
    const RunEnd end = run.run();
    ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
    const BodyTotals t = totals_of(run, BlockId{0});
    const Ledger& ledger = run.state().ledger;
    // Forces at the end of a step act along its way: on a rigid spin the implicit half takes w^2 H/2 times the virial
    // of its stress, which in either half of the plate is the kinetic energy: T' = -w^2 H/2 T.
    const double time = seconds(run.state().time),
                 predicted = p.spin / std::sqrt(1.0 + 0.5 * p.dt * p.spin * p.spin * time);
    const double inertia = 2500.0 * 4.0 * (4.0 + 4.0) / 12.0, spin = t.angular_momentum / inertia;
    std::printf(
        "m = %d, %.0f turns, %ld steps, %zu seams: iterations %.2f a step, apart %.1e m, closure %.1e, seams %.1e J of "
        "%.4g J\n"
        "  spin %.5f 1/s, predicted %.5f, of %.0f; momentum %.1e\n",
        p.substeps, p.turns, static_cast<long>(run.stats().steps), seams_of(run),
        static_cast<double>(run.stats().iterations) / static_cast<double>(run.stats().steps), apart,
        ledger.relative_closure(), ledger[Column::seams], ledger[Column::kinetic], spin, predicted, p.spin,
        t.momentum.norm());
    print_ledger(ledger);
    EXPECT_LT(apart, 1e-10);
    EXPECT_LT(ledger.relative_closure(), 1e-11);
    EXPECT_NEAR(spin, predicted, 0.02 * (p.spin - predicted));
  }
}

}  // namespace
}  // namespace scree::test
