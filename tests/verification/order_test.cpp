// Orders in time of the schemes and of hand-overs between them: a block that oscillates on springs under its weight and
// a sinusoidal load, against the motion that is exact in time.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <tuple>

#include "coupling/integrate/newmark.h"
#include "coupling/transfer/transfer.h"
#include "model/dense_algebra.h"
#include "tests/support/by_hand.h"
#include "tests/support/nmm_block.h"
#include "tests/support/order_table.h"
#include "tests/support/schemes.h"

namespace scree::test::order_test {
namespace {

using coupling::CentralDifference;
using coupling::Integrator;
using coupling::Newmark;
using coupling::NewmarkScheme;

const auto* const kTables = testing::AddGlobalTestEnvironment(new OrderTable);

constexpr double kStage = 0.04;     // of a stage [s]: a fifth of the block's slowest period, 8 fastest periods
constexpr double kCoarsest = 1e-3;  // [s], two fifths of the certified explicit step
constexpr int kHalvings = 7;
constexpr double kClosure = 1e-9;
constexpr double kFar = 1.0;  // admissible movement of a point per step, so large that no step is cut [m]

struct TimeScheme {
  Integrator integrator;
  NewmarkScheme newmark = NewmarkScheme::damped;
};
constexpr TimeScheme kCentral{Integrator::explicit_}, kTrapezoidal{Integrator::implicit, NewmarkScheme::trapezoidal},
    kDamped{Integrator::implicit, NewmarkScheme::damped};

/// Explicit stages use the affine-exact mass and implicit ones the consistent mass, as in users' runs: the reference of
/// a hand-over is the motion with one mass and then with the other.
Scene swinging_block(Kinematics kinematics, const std::vector<TimeScheme>& schemes, double h) {
  Scene scene(1e7, 0.2, 2000.0);
  const BlockId id = scene.add("block", {{{0, 0}, {2, 0.3}, {1.5, 1.2}, {0.2, 1}}, {}});
  for (const Vec2& x : {Vec2(0.0, 0.0), Vec2(2.0, 0.3), Vec2(0.2, 1.0)})
    scene.model.point_supports.push_back({id, x, true, true, 2e6});
  scene.model.functions.push_back({"beat", TimeFunction::Shape::sine, 1.0, 0.0, 0.0, 15.0, {}, {}, {}});
  scene.model.point_loads.push_back({id, {1.5, 1.2}, {1e4, -5e3}, FunctionId{0}});
  // Linear stages admit no rotation above 0.01 rad at their start.
  scene.model.initial_velocities.push_back({id, {0.3, -0.2}, kinematics == Kinematics::linear ? 0.1 : 2.0});
  scene.plan.detection = 4.0 * kFar;
  for (const TimeScheme& s : schemes) {
    coupling::Stage& stage = scene.stage("nmm", s.integrator, kStage, h, 0.5);
    stage.kinematics = kinematics;
    stage.newmark = s.newmark;
    stage.control.max_displacement = kFar;
  }
  return scene;
}

/// Positions and velocities of all covers.
struct Motion {
  std::vector<double> q, v;
};

/// The equations of the covers in a stage, M q'' = f(q, t), and their solution independent of Scree's time schemes.
class Equations {
 public:
  Equations(const Model& model, const coupling::Stage& stage)
      : model_(model),
        block_(model.blocks[0].polygon, coupling::body_requests(model, stage)[0].form, model.materials[0]),
        unknown_(block_.unknowns(&unknowns_)) {
    for (const PointSupport& s : model.point_supports) supports_.push_back(row_of(s.point));
  }
  [[nodiscard]] Motion start() const {
    const InitialVelocity& i = model_.initial_velocities[0];
    AffineMotion m;
    m.c = block_.centre();
    m.vc = i.velocity;
    m.Fdot = i.spin * quarter_turn();
    Motion out{block_.q, block_.v};
    block_.pool.place(0, m, out.q, out.v);
    return out;
  }
  void advance_by_modes(Motion& m, double t0, double t1) const;
  void advance_by_runge_kutta(Motion& m, double t0, double t1) const;
  [[nodiscard]] std::vector<double> acceleration(const std::vector<double>& q, double t) const;
  /// Root mean square of the difference over the mass of the block.
  [[nodiscard]] double distance(const std::vector<double>& a, const std::vector<double>& b) const {
    std::vector<double> difference(a);
    for (std::size_t i = 0; i < a.size(); ++i) difference[i] -= b[i];
    return std::sqrt(2.0 * block_.pool.kinetic_energy(block_.q, difference, std::array<char, 1>{1}) /
                     block_.shape.mass);
  }

