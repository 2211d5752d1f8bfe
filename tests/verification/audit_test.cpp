// The audit of contacts: it must report planted faults (gap, stretch, forces beyond the law, an overlap without a
// contact) and must pass in runs of at least 500 steps.
#include "coupling/contact/audit/audit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/support/by_hand.h"

namespace scree::test::audit_test {
namespace {

using coupling::Integrator;

/// Blocks of unequal sizes and shapes, turned and thrown together onto a floor between walls.
Scene heap(int count) {
  Scene scene(5e8, 0.2, 2500.0, 25.0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> size(0.6, 1.2), turn(0.0, 3.0), speed(-3.0, 0.0);
  scene.add("floor", rectangle(-3.0, -1.0, 7.0, 0.0), true);
  scene.add("left", rectangle(-4.0, -1.0, -3.0, 6.0), true);
  scene.add("right", rectangle(7.0, -1.0, 8.0, 6.0), true);
  for (int i = 0; i < count; ++i) {
    const double w = size(random), h = size(random), bevel = 0.3 * std::min(w, h);
    const Polygon p{
        {{-w / 2, -h / 2}, {w / 2, -h / 2}, {w / 2, h / 2 - bevel}, {w / 2 - bevel, h / 2}, {-w / 2, h / 2}}, {}};
    const int row = i / 5;
    const Vec2 at(-1.8 + 1.9 * (i % 5), 1.0 + 1.9 * row);
    const BlockId id = scene.add("b" + std::to_string(i), transformed(p, at, rotation(turn(random))));
    scene.model.initial_velocities.push_back({id, Vec2(0.5 * speed(random), speed(random)), turn(random) - 1.5});
  }
  return scene;
}

/// Two blocks on a slope, one bonded to it; the shaking of their base breaks them loose.
Scene shaken() {
  Scene scene(1e9, 0.2, 2500.0, 30.0);
  scene.model.joints[0].cohesion = 2e4;
  scene.model.joints[0].tensile_strength = 1e4;
  scene.model.joints[0].residual_friction = 20.0 * kDegree;
  scene.model.joints[0].weakening_slip = 0.05;
  const Mat2 R = rotation(-0.4);
  scene.add("base", transformed(rectangle(-3, -1, 12, 0), Vec2(0, 0), R));
  std::vector<double> t, a;
  for (int i = 0; i <= 400; ++i) {
    t.push_back(0.005 * i);
    a.push_back(8.0 * std::sin(2.0 * std::numbers::pi * 3.0 * t.back()));
  }
  scene.model.motions.emplace_back(t, a, Vec2(1.0, 0.0));
  scene.model.block_supports.push_back({BlockId{0}, MotionId{0}});
  scene.add("lower", transformed(rectangle(0, 0, 1.5, 1), Vec2(0, 0), R));
  scene.add("upper", transformed(rectangle(0.1, 1, 1.3, 2.2), Vec2(0, 0), R));
  return scene;
}

struct Setting {
  const char* name;
  const char* method;
  Integrator integrator;
  bool heap;
  double duration, dt;  // dt 0: auto
};

class AuditedRun : public testing::TestWithParam<Setting> {};

TEST_P(AuditedRun, every_step_passes) {
  const Setting& r = GetParam();
  Scene scene = r.heap ? heap(10) : shaken();
  coupling::Partition& sides =
      scene.stage(r.method, r.integrator, r.duration, r.dt > 0.0 ? std::optional<double>(r.dt) : std::nullopt, 0.6)
          .partition;
  sides.speed = {1.0, 0.5};  // of partitioned stages
  scene.plan.audit = true;
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  const coupling::RunEnd end = run.run();
  std::printf("%s: %lld steps, %lld checks, worst %.2g of what is allowed (%s)\n", r.name,
              static_cast<long long>(run.stats().steps), static_cast<long long>(run.audit().checks()),
              run.audit().worst(), run.audit().text().c_str());
  ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
  EXPECT_GE(run.stats().steps, 500);
  EXPECT_GT(run.audit().checks(), 5 * run.stats().steps);
  EXPECT_TRUE(run.audit().passed());
}

INSTANTIATE_TEST_SUITE_P(
    Runs, AuditedRun,
    testing::Values(Setting{"dda_implicit_heap", "dda", Integrator::implicit, true, 1.2, 2e-3},
                    Setting{"dda_explicit_heap", "dda", Integrator::explicit_, true, 0.6, 0.0},
                    Setting{"nmm_explicit_heap", "nmm", Integrator::explicit_, true, 0.4, 0.0},
                    Setting{"dda_implicit_shaken", "dda", Integrator::implicit, false, 1.5, 2e-3},
                    Setting{"dda_explicit_shaken", "dda", Integrator::explicit_, false, 1.0, 0.0},
                    Setting{"nmm_implicit_shaken", "nmm", Integrator::implicit, false, 1.0, 2e-3},
                    Setting{"dda_partitioned_heap", "dda", Integrator::partitioned, true, 0.6, 1e-3},
                    Setting{"nmm_partitioned_shaken", "nmm", Integrator::partitioned, false, 0.5, 1e-3}),
    [](const auto& p) { return p.param.name; });

/// A block at rest on a floor, whose contact memory can be falsified.
struct Resting {
  Scene scene{1e9, 0.2, 2500.0, 30.0};
  std::unique_ptr<ByHand> hand;
  coupling::ContactList list;

  Resting() {
    scene.add("floor", rectangle(-1, -1, 3, 0), true);
    scene.add("block", rectangle(0, 0, 1, 1));
    const coupling::Stage& stage = scene.stage("dda", Integrator::implicit, 1.0, 1e-3);
    hand = std::make_unique<ByHand>(scene.model, stage);
    coupling::ContactFinder finder(*hand->setup, 0.05);
    finder.find(hand->state.q, coupling::ContactList(), true, list);
  }
  [[nodiscard]] coupling::Audit geometry() const {
    coupling::Audit audit;
    coupling::audit_geometry(*hand->setup, list, hand->state.q, 0.05, audit);
    return audit;
  }
  [[nodiscard]] coupling::Audit law(double fn, double ft) const {
    coupling::Audit audit;
    coupling::audit_law(*hand->setup, list.memory[0], fn, ft, 1e-3, audit);
    return audit;
  }
};

TEST(Audit, contact_as_it_is_passes) {
  const Resting r;
  ASSERT_FALSE(r.list.points.empty());
  EXPECT_TRUE(r.geometry().passed());
  EXPECT_GT(r.geometry().checks(), 1);
  EXPECT_TRUE(r.law(1000.0, 577.0).passed());
}

TEST(Audit, wrong_gap_or_stretch_is_found) {
  Resting gap, stretch;
  gap.list.memory[0].gap += 1e-6;
  EXPECT_FALSE(gap.geometry().passed());
  EXPECT_NE(gap.geometry().text().find("the gap is"), std::string::npos) << gap.geometry().text();
  stretch.list.memory[0].stretch = 1e-6;
  EXPECT_FALSE(stretch.geometry().passed());
}

TEST(Audit, pull_and_friction_beyond_the_law_are_found) {
  const Resting r;
  EXPECT_FALSE(r.law(-1.0, 0.0).passed());
  EXPECT_NE(r.law(-1.0, 0.0).text().find("'block'"), std::string::npos);
  EXPECT_FALSE(r.law(1000.0, 578.0).passed());
  EXPECT_NE(r.law(1000.0, 578.0).text().find("limit is 577.35"), std::string::npos) << r.law(1000.0, 578.0).text();
}

TEST(Audit, block_that_nothing_holds_inside_another_is_found) {
  Resting r;
  r.list.points.clear();
  r.list.memory.clear();
  EXPECT_TRUE(r.geometry().passed());  // it only touches
  AffineMotion m;
  m.c = Vec2(0.5, 0.45);
  const coupling::Body& b = r.hand->setup->bodies()[1];
  r.hand->setup->pool_of(b).place(b.index, m, r.hand->state.q, r.hand->state.v);
  EXPECT_FALSE(r.geometry().passed());
  EXPECT_NE(r.geometry().text().find("inside block 'floor'"), std::string::npos) << r.geometry().text();
}

/// The arms of a beam held in the middle hang down: its lower side is above the chord of its ends there, and
/// the corner of a block between the two touches nothing.
TEST(Audit, corner_between_a_bent_side_and_its_chord_is_outside) {
  Scene scene(5e8, 0.2, 2500.0, 30.0);
  const BlockId beam = scene.add("beam", rectangle(0.0, 1.0, 6.0, 1.3));
  scene.add("below", rectangle(4.4, 0.0, 4.6, 0.978), true);
  for (const double x : {2.9, 3.1}) scene.model.point_supports.push_back({beam, {x, 1.0}, true, true, 1e10});
  scene.stage("nmm", Integrator::implicit, 4.0, 0.05, 0.15).rest = true;
  scene.plan.detection = 0.002;
  scene.plan.audit = true;
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  const coupling::RunEnd end = run.run();
  EXPECT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
  const coupling::Setup& setup = run.setup();
  const auto height = [&](double x) {
    const coupling::Body& b = setup.bodies()[0];
    return coupling::position(setup.global(b, setup.pool_of(b).row_at(b.index, Vec2(x, 1.0) - b.centre)), run.state().q)
        .y();
  };
  const double chord = height(6.0);
  std::printf("lower side at %.4f m, chord at %.4f m\n", height(4.5), chord);
  EXPECT_LT(chord, 0.978 - 2e-3);
  EXPECT_GT(height(4.5), 0.978 + 2e-3);
}

TEST(Audit, corners_where_joints_cross_go_as_deep_as_the_joints_beside_them_give_way) {
  constexpr double kDetection = 0.02;
  Scene scene(3e8, 0.2, 2500.0, 30.0);
  scene.model.gravity = {-5.0, -9.0};
  scene.add("floor", rectangle(-2, -2, 22, 0), true);
  scene.add("wall", rectangle(-2, 0, 0, 22), true);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 2; ++column)
      scene.add(fmt::format("b{}{}", row, column), rectangle(10 * column, 10 * row, 10 * (column + 1), 10 * (row + 1)));
  scene.stage("dda", Integrator::implicit, 2.0, 1e-2).rest = true;
  scene.plan.detection = kDetection;
  scene.plan.audit = true;
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  const coupling::RunEnd end = run.run();
  EXPECT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
  // The upper right block penetrates the lower left one deeper than is allowed without a contact.
  const coupling::Setup& setup = run.setup();
  const auto corner = [&](std::size_t block, double x, double y) {
    const coupling::Body& b = setup.bodies()[block];
    return coupling::position(setup.global(b, setup.pool_of(b).row_at(b.index, Vec2(x, y) - b.centre)), run.state().q);
  };
  const Vec2 into = corner(2, 10, 10) - corner(5, 10, 10);
  std::printf("%.4g m, %.4g m deep, of %.4g m that may lie unheld\n", into.x(), into.y(), 0.1 * kDetection);
  EXPECT_GT(into.minCoeff(), 0.1 * kDetection);
  // Without the closed joints beside it, this penetration is a violation.
  coupling::ContactFinder finder(setup, kDetection);
  coupling::ContactList known, list;
  finder.restore(run.state().contacts.memory, known);
  finder.find(run.state().q, known, false, list);
  const auto found = [&] {
    coupling::Audit audit;
    coupling::audit_geometry(setup, list, run.state().q, kDetection, audit);
    return audit;
  };
  EXPECT_TRUE(found().passed()) << found().text();
  for (coupling::ContactMemory& m : list.memory) m.status = coupling::ContactStatus::open;
  EXPECT_FALSE(found().passed());
  EXPECT_NE(found().text().find("nothing holds it"), std::string::npos) << found().text();
}

TEST(Audit, not_a_number_is_a_violation) {
  coupling::Audit audit;
  audit.check(std::nan(""), 1.0, [] { return std::string("lost"); });
  EXPECT_FALSE(audit.passed());
}

}  // namespace
}  // namespace scree::test::audit_test
