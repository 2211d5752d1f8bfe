// A new mesh for the same block: transfer of a wave, of a state at rest and of the momenta, against runs on one mesh.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "coupling/bodies/setup.h"
#include "coupling/transfer/transfer.h"
#include "tests/support/scene.h"

namespace scree::test::mesh_change_test {
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

/// Peaks of velocity and stress along the bar at a monitor, closure of the ledger, and transfers.
struct Passed {
  double velocity = 0.0, stress = 0.0, closure = 0.0;
  std::vector<TransferRow> rows;
};

constexpr double kLength = 1.0;  // of the pulse in the bar [m]

/// A pulse sin^2 of 1 m runs along a bar of 4 m. When its middle is at 1.5 m the further stages begin, one after the
/// other, all but the last of them very short; the wave is measured at 3 m.
/// @param sizes  cover sizes of the NMM; 0: DDA
Passed pass(const std::vector<double>& sizes, Kinematics kinematics, Integrator integrator = Integrator::explicit_) {
  Scene scene(62.5e9, 0.0, 2500.0);
  Model& model = scene.model;
  model.plane = Plane::stress;
  model.gravity.setZero();
  const double speed = 5000.0;
  const BlockId bar = scene.add("bar", rectangle(0.0, 0.0, 4.0, 0.1));
  model.functions.push_back({"pulse", TimeFunction::Shape::sine_squared, 1.0, 0.0, kLength / speed, 0.0, {}, {}, {}});
  model.tractions.push_back({{bar, {0, 3}, 0.0, 1.0}, Vec2(1e6, 0.0), FunctionId{0}});
  model.monitors.push_back({"behind", bar, Vec2(3.0, 0.05)});
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const bool first = i == 0, last = i + 1 == sizes.size();
    const double duration = (first && last ? 3.9 : first ? 2.0 : last ? 1.9 : 1e-3) / speed;
    Stage& stage = scene.stage(sizes[i] > 0.0 ? "nmm" : "dda", integrator, duration, std::nullopt, sizes[i]);
    stage.kinematics = kinematics;
    if (integrator == Integrator::implicit) stage.dt = 1e-6;
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
  // Pulses of ten covers and more. One mesh alone disperses the shortest ones: peaks are compared with its peaks.
  std::printf("covers a pulse   h'/h     peak v   peak stress   T'/T     U'/U     closure\n");
  struct Case {
    double covers, ratio;
    Kinematics kinematics;
  };
  for (const auto& [covers, ratio, kinematics] :
       {Case{10.0, 0.7, Kinematics::linear}, Case{10.0, 0.5, Kinematics::linear}, Case{20.0, 0.7, Kinematics::linear},
        Case{20.0, 0.5, Kinematics::corotational}, Case{20.0, 2.0, Kinematics::linear}}) {
    const double h = kLength / covers;
    const Passed one = pass({h}, kinematics), changed = pass({h, ratio * h}, kinematics);
    ASSERT_EQ(changed.rows.size(), 1U);
    const BodyTotals &before = changed.rows[0].before, &after = changed.rows[0].after;
    const double v = changed.velocity / one.velocity, stress = changed.stress / one.stress;
    std::printf("%10.0f %12.1f %10.4f %10.4f %11.4f %8.4f    %.0e\n", covers, ratio, v, stress,
                after.kinetic / before.kinetic, after.elastic / before.elastic, changed.closure);
    expect_clean(changed);
    EXPECT_GT(v, 0.98);
    EXPECT_GT(stress, ratio < 1.0 ? 0.98 : 0.95);  // ten covers: less than half as many elements in a pulse
    EXPECT_LE(after.kinetic, before.kinetic * (1.0 + 1e-12));
    EXPECT_LE(after.elastic, before.elastic * (1.0 + 1e-6));
    EXPECT_GT(after.kinetic + after.elastic, 0.98 * (before.kinetic + before.elastic));
  }
}

TEST(MeshChange, a_wave_waits_while_the_block_is_affine_and_goes_on_with_another_mesh) {
  const double h = kLength / 20.0;
  const Passed same = pass({h, 0.0, h}, Kinematics::corotational),
               other = pass({h, 0.0, 0.7 * h}, Kinematics::corotational);
  std::printf("NMM -> DDA -> NMM: peak with another mesh %.4f of that with the same\n", other.velocity / same.velocity);
  expect_clean(same);
  expect_clean(other);
  EXPECT_GT(other.velocity, 0.98 * same.velocity);
  EXPECT_GT(other.stress, 0.98 * same.stress);
}

TEST(MeshChange, implicit_steps_hand_a_wave_over_too) {
  const double h = kLength / 20.0;
  const Passed one = pass({h}, Kinematics::linear, Integrator::implicit),
               changed = pass({h, 0.7 * h}, Kinematics::linear, Integrator::implicit);
  expect_clean(changed);
  EXPECT_GT(changed.velocity, 0.98 * one.velocity);
  EXPECT_GT(changed.stress, 0.98 * one.stress);
}

/// Blocks of every kind, turned, stretched, bent and shaken at random, before a change of mesh.
class Shaken {
 public:
  explicit Shaken(std::uint32_t seed) : generator_(seed), scene_(1e9, 0.25, 2500.0) {
    for (int n = 0; n < 10; ++n) {
      const BlockId id = scene_.add("block " + std::to_string(n), polygon({10.0 * n, 0.0}));
      if (n % 3 == 1) {
        Crack crack;
        crack.block = id;
        crack.joint = JointId{0};
        crack.from = Vec2(10.0 * n - 2.0, number(-0.2, 0.2));
        crack.to = Vec2(10.0 * n + number(-0.2, 2.0), number(-0.2, 0.2));
        scene_.model.cracks.push_back(crack);
      }
    }
    before_ = scene_.stage("nmm", Integrator::partitioned, 1.0, 1e-4, number(0.2, 0.35));
    divide(before_);
    state.bodies = coupling::initial_records(scene_.model, coupling::body_requests(scene_.model, before_));
    setup = std::make_unique<coupling::Setup>(scene_.model, methods(), state.bodies);
    state.q.assign(2 * static_cast<std::size_t>(setup->nodes()), 0.0);
    state.v = state.q;
    double kinetic = 0.0, elastic = 0.0;
    for (const coupling::Body& b : setup->bodies()) {
      shake(b);
      const BodyTotals t = totals_of(*setup, state, b);
      kinetic += t.kinetic;
      elastic += t.elastic;
    }
    state.ledger.set(Column::elastic, elastic);
    state.ledger.open(std::array{kinetic});
  }