 private:
  [[nodiscard]] Row row_of(const Vec2& point) const { return block_.pool.row_at(0, point - block_.centre()); }
  [[nodiscard]] Eigen::VectorXd free(const std::vector<double>& all) const {
    Eigen::VectorXd out(unknowns_);
    for (std::size_t c = 0; c < unknown_.size(); ++c)
      if (unknown_[c] >= 0) out.segment<2>(unknown_[c]) = Vec2(all[2 * c], all[2 * c + 1]);
    return out;
  }
  [[nodiscard]] Eigen::VectorXd point_force(const Row& row, const Vec2& force) const {
    std::vector<double> f(block_.q.size(), 0.0);
    coupling::add_force(row, force, f);
    return block_.folded(f);
  }
  [[nodiscard]] Eigen::MatrixXd mass() const;

  const Model& model_;
  NmmBlock block_;
  int unknowns_ = 0;
  std::vector<int> unknown_;  // as NmmBlock::unknowns
  std::vector<Row> supports_;
};

Eigen::MatrixXd Equations::mass() const {
  Eigen::MatrixXd inverse(unknowns_, unknowns_);
  std::vector<double> f(block_.q.size(), 0.0), a(f);
  for (std::size_t c = 0; c < unknown_.size(); ++c)
    for (std::size_t d = 0; d < 2 && unknown_[c] >= 0; ++d) {
      f[2 * c + d] = 1.0;
      block_.pool.mass_solve(block_.q, f, a);
      inverse.col(unknown_[c] + static_cast<int>(d)) = free(a);
      f[2 * c + d] = 0.0;
    }
  const Eigen::MatrixXd M = inverse_of(inverse);
  return 0.5 * (M + M.transpose());
}

/// Linear kinematics: mode by mode, n'' + w^2 n = g + p sin(W t) has
///   n = g/w^2 + p sin(W t)/(w^2 - W^2) + a cos(w t) + b sin(w t).
void Equations::advance_by_modes(Motion& m, double t0, double t1) const {
  Eigen::MatrixXd K = block_.stiffness();
  for (std::size_t i = 0; i < supports_.size(); ++i)
    for (const Vec2& axis : {Vec2(1.0, 0.0), Vec2(0.0, 1.0)}) {
      const Eigen::VectorXd r = point_force(supports_[i], axis);
      K += *model_.point_supports[i].stiffness * r * r.transpose();
    }
  const Eigen::MatrixXd M = mass();
  const Modes solution = generalized_modes(K, M);
  const Eigen::MatrixXd& modes = solution.vectors;  // modes^T M modes = I

  std::vector<double> weight(block_.q.size(), 0.0);
  block_.pool.body_force(model_.gravity, weight);
  const PointLoad& load = model_.point_loads[0];
  const double W = 2.0 * std::numbers::pi * model_.functions[load.function.index()].frequency;
  const Eigen::ArrayXd w2 = solution.values, w = w2.sqrt(),
                       rest = (modes.transpose() * block_.folded(weight)).array() / w2,
                       beat = (modes.transpose() * point_force(row_of(load.point), load.force)).array() / (w2 - W * W);
  const auto forced = [&](double t) -> Eigen::ArrayXd { return rest + beat * std::sin(W * t); };
  const auto forced_rate = [&](double t) -> Eigen::ArrayXd { return W * beat * std::cos(W * t); };

  const Eigen::MatrixXd project = modes.transpose() * M;
  const Eigen::ArrayXd a = (project * (free(m.q) - free(block_.q))).array() - forced(t0),
                       b = ((project * free(m.v)).array() - forced_rate(t0)) / w, c = (w * (t1 - t0)).cos(),
                       s = (w * (t1 - t0)).sin();
  const std::vector<double> u = block_.spread(modes * (forced(t1) + a * c + b * s).matrix());
  m.v = block_.spread(modes * (forced_rate(t1) + w * (b * c - a * s)).matrix());
  m.q = block_.q;
  for (std::size_t i = 0; i < u.size(); ++i) m.q[i] += u[i];
}

std::vector<double> Equations::acceleration(const std::vector<double>& q, double t) const {
  std::vector<double> f(q.size(), 0.0), a(f);
  (void)block_.pool.internal_force(q, f);
  block_.pool.body_force(model_.gravity, f);
  const PointLoad& load = model_.point_loads[0];
  coupling::add_force(row_of(load.point), model_.factor(load.function, t) * load.force, f);
  for (std::size_t i = 0; i < supports_.size(); ++i) {
    const PointSupport& s = model_.point_supports[i];
    coupling::add_force(supports_[i], *s.stiffness * (s.point - coupling::position(supports_[i], q)), f);
  }
  block_.pool.mass_solve(q, f, a);
  return a;
}

/// Any kinematics: Kutta's method of order 4, with steps whose error is 1e-11 of the motion.
void Equations::advance_by_runge_kutta(Motion& m, double t0, double t1) const {
  constexpr int kSteps = 4000;
  const double h = (t1 - t0) / kSteps;
  const auto moved = [](std::vector<double> x, double by, const std::vector<double>& rate) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += by * rate[i];
    return x;
  };
  for (int n = 0; n < kSteps; ++n) {
    const double t = t0 + n * h;
    const std::vector<double> a1 = acceleration(m.q, t), v2 = moved(m.v, 0.5 * h, a1),
                              a2 = acceleration(moved(m.q, 0.5 * h, m.v), t + 0.5 * h), v3 = moved(m.v, 0.5 * h, a2),
                              a3 = acceleration(moved(m.q, 0.5 * h, v2), t + 0.5 * h), v4 = moved(m.v, h, a3),
                              a4 = acceleration(moved(m.q, h, v3), t + h);
    for (std::size_t i = 0; i < m.q.size(); ++i) {
      m.q[i] += h / 6.0 * (m.v[i] + 2.0 * (v2[i] + v3[i]) + v4[i]);
      m.v[i] += h / 6.0 * (a1[i] + 2.0 * (a2[i] + a3[i]) + a4[i]);
    }
  }
}

/// The exact motion at the end of the stages of a scene, and the equations that measure errors there.
struct Reference {
  Scene scene;
  Motion motion;
  std::unique_ptr<Equations> equations;  // of the last stage

