// Blocks on onefold covers of the NMM, on a triangle of their own and on one around the model, move as DDA blocks in
// `affine` form; and a step in terms of the stars is the same as one in centroidal form.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/contact/table/contact_finder.h"
#include "coupling/onefold/onefold_forms.h"
#include "model/dense_algebra.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::onefold_test {
namespace {

using namespace coupling;

/// How the blocks are represented.
enum class Kind { dda, own_triangle, model_triangle };

void represent(Kind kind, const Model& model, Stage& stage) {
  stage.method = kind == Kind::dda ? "dda" : "nmm";
  stage.rotation = BlockRotation::affine;
  stage.rules.clear();
  if (kind == Kind::dda) return;
  for (std::int32_t b = 0; b < static_cast<std::int32_t>(model.blocks.size()); ++b)
    stage.rules.push_back({{BlockId{b}}, "nmm", 0.0, true, kind == Kind::model_triangle});
}

/// Blocks that fall on a slope and on each other, slide, roll and hit a wall; soft enough to strain visibly.
Scene rockfall() {
  Scene scene(2e7, 0.25, 2500.0, 25.0);
  scene.add("slope", {{{-1, -1}, {6, -1}, {6, 0}, {3, 0}, {0, 1.8}, {-1, 1.8}}, {}}, true);
  scene.add("wall", rectangle(5.0, 0.0, 6.0, 2.0), true);
  const auto thrown = [&](const char* name, Polygon polygon, const Vec2& velocity, double spin) {
    const BlockId id = scene.add(name, std::move(polygon));
    scene.model.initial_velocities.push_back({id, velocity, spin});
  };
  thrown("slider", transformed(rectangle(0.0, 0.0, 0.7, 0.4), Vec2(0.5, 1.5), rotation(-std::atan(0.6))),
         Vec2(0.5, -0.3), 0.0);
  thrown("roller", {{{1.9, 1.5}, {2.4, 1.4}, {2.7, 1.8}, {2.4, 2.2}, {1.9, 2.0}}, {}}, Vec2(1.5, -1.0), -5.0);
  thrown("flyer", {{{3.6, 0.5}, {4.3, 0.4}, {4.4, 0.9}, {3.7, 1.1}}, {}}, Vec2(2.0, -1.5), 4.0);
  scene.add("standing", rectangle(3.3, 0.0, 3.8, 0.4));
  thrown("on it", {{{3.35, 0.401}, {3.7, 0.401}, {3.6, 0.601}, {3.4, 0.651}}, {}}, Vec2(-0.6, 0.0), 0.0);
  thrown("rocking", transformed(rectangle(0.0, 0.0, 0.3, 0.5), Vec2(4.5, 0.003), rotation(-0.05)), Vec2(0.2, -0.2),
         0.0);
  return scene;
}

/// The same scene for a run in which no step is cut, with a frame per step.
Scene rockfall(Integrator integrator, int steps) {
  Scene scene = rockfall();
  const double dt = 5e-4;
  scene.stage("dda", integrator, steps * dt, dt).control.max_displacement = 0.1;
  scene.plan.output.every = ticks(dt);
  return scene;
}

/// A block that flies, rotates and vibrates under its weight, a load that varies in time, and its in-situ stress.
Scene flight() {
  Scene scene(5e6, 0.3, 2500.0);
  scene.model.materials[0].initial_stress = InitialStress{};
  scene.model.materials[0].initial_stress->stress = (Mat2() << -2e4, 5e3, 5e3, -1e4).finished();
  const BlockId id = scene.add("block", {{{0, 0}, {1.2, 0.1}, {1.0, 0.7}, {0.2, 0.9}}, {}});
  scene.model.initial_velocities.push_back({id, Vec2(2.0, 5.0), 4.0});
  TimeFunction hum;
  hum.name = "hum";
  hum.shape = TimeFunction::Shape::sine;
  hum.frequency = 7.0;
  scene.model.functions.push_back(hum);
  scene.model.point_loads.push_back({id, Vec2(1.2, 0.1), Vec2(1e3, 2e3), FunctionId{0}});
  return scene;
}

struct Instant {
  std::vector<Vec2> x, v;      // of the corners
  std::vector<double> stress;  // [Pa]
  std::vector<ContactMemory> contacts;
};

struct Recorded {
  std::vector<Instant> instants;
  RunStats stats;
  double closure = 0.0;
};

Recorded record(Scene scene, Kind kind) {
  represent(kind, scene.model, scene.plan.stages[0]);
  Driver run(scene.model, scene.plan, methods());
  scene.plan.threads = 1;
  Recorded out;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    Instant now;
    for (const Row& row : run.setup().outlines().nodes) {
      now.x.push_back(position(row, view.state->q));
      now.v.push_back(position(row, view.state->v));
    }
    now.stress.assign(view.stress.begin(), view.stress.end());
    now.contacts = view.state->contacts.memory;
    out.instants.push_back(std::move(now));
  };
  run.add_sink(watch);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  out.stats = run.stats();
  out.closure = run.state().ledger.relative_closure();
  return out;
}

