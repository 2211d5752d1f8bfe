// Contacts that change tributary length, edge and kind (edge-edge or not) while they carry load: forces, penetration
// and energy must not jump. Sliding is compared with Coulomb's law.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <functional>
#include <map>

#include "coupling/contact/table/contact_point.h"
#include "tests/support/schemes.h"

namespace scree::test::contact_tributary_test {
namespace {

using namespace coupling;

/// Present position of a point of a block's outline, given by its position in the model.
Vec2 point_of(const Driver& run, BlockId block, const Vec2& x0) {
  const Body& b = run.setup().bodies()[block.index()];
  const Row row = run.setup().pool_of(b).row_at(b.index, x0 - b.centre);
  return position(run.setup().global(b, row), run.state().q);
}

struct Resultant {
  double normal = 0.0, tangential = 0.0;
};
Resultant resultant(const State& state) {
  Resultant sum;
  for (const ContactMemory& m : state.contacts) {
    if (m.status == ContactStatus::open) continue;
    sum.normal += m.fn;
    // ft acts on the vertex along the edge; it has the same sign for vertices of either block.
    sum.tangential += m.ft;
  }
  return sum;
}

// ---- Sliding over a row of blocks -------------------------------------------------------------------------------

constexpr double kGravity = 9.81;

class SlidingOverJoints : public testing::TestWithParam<std::tuple<Scheme, double>> {
 protected:
  /// A 1 x 1 m block on an incline of blocks 0.7 m long.
  static Scene incline(const Scheme& scheme, double friction_deg, double slope_deg, double speed, double duration) {
    Scene scene(1e9, 0.2, 2600.0, friction_deg);
    const Mat2 R = rotation(-slope_deg * kDegree);
    const Vec2 origin(0.0, 0.0);
    for (int i = 0; i < 6; ++i) {
      const double x = -0.85 + 0.7 * i;
      scene.add("base" + std::to_string(i), transformed(rectangle(x, -1, x + 0.7, 0), origin, R), true);
    }
    scene.add("rest", transformed(rectangle(3.35, -1, 9, 0), origin, R), true);
    const BlockId block = scene.add("slider", transformed(rectangle(-0.5, 0, 0.5, 1), origin, R));
    if (speed > 0.0) scene.model.initial_velocities.push_back({block, R * Vec2(speed, 0.0), 0.0});
    scene
        .stage(scheme.method, scheme.integrator, duration,
               scheme.implicit() ? std::optional<double>(1e-3) : std::nullopt, 0.4)
        .damping = scheme.implicit() ? 0.0 : 100.0;
    return scene;
  }
};

TEST_P(SlidingOverJoints, distance_follows_coulomb) {
  const auto& [scheme, phi] = GetParam();
  const double slope = 30.0 * kDegree, t = 1.0;
  const Scene scene = incline(scheme, phi, 30.0, 0.0, t);
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Mat2 R = rotation(-slope);
  const double distance = (centre_of(run, BlockId{7}) - R * Vec2(0.0, 0.5)).dot(R * Vec2(1.0, 0.0));
  const double expected = 0.5 * kGravity * (std::sin(slope) - std::cos(slope) * std::tan(phi * kDegree)) * t * t;
  EXPECT_NEAR(distance / expected, 1.0, 5e-4) << distance << " m";
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

TEST_P(SlidingOverJoints, forces_and_depth_stay_across_the_joints) {
  const auto& [scheme, phi] = GetParam();
  const double duration = 1.0, speed = 2.0;
  Scene scene = incline(scheme, phi, 0.0, speed, duration);
  scene.plan.output.every = ticks(duration / 2000);
  Driver run(scene.model, scene.plan, methods());
  const double weight = 2600.0 * kGravity, friction = weight * std::tan(phi * kDegree);
  double depth = 0.0, deepest = 0.0, normal = 0.0, tangential = 0.0, travelled = 0.0;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    if (view.time < 0.3) return;  // gravity is applied at once: its oscillation has decayed by then
    const Vec2 centre = centre_of(run, BlockId{7});
    if (depth == 0.0) depth = 0.5 - centre.y();
    if (totals_of(run, BlockId{7}).momentum.x() < 0.05 * 2600.0 * speed) return;  // the block stops and sticks
    const Resultant r = resultant(*view.state);
    deepest = std::max(deepest, std::abs(0.5 - centre.y() - depth));
    normal = std::max(normal, std::abs(r.normal - weight) / weight);
    tangential = std::max(tangential, std::abs(std::abs(r.tangential) - friction) / weight);
    travelled = centre.x();
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_GT(travelled, 0.9);  // the leading edge passed at least two joints
  std::printf("%s phi %g: %.2f m, depth %.3e changes %.1e, normal %.1e, friction %.1e of the weight\n", scheme.name,
              phi, travelled, depth, deepest, normal, tangential);
  EXPECT_LT(deepest, 0.01 * depth);
  EXPECT_LT(normal, 2e-3);
  EXPECT_LT(tangential, 2e-3);
  if (phi == 0.0 &&
      !scheme.implicit()) {  // in an implicit step that crosses a joint, the side of the next block pushes once
    EXPECT_NEAR(totals_of(run, BlockId{7}).momentum.x() / (2600.0 * speed), 1.0, 1e-6);
  }
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(schemes, SlidingOverJoints,
                         testing::Combine(testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                                          Scheme{"dda", "dda", Integrator::explicit_},
                                                          Scheme{"dda_implicit", "dda", Integrator::implicit}),
                                          testing::Values(0.0, 10.0)),
                         [](const auto& of) {
                           return std::string(std::get<0>(of.param).name) + "_phi" +
                                  std::to_string(static_cast<int>(std::get<1>(of.param)));
                         });

class Slivers : public testing::TestWithParam<Scheme> {};

/// A block slides over a row that contains slivers a few millimetres wide, and keeps its velocity.
TEST_P(Slivers, carry_what_slides_over_them) {
  const Scheme scheme = GetParam();
  Scene scene(1e9, 0.2, 2600.0, 0.0);
  const double x[] = {-2.0, 0.6, 0.604, 0.608, 0.613, 1.1, 6.0};
  for (std::size_t i = 0; i + 1 < std::size(x); ++i)
    scene.add("base" + std::to_string(i), rectangle(x[i], -1, x[i + 1], 0), true);
  const BlockId block = scene.add("slider", rectangle(-0.5, 0, 0.5, 1));
  scene.model.initial_velocities.push_back({block, Vec2(2.0, 0.0), 0.0});
  scene.stage(scheme.method, scheme.integrator, 1.0, std::nullopt, 0.4).damping = 100.0;
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const double settlement = 2600.0 * kGravity / (scene.model.elasticity_of(block).p_modulus());
  std::printf("%s: x %.6f, depth %.4e of %.4e, closure %.1e\n", scheme.name, centre_of(run, block).x(),
              0.5 - centre_of(run, block).y(), settlement, run.state().ledger.relative_closure());
  EXPECT_NEAR(totals_of(run, block).momentum.x() / 5200.0, 1.0, 1e-5);
  EXPECT_NEAR(0.5 - centre_of(run, block).y(), settlement, 0.5 * settlement);  // and the block's own strain
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(schemes, Slivers,
                         testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                         Scheme{"dda", "dda", Integrator::explicit_}),
                         [](const auto& of) { return std::string(of.param.name); });

class LastEdge : public testing::TestWithParam<Scheme> {};

/// A block slides over the end of the last edge, tips and falls: no contact adds energy.
TEST_P(LastEdge, block_slides_off_the_end) {
  const Scheme scheme = GetParam();
  Scene scene(1e9, 0.2, 2600.0, 20.0);
  scene.add("base", rectangle(-3, -1, 0.7, 0), true);
  const BlockId block = scene.add("slider", rectangle(-0.5, 0, 0.5, 1));
  scene.model.initial_velocities.push_back({block, Vec2(3.0, 0.0), 0.0});
  scene.stage(scheme.method, scheme.integrator, 1.0, scheme.implicit() ? std::optional<double>(1e-3) : std::nullopt,
              0.4);
  scene.plan.output.every = ticks(1e-3);
  Driver run(scene.model, scene.plan, methods());
  double before = 0.5 * 2600.0 * 9.0, gain = 0.0;
  Watch watch;
  watch.see = [&](const FrameView&) {
    const BodyTotals t = totals_of(run, block);
    const double held =
        t.kinetic + t.elastic + 2600.0 * kGravity * (t.centre.y() - 0.5) + run.state().ledger[Column::contact_springs];
    gain = std::max(gain, held - before);
    before = held;
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  std::printf("%s: ends at %.3f %.3f, gains %.1e J at most, closure %.1e\n", scheme.name, centre_of(run, block).x(),
              centre_of(run, block).y(), gain, run.state().ledger.relative_closure());
  EXPECT_LT(centre_of(run, block).y(), -0.5);  // it fell
  EXPECT_LT(gain, 1e-4 * 0.5 * 2600.0 * 9.0);  // the energy of the explicit scheme oscillates by its shadow term
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(schemes, LastEdge,
                         testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                         Scheme{"dda", "dda", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

// ---- Rocking ----------------------------------------------------------------------------------------------------

class Rocking : public testing::TestWithParam<Scheme> {};

/// A block tilts about its corner from 0 through 5 and 10 degrees and back.
TEST_P(Rocking, changes_of_kind_keep_the_force_and_book_its_energy) {
  const Scheme scheme = GetParam();
  Scene scene(1e9, 0.2, 2600.0, 50.0);
  scene.add("base", rectangle(-3, -1, 3, 0), true);
  const BlockId block = scene.add("block", rectangle(-0.5, 0, 0.5, 1));
  const double spin = -1.62;
  scene.model.initial_velocities.push_back({block, Vec2(-0.5 * spin, 0.5 * spin).cwiseProduct(Vec2(1.0, -1.0)), spin});
  scene.stage(scheme.method, scheme.integrator, 0.7, scheme.implicit() ? std::optional<double>(2e-4) : std::nullopt,
              0.5);
  scene.plan.output.every = ticks(1e-4);
  Driver run(scene.model, scene.plan, methods());
  struct Before {
    std::map<ContactKey, ContactMemory> contacts;
    double share = 0.0;
  } before;
  int changes = 0;
  double steepest = 0.0, booked_error = 0.0, force_error = 0.0;
  struct Step final : Sink {
    std::function<void()> see;
    void step(double, const RunStats&, const Ledger&) override { see(); }
  } watch;
  watch.see = [&] {
    const State& state = run.state();
    const Vec2 side = totals_of(run, block).centre;
    steepest = std::max(steepest, side.y());
    double expected = 0.0;
    bool changed = false;
    for (const ContactMemory& m : state.contacts) {
      const auto old = before.contacts.find(m.key);
      if (m.status == ContactStatus::open || old == before.contacts.end() ||
          old->second.status == ContactStatus::open || old->second.edge_edge == m.edge_edge)
        continue;
      changed = true;
      ++changes;
      const double fn = m.kn * m.gap, ft = m.kt * m.stretch;  // of the springs
      expected +=
          0.5 * fn * fn * (1.0 / m.kn - 1.0 / old->second.kn) + 0.5 * ft * ft * (1.0 / m.kt - 1.0 / old->second.kt);
      if (!scheme.implicit()) force_error = std::max(force_error, std::abs(-fn - (m.fn - m.fd)) / std::abs(fn));
    }
    const double share = state.ledger[Column::contact_tributary];
    if (changed) booked_error = std::max(booked_error, std::abs(share - before.share - expected) / std::abs(expected));
    before.share = share;
    before.contacts.clear();
    for (const ContactMemory& m : state.contacts) before.contacts[m.key] = m;
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const double tilt = std::asin(std::min(1.0, steepest / std::sqrt(0.5))) / kDegree - 45.0;
  std::printf("%s: tilt %.2f degrees, %d changes of kind, force %.1e, energy %.1e, closure %.1e\n", scheme.name, tilt,
              changes, force_error, booked_error, run.state().ledger.relative_closure());
  EXPECT_GT(tilt, 10.5);
  EXPECT_GE(changes, 1);  // on return a mesh vertex of the base may be the contact before the corner faces it again
  EXPECT_LE(changes, 4);  // no chatter
  EXPECT_LT(force_error, 1e-12);
  EXPECT_LT(booked_error, 1e-6);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(schemes, Rocking,
                         testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                         Scheme{"dda", "dda", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

// ---- Corners beside the end of an edge --------------------------------------------------------------------------

class NarrowFoot : public testing::TestWithParam<Scheme> {};

/// A wedge with a foot of 4 cm exactly on the corner of its base, as joints at a sharp angle cut it: the corner of the
/// foot stands on the top of the base, 4 cm behind the line of its side, and a corner of the base lies as far behind a
/// side of the wedge. No block overlaps another.
TEST_P(NarrowFoot, stands_without_force_as_the_run_begins) {
  const Scheme scheme = GetParam();
  Scene scene(5e9, 0.2, 2600.0, 35.0);
  scene.add("base", rectangle(0, 0, 6, 1), true);
  scene.add("wedge", {{{0, 1}, {0.04, 1}, {0.8, 6.8}, {0, 6.8}}, {}});
  scene.add("beside", {{{0.04, 1}, {3, 1}, {3, 6.8}, {0.8, 6.8}}, {}});
  scene.stage(scheme.method, scheme.integrator, 0.01, scheme.implicit() ? std::optional<double>(1e-3) : std::nullopt,
              1.0);
  Driver run(scene.model, scene.plan, methods());
  double springs = -1.0, edges = 0.0;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    if (springs < 0.0) springs = view.state->ledger[Column::contact_springs];
    edges = std::max(edges, std::abs(view.state->ledger[Column::contact_edges]));
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_EQ(springs, 0.0);
  EXPECT_LT(edges, 1e-3 * run.state().ledger[Column::kinetic]);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(schemes, NarrowFoot,
                         testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                         Scheme{"dda", "dda", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

// ---- Corners that meet exactly ----------------------------------------------------------------------------------

class FourCorners : public testing::TestWithParam<Scheme> {};

/// Two columns of two blocks each, whose corners meet in one point: no force acts between diagonal neighbours.
TEST_P(FourCorners, columns_stand_and_do_not_push_across) {
  const Scheme scheme = GetParam();
  Scene scene(1e9, 0.0, 2600.0, 30.0);
  scene.add("base", rectangle(-2, -1, 4, 0), true);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column)
      scene.add("b" + std::to_string(row) + std::to_string(column), rectangle(column, row, column + 1, row + 1));
  scene
      .stage(scheme.method, scheme.integrator, 1.0, scheme.implicit() ? std::optional<double>(2e-3) : std::nullopt, 0.6)
      .damping = scheme.implicit() ? 0.0 : 100.0;
  scene.plan.output.every = ticks(0.5);
  Driver run(scene.model, scene.plan, methods());
  std::vector<Vec2> settled;
  double across = 0.0;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    if (view.time < 0.4) return;
    for (const ContactMemory& m : view.state->contacts) {
      const auto diagonal = [&](int a, int b) {
        return (m.key.block_p == a && m.key.block_e == b) || (m.key.block_p == b && m.key.block_e == a);
      };
      if (diagonal(1, 4) || diagonal(2, 3)) across = std::max(across, std::hypot(m.fn, m.ft));
    }
    if (settled.empty())
      for (std::int32_t i = 1; i <= 4; ++i) settled.push_back(centre_of(run, BlockId{i}));
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  double drift = 0.0;
  for (std::int32_t i = 1; i <= 4; ++i)
    drift = std::max(drift, std::abs((centre_of(run, BlockId{i}) - settled[static_cast<std::size_t>(i) - 1]).x()));
  const Resultant r = resultant(run.state());
  std::printf("%s: drift %.1e m, across %.1e N, sum of normal forces %.6e, closure %.1e\n", scheme.name, drift, across,
              r.normal, run.state().ledger.relative_closure());
  EXPECT_LT(across, 1e-12 * 2600.0 * kGravity);  // round-off of contacts that close without force
  EXPECT_LT(drift, 1e-6);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(schemes, FourCorners,
                         testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                         Scheme{"dda", "dda", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

// ---- Laws -------------------------------------------------------------------------------------------------------

/// A block on a base, brought to rest.
struct Rested {
  Scene scene{1e9, 0.0, 2600.0, 30.0};
  std::unique_ptr<Driver> run;
  Rested(const Scheme& scheme, const std::function<void(JointLaw&)>& change) {
    change(scene.model.joints[0]);
    scene.add("base", rectangle(-2, -1, 4, 0), true);
    scene.add("block", rectangle(0, 0, 1.5, 2));
    const std::optional<double> dt = scheme.implicit() ? std::optional<double>(1e-2) : std::nullopt;
    scene.stage(scheme.method, scheme.integrator, 0.5, dt, 0.4).rest = true;
    run = std::make_unique<Driver>(scene.model, scene.plan, methods());
    EXPECT_EQ(run->run().status, RunEnd::Status::done);
  }
};

TEST(Laws, stiffness_per_area_gives_the_settlement_of_a_block) {
  const double kn = 3e8;
  const Rested r({"", "dda", Integrator::implicit}, [&](JointLaw& law) { law.normal_stiffness = kn; });
  const double pressure = 2600.0 * kGravity * 2.0;
  // DDA: one strain per block, that of the mean pressure.
  const double settlement = pressure / kn + 0.5 * pressure / 1e9 * 1.0;
  EXPECT_NEAR(1.0 - centre_of(*r.run, BlockId{1}).y(), settlement, 2e-4 * settlement);  // strain 3e-5
}

/// Only the corners of the block count, independent of the mesh that divides the edges between them.
TEST(Laws, penalty_counts_the_corners_alone) {
  for (const Scheme& scheme : {Scheme{"", "dda", Integrator::implicit}, Scheme{"", "nmm", Integrator::explicit_}}) {
    const double k = 2e8;
    const Rested r(scheme, [&](JointLaw& law) { law.penalty = k; });
    const double weight = 2600.0 * kGravity * 3.0;
    int closed = 0;
    double force = 0.0;
    for (const ContactMemory& m : r.run->state().contacts)
      if (m.status != ContactStatus::open) {
        ++closed;
        force += m.fn;
        EXPECT_EQ(m.kn, k);
        EXPECT_NEAR(m.gap, -0.5 * weight / k, 1e-3 * weight / k);  // the mesh is not quite symmetric
      }
    EXPECT_EQ(closed, 2);
    EXPECT_NEAR(force, weight, 1e-6 * weight);
  }
}

/// A block under a sideways load holds as long as the load is below the sum of cohesion and friction.
TEST(Laws, cohesion_acts_on_the_contact_length) {
  for (const double part : {0.95, 1.05}) {
    const double cohesion = 4e4, length = 0.3, weight = 2600.0 * kGravity * 3.0;
    Scene scene(1e9, 0.0, 2600.0, 20.0);
    JointLaw& law = scene.model.joints[0];
    law.penalty = 2e8;
    law.contact_length = length;
    law.cohesion = cohesion;
    const double limit = 2.0 * cohesion * length + weight * std::tan(20.0 * kDegree);
    scene.model.gravity = {0.0, -kGravity};
    scene.add("base", rectangle(-2, -1, 8, 0), true);
    scene.add("block", rectangle(0, 0, 6, 0.5));  // flat: both corners carry nearly the same
    scene.stage("dda", Integrator::implicit, 0.5, 1e-2).rest = true;
    // Inclined gravity: the weight acts down, and `part` of the limit sideways.
    scene.model.gravity = {part * limit / (2600.0 * 3.0), -kGravity};
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    double slip = 0.0;
    for (const ContactMemory& m : run.state().contacts) slip += m.slip;
    if (part < 1.0)
      EXPECT_EQ(slip, 0.0);
    else
      EXPECT_GT(slip, 1e-4);
  }
}

class Cohesion : public testing::TestWithParam<Scheme> {};

/// New contact points on a joint that has slipped have no cohesion.
TEST_P(Cohesion, lost_once_stays_lost_across_joints) {
  const Scheme scheme = GetParam();
  Scene scene(1e9, 0.2, 2600.0, 10.0);
  scene.model.joints[0].cohesion = 1e5;
  for (const auto& [low, high] : {std::pair(-3.0, 0.17), std::pair(0.17, 0.51), std::pair(0.51, 3.0)})
    scene.add("base", rectangle(low, -1, high, 0), true);
  const BlockId block = scene.add("slider", rectangle(-0.5, 0, 0.5, 1));
  scene.model.initial_velocities.push_back({block, Vec2(0.6, 0.0), 0.0});
  scene
      .stage(scheme.method, scheme.integrator, 0.2, scheme.implicit() ? std::optional<double>(1e-4) : std::nullopt, 0.3)
      .damping = scheme.implicit() ? 0.0 : 100.0;
  Driver run(scene.model, scene.plan, methods());
  struct Step final : Sink {
    std::function<void(double)> see;
    void step(double time, const RunStats&, const Ledger&) override { see(time); }
  } watch;
  double beyond = 0.0;
  watch.see = [&](double time) {
    if (time < 0.01) return;  // every point has slipped by then
    const Resultant r = resultant(run.state());
    beyond = std::max(beyond, std::abs(r.tangential) - r.normal * std::tan(10.0 * kDegree));
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_GT(centre_of(run, block).x(), 0.05);  // the leading edge passed one joint, and an inner part another
  EXPECT_LT(beyond, 1e-9 * 2600.0 * kGravity);
}
INSTANTIATE_TEST_SUITE_P(schemes, Cohesion,
                         testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                         Scheme{"dda", "dda", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

// ---- Frames and threads -----------------------------------------------------------------------------------------

/// A block thrown on two others, in a scene turned by R.
Scene thrown(const Mat2& R, const char* method, Integrator integrator) {
  Scene scene(1e9, 0.2, 2600.0, 25.0);
  const Vec2 origin(0.0, 0.0);
  scene.model.gravity = R * Vec2(0.0, -kGravity);
  scene.add("base", transformed(rectangle(-4, -1, 6, 0), origin, R), true);
  scene.add("left", transformed(rectangle(0, 0, 1, 1), origin, R));
  scene.add("right", transformed(rectangle(1, 0, 2.2, 1), origin, R));
  const BlockId top = scene.add(
      "top", transformed(transformed(rectangle(-0.4, 0, 0.6, 0.8), origin, rotation(0.12)), R * Vec2(0.7, 1.1), R));
  scene.model.initial_velocities.push_back({top, R * Vec2(1.0, -1.0), 0.3});
  const bool implicit = integrator == Integrator::implicit;
  scene.model.joints[0].damping = 0.2;
  // Whether a contact slides is decided by a threshold: round-off may change the decision one period later.
  scene.stage(method, integrator, 0.3, implicit ? std::optional<double>(1e-3) : std::nullopt, 0.5).sliding_damping =
      0.0;
  return scene;
}

class Frames : public testing::TestWithParam<Scheme> {};

TEST_P(Frames, turned_scene_moves_the_same) {
  const Mat2 R = rotation(37.0 * kDegree);
  std::vector<Vec2> centre[2];
  for (const bool turned : {false, true}) {
    const Scene scene = thrown(turned ? R : Mat2(Mat2::Identity()), GetParam().method, GetParam().integrator);
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
    for (std::int32_t i = 1; i <= 3; ++i)
      centre[turned ? 1 : 0].push_back(turned ? Vec2(R.transpose() * centre_of(run, BlockId{i}))
                                              : centre_of(run, BlockId{i}));
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT((centre[0][i] - centre[1][i]).norm(), 1e-8) << i;
}
INSTANTIATE_TEST_SUITE_P(schemes, Frames,
                         testing::Values(Scheme{"dda", "dda", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(Threads, sharing_contacts_have_the_same_bits) {
  std::uint64_t hash[2];
  const int most = omp_get_max_threads();
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    Scene scene = thrown(Mat2::Identity(), "nmm", Integrator::explicit_);
    scene.plan.stages[0].duration = ticks(0.15);
    scene.plan.stages[0].cover_size = 0.25;
    Driver run(scene.model, scene.plan, methods());
    std::int64_t most_contacts = 0;
    Watch watch;
    watch.see = [&](const FrameView& view) { most_contacts = std::max(most_contacts, view.stats->contacts); };
    run.add_sink(watch);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    hash[threads - 1] = state_hash(run.state());
    EXPECT_GT(most_contacts, 6);
  }
  omp_set_num_threads(most);
  EXPECT_EQ(hash[0], hash[1]);
}

// ---- Corners against corners ------------------------------------------------------------------------------------

class HeadOn : public testing::TestWithParam<std::tuple<Scheme, double, double>> {};

/// Two squares on their tips meet corner to corner, without gravity.
TEST_P(HeadOn, momentum_is_kept_and_they_do_not_pass) {
  const auto& [scheme, speed, offset] = GetParam();
  Scene scene(1e9, 0.2, 2600.0, 20.0);
  scene.model.gravity = {0.0, 0.0};
  const Mat2 R = rotation(45.0 * kDegree);
  const double r = std::sqrt(0.5);
  const BlockId a = scene.add("a", transformed(rectangle(-0.5, -0.5, 0.5, 0.5), Vec2(-r - 0.002, offset), R)),
                b = scene.add("b", transformed(rectangle(-0.5, -0.5, 0.5, 0.5), Vec2(r + 0.002, 0.0), R));
  scene.model.initial_velocities.push_back({a, Vec2(speed, 0.0), 0.0});
  scene.model.initial_velocities.push_back({b, Vec2(-speed, 0.0), 0.0});
  scene.stage(scheme.method, scheme.integrator, 0.1 / speed,
              scheme.implicit() ? std::optional<double>(1e-4 / speed) : std::nullopt, 0.4);
  scene.plan.output.every = scene.plan.stages[0].duration / 500;
  Driver run(scene.model, scene.plan, methods());
  double deepest = 0.0;  // of a corner in the other square
  Watch watch;
  watch.see = [&](const FrameView&) {
    for (const auto& [of, in] : {std::pair(a, b), std::pair(b, a)})
      for (const Vec2& corner : scene.model.blocks[of.index()].polygon.outer) {
        const Vec2 x = point_of(run, of, corner);
        double inside = 1.0;
        const Ring& ring = scene.model.blocks[in.index()].polygon.outer;
        for (std::size_t i = 0; i < ring.size(); ++i)
          inside = std::min(
              inside,
              -contact_geometry(x, point_of(run, in, ring[i]), point_of(run, in, ring[(i + 1) % ring.size()])).gap);
        deepest = std::max(deepest, inside);
      }
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const BodyTotals ta = totals_of(run, a), tb = totals_of(run, b);
  const double scale = 2600.0 * speed;
  // One pair of faces carries the force, over a length and to a depth of s = d/sqrt(2) where d is the overlap of the
  // tips. The work of F = E' s^2 (width 1 m) along s is E' s^3/3; it equals the kinetic energy of the squares.
  const double limit = std::cbrt(3.0 * scale * speed / scene.model.elasticity_of(a).p_modulus());
  std::printf("%s %g m/s, offset %g: %.3f %.3f after, depth %.2e of %.2e, closure %.1e\n", scheme.name, speed, offset,
              ta.momentum.x() / scale, ta.momentum.y() / scale, deepest, limit, run.state().ledger.relative_closure());
  EXPECT_LT((ta.momentum + tb.momentum).norm(), 1e-11 * scale);
  EXPECT_LT(deepest, limit);
  EXPECT_LT(ta.momentum.x(), 0.5 * scale);
  EXPECT_LE(ta.kinetic + tb.kinetic, scale * speed * (1.0 + 1e-9));
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(schemes, HeadOn,
                         testing::Combine(testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                                          Scheme{"dda", "dda", Integrator::explicit_},
                                                          Scheme{"dda_implicit", "dda", Integrator::implicit}),
                                          testing::Values(1.0, 10.0), testing::Values(0.0, 1e-3)),
                         [](const auto& of) {
                           return std::string(std::get<0>(of.param).name) + "_" +
                                  std::to_string(static_cast<int>(std::get<1>(of.param))) +
                                  (std::get<2>(of.param) > 0.0 ? "_aside" : "");
                         });

}  // namespace
}  // namespace scree::test::contact_tributary_test