  /// @param late  each hand-over gives v - late a in place of v [s]
  explicit Reference(Scene of, double late = 0.0) : scene(std::move(of)) {
    double t = 0.0;
    for (const coupling::Stage& stage : scene.plan.stages) {
      if (t > 0.0) {
        const std::vector<double> a = equations->acceleration(motion.q, t);
        for (std::size_t i = 0; i < a.size(); ++i) motion.v[i] -= late * a[i];
      }
      equations = std::make_unique<Equations>(scene.model, stage);
      if (t == 0.0) motion = equations->start();
      if (stage.kinematics == Kinematics::linear)
        equations->advance_by_modes(motion, t, t + kStage);
      else
        equations->advance_by_runge_kutta(motion, t, t + kStage);
      t += kStage;
    }
  }
};

/// Errors of displacement [m] and velocity [m/s] as functions of the step, for one table.
struct Errors {
  OrderRow u, v;
  Errors(const std::string& path, Kinematics kinematics) {
    const std::string of = path + (kinematics == Kinematics::linear ? ", linear: " : ", corotational: ");
    u.what = of + "u over dt";
    v.what = of + "v over dt";
  }
  void add(double h, const coupling::State& state, const Reference& exact) {
    u.size.push_back(h);
    v.size.push_back(h);
    u.error.push_back(exact.equations->distance(state.q, exact.motion.q));
    v.error.push_back(exact.equations->distance(state.v, exact.motion.v));
  }
  void expect(double order) {
    expect_order_of(std::move(u), order);
    expect_order_of(std::move(v), order);
  }
};

double step_after(int halvings) { return std::ldexp(kCoarsest, -halvings); }

struct Path {
  const char* name;
  const char* title;
  std::vector<TimeScheme> stages;
  double order;
};
std::ostream& operator<<(std::ostream& out, const Path& p) { return out << p.name; }

class Order : public testing::TestWithParam<std::tuple<Path, Kinematics>> {};

TEST_P(Order, of_displacement_and_velocity_is_that_of_the_theory) {
  const auto& [path, kinematics] = GetParam();
  const Reference exact(swinging_block(kinematics, path.stages, kCoarsest));
  Errors errors(path.title, kinematics);
  for (int k = 0; k <= kHalvings; ++k) {
    const double h = step_after(k);
    const Scene scene = swinging_block(kinematics, path.stages, h);
    coupling::Driver run(scene.model, scene.plan, methods());
    const coupling::RunEnd end = run.run();
    ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
    ASSERT_EQ(run.stats().steps, static_cast<std::int64_t>(path.stages.size()) * ticks(kStage) / ticks(h));
    EXPECT_LE(run.state().ledger.relative_closure(), kClosure) << "step " << h;
    errors.add(h, run.state(), exact);
  }
  errors.expect(path.order);
}

// A hand-over to (1/2, 1) is of first order because that scheme is.
INSTANTIATE_TEST_SUITE_P(
    all, Order,
    testing::Combine(
        testing::Values(
            Path{"central_difference", "central difference", {kCentral}, 2.0},
            Path{"trapezoidal", "(1/4, 1/2)", {kTrapezoidal}, 2.0}, Path{"damped", "(1/2, 1)", {kDamped}, 1.0},
            Path{"central_to_trapezoidal", "central difference -> (1/4, 1/2)", {kCentral, kTrapezoidal}, 2.0},
            Path{"trapezoidal_to_central", "(1/4, 1/2) -> central difference", {kTrapezoidal, kCentral}, 2.0},
            Path{"central_to_damped", "central difference -> (1/2, 1)", {kCentral, kDamped}, 1.0}),
        testing::Values(Kinematics::linear, Kinematics::corotational)),
    [](const auto& test) {
      return std::string(std::get<0>(test.param).name) +
             (std::get<1>(test.param) == Kinematics::linear ? "_linear" : "_corotational");
    });

TEST(OrderReference, runge_kutta_meets_the_modes_of_a_linear_block) {
  for (const TimeScheme& scheme : {kCentral, kTrapezoidal}) {
    const Scene scene = swinging_block(Kinematics::linear, {scheme}, kCoarsest);
    const Equations equations(scene.model, scene.plan.stages[0]);
    Motion a = equations.start(), b = a;
    equations.advance_by_modes(a, 0.0, kStage);
    equations.advance_by_runge_kutta(b, 0.0, kStage);
    EXPECT_LT(equations.distance(a.q, b.q), 1e-10 * equations.distance(a.q, equations.start().q));
    EXPECT_LT(equations.distance(a.v, b.v), 1e-10 * equations.distance(a.v, equations.start().v));
  }
}

double kinetic_energy(const coupling::Setup& setup, const coupling::State& state) {
  return setup.pool(0).kinetic_energy(state.q, state.v, setup.counted(0));
}

/// The two stages of a scene without the driver.
struct HandOverByHand {
  coupling::State state;
  double lost = 0.0;  // kinetic energy lost because v_{n-1/2} replaces v_n [J]

