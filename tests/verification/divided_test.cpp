// One block with two time integrators: one half takes explicit steps and the other half implicit steps.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "coupling/transfer/transfer.h"
#include "tests/support/schemes.h"

namespace scree::test::divided_test {
namespace {

using namespace scree::coupling;

/// Largest present gap between the two nodes of an interface constraint, by component [m].
double largest_gap(const Setup& setup, std::span<const double> q) {
  double most = 0.0;
  for (const Body& b : setup.bodies()) {
    const std::int32_t first = setup.pool_first(static_cast<std::size_t>(b.pool));
    for (const Pool::InterfaceConstraint& s : setup.pool_of(b).interface_constraints(b.index))
      for (std::size_t d = 0; d < 2; ++d)
        most = std::max(most, std::abs(q[2 * static_cast<std::size_t>(first + s.explicit_node) + d] -
                                       q[2 * static_cast<std::size_t>(first + s.implicit_node) + d]));
  }
  return most;
}

std::size_t constraints_of(const Driver& run) {
  std::size_t count = 0;
  for (const Body& b : run.setup().bodies()) count += run.setup().pool_of(b).interface_constraints(b.index).size();
  return count;
}

void print_ledger(const Ledger& l) {
  for (int c = 0; c < kColumns; ++c)
    if (const double x = l[static_cast<Column>(c)]; x != 0.0)
      std::printf("  %-18s %.6g\n", info(static_cast<Column>(c)).name.data(), x);
}

struct Plate {
  double young, spin, dt, turns;
  std::int32_t substeps;
  bool left;  // the explicit half
};

/// A plate of 2 m that spins freely; one half takes explicit steps.
Scene spinning_plate(const Plate& p) {
  Scene scene(p.young, 0.2, 2500.0);
  scene.model.gravity = Vec2(0.0, 0.0);
  const BlockId plate = scene.add("plate", rectangle(-1.0, -1.0, 1.0, 1.0));
  scene.model.initial_velocities.push_back({plate, Vec2(0.0, 0.0), p.spin});
  Stage& stage = scene.stage("nmm", Integrator::partitioned, p.turns * 2.0 * std::numbers::pi / p.spin, p.dt, 0.25);
  const double side = p.left ? -2.0 : 2.0;
  stage.partition.explicit_region = {{side, -2.0}, {0.0, -2.0}, {0.0, 2.0}, {side, 2.0}};
  stage.partition.substeps = p.substeps;
  return scene;
}

struct Spun {
  double spin = 0.0, apart = 0.0, iterations = 0.0, time = 0.0;
  Ledger ledger;
  Vec2 momentum{0.0, 0.0};
};
Spun spun(const Plate& p) {
  const Scene scene = spinning_plate(p);
  Driver run(scene.model, scene.plan, methods());
  Spun out;
  Watch watch;
  watch.see = [&](const FrameView& f) { out.apart = std::max(out.apart, largest_gap(run.setup(), f.state->q)); };
  run.add_sink(watch);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  EXPECT_GT(constraints_of(run), 8u);
  const BodyTotals t = totals_of(run, BlockId{0});
  out.spin = t.angular_momentum / (2500.0 * 4.0 * 8.0 / 12.0);
  out.iterations = static_cast<double>(run.stats().iterations) / static_cast<double>(run.stats().steps);
  out.time = seconds(run.state().time);
  out.ledger = run.state().ledger;
  out.momentum = t.momentum;
  return out;
}

/// In an implicit step, the forces at its end act along its whole displacement: in a rigid spin the implicit half loses
/// w^2 H/2 times the virial of its stress. The virial of both halves is twice the kinetic energy T, hence T' = -w^2 H T
/// if all is implicit, and T' = -w^2 H/2 T in the mean of the runs with either half explicit.
double predicted_spin(const Plate& p, double time) {
  return p.spin / std::sqrt(1.0 + 0.5 * p.dt * p.spin * p.spin * time);
}

TEST(Divided, a_spinning_plate_loses_what_the_implicit_half_takes_and_its_halves_stay_together) {
  // The spin stretches the plate, which increases its inertia: 1.2 % of the loss at 50 1/s in rock of 1 GPa, in
  // proportion to rho v^2/E.
  for (const auto& [plate, within] : {std::pair(Plate{1e9, 50.0, 1e-4, 20.0, 1, true}, 0.015),
                                      std::pair(Plate{1e9, 50.0, 2e-4, 20.0, 4, true}, 0.015),
                                      std::pair(Plate{1.6e10, 50.0, 2.5e-5, 2.0, 1, true}, 0.002)}) {
    double loss = 0.0, time = 0.0;
    for (const bool left : {true, false}) {
      Plate p = plate;
      p.left = left;
      const Spun run = spun(p);
      const double energy = run.ledger[Column::kinetic];
      std::printf(
          "E = %.1e, H = %.1e s, m = %d, %.0f turns, %s half explicit: %.2f iterations a step, apart %.1e m, "
          "ledger %.1e, interface constraints %.1e of the kinetic energy, momentum %.1e, spin %.4f 1/s\n",
          p.young, p.dt, p.substeps, p.turns, left ? "left" : "right", run.iterations, run.apart,
          run.ledger.relative_closure(), run.ledger[Column::interface_constraints] / energy, run.momentum.norm(),
          run.spin);
      EXPECT_LT(run.apart, 1e-10);
      EXPECT_LT(run.ledger.relative_closure(), 1e-12);
      EXPECT_LT(std::abs(run.ledger[Column::interface_constraints]), 1e-8 * energy);
      EXPECT_LT(run.momentum.norm(), 1e-12 * 1e4 * p.spin * run.time / p.dt);  // round-off of so many steps
      loss += 0.5 * (p.spin - run.spin);
      time = run.time;
      if (p.substeps == 1) {
        EXPECT_LT(run.iterations, 5.0);
      }
    }
    const double predicted = plate.spin - predicted_spin(plate, time);
    std::printf("  of the spin lost %.5f 1/s, predicted %.5f (%.2f %%)\n", loss, predicted,
                100.0 * (loss - predicted) / predicted);
    EXPECT_NEAR(loss, predicted, within * predicted);
  }
}

/// A bar of 10 m; a smooth pulse from its left end passes the interface in the middle.
struct Bar {
  Scene scene{1e9, 0.0, 2500.0};
  explicit Bar(Integrator integrator, double dt, std::int32_t substeps) {
    Model& model = scene.model;
    model.gravity = Vec2(0.0, 0.0);
    const BlockId bar = scene.add("bar", rectangle(0.0, 0.0, 10.0, 0.5));
    model.functions.push_back({"pulse", TimeFunction::Shape::sine_squared, 1.0, 0.0, 5e-3, 0.0, {}, {}, {}});
    model.tractions.push_back({{bar, {0, 3}, 0.0, 1.0}, Vec2(1e6, 0.0), FunctionId{0}});
    for (const double x : {2.5, 7.5}) model.monitors.push_back({std::to_string(x), bar, Vec2(x, 0.25)});
    Stage& stage = scene.stage("nmm", integrator, 0.017, dt, 0.25);
    stage.partition.explicit_region = {{-1.0, -1.0}, {5.03, -1.0}, {5.03, 2.0}, {-1.0, 2.0}};
    stage.partition.substeps = substeps;
    scene.plan.output.history_every = ticks(1e-4);
  }
};

/// Velocity along the bar at its two monitors.
std::vector<std::array<double, 2>> history(const Bar& bar, double& closure) {
  struct Histories final : Sink {
    std::vector<std::array<double, 2>> v;
    void history(const HistoryView& view) override { v.push_back({view.velocity[0], view.velocity[2]}); }
  } sink;
  Driver run(bar.scene.model, bar.scene.plan, methods());
  run.add_sink(sink);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  closure = run.state().ledger.relative_closure();
  return sink.v;
}

TEST(Divided, a_wave_passes_the_interface) {
  const double speed = std::sqrt(1e9 / 2500.0), most = 1e6 / (2500.0 * speed);
  double ignored = 0.0;
  const auto whole = history(Bar(Integrator::explicit_, 2e-5, 1), ignored);
  std::vector<std::array<double, 2>> coarser;
  double last = 0.0;
  for (const auto& [dt, m] : {std::pair(1e-4, 1), std::pair(5e-5, 1), std::pair(2.5e-5, 1), std::pair(5e-5, 5)}) {
    double closure = 0.0, echo = 0.0, passed = 0.0, change = 0.0;
    const auto divided = history(Bar(Integrator::partitioned, dt, m), closure);
    for (std::size_t i = 0; i < divided.size(); ++i) {
      // The pulse has passed the first monitor, and the reflection from the far end has not arrived.
      if (1e-4 * static_cast<double>(i) > 2.5 / speed + 6e-3)
        echo = std::max(echo, std::abs(divided[i][0] - whole[i][0]));
      passed = std::max(passed, divided[i][1]);
      if (m == 1 && !coarser.empty()) change = std::max(change, std::abs(divided[i][1] - coarser[i][1]));
    }
    std::printf("H = %.0e s, m = %d: echo %.2e, passes %.4f of the pulse, ledger %.1e, change %.3e\n", dt, m,
                echo / most, passed / most, closure, change / most);
    EXPECT_LT(closure, 1e-12);
    EXPECT_LT(echo, 0.01 * most);
    EXPECT_NEAR(passed, most, 750.0 * dt * most);  // numerical damping of the implicit half
    if (last > 0.0 && m == 1) {
      EXPECT_NEAR(std::log2(last / change), 1.0, 0.2);  // the order of the implicit half
    }
    if (m == 1) last = change;
    coarser = divided;
  }
}

/// A random block, divided by a random line; a short blow at a corner excites all its modes.
Scene struck_block(std::mt19937_64& random, std::int32_t substeps) {
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  Scene scene(std::pow(10.0, uniform(8.0, 10.5)), uniform(0.0, 0.4), 2500.0);
  scene.model.gravity = Vec2(0.0, 0.0);
  const double width = uniform(1.5, 4.0), height = uniform(1.0, 2.0), turn = uniform(0.0, 3.0);
  Polygon outline = rectangle(0.0, 0.0, width, height);
  for (Vec2& x : outline.outer) x = rotation(turn) * (x + Vec2(uniform(-0.1, 0.1), uniform(-0.1, 0.1)));
  const BlockId block = scene.add("block", outline);
  Stage& stage = scene.stage("nmm", Integrator::partitioned, 1.0, 1.0, uniform(0.15, 0.35));
  const double cut = uniform(0.3, 0.7) * width, lean = uniform(-0.3, 0.3);
  for (const Vec2& x : {Vec2(-9.0, -9.0), Vec2(cut - 9.0 * lean, -9.0), Vec2(cut + 9.0 * lean, 9.0), Vec2(-9.0, 9.0)})
    stage.partition.explicit_region.push_back(rotation(turn) * x);
  stage.partition.substeps = substeps;
  // Step bound of the explicit half alone.
  std::vector<BodyRecord> records = initial_records(scene.model, body_requests(scene.model, stage));
  records[0].form.division.acts = Division::Acts::explicit_half;
  const Setup half(scene.model, methods(), records);
  const double h = 0.999 * 2.0 / std::sqrt(half.pool(0).mass_ratio(0) * half.pool(0).frequency_bound(0));
  stage.dt = substeps * h;
  stage.duration = 400 * ticks(substeps * h);
  scene.plan.output.every = stage.duration;
  scene.plan.output.history_every = 5 * ticks(substeps * h);
  scene.model.functions.push_back(
      {"blow", TimeFunction::Shape::half_sine, 1.0, 0.0, 3.0 * substeps * h, 0.0, {}, {}, {}});
  scene.model.point_loads.push_back({block, outline.outer[2], Vec2(-1e5, -3e4), FunctionId{0}});
  return scene;
}

TEST(Divided, no_instability_at_the_bound_of_the_explicit_half) {
  std::mt19937_64 random(7);
  double growth = 0.0, closure = 0.0, apart = 0.0;
  const int blocks = std::getenv("SCREE_FULL") != nullptr ? 100 : 8;
  for (const std::int32_t m : {1, 2, 5, 10})
    for (int i = 0; i < blocks; ++i) {
      const Scene scene = struck_block(random, m);
      Driver run(scene.model, scene.plan, methods());
      struct Energy final : Sink {
        double most = 0.0;
        void history(const HistoryView& view) override {
          const Ledger& l = *view.ledger;
          if (l[Column::loads] > 0.0)
            most = std::max(most, (l[Column::kinetic] + l[Column::elastic]) / l[Column::loads]);
        }
      } energy;
      run.add_sink(energy);
      const RunEnd end = run.run();
      ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
      growth = std::max(growth, energy.most);
      closure = std::max(closure, run.state().ledger.relative_closure());
      apart = std::max(apart, largest_gap(run.setup(), run.state().q));
    }
  std::printf(
      "%d blocks, m = 1, 2, 5, 10, 400 steps at 0.999 of the bound: energy at most %.4f of the work, ledger "
      "%.1e, apart %.1e m\n",
      4 * blocks, growth, closure, apart);
  EXPECT_LT(growth, 1.05);  // the shadow term is not counted
  EXPECT_LT(closure, 1e-11);
  EXPECT_LT(apart,
            1e-8);  // 1e-9 of the blow's force against the mass at an interface constraint, corrected in the next step
}

/// A block slides over the interface constraints of a divided base; the base is undivided in the stages before and
/// after.
TEST(Divided, contacts_and_hand_over) {
  Scene scene(1e9, 0.2, 2600.0, 20.0);
  const BlockId base = scene.add("base", rectangle(-3.0, -1.0, 3.0, 0.0)),
                slider = scene.add("slider", rectangle(-1.5, 0.0, -0.5, 0.5));
  scene.model.point_supports.push_back({base, Vec2(-2.5, -1.0), true, true, std::nullopt});
  scene.model.point_supports.push_back({base, Vec2(2.5, -1.0), true, true, std::nullopt});
  scene.model.point_supports.push_back({base, Vec2(0.0, -1.0), true, true, std::nullopt});
  scene.model.initial_velocities.push_back({slider, Vec2(2.0, 0.0), 0.0});
  scene.stage("nmm", Integrator::implicit, 0.1, 2e-4, 0.4);
  Stage& stage = scene.stage("nmm", Integrator::partitioned, 0.3, 2e-4, 0.4);
  stage.rules.push_back({{slider}, "dda", 0.0, false});
  stage.partition.explicit_region = {{-1.0, -2.0}, {0.3, -2.0}, {0.3, 0.0}, {-1.0, 0.0}};
  scene.stage("nmm", Integrator::explicit_, 0.1, std::nullopt, 0.4);
  scene.plan.output.history_every = ticks(1e-3);
  Driver run(scene.model, scene.plan, methods());
  struct Sinks final : Sink {
    double closure = 0.0, momentum = 0.0;
    std::vector<std::pair<double, double>> support;
    void history(const HistoryView& view) override { closure = std::max(closure, view.ledger->relative_closure()); }
  } sinks;
  run.add_sink(sinks);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const Ledger& ledger = run.state().ledger;
  print_ledger(ledger);
  const double moved = centre_of(run, slider).x() + 1.0, g = 9.81, mu = std::tan(20.0 * kDegree), t = 0.5;
  std::printf("slid %.5f m, rigid %.5f; closure %.1e at most, steps %ld, iterations %ld\n", moved,
              2.0 * t - 0.5 * mu * g * t * t, sinks.closure, static_cast<long>(run.stats().steps),
              static_cast<long>(run.stats().iterations));
  EXPECT_LT(sinks.closure, 1e-9);
  EXPECT_NEAR(moved, 2.0 * t - 0.5 * mu * g * t * t, 0.01);
  // Division and reunion transfer a negligible energy.
  EXPECT_LT(std::abs(ledger[Column::transfer]), 1e-3 * std::abs(ledger[Column::friction]));
}

/// Four blocks on a held base, the uppermost explicit; the upper two are pushed aside.
Scene column(bool shared, double dt) {
  Scene scene(1e9, 0.2, 2600.0, 25.0);
  // The weight grows gradually, so that no block bounces: explicit contacts damp bouncing, those of implicit steps do
  // not.
  scene.model.gravity = Vec2(0.0, 0.0);
  scene.model.functions.push_back({"weight", TimeFunction::Shape::ramp, 1.0, 0.0, 0.1, 0.0, {}, {}, {}});
  scene.model.body_accelerations.push_back({{}, Vec2(0.0, -9.81), FunctionId{0}});
  scene.add("base", rectangle(-2.0, -1.0, 2.0, 0.0), true);
  Stage& stage = scene.stage("dda", Integrator::partitioned, 0.5, dt, 0.5);
  for (int i = 0; i < 4; ++i) {
    const BlockId b = scene.add("b" + std::to_string(i), rectangle(-0.5, 0.5 * i, 0.5, 0.5 * i + 0.5));
    if (i == 3) stage.partition.explicit_blocks.push_back(b);
    if (i >= 2) scene.model.initial_velocities.push_back({b, Vec2(1.0, 0.0), 0.0});
  }
  stage.partition.shared_contacts = shared;
  scene.plan.output.history_every = ticks(1e-2);
  return scene;
}

TEST(SharedContacts, move_blocks_as_separated_ones_do_and_close_the_ledger) {
  std::vector<double> apart;              // largest distance between both algorithms' results, over the longest path
  for (const double dt : {8e-4, 4e-4}) {  // at shorter ones friction flutters, see cases/newmark-block
    std::vector<Vec2> at[2];
    for (const bool shared : {false, true}) {
      const Scene scene = column(shared, dt);
      Driver run(scene.model, scene.plan, methods());
      const RunEnd end = run.run();
      ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
      for (std::int32_t b = 1; b <= 4; ++b) at[shared ? 1 : 0].push_back(centre_of(run, BlockId{b}));
      const Ledger& ledger = run.state().ledger;
      EXPECT_LT(ledger.relative_closure(), 1e-11);
      EXPECT_GT(ledger[Column::friction], 0.0);
      if (shared) {
        EXPECT_EQ(ledger[Column::contact_closing], 0.0) << "a contact of the open-close iteration";
      }
    }
    apart.push_back(0.0);
    for (std::size_t b = 0; b < 4; ++b) apart.back() = std::max(apart.back(), (at[0][b] - at[1][b]).norm());
    apart.back() /= at[0][3].x();
    std::printf("dt %.1e s: the upper block went %.4f m, blocks apart %.2e of it\n", dt, at[0][3].x(), apart.back());
    EXPECT_GT(at[0][3].x(), 0.05);
  }
  EXPECT_LT(apart[0], 2e-3);
  EXPECT_LT(apart[1], 2e-3);
}

}  // namespace
}  // namespace scree::test::divided_test