  std::vector<TransferRow> change() {
    Stage stage = before_;
    stage.cover_size = number(0.12, 0.5);
    if (number(0.0, 1.0) < 0.5) {
      stage.integrator = Integrator::explicit_;  // and each block is one body again
      stage.partition = {};
    }
    coupling::TransferReport handed = coupling::transfer_bodies(scene_.model, methods(), *setup, stage, state);
    setup = std::move(handed.setup);
    return std::move(handed.rows);
  }

  coupling::State state;
  std::unique_ptr<coupling::Setup> setup;

 private:
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator_); }
  Polygon polygon(const Vec2& centre) {
    const int corners = std::uniform_int_distribution<int>(3, 7)(generator_);
    Polygon p;
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + number(-0.25, 0.25)) / corners, r = number(1.0, 1.5);
      p.outer.push_back(centre + r * Vec2(std::cos(angle), std::sin(angle)));
    }
    return p;
  }
  /// Every third block lies across the border of the explicit region.
  static void divide(Stage& stage) {
    stage.partition.explicit_region = {{55.0, -3.0}, {60.1, -3.0}, {59.9, 3.0}, {55.0, 3.0}};
    stage.partition.substeps = 1;
  }
  void shake(const coupling::Body& b) {
    const Pool& pool = setup->pool_of(b);
    const auto p = static_cast<std::size_t>(b.pool);
    const std::span<double> q = setup->part(std::span(state.q), p), v = setup->part(std::span(state.v), p);
    AffineMotion m;
    m.c = {number(-1.0, 1.0), number(-1.0, 1.0)};
    m.F = Eigen::Rotation2Dd(number(-3.0, 3.0)).toRotationMatrix() *
          (Mat2() << 1.0 + number(-0.01, 0.01), number(-0.01, 0.01), number(-0.01, 0.01), 1.0 + number(-0.01, 0.01))
              .finished();
    m.vc = {number(-3.0, 3.0), number(-3.0, 3.0)};
    m.Fdot = quarter_turn() * number(-5.0, 5.0) * m.F;
    pool.place(b.index, m, q, v);
    const auto first = static_cast<std::size_t>(b.first_node - setup->pool_first(p));
    const double phase = number(0.0, 3.0);
    for (std::size_t k = first; k < first + static_cast<std::size_t>(b.nodes); ++k) {
      const Vec2 x(q[2 * k], q[2 * k + 1]);
      const double s = std::sin(1.5 * (x - m.c).sum() + phase), c = std::cos(2.0 * (x - m.c).x() + phase);
      q[2 * k] += 3e-3 * s;
      q[2 * k + 1] += 2e-3 * c;
      v[2 * k] += 0.5 * c;
      v[2 * k + 1] -= 0.4 * s;
    }
    pool.settle(b.index, q, v);
  }

  std::mt19937 generator_;
  Scene scene_;
  Stage before_;
};