  HandOverByHand(const Scene& scene, double h, bool synchronised) {
    const std::vector<coupling::Stage>& stages = scene.plan.stages;
    ByHand run(scene.model, stages[0]);
    CentralDifference first(*run.setup, stages[0].control, scene.plan.detection);
    go(first, run.state, h);
    const std::vector<double> a = run.state.a;
    first.leave(run.state);
    if (!synchronised) {
      lost = kinetic_energy(*run.setup, run.state);
      for (std::size_t i = 0; i < a.size(); ++i) run.state.v[i] -= 0.5 * h * a[i];
      lost -= kinetic_energy(*run.setup, run.state);
    }
    const coupling::TransferReport handed =
        coupling::transfer_bodies(scene.model, run.methods, *run.setup, stages[1], run.state);
    Newmark second(*handed.setup, stages[1].control, scene.plan.detection, {.scheme = stages[1].newmark});
    go(second, run.state, h);
    second.update_ledger(run.state);
    state = std::move(run.state);
  }

 private:
  static void go(coupling::TimeIntegrator& integrator, coupling::State& state, double h) {
    (void)integrator.enter(state);
    for (const Tick end = state.time + ticks(kStage); state.time < end;) {
      const coupling::StepReport report = integrator.step(state, ticks(h));
      ASSERT_EQ(report.status, coupling::StepReport::Status::ok) << report.cause;
    }
  }
};

class UnsynchronisedOrder : public testing::TestWithParam<Kinematics> {};

TEST_P(UnsynchronisedOrder, is_the_first_and_the_ledger_is_open_by_what_is_lost) {
  const Kinematics kinematics = GetParam();
  const std::vector<TimeScheme> stages{kCentral, kTrapezoidal};
  const Reference exact(swinging_block(kinematics, stages, kCoarsest));
  Errors errors("v_{n-1/2} handed to (1/4, 1/2)", kinematics);
  for (int k = 0; k <= kHalvings; ++k) {
    const double h = step_after(k);
    const Scene scene = swinging_block(kinematics, stages, h);
    // Apart from the velocity this is the driver's hand-over.
    coupling::Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
    const HandOverByHand synchronised(scene, h, true), unsynchronised(scene, h, false);
    EXPECT_EQ(synchronised.state.q, run.state().q);
    EXPECT_EQ(synchronised.state.v, run.state().v);
    EXPECT_LE(synchronised.state.ledger.relative_closure(), kClosure);

    const coupling::Ledger& ledger = unsynchronised.state.ledger;
    EXPECT_LE(std::abs(ledger.closure() + unsynchronised.lost), kClosure * ledger.moved()) << "step " << h;
    EXPECT_GT(std::abs(unsynchronised.lost), 100.0 * kClosure * ledger.moved()) << "step " << h;
    errors.add(h, unsynchronised.state, exact);
  }
  // The error is the exact response to a velocity error of h a/2, up to terms of second order: 0.5 % of it here.
  const double h = step_after(kHalvings);
  const Reference late(swinging_block(kinematics, stages, h), 0.5 * h);
  EXPECT_NEAR(errors.u.error.back() / exact.equations->distance(late.motion.q, exact.motion.q), 1.0, 0.01);
  EXPECT_NEAR(errors.v.error.back() / exact.equations->distance(late.motion.v, exact.motion.v), 1.0, 0.01);
  errors.expect(1.0);
}
INSTANTIATE_TEST_SUITE_P(all, UnsynchronisedOrder, testing::Values(Kinematics::linear, Kinematics::corotational),
                         [](const auto& test) {
                           return std::string(test.param == Kinematics::linear ? "linear" : "corotational");
                         });

}  // namespace
}  // namespace scree::test::order_test