/// Largest differences of two runs, divided by the largest value in the first.
struct Apart {
  double x = 0.0, v = 0.0, stress = 0.0, force = 0.0;
  std::int64_t states = 0, switches = 0, closed = 0;  // contact states that differ; changes of state; closed ones
};

Apart compare(const Recorded& a, const Recorded& b) {
  Apart d;
  double x = 0.0, v = 0.0, stress = 0.0, force = 0.0;
  EXPECT_EQ(a.instants.size(), b.instants.size());
  for (std::size_t i = 0; i < std::min(a.instants.size(), b.instants.size()); ++i) {
    const Instant &p = a.instants[i], &q = b.instants[i];
    for (std::size_t k = 0; k < p.x.size(); ++k) {
      d.x = std::max(d.x, (p.x[k] - q.x[k]).norm());
      d.v = std::max(d.v, (p.v[k] - q.v[k]).norm());
      x = std::max(x, (p.x[k] - a.instants[0].x[k]).norm());
      v = std::max(v, p.v[k].norm());
    }
    for (std::size_t k = 0; k < p.stress.size(); ++k) {
      d.stress = std::max(d.stress, std::abs(p.stress[k] - q.stress[k]));
      stress = std::max(stress, std::abs(p.stress[k]));
    }
    EXPECT_EQ(p.contacts.size(), q.contacts.size()) << "frame " << i;
    if (p.contacts.size() != q.contacts.size()) return d;
    for (std::size_t c = 0; c < p.contacts.size(); ++c) {
      const ContactMemory &m = p.contacts[c], &n = q.contacts[c];
      d.states += m.key == n.key && m.status == n.status ? 0 : 1;
      d.closed += m.status != ContactStatus::open ? 1 : 0;
      d.force = std::max(d.force, std::hypot(m.fn - n.fn, m.ft - n.ft));
      force = std::max(force, std::hypot(m.fn, m.ft));
      if (i == 0) continue;
      for (const ContactMemory& was : a.instants[i - 1].contacts)
        if (was.key == m.key) d.switches += was.status != m.status ? 1 : 0;
    }
  }
  d.x /= x;
  d.v /= v;
  d.stress /= stress;
  if (force > 0.0) d.force /= force;
  return d;
}

class Onefold : public testing::TestWithParam<std::tuple<Integrator, Kind>> {};

void print(const char* what, const Apart& d, const Recorded& run) {
  std::printf(
      "%s: %lld steps, %lld closed contacts seen, %lld switches; apart: x %.1e, v %.1e, stress %.1e, "
      "contact force %.1e, states %lld; closure %.1e\n",
      what, static_cast<long long>(run.stats.steps), static_cast<long long>(d.closed),
      static_cast<long long>(d.switches), d.x, d.v, d.stress, d.force, static_cast<long long>(d.states), run.closure);
}