TEST(MeshChange, momenta_and_books_of_cracked_and_divided_blocks_are_exact) {
  double lost = 0.0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    Shaken blocks(seed);
    for (int times = 0; times < 2; ++times) {
      const auto rows = blocks.change();
      ASSERT_EQ(rows.size(), 10U);
      for (const TransferRow& row : rows) {
        EXPECT_LT(row.mass_error, 1e-12);
        EXPECT_LT(row.momentum_error, 1e-12) << seed << " " << row.block.value;
        EXPECT_LT(row.angular_error, 1e-12) << seed << " " << row.block.value;
        EXPECT_LT(row.energy_error, 1e-12);
        EXPECT_LE(row.after.kinetic, row.before.kinetic * (1.0 + 1e-12));
        EXPECT_EQ(row.reservoir_kinetic, 0.0);
        EXPECT_LT((row.after.centre - row.before.centre).norm(), 1e-12);
        // The waves span ten covers and more; shorter motion does not become rotation or strain of the new covers.
        EXPECT_LE(row.after.elastic, row.before.elastic * 1.001);
        lost = std::max(lost, row.booked / (row.before.kinetic + row.before.elastic));
      }
      EXPECT_LT(std::abs(blocks.state.ledger.closure()), 1e-12 * blocks.state.ledger[Column::kinetic]);
    }
  }
  std::printf("random blocks: at most %.4f of kinetic and elastic energy is lost\n", lost);
  EXPECT_LT(lost, 0.06);
}

/// Stacked blocks come to rest; then the mesh changes, and the run continues for 20 ms.
struct Rested {
  double force = 0.0, kinetic = 0.0, elastic = 0.0;  // force on the base [N]; largest kinetic, final elastic energy [J]
  std::vector<TransferRow> rows;
};
Rested rest(double ratio) {
  Scene scene(1e9, 0.2, 2500.0);
  scene.add("base", rectangle(-1.0, -1.0, 4.0, 0.0), true);
  scene.add("block", rectangle(0.0, 0.0, 3.0, 2.0));
  scene.add("top", rectangle(0.7, 2.0, 2.2, 3.5));
  scene.stage("nmm", Integrator::implicit, 0.25, 2e-3, 0.4).rest = true;
  scene.stage("nmm", Integrator::implicit, 0.02, 1e-3, 0.4 * ratio);
  struct Watch final : coupling::Sink {
    double kinetic = 0.0;
    void history(const HistoryView& h) override {
      if (h.time > 0.2501) kinetic = std::max(kinetic, (*h.ledger)[Column::kinetic]);
    }
  } watch;
  scene.plan.output.history_every = ticks(1e-3);
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(watch);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  Rested out{0.0, watch.kinetic, run.state().ledger[Column::elastic], run.transfers()};
  for (const coupling::ContactMemory& m : run.state().contacts)
    if (m.key.block_p == 0 || m.key.block_e == 0) out.force += m.fn;
  return out;
}

TEST(MeshChange, contact_forces_stay_and_what_rests_rests) {
  const double weight = 2500.0 * 9.81 * (6.0 + 2.25);
  const Rested same = rest(1.0);
  for (const double ratio : {0.6, 1.7}) {
    const Rested other = rest(ratio);
    ASSERT_EQ(other.rows.size(), 2U);
    const double held = other.rows[0].after.elastic / other.rows[0].before.elastic;
    std::printf(
        "h' = %.1f h: contact force %.5f of the weight (same mesh %.5f), U'/U %.4f, kinetic / elastic %.1e (%.1e)\n",
        ratio, other.force / weight, same.force / weight, held, other.kinetic / same.elastic,
        same.kinetic / same.elastic);
    EXPECT_NEAR(other.force, same.force, 0.01 * weight);
    EXPECT_GT(held, 0.96);
    EXPECT_LT(other.kinetic, 0.01 * same.elastic);
  }
}

}  // namespace
}  // namespace scree::test::mesh_change_test
