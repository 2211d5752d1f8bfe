// The friction check: it must report sliding blocks that lose friction although every step obeys the law and the ledger
// closes, and must not report others.
#include "coupling/contact/audit/friction_check.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/schemes.h"

namespace scree::test::friction_check_test {
namespace {

using namespace coupling;

/// The equations without sliding damping, in which steep blocks flutter: contacts of explicit steps are damped by a
/// fifth of critical; contacts of implicit steps and the deformation of sliding blocks are not damped.
void bare(Scene& scene) {
  for (Stage& stage : scene.plan.stages) {
    stage.sliding_damping = 0.0;
    scene.model.joints[0].damping = stage.integrator == Integrator::implicit ? 0.0 : 0.2;
  }
}

/// Warnings of a run, its friction ratio and the distance that a block slid [m].
struct Found final : Sink {
  std::vector<std::string> warnings;
  double ratio = 0.0, slid = 0.0;
  void event(const Event& e) override {
    if (e.kind == EventKind::warning) warnings.push_back(e.text);
  }
  [[nodiscard]] std::size_t of_friction() const {
    std::size_t count = 0;
    for (const std::string& w : warnings) count += w.find("sliding friction was") != std::string::npos ? 1 : 0;
    return count;
  }
};

/// Runs a scene and records the displacement of a block, the friction ratio and the warnings.
void look_at(Scene& scene, BlockId block, Found& found) {
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(found);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  found.ratio = run.stats().friction_ratio;
  found.slid = (centre_of(run, block) - run.setup().bodies()[block.index()].centre).norm();
}

/// A wedge of 20 m on a plane of 35 degrees, 2 degrees below its friction angle, pushed down the plane for 0.2 s: a
/// rigid wedge slides 0.220 m.
struct Wedge : Scene {
  BlockId wedge;
  explicit Wedge(double seconds_after = 1.0) : Scene(5e9, 0.2, 2600.0, 37.0) {
    const Vec2 t(std::cos(35.0 * kDegree), std::sin(35.0 * kDegree)), n(-t.y(), t.x());
    const auto at = [&](double s, double z) -> Vec2 { return s * t + z * n; };
    add("plane", {{at(-60, -20), at(60, -20), at(60, 0), at(-60, 0)}, {}}, true);
    wedge = add("wedge", {{Vec2(0, 0), Vec2(28.563, 20), Vec2(11.547, 20)}, {}});
    model.gravity = {0.0, 0.0};
    TimeFunction ramp, pulse;
    ramp.shape = TimeFunction::Shape::ramp;
    ramp.duration = 0.5;
    pulse.shape = TimeFunction::Shape::half_sine;
    pulse.start = 1.0;
    pulse.duration = 0.2;
    model.functions = {ramp, pulse};
    model.body_accelerations.push_back({{}, {0.0, -9.81}, FunctionId{0}});
    model.body_accelerations.push_back({{}, {-3.0, 0.0}, FunctionId{1}});
    seconds = 1.2 + seconds_after;
  }
  double seconds;
};

TEST(FrictionCheck, fires_where_the_wedge_flutters_in_explicit_steps) {
  Wedge scene;
  scene.stage("dda", Integrator::explicit_, scene.seconds, std::nullopt);
  bare(scene);
  Found found;
  look_at(scene, scene.wedge, found);
  std::printf("slid %.3f m, ratio %.4f\n", found.slid, found.ratio);
  EXPECT_LT(found.ratio, 0.97);
  ASSERT_EQ(found.of_friction(), 1U);
  const auto names_pair = [](const std::string& w) {
    return w.find("blocks 'wedge' and 'plane'") != std::string::npos;
  };
  EXPECT_TRUE(std::any_of(found.warnings.begin(), found.warnings.end(), names_pair));
}

TEST(FrictionCheck, fires_at_implicit_steps_of_1_ms_and_not_of_5_ms) {
  for (const double dt : {1e-3, 5e-3}) {
    Wedge scene;
    scene.stage("dda", Integrator::implicit, scene.seconds, dt);
    bare(scene);
    Found found;
    look_at(scene, scene.wedge, found);
    std::printf("dt %g: slid %.3f m, ratio %.4f\n", dt, found.slid, found.ratio);
    EXPECT_EQ(found.of_friction(), dt < 2e-3 ? 1U : 0U) << dt;
  }
}

/// A block that slides steadily down a plane of 25 degrees at a friction angle of 20, in all schemes.
struct Slide : Scene {
  BlockId block;
  Slide() : Scene(1e9, 0.2, 2600.0, 20.0) {
    const Vec2 t(std::cos(25.0 * kDegree), -std::sin(25.0 * kDegree)), n(-t.y(), t.x());
    const auto at = [&](double s, double z) -> Vec2 { return s * t + z * n; };
    add("plane", {{at(-2, -2), at(8, -2), at(8, 0), at(-2, 0)}, {}}, true);
    block = add("block", {{at(-1, 0), at(1, 0), at(1, 1), at(-1, 1)}, {}});
  }
};

class SteadySlide : public ::testing::TestWithParam<Scheme> {};

TEST_P(SteadySlide, has_its_friction) {
  Slide scene;
  Stage& stage = scene.stage(GetParam().method, GetParam().integrator, 1.5,
                             GetParam().implicit() ? std::optional(2e-3) : std::nullopt);
  stage.damping = 50.0;  // damping of the block itself, by which the initial oscillation decays
  Found found;
  look_at(scene, scene.block, found);
  std::printf("%s: slid %.3f m, ratio %.6f\n", GetParam().name, found.slid, found.ratio);
  EXPECT_GT(found.ratio, 0.995);
  EXPECT_LT(found.ratio, 1.0 + 1e-5);
  EXPECT_EQ(found.of_friction(), 0U);
}
INSTANTIATE_TEST_SUITE_P(AllSchemes, SteadySlide, ::testing::ValuesIn(kAllSchemes),
                         [](const auto& p) { return p.param.name; });

/// Explicit and implicit steps in one stage, and steps of two sizes: every substep is checked by the integrator that
/// has the contact.
TEST(FrictionCheck, sees_partitioned_and_subcycled_stages) {
  for (const bool flutters : {false, true})
    for (const int kind : {0, 1, 2}) {  // explicit wedge, shared contacts, steps of two sizes
      Wedge scene;
      if (!flutters) scene.model.joints[0].friction = 20.0 * kDegree, scene.model.functions[1].amplitude = 0.0;
      const BlockId other = scene.add("other", rectangle(100, 0, 110, 10));
      Stage& stage =
          scene.stage("dda", Integrator::partitioned, flutters ? scene.seconds : 1.2, kind == 2 ? 5e-4 : 1e-3);
      (kind == 1 ? stage.partition.implicit_blocks : stage.partition.explicit_blocks) = {scene.wedge};
      if (kind == 1) stage.partition.explicit_blocks = {other};
      stage.partition.shared_contacts = kind == 1;
      stage.partition.slow_explicit = kind == 2;
      bare(scene);
      scene.model.body_accelerations[0].blocks = scene.model.body_accelerations[1].blocks = {scene.wedge};
      Found found;
      look_at(scene, scene.wedge, found);
      std::printf("%s, kind %d: slid %.3f m, ratio %.4f\n", flutters ? "flutters" : "slides", kind, found.slid,
                  found.ratio);
      EXPECT_TRUE(std::isfinite(found.ratio));
      if (flutters) {
        EXPECT_EQ(found.of_friction(), 1U) << kind;
      }
    }
}

/// A vertex that passes from edge to collinear edge keeps its slide memory: none of the edges is as long as a hundred
/// elastic stretches.
TEST(FrictionCheck, goes_with_a_vertex_to_the_next_edge) {
  for (const double piece : {100.0, 0.04}) {
    Scene scene(1e7, 0.2, 2600.0, 20.0);
    Polygon plane{{{-2, -2}, {8, -2}, {8, 0}}, {}};
    for (double x = 8.0 - piece; x > -2.0; x -= piece) plane.outer.push_back({x, 0.0});
    plane.outer.push_back({-2, 0});
    scene.add("plane", plane, true);
    const BlockId block = scene.add("block", rectangle(-1, 0, 1, 1));
    scene.model.gravity = {9.81 * std::sin(25.0 * kDegree), -9.81 * std::cos(25.0 * kDegree)};
    scene.stage("dda", Integrator::explicit_, 1.5, std::nullopt);
    Found found;
    look_at(scene, block, found);
    std::printf("pieces of %g m: slid %.3f m, ratio %.6f\n", piece, found.slid, found.ratio);
    EXPECT_TRUE(std::isfinite(found.ratio));
    EXPECT_EQ(found.of_friction(), 0U);
  }
}

/// The slide memory is the same after a restart: the whole state is equal bit for bit.
TEST(FrictionCheck, goes_on_from_a_checkpoint_in_the_same_bits) {
  Wedge scene;
  scene.stage("dda", Integrator::explicit_, scene.seconds, std::nullopt);
  bare(scene);
  scene.plan.output.every = scene.plan.output.history_every = ticks(0.05);
  struct Keep final : Keeper {
    Checkpoint last;
    bool due(std::int64_t step) override { return step == 700; }
    void keep(const Checkpoint& c) override {
      if (c.state.step == 700) last = c;
    }
  } keeper;
  Found whole, rest;
  Driver run(scene.model, scene.plan, methods());
  run.set_keeper(keeper);
  run.add_sink(whole);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_EQ(keeper.last.state.step, 700);
  Driver again(scene.model, scene.plan, methods());
  again.add_sink(rest);
  again.continue_from(keeper.last);
  ASSERT_EQ(again.run().status, RunEnd::Status::done);
  EXPECT_EQ(state_hash(again.state()), state_hash(run.state()));
  EXPECT_EQ(again.stats().friction_ratio, run.stats().friction_ratio);
  EXPECT_EQ(whole.of_friction(), 1U);  // reported once in all, before or after the checkpoint
  EXPECT_LE(rest.of_friction(), 1U);
}

/// A block on a level base that is shaken back and forth: it slips and sticks in each period, with a net slip in one
/// direction.
TEST(FrictionCheck, is_silent_where_a_block_really_stops) {
  for (const bool implicit : {false, true}) {
    Scene scene(5e9, 0.2, 2600.0, 20.0);
    scene.add("base", rectangle(-4, -2, 8, 0));
    scene.model.block_supports.push_back({BlockId{0}, MotionId{0}});
    std::vector<double> t, a;
    for (int i = 0; i <= 800; ++i) {  // 5 Hz: strong and short in one direction, weak and long in the other
      t.push_back(0.0025 * i);
      const double phase = std::fmod(5.0 * t.back(), 1.0);
      a.push_back(t.back() >= 2.0
                      ? 0.0
                      : (phase < 0.25 ? 8.0 * std::sin(4.0 * std::numbers::pi * phase)
                                      : -8.0 / 3.0 * std::sin(4.0 / 3.0 * std::numbers::pi * (phase - 0.25))));
    }
    scene.model.motions.emplace_back(t, a, Vec2(1.0, 0.0));
    const BlockId block = scene.add("block", rectangle(0, 0, 1, 1));
    scene.stage("dda", implicit ? Integrator::implicit : Integrator::explicit_, 2.0,
                implicit ? std::optional(1e-3) : std::nullopt);
    Found found;
    look_at(scene, block, found);
    std::printf("%s: went %.4f m, ratio %.4f\n", implicit ? "implicit" : "explicit", found.slid, found.ratio);
    EXPECT_EQ(found.of_friction(), 0U) << found.ratio;
  }
}

// ---------------------------------------------------------------------------------------------------------------

/// One point of a block on a base, with forces given by hand.
struct Point {
  Scene scene{5e9, 0.2, 2600.0, 30.0};
  Methods all = standard_methods();
  std::unique_ptr<Setup> setup;
  ContactList list;
  /// @param acts  a load that never ends
  explicit Point(bool acts = true) {
    if (acts) {
      TimeFunction load;
      load.shape = TimeFunction::Shape::sine;
      load.frequency = 1.0;
      scene.model.functions.push_back(load);
    }
    scene.add("base", rectangle(-1, -1, 2, 0), true);
    scene.add("block", rectangle(0, 0, 1, 1));
    scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
    setup = std::make_unique<Setup>(scene.model, all,
                                    initial_records(scene.model, body_requests(scene.model, scene.plan.stages[0])));
    ContactPoint p;
    const Outlines& o = setup->outlines();
    for (const VertexIndex v : o.vertices.indices())
      if (o.vertices[v].body == BodyIndex{1}) p.vertex = v;
    p.edge = EdgeIndex{0};
    ContactMemory m;
    m.joint = 0;
    m.kn = m.kt = 1e8;  // an elastic stretch of 6e-5 of the block
    m.tributary = 0.5;
    m.status = ContactStatus::stick;
    m.fn = 1e4;
    list.points.push_back(p);
    list.memory.push_back(m);
  }
  [[nodiscard]] double limit() const { return 1e4 * std::tan(30.0 * kDegree); }
  ContactMemory& memory() { return list.memory[0]; }
  /// Steps in each of which the point slips by `stretches` elastic stretches under the fraction `part` of its limit.
  void slide(FrictionCheck& check, int steps, double h, double stretches, double part) {
    for (int i = 0; i < steps; ++i) {
      check.begin(list, 0.0);
      memory().status = stretches != 0.0 ? ContactStatus::slip : ContactStatus::stick;
      memory().ft = -part * limit();
      check.see(h, list.points[0], stretches * limit() / memory().kt, memory());
    }
  }
};

TEST(FrictionCheck, is_the_ratio_of_two_impulses) {
  for (const double part : {1.0, 0.985}) {
    Point point;
    FrictionCheck check(*point.setup);
    check.begin(point.list, 0.0);
    const double T = check.period(point.list.points[0]);
    // m = 2600 kg on k_t = 1e8 N/m, and 2 sqrt(A)/c_s.
    EXPECT_NEAR(T, std::hypot(2.0 * std::numbers::pi * std::sqrt(2600.0 / 1e8), 2.0 * std::sqrt(2600.0 * 2.4 / 5e9)),
                1e-9 * T);
    point.slide(check, 20 * 40, T / 39.5, 1.0, part);
    EXPECT_NEAR(point.memory().slide.worst, part, 1e-6);
  }
}

TEST(FrictionCheck, counts_what_is_lost_while_a_point_is_turned_round_and_not_while_it_is_open) {
  Point point;
  FrictionCheck check(*point.setup);
  check.begin(point.list, 0.0);
  const double h = check.period(point.list.points[0]) / 39.5;
  for (int k = 0; k < 20; ++k) {  // in each period: forward slip, a tenth of the time backward slip, then open
    point.slide(check, 18, h, 2.0, 1.0);
    point.slide(check, 2, h, -0.5, -1.0);
    const double fn = point.memory().fn;
    point.memory().status = ContactStatus::open;
    point.memory().fn = point.memory().ft = 0.0;
    for (int i = 0; i < 20; ++i) {
      check.begin(point.list, 0.0);
      check.see(h, point.list.points[0], 0.0, point.memory());
    }
    point.memory().fn = fn;
  }
  EXPECT_NEAR(point.memory().slide.worst, 0.8, 1e-6);
}

TEST(FrictionCheck, forgets_a_slide_that_stops) {
  Point point;
  FrictionCheck check(*point.setup);
  check.begin(point.list, 0.0);
  const double h = check.period(point.list.points[0]) / 39.5;
  for (int k = 0; k < 50; ++k) {
    point.slide(check, 7 * 40, h, 1.0, 1.0);
    point.slide(check, 3 * 40 + 17, h, 0.0, 0.1);  // sticks under little force
  }
  EXPECT_NEAR(point.memory().slide.worst, 1.0, 1e-6);
}

TEST(FrictionCheck, tells_of_points_that_stick_and_slip_with_the_period_of_a_stack_once_nothing_acts) {
  for (const bool acts : {false, true}) {
    Point point(acts);
    FrictionCheck check(*point.setup);
    check.begin(point.list, 0.0);
    const double h = check.period(point.list.points[0]) / 39.5;
    for (int k = 0; k < 60; ++k) {  // one slip at full friction in three periods of the block
      point.slide(check, 40, h, 1.0, 1.0);
      point.slide(check, 80, h, 0.0, 0.75);
    }
    if (acts)  // shaking causes the same in blocks that lose no friction
      EXPECT_TRUE(std::isinf(point.memory().slide.worst)) << point.memory().slide.worst;
    else
      EXPECT_NEAR(point.memory().slide.worst, (1.0 + 2.0 * 0.75) / 3.0, 0.01);
  }
}

TEST(FrictionCheck, is_silent_where_a_slide_ends_and_nothing_acts) {
  for (const double pace : {1.0, 0.97, 0.9, 0.6}) {  // ratio of the slip of successive windows
    Point point(false);
    FrictionCheck check(*point.setup);
    check.begin(point.list, 0.0);
    const double h = check.period(point.list.points[0]) / 39.5;
    double slip = 10.0;
    for (int k = 0; k < 40 && slip > 1e-3; ++k, slip *= pace) point.slide(check, 40, h, slip, 1.0);
    point.slide(check, 200 * 40, h, 0.0, 0.3);
    EXPECT_GE(point.memory().slide.worst, FrictionCheck::kLeast) << pace;
  }
}

TEST(FrictionCheck, takes_what_deformation_brings_for_no_slide) {
  for (const double part : {0.9, 1.1}) {  // of the slip that counts: 2e-3 of the block's size, as its springs are stiff
    Point point;
    point.memory().kt = 1e11;
    FrictionCheck check(*point.setup);
    check.begin(point.list, 0.0);
    const double step = part * 2e-3 / (6.0 * 41.0), stretch = point.limit() / point.memory().kt;
    point.slide(check, 8 * 41, check.period(point.list.points[0]) / 40.5, step / stretch, 0.5);
    EXPECT_EQ(std::isinf(point.memory().slide.worst), part < 1.0) << part;
  }
}

TEST(FrictionCheck, takes_uneven_ways_for_stops_and_even_ones_for_flutter) {
  for (const double faster : {1.0, 1.9, 2.1, 10.0}) {  // pace of every other window
    Point point;
    FrictionCheck check(*point.setup);
    check.begin(point.list, 0.0);
    const double h = check.period(point.list.points[0]) / 39.5;
    for (int k = 0; k < 10; ++k) {
      point.slide(check, 40, h, 1.0, 0.5);
      point.slide(check, 40, h, faster, 0.5);
    }
    EXPECT_EQ(std::isinf(point.memory().slide.worst), faster > 2.0) << faster;
  }
}

TEST(FrictionCheck, tells_what_is_lost_in_six_windows_with_one_among_them_that_keeps) {
  for (const int keeping : {0, 1, 2})
    for (const int losing : {5, 6}) {
      Point point;
      FrictionCheck check(*point.setup);
      check.begin(point.list, 0.0);
      const double h = check.period(point.list.points[0]) / 39.5;
      const auto window = [&](double part) { point.slide(check, 40, h, 1.0, part); };
      for (int k = 0; k < 5; ++k) window(1.0);
      for (int k = 0; k < losing; ++k) {
        if (k >= 4 && k < 4 + keeping) window(1.0);
        window(0.8);
      }
      for (int k = 0; k < 5; ++k) window(1.0);
      EXPECT_EQ(point.memory().slide.worst < FrictionCheck::kLeast, losing == 6 && keeping < 2)
          << keeping << ", " << losing << ": " << point.memory().slide.worst;
    }
}

TEST(FrictionCheck, needs_a_hundred_stretches_one_way) {
  Point point;
  FrictionCheck check(*point.setup);
  check.begin(point.list, 0.0);
  const double h = check.period(point.list.points[0]) / 39.5;
  point.slide(check, 8 * 40, h, 0.4, 0.5);  // 96 stretches in the six windows that count
  EXPECT_TRUE(std::isinf(point.memory().slide.worst));
  for (int k = 0; k < 20; ++k) point.slide(check, 4 * 40, h, k % 2 == 0 ? -1.0 : 1.0, 0.5);
  EXPECT_TRUE(std::isinf(point.memory().slide.worst));
  point.slide(check, 8 * 40, h, 1.0, 0.5);
  EXPECT_NEAR(point.memory().slide.worst, 0.5, 1e-6);
}

}  // namespace
}  // namespace scree::test::friction_check_test