TEST_P(Onefold, blocks_in_contact_move_as_dda_blocks_in_affine_form) {
  const auto [integrator, kind] = GetParam();
  const int steps = 600;
  const Scene scene = rockfall(integrator, steps);
  const Recorded dda = record(scene, Kind::dda), nmm = record(scene, kind);
  const Apart d = compare(dda, nmm);
  print("600 steps", d, nmm);
  EXPECT_EQ(nmm.stats.steps, steps);
  EXPECT_EQ(nmm.stats.cuts, 0);
  EXPECT_GT(d.switches, 50);
  EXPECT_EQ(d.states, 0);
  EXPECT_LT(d.x, 1e-10);
  EXPECT_LT(d.v, 1e-10);
  EXPECT_LT(d.stress, 1e-10);
  EXPECT_LT(d.force, 1e-10);
  EXPECT_LT(nmm.closure, 1e-9);
  EXPECT_LT(dda.closure, 1e-9);
}

// Collisions amplify any difference of two runs. After many of them, NMM and DDA may differ as much as two runs of the
// DDA whose initial velocities differ by 1.4 parts in 10^14, about the round-off that accumulates in that time.
TEST_P(Onefold, blocks_that_collide_again_and_again_part_by_round_off_alone) {
  const auto [integrator, kind] = GetParam();
  Scene scene = rockfall(integrator, 2000);
  const Recorded dda = record(scene, Kind::dda), nmm = record(scene, kind);
  for (InitialVelocity& i : scene.model.initial_velocities)
    i.velocity *= 1.0 + 64.0 * std::numeric_limits<double>::epsilon();
  const Recorded twin = record(scene, Kind::dda);
  const Apart d = compare(dda, nmm), by_round_off = compare(dda, twin);
  print("2000 steps", d, nmm);
  print("two runs of the DDA", by_round_off, twin);
  EXPECT_LT(d.x, 1e-6);  // the same formulation, computed in two ways, rotation included
  EXPECT_LT(d.x, 100.0 * by_round_off.x);
  EXPECT_LT(nmm.closure, 1e-9);
}

