// The NMM in implicit steps: orders of accuracy in time compared with fine explicit steps, energy balance, static
// solutions, change to explicit steps.
#include <gtest/gtest.h>

#include "coupling/integrate/central_difference.h"
#include "coupling/integrate/newmark.h"
#include "tests/support/schemes.h"

namespace scree::test::implicit_nmm_test {
namespace {

using coupling::Column;
using coupling::Integrator;
using coupling::Newmark;
using coupling::NewmarkScheme;
using coupling::State;

/// One free block that starts stretched, turned and spinning.
struct Released {
  Scene scene{1e7, 0.2, 2000.0};
  State state;
  std::unique_ptr<coupling::Setup> setup;
  coupling::StepControl control;

  explicit Released(Kinematics kinematics, MassKind mass = MassKind::consistent) {
    scene.model.gravity = {0.0, 0.0};
    scene.add("block", {{{0, 0}, {2, 0.3}, {1.5, 1.2}, {0.2, 1}}, {}});
    state.bodies =
        coupling::initial_records(scene.model, {{"nmm", {.kinematics = kinematics, .mass = mass, .cover_size = 0.5}}});
    setup = std::make_unique<coupling::Setup>(scene.model, methods(), state.bodies);
    state.q.assign(2 * static_cast<std::size_t>(setup->nodes()), 0.0);
    state.v = state.q;
    AffineMotion m;
    m.c = setup->bodies()[0].centre;
    m.F << 1.01, 0.004, -0.002, 0.99;
    m.Fdot = 0.5 * quarter_turn();
    setup->pool(0).place(0, m, state.q, state.v);
    std::vector<double> f(state.q.size(), 0.0);
    const std::array energies{setup->pool(0).kinetic_energy(state.q, state.v, setup->counted(0)),
                              setup->pool(0).internal_force(state.q, f)};
    state.ledger.open(energies);
    control.max_displacement = 1.0;
  }
  void run(coupling::TimeIntegrator& integrator, double duration, double h) {
    (void)integrator.enter(state);
    const Tick step = ticks(h);
    for (Tick t = 0; t + step <= ticks(duration); t += step) {
      const coupling::StepReport report = integrator.step(state, step);
      ASSERT_EQ(report.status, coupling::StepReport::Status::ok) << report.cause;
    }
    integrator.update_ledger(state);
  }
  void run(NewmarkScheme scheme, double duration, double h) {
    Newmark integrator(*setup, control, 0.05, {.scheme = scheme});
    run(integrator, duration, h);
  }
};

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(ImplicitNmm, schemes_meet_explicit_steps_with_orders_one_and_two) {
  const double duration = 0.016;  // half a period of the slowest mode
  Released reference(Kinematics::corotational);
  coupling::CentralDifference explicit_integrator(*reference.setup, reference.control, 0.05, {});
  reference.run(explicit_integrator, duration, 1e-6);
  for (const auto& [scheme, order] :
       {std::pair(NewmarkScheme::damped, 1.0), std::pair(NewmarkScheme::trapezoidal, 2.0)}) {
    std::vector<double> errors;
    for (const double h : {1e-4, 5e-5, 2.5e-5}) {
      Released r(Kinematics::corotational);
      r.run(scheme, duration, h);
      errors.push_back(distance(r.state.q, reference.state.q));
      EXPECT_LT(r.state.ledger.relative_closure(), 1e-9);
    }
    const double seen = std::log2(errors[1] / errors[2]);
    std::printf("order %g expected: errors %.3e %.3e %.3e, order %.3f\n", order, errors[0], errors[1], errors[2], seen);
    EXPECT_NEAR(seen, order, 0.15);
  }
}

TEST(ImplicitNmm, trapezoidal_scheme_keeps_the_energy_of_a_linear_block) {
  Released r(Kinematics::linear);
  const double before = r.state.ledger.energy();
  r.run(NewmarkScheme::trapezoidal, 0.2, 1e-3);
  EXPECT_NEAR(r.state.ledger.energy() / before, 1.0, 1e-11);
  EXPECT_LT(r.state.ledger.relative_closure(), 1e-11);
}

TEST(ImplicitNmm, damped_scheme_loses_what_its_column_says) {
  Released r(Kinematics::corotational);
  r.run(NewmarkScheme::damped, 0.02, 1e-4);
  const coupling::Ledger& ledger = r.state.ledger;
  EXPECT_GT(ledger[Column::newmark_damping], 0.01 * ledger[Column::kinetic]);
  EXPECT_LT(ledger.relative_closure(), 1e-9);
}

TEST(ImplicitNmm, free_spin_keeps_momentum_and_grows_no_energy) {
  Scene scene(1e7, 0.2, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  const BlockId id = scene.add("block", rectangle(0, 0, 2, 1));
  scene.model.initial_velocities.push_back({id, {1.0, 0.5}, 2.0});
  scene.stage("nmm", Integrator::implicit, 0.5, 1e-3, 0.5).control.max_displacement = 0.1;
  coupling::Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  const BodyTotals t = totals_of(run, id);
  EXPECT_LT((t.momentum - 4000.0 * Vec2(1.0, 0.5)).norm(), 1e-8 * 4000.0);
  // (1/2, 1) in Cartesian unknowns damps a spin w by w h/2 per radian: 1e-3 per radian, over one radian.
  const double J = 2000.0 * 2.0 * 5.0 / 12.0, spin = (t.angular_momentum - cross(t.centre, t.momentum)) / J;
  EXPECT_NEAR(spin, 2.0 * std::exp(-1e-3), 5e-4);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

/// A beam of 8 x 1 m held along its left end.
Scene cantilever(double load) {
  Scene scene(1e9, 0.25, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  const BlockId beam = scene.add("beam", rectangle(0, 0, 8, 1));
  for (int i = 0; i <= 8; ++i) scene.model.point_supports.push_back({beam, {0.0, i / 8.0}, true, true, 1e11});
  EdgeTraction end;
  end.span = {beam, {0, 1}, 0.0, 1.0};  // the right edge
  end.traction = {0.0, load};
  scene.model.tractions.push_back(end);
  scene.model.monitors.push_back({"tip", beam, {8.0, 0.5}});
  return scene;
}

struct Tip final : coupling::Sink {
  double y = 0.0;
  void history(const coupling::HistoryView& h) override { y = h.displacement[1]; }
};

TEST(ImplicitNmm, cantilever_comes_to_the_static_solution_in_few_steps) {
  // E I w = F L^3/3, plane strain; shear adds 6/5 F L/(G A).
  const double E = 1e9 / (1.0 - 0.25 * 0.25), G = 1e9 / 2.5, load = -1e4;
  const double theory = load * 512.0 / (3.0 * E / 12.0) + 1.2 * load * 8.0 / G;
  double last = 1.0;
  for (const double cover : {0.5, 0.25, 0.125}) {
    Scene scene = cantilever(load);
    coupling::Stage& stage = scene.stage("nmm", Integrator::implicit, 1000.0, 10.0, cover);
    stage.rest = true;
    stage.rest_force = 1e-6;
    stage.rest_steps = 10;
    stage.control.max_displacement = 1.0;
    scene.plan.detection = 4.0;
    coupling::Driver run(scene.model, scene.plan, methods());
    Tip tip;
    run.add_sink(tip);
    const coupling::RunEnd end = run.run();
    ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
    const double error = std::abs(tip.y / theory - 1.0);
    std::printf("cover %g: tip %.6e, theory %.6e, error %.3f, %lld steps, closure %.1e\n", cover, tip.y, theory, error,
                static_cast<long long>(run.stats().steps), run.state().ledger.relative_closure());
    EXPECT_LT(error, 0.6 * last);
    last = error;
    EXPECT_LE(run.stats().steps, 5);
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
  }
  EXPECT_LT(last, 0.03);
}

TEST(ImplicitNmm, static_state_is_handed_to_explicit_steps_without_a_jump) {
  Scene scene(1e9, 0.2, 2600.0);
  const BlockId id = scene.add("block", {{{0, 0}, {2, 0}, {1.7, 1.1}, {0.2, 1}}, {}});
  for (const double x : {0.0, 0.5, 1.0, 1.5, 2.0})
    scene.model.point_supports.push_back({id, {x, 0.0}, true, true, 1e10});
  coupling::Stage& first = scene.stage("nmm", Integrator::implicit, 1000.0, 10.0, 0.3);
  first.rest = true;
  first.rest_force = 1e-8;
  scene.stage("nmm", Integrator::explicit_, 1e-3, std::nullopt, 0.3);
  coupling::Driver run(scene.model, scene.plan, methods());
  const coupling::RunEnd end = run.run();
  ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
  double most = 0.0;
  for (const double a : run.state().a) most = std::max(most, std::abs(a));
  std::printf("acceleration after the hand-over %.2e g, closure %.1e\n", most / 9.81,
              run.state().ledger.relative_closure());
  EXPECT_LT(most, 1e-6 * 9.81);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

TEST(ImplicitNmm, moving_block_is_handed_to_explicit_steps_with_closed_books) {
  // The mass matrix changes at the same velocities: the change of kinetic energy is booked.
  Scene scene(1e7, 0.2, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  const BlockId id = scene.add("block", rectangle(0, 0, 2, 1));
  scene.model.initial_velocities.push_back({id, {1.0, 0.0}, 0.0});
  PointLoad pull{id, {2.0, 1.0}, {4e4, 0.0}, {}};
  scene.model.point_loads.push_back(pull);
  scene.stage("nmm", Integrator::implicit, 0.02, 1e-3, 0.4);
  scene.stage("nmm", Integrator::explicit_, 0.02, std::nullopt, 0.4);
  scene.stage("nmm", Integrator::implicit, 0.02, 1e-3, 0.4).kinematics = Kinematics::linear;
  coupling::Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  EXPECT_NE(run.state().ledger[Column::transfer], 0.0);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
  EXPECT_NEAR(totals_of(run, id).momentum.x() / (4000.0 + 4e4 * 0.06), 1.0, 1e-9);
}

TEST(ImplicitNmm, books_close_with_every_damping_and_load) {
  for (const NewmarkScheme scheme : {NewmarkScheme::damped, NewmarkScheme::trapezoidal})
    for (const bool rigid : {false, true}) {
      Scene scene = cantilever(-3e4);
      scene.model.gravity = {0.0, -9.81};
      scene.model.functions.push_back({"beat", TimeFunction::Shape::sine, 1.0, 0.0, 0.0, 8.0, {}, {}, {}});
      scene.model.tractions[0].function = FunctionId{0};
      scene.model.viscous_edges.push_back({{BlockId{0}, {0, 2}, 0.25, 1.0}});
      coupling::Stage& stage = scene.stage("nmm", Integrator::implicit, 0.2, 2e-3, 0.5);
      stage.newmark = scheme;
      stage.damping = 5.0;
      stage.damp_rigid_motion = rigid;
      if (scheme == NewmarkScheme::trapezoidal) stage.kinematics = Kinematics::linear;
      stage.stiffness_damping = 1e-4;
      coupling::Driver run(scene.model, scene.plan, methods());
      const coupling::RunEnd end = run.run();
      ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
      const coupling::Ledger& ledger = run.state().ledger;
      for (const Column c : {Column::mass_damping, Column::stiffness_damping, Column::viscous_edges})
        EXPECT_GT(ledger[c], 1e-6 * ledger.moved()) << coupling::info(c).name;
      EXPECT_NE(ledger[Column::loads], 0.0);
      EXPECT_LT(ledger.relative_closure(), 1e-9);
    }
}

TEST(ImplicitNmm, velocity_scaled_between_steps_is_booked_as_rest_damping) {
  std::array<double, 2> kept{};
  for (const int i : {0, 1}) {
    Released r(Kinematics::corotational);
    Newmark integrator(*r.setup, r.control, 0.05, {.dynamics = i == 0 ? 0.98 : 1.0});
    r.run(integrator, 0.01, 1e-4);
    kept[static_cast<std::size_t>(i)] = r.state.ledger[Column::kinetic];
    EXPECT_EQ(r.state.ledger[Column::rest_damping] > 0.0, i == 0);
    EXPECT_LT(r.state.ledger.relative_closure(), 1e-9);
  }
  EXPECT_LT(kept[0], 0.2 * kept[1]);  // 0.98^200 = 0.018 of the rigid motion
}

TEST(ImplicitNmm, lumped_mass_takes_implicit_steps) {
  Released r(Kinematics::corotational, MassKind::lumped);
  Newmark integrator(*r.setup, r.control, 0.05, {});
  r.run(integrator, 0.001, 1e-4);
}

TEST(ImplicitNmm, copied_state_goes_on_bit_for_bit_with_new_integrators) {
  for (const NewmarkScheme scheme : {NewmarkScheme::damped, NewmarkScheme::trapezoidal}) {
    Released r(Kinematics::corotational);
    Newmark first(*r.setup, r.control, 0.05, {.scheme = scheme});
    (void)first.enter(r.state);
    for (int i = 0; i < 5; ++i) ASSERT_EQ(first.step(r.state, ticks(1e-4)).status, coupling::StepReport::Status::ok);
    State copy = r.state;
    const Tick last = copy.last_step;
    for (int i = 0; i < 5; ++i) (void)first.step(r.state, ticks(1e-4));
    Newmark second(*r.setup, r.control, 0.05, {.scheme = scheme});
    (void)second.enter(copy);
    copy.last_step = last;  // enter() begins a stage; a restart continues a stage
    for (int i = 0; i < 5; ++i) (void)second.step(copy, ticks(1e-4));
    EXPECT_EQ(coupling::state_hash(copy), coupling::state_hash(r.state));
  }
}

TEST(ImplicitNmm, mass_damping_spares_sliding_and_spin) {
  Scene scene(1e7, 0.2, 2000.0);
  scene.model.gravity = {0.0, -9.81};
  const BlockId id = scene.add("block", rectangle(0, 0, 2, 1));
  scene.stage("nmm", Integrator::implicit, 0.1, 1e-3, 0.4).damping = 300.0;
  coupling::Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  EXPECT_NEAR(totals_of(run, id).momentum.y() / (-9.81 * 0.1 * 4000.0), 1.0, 1e-9);
}

TEST(ImplicitNmm, affine_exact_mass_and_dda_with_the_trapezoid_are_refused) {
  Scene scene;
  scene.add("block", rectangle(0, 0, 2, 1));
  scene.stage("nmm", Integrator::implicit, 0.1, 1e-3, 0.4).mass = MassKind::affine_exact;
  EXPECT_THROW(coupling::Driver(scene.model, scene.plan, methods()).run(), coupling::PlanError);
  scene.plan.stages[0].mass.reset();
  scene.plan.stages[0].method = "dda";
  scene.plan.stages[0].newmark = NewmarkScheme::trapezoidal;
  EXPECT_THROW(coupling::Driver(scene.model, scene.plan, methods()).run(), coupling::PlanError);
}

TEST(ImplicitNmm, trapezoidal_run_that_meets_a_contact_names_the_pair) {
  Scene scene;
  scene.add("floor", rectangle(-1, -1, 3, 0), true);
  scene.add("block", rectangle(0, 0.001, 1, 1));
  scene.stage("nmm", Integrator::implicit, 0.1, 1e-3, 0.4).newmark = NewmarkScheme::trapezoidal;
  coupling::Driver run(scene.model, scene.plan, methods());
  const coupling::RunEnd end = run.run();
  EXPECT_EQ(end.status, coupling::RunEnd::Status::not_converged);
  EXPECT_NE(end.reason.find("'block'"), std::string::npos) << end.reason;
  EXPECT_NE(end.reason.find("'floor'"), std::string::npos) << end.reason;
}

TEST(Statics, block_without_support_is_named) {
  Scene scene;
  scene.model.gravity = {0.0, 0.0};
  scene.add("floor", rectangle(-1, -1, 3, 0), true);
  scene.add("stone", rectangle(0, 0.5, 1, 1));
  coupling::Stage& stage = scene.stage("nmm", Integrator::implicit, 0.1, 1e-3, 0.4);
  stage.rest = true;
  stage.rest_force = 1e-6;
  coupling::Driver run(scene.model, scene.plan, methods());
  const coupling::RunEnd end = run.run();
  EXPECT_EQ(end.status, coupling::RunEnd::Status::not_converged);
  EXPECT_NE(end.reason.find("'stone' has no path"), std::string::npos) << end.reason;
}

TEST(Statics, run_that_does_not_come_to_rest_names_the_block) {
  Scene scene;
  scene.add("floor", rectangle(-1, -1, 3, 0), true);
  scene.add("stone", rectangle(0, 0, 1, 1));
  coupling::Stage& stage = scene.stage("nmm", Integrator::implicit, 1.0, 1e-3, 0.4);
  stage.rest = true;
  stage.rest_force = 1e-10;
  stage.rest_steps = 3;
  coupling::Driver run(scene.model, scene.plan, methods());
  const coupling::RunEnd end = run.run();
  EXPECT_EQ(end.status, coupling::RunEnd::Status::not_converged);
  EXPECT_NE(end.reason.find("block 'stone' has an unbalanced force"), std::string::npos) << end.reason;
}

class RestByForce : public testing::TestWithParam<Scheme> {};

TEST_P(RestByForce, block_on_a_floor_rests_before_its_time) {
  Scene scene;
  scene.add("floor", rectangle(-1, -1, 3, 0), true);
  const BlockId id = scene.add("stone", rectangle(0, 0, 1, 1));
  coupling::Stage& stage = scene.stage(GetParam().method, GetParam().integrator, 20.0,
                                       GetParam().implicit() ? std::optional<double>(1e-2) : std::nullopt, 0.4);
  stage.rest = true;
  stage.rest_force = 1e-4;
  coupling::Driver run(scene.model, scene.plan, methods());
  const coupling::RunEnd end = run.run();
  ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
  EXPECT_LT(seconds(run.state().time), 10.0);
  double up = 0.0;
  for (const coupling::ContactMemory& m : run.state().contacts) up += m.fn;
  EXPECT_NEAR(up / (2600.0 * 9.81), 1.0, 5e-4);
  EXPECT_EQ(totals_of(run, id).kinetic, 0.0);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(all, RestByForce,
                         testing::Values(Scheme{"nmm_implicit", "nmm", Integrator::implicit},
                                         Scheme{"nmm_explicit", "nmm", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit},
                                         Scheme{"dda_explicit", "dda", Integrator::explicit_}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace scree::test::implicit_nmm_test