TEST_P(Onefold, block_in_flight_moves_as_a_dda_block_in_affine_form) {
  const auto [integrator, kind] = GetParam();
  const bool implicit = integrator == Integrator::implicit;
  for (const NewmarkScheme scheme : {NewmarkScheme::damped, NewmarkScheme::trapezoidal}) {
    if (!implicit && scheme == NewmarkScheme::trapezoidal) continue;
    Scene scene = flight();
    const double dt = 1e-3;
    const int steps = 1000;
    Stage& stage = scene.stage("dda", integrator, steps * dt, dt);
    stage.control.max_displacement = 0.1;
    stage.newmark = scheme;
    stage.damping = 2.0;  // acts on the motion that is not affine, which is zero here
    scene.plan.output.every = ticks(dt);
    const Recorded dda = record(scene, Kind::dda), nmm = record(scene, kind);
    const Apart d = compare(dda, nmm);
    print(scheme == NewmarkScheme::damped ? "flight" : "flight, trapezoidal", d, nmm);
    EXPECT_EQ(nmm.stats.steps, steps);
    EXPECT_LT(d.x, 1e-10);
    EXPECT_LT(d.v, 1e-10);
    EXPECT_LT(d.stress, 1e-10);
    EXPECT_LT(nmm.closure, 1e-9);
    EXPECT_LT(dda.closure, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Runs, Onefold,
                         testing::Combine(testing::Values(Integrator::explicit_, Integrator::implicit),
                                          testing::Values(Kind::own_triangle, Kind::model_triangle)),
                         [](const auto& of) {
                           return std::string(std::get<0>(of.param) == Integrator::implicit ? "implicit" : "explicit") +
                                  (std::get<1>(of.param) == Kind::own_triangle ? "_own" : "_model");
                         });

// An explicit run with the automatic step: the certified bound is that of the affine block for any kind of cover.
TEST(OnefoldStep, certified_bound_is_that_of_the_dda_block) {
  Scene scene = rockfall();
  scene.stage("dda", Integrator::explicit_, 0.05, std::nullopt).control.max_displacement = 0.1;
  const Recorded dda = record(scene, Kind::dda);
  for (const Kind kind : {Kind::own_triangle, Kind::model_triangle}) {
    const Recorded nmm = record(scene, kind);
    EXPECT_EQ(nmm.stats.steps, dda.stats.steps);
    EXPECT_LT(compare(dda, nmm).x, 1e-10);
  }
  EXPECT_GT(dda.stats.steps, 30);
}

// ---- `affine` against `exact` ------------------------------------------------------------------------------------

/// Spin and centre of the flying block after 0.5 s of implicit steps.
BodyTotals flown(BlockRotation rotation, double dt, double young) {
  Scene scene = flight();
  scene.model.materials[0].young = young;
  scene.model.materials[0].initial_stress.reset();
  scene.model.point_loads.clear();
  Stage& stage = scene.stage("dda", Integrator::implicit, 0.5, dt);
  stage.control.max_displacement = 0.1;
  stage.rotation = rotation;
  Driver run(scene.model, scene.plan, methods());
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  return totals_of(run, BlockId{0});
}

double spin_of(const BodyTotals& t, const Model& model) {
  const Moments m = moments(model.blocks[0].polygon);
  return (t.angular_momentum - cross(t.centre, t.momentum)) / (model.materials[0].density * m.second.trace());
}

// Newmark (1/2, 1) in (c, F) damps a spin w by w dt/2 per radian (docs/theory/dda.md, "Affine form"); the exact
// rotation does not damp it.
TEST(DdaRotation, affine_damps_a_spin_by_half_the_turn_of_a_step_and_exact_does_not) {
  const Model model = flight().model;
  const double spin = 4.0, angle = 0.5 * spin, stiff = 1e10;
  for (const double dt : {2e-3, 1e-3}) {
    const double lost = -std::log(spin_of(flown(BlockRotation::affine, dt, stiff), model) / spin) / angle;
    std::printf("dt %.0e: loss of spin a radian over w dt/2: %.4f\n", dt, lost / (0.5 * spin * dt));
    EXPECT_NEAR(lost, 0.5 * spin * dt, 0.02 * 0.5 * spin * dt) << dt;  // next order; decrease of the spin
    EXPECT_NEAR(spin_of(flown(BlockRotation::exact, dt, stiff), model), spin, 1e-9 * spin) << dt;
  }
}

// ---- The form in the stars --------------------------------------------------------------------------------------

/// A stack of two blocks at rest on a floor as wide as the model, and one implicit step.
struct Step {
  ByHand hand;
  ContactList contacts;
  OnefoldForms forms;
  explicit Step(const Model& model, Stage stage, Kind kind) : hand(model, with(model, stage, kind)) {
    ContactFinder finder(*hand.setup, 0.01);
    finder.find(hand.state.q, {}, true, contacts);
    forms = onefold_forms(*hand.setup, hand.state.q, contacts);
  }
  static const Stage& with(const Model& model, Stage& stage, Kind kind) {
    represent(kind, model, stage);
    return stage;
  }
};

Scene stack(double width) {
  Scene scene(1e10, 0.25, 2600.0);
  const double x = 0.3 * (width - 1.0);
  scene.add("floor", rectangle(0.0, -0.2, width, 0.0), true);
  scene.add("lower", rectangle(x, 0.0, x + 1.0, 0.4));
  scene.add("upper", rectangle(x + 0.1, 0.4, x + 0.9, 0.8));
  return scene;
}

// Matrices of the contacts ([Qu2013] eq. 7.20-7.55), of mass and stiffness, each computed by its own formulas in terms
// of the stars and in centroidal form, are equal after the map. The steps are equal within the round-off that the
// condition number of the form in the stars allows.
TEST(OnefoldForms, stars_and_centroidal_form_are_the_same_step) {
  const double h = 1e-3, eps = std::numeric_limits<double>::epsilon();
  for (const double width : {1.0, 10.0, 100.0, 1000.0}) {
    Scene scene = stack(width);
    Stage stage = scene.stage("nmm", Integrator::implicit, h, h);
    const Step step(scene.model, stage, Kind::model_triangle);
    ASSERT_EQ(step.contacts.points.size(), 4U);  // both ends of both joints
    const OnefoldForms& f = step.forms;
    using Wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    const auto off = [&](const Wide& stars, const Eigen::MatrixXd& centroidal) {
      const Wide map = f.map.cast<long double>();
      return (map.transpose() * stars * map - centroidal.cast<long double>()).cast<double>().norm() / centroidal.norm();
    };
    // The products are in long double, so that they add no round-off. Matrices that were rounded in terms of the stars,
    // as those of mass and contacts would be in a run, have a relative error of (L/d)^2 eps for a block of width d.
    const Wide rows = f.stars.rows.cast<long double>();
    const double contact = off(rows.transpose() * f.stars.springs.cast<long double>().asDiagonal() * rows,
                               f.centroidal.contact()),
                 rounded = off(f.stars.contact().cast<long double>(), f.centroidal.contact()),
                 mass = off(f.stars.mass.cast<long double>(), f.centroidal.mass),
                 stiffness = off(f.stars.stiffness.cast<long double>(), f.centroidal.stiffness);
    EXPECT_LT(contact, 1e-12) << width;
    EXPECT_LT(stiffness, 1e-12) << width;
    EXPECT_LT(rounded, std::max(1e-12, 2.0 * eps * width * width)) << width;
    EXPECT_LT(mass, std::max(1e-12, 2.0 * eps * width * width)) << width;

    const Eigen::MatrixXd A = f.stars.of_step(h), B = f.centroidal.of_step(h);
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(B.rows(), -1.0, 2.0);  // on the centroidal unknowns
    const Eigen::VectorXd d = solve_symmetric(B, load);
    const Eigen::VectorXd of_stars = solve_general(f.map.transpose(), load);
    const Eigen::VectorXd difference = solve_symmetric(A, of_stars) - f.map * d;
    const double apart = difference.norm() / (f.map * d).norm(), condition = condition_number(A);
    std::printf(
        "model/block %6.0f: condition %.2e in the stars, %.2e centroidal; contact %.1e, rounded "
        "%.1e, mass %.1e, stiffness %.1e; "
        "solutions apart %.1e\n",
        width, condition, condition_number(B), contact, rounded, mass, stiffness, apart);
    EXPECT_LT(apart, 10.0 * eps * condition) << width;
  }
}

// The centroidal form does not depend on the triangle.
TEST(OnefoldForms, centroidal_form_does_not_depend_on_the_triangle) {
  Scene scene = stack(100.0);
  Stage stage = scene.stage("nmm", Integrator::implicit, 1e-3, 1e-3);
  const Step own(scene.model, stage, Kind::own_triangle), shared(scene.model, stage, Kind::model_triangle);
  const OnefoldMatrices &a = own.forms.centroidal, &b = shared.forms.centroidal;
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_LT((a.stiffness - b.stiffness).norm(), 1e-12 * a.stiffness.norm());
  EXPECT_LT((a.contact() - b.contact()).norm(), 1e-12 * a.contact().norm());
  EXPECT_GT(condition_number(shared.forms.stars.of_step(1e-3)),
            100.0 * condition_number(own.forms.stars.of_step(1e-3)));
}

// All blocks have the stars of the model's triangle in the same places.
TEST(OnefoldForms, stars_of_the_model_triangle_are_shared_in_place) {
  Scene scene = rockfall();
  Stage stage = scene.stage("nmm", Integrator::explicit_, 0.1, 1e-4);
  represent(Kind::model_triangle, scene.model, stage);
  const ByHand hand(scene.model, stage);
  const Eigen::Map<const Eigen::MatrixXd> stars(hand.state.q.data(), 6,
                                                static_cast<Eigen::Index>(hand.state.q.size() / 6));
  for (Eigen::Index b = 1; b < stars.cols(); ++b) EXPECT_LT((stars.col(b) - stars.col(0)).norm(), 1e-13 * 20.0);
  for (const Row& row : hand.setup->outlines().nodes) EXPECT_GT(*std::min_element(row.w.begin(), row.w.end()), 0.0);
}

}  // namespace
}  // namespace scree::test::onefold_test
