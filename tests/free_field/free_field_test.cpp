// Free-field sides against level ground: waves from below rise undistorted along them, scattered waves leave.
#include "model/free_field.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <vector>

#include "tests/support/schemes.h"

namespace scree::test::free_field_test {
namespace {

using namespace coupling;

constexpr double kYoung = 2e8, kPoisson = 0.25, kDensity = 2000.0, kPulse = 0.08, kSpeed = 0.1;

enum class Sides { free, viscous, rollers, ground };

double wave_speed(bool shear) {
  const Elasticity law = Elasticity::from(kYoung, kPoisson, Plane::strain);
  return std::sqrt((shear ? law.mu : law.p_modulus()) / kDensity);
}

/// Velocity of the pulse: kSpeed sin^4(pi t/kPulse). Its first three derivatives are continuous.
double pulse_at(double t) {
  if (t < 0.0 || t > kPulse) return 0.0;
  const double s = std::sin(std::numbers::pi * t / kPulse);
  return kSpeed * s * s * s * s;
}

GroundMotion pulse(bool shear) {
  std::vector<double> t, a;
  for (int i = 0; i <= 1000; ++i) {
    const double turn = std::numbers::pi * i / 1000.0;
    t.push_back(kPulse * i / 1000.0);
    a.push_back(kSpeed * 4.0 * std::numbers::pi / kPulse * std::pow(std::sin(turn), 3) * std::cos(turn));
  }
  GroundMotion::Setting setting;
  setting.name = "pulse";
  return {t, a, shear ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0), setting};
}

/// Ground above y = 0; its surface is level at the heights of the left and right sides, with a slope between them.
struct Ground {
  double width = 8.0, left = 8.0, right = 8.0, toe = 0.0, crest = 0.0;
  [[nodiscard]] Polygon polygon() const {
    if (left == right) return rectangle(0.0, 0.0, width, left);
    return {{{0.0, 0.0}, {width, 0.0}, {width, right}, {crest, right}, {toe, left}, {0.0, left}}, {}};
  }
};

struct Shaken : Scene {
  Ground ground;
  bool shear;
  Sides kind;
  BlockId block;
  Shaken(const Ground& of, bool is_shear, Sides sides)
      : Scene(kYoung, kPoisson, kDensity), ground(of), shear(is_shear), kind(sides) {
    model.gravity = {0.0, 0.0};
    block = add("ground", ground.polygon());
    model.motions.push_back(pulse(shear));
    model.viscous_edges.push_back({{block, {0, 0}, 0.0, 1.0}, MotionId{0}, 1.0});
    const auto last = static_cast<std::int32_t>(model.blocks[0].polygon.outer.size()) - 1;
    for (const std::int32_t edge : {1, last}) {
      const EdgeSpan span{block, {0, edge}, 0.0, 1.0};
      if (sides == Sides::viscous) model.viscous_edges.push_back({span});
      if (sides == Sides::rollers) {
        Mat2 held = Mat2::Zero();
        held(shear ? 1 : 0, shear ? 1 : 0) = 1.0;
        model.edge_supports.push_back({span, held, {}});
      }
    }
  }
  void monitor(double x, double y) {
    model.monitors.push_back({"m" + std::to_string(model.monitors.size()), block, {x, y}});
  }
  /// Adds the last stage, and the free field beside the sides if they have one.
  void go(Integrator integrator, double duration, double cover = 0.5, bool rigid = false) {
    Stage& s = stage("nmm", integrator, duration, std::nullopt, cover);
    const auto last = static_cast<std::int32_t>(model.blocks[0].polygon.outer.size()) - 1;
    for (const auto& [edge, height] : {std::pair(1, ground.right), std::pair(last, ground.left)})
      if (kind == Sides::ground)
        add_free_field(model, {{block, {0, edge}, 0.0, 1.0}}, {0.0, height, MotionId{0}, rigid, 1.0}, duration);
    if (integrator == Integrator::implicit) s.dt = 5e-5;
    plan.output.history_every = ticks(2e-4);
    plan.output.every = s.duration;
  }
};

/// Largest difference of each monitor's velocity from that of a free surface at its height, over the largest velocity
/// of that surface; and the largest velocity of each monitor over the same.
struct Look final : Sink {
  explicit Look(const Shaken& of, std::vector<double> heights, double until = 1e9)
      : shaken(&of), height(std::move(heights)), end(until), error(height.size(), 0.0), peak(height.size(), 0.0) {}
  void history(const HistoryView& h) override {
    if (h.time > end) return;
    for (std::size_t k = 0; k < height.size(); ++k) {
      const Vec2 v(h.velocity[2 * k], h.velocity[2 * k + 1]);
      const double along = shaken->shear ? v.x() : v.y();
      const Vec2 free = 2.0 * pulse_at(h.time - height[k] / wave_speed(shaken->shear)) *
                        (shaken->shear ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0));
      error[k] = std::max(error[k], (v - free).norm() / (2.0 * kSpeed));
      peak[k] = std::max(peak[k], along / (2.0 * kSpeed));
    }
  }
  const Shaken* shaken;
  std::vector<double> height;
  double end;
  std::vector<double> error, peak;
};

const char* name_of(Sides sides) {
  switch (sides) {
    case Sides::free:
      return "free";
    case Sides::viscous:
      return "viscous";
    case Sides::rollers:
      return "rollers";
    case Sides::ground:
      break;
  }
  return "free field";
}

/// Results for level ground: extremes over the monitors on the surface, from the sides to the middle.
struct Level {
  double error = 0.0, low = 1.0, high = 0.0, closure = 0.0;
};
Level level(Integrator integrator, bool shear, Sides sides, double cover, std::optional<double> dt = {}) {
  const Ground ground;
  Shaken shaken(ground, shear, sides);
  for (const double x : {0.0, 0.5, 1.0, 2.0, 4.0, 7.5, 8.0}) shaken.monitor(x, ground.left);
  shaken.go(integrator, 2.0 * ground.left / wave_speed(shear) + 1.2 * kPulse, cover);
  if (dt) shaken.plan.stages[0].dt = dt;
  Look look(shaken, std::vector<double>(7, ground.left));
  Driver run(shaken.model, shaken.plan, methods());
  run.add_sink(look);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  Level found;
  for (std::size_t k = 0; k < 7; ++k) {
    found.error = std::max(found.error, look.error[k]);
    found.low = std::min(found.low, look.peak[k]);
    found.high = std::max(found.high, look.peak[k]);
  }
  found.closure = std::abs(run.state().ledger.closure()) / run.state().ledger.moved();
  std::printf("%-8s %-8s %-10s covers %.2f m: largest difference %.5f, peaks %.5f to %.5f, closure %.1e\n",
              integrator == Integrator::implicit ? "implicit" : "explicit", shear ? "shear" : "pressure",
              name_of(sides), cover, found.error, found.low, found.high, found.closure);
  return found;
}

class FreeFieldLevel : public testing::TestWithParam<std::tuple<Integrator, bool>> {};
INSTANTIATE_TEST_SUITE_P(waves, FreeFieldLevel,
                         testing::Combine(testing::Values(Integrator::explicit_, Integrator::implicit),
                                          testing::Bool()));

TEST_P(FreeFieldLevel, wave_goes_up_undistorted_up_to_the_sides) {
  const auto [integrator, shear] = GetParam();
  const Level found = level(integrator, shear, Sides::ground, 0.5);
  EXPECT_LT(found.error, 0.02);
  EXPECT_NEAR(found.low, 1.0, 0.02);
  EXPECT_NEAR(found.high, 1.0, 0.02);
  EXPECT_LT(found.closure, 1e-12);
}

// A divided block: its left half takes explicit steps, its right half implicit steps.
TEST(FreeFieldPartitioned, wave_goes_up_undistorted_on_both_sides) {
  const Ground ground;
  Shaken shaken(ground, true, Sides::ground);
  for (const double x : {0.0, 2.0, 6.0, 8.0}) shaken.monitor(x, ground.left);
  shaken.go(Integrator::partitioned, ground.left / wave_speed(true) + 1.1 * kPulse);
  Stage& stage = shaken.plan.stages[0];
  stage.dt = 2e-4;
  stage.partition.explicit_region = {{-1.0, -1.0}, {4.0, -1.0}, {4.0, 9.0}, {-1.0, 9.0}};
  Look look(shaken, std::vector<double>(4, ground.left));
  Driver run(shaken.model, shaken.plan, methods());
  run.add_sink(look);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const Ledger& ledger = run.state().ledger;
  const double error = *std::max_element(look.error.begin(), look.error.end());
  std::printf("partitioned: largest difference %.5f, closure %.1e\n", error,
              std::abs(ledger.closure()) / ledger.moved());
  EXPECT_LT(error, 0.02);
  EXPECT_LT(std::abs(ledger.closure()), 1e-12 * ledger.moved());
}

class FreeFieldWaves : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(waves, FreeFieldWaves, testing::Bool());

TEST_P(FreeFieldWaves, sides_without_the_ground_beside_them_distort_it) {
  EXPECT_GT(level(Integrator::explicit_, GetParam(), Sides::free, 0.5).error, 0.05);
  EXPECT_GT(level(Integrator::explicit_, GetParam(), Sides::viscous, 0.5).error, 0.2);
}

// The step is so small that the lag of explicit dashpots, half a step, is negligible.
TEST_P(FreeFieldWaves, error_falls_with_the_square_of_the_covers) {
  const double coarse = level(Integrator::explicit_, GetParam(), Sides::ground, 1.0, 1e-5).error,
               fine = level(Integrator::explicit_, GetParam(), Sides::ground, 0.5, 1e-5).error;
  std::printf("order %.2f\n", std::log2(coarse / fine));
  EXPECT_GT(std::log2(coarse / fine), 1.8);
}

/// A slope of 3 m: far from it both sides move as level ground does until the scattered waves arrive.
struct Slope {
  std::vector<double> far;  // largest difference at the left and the right side
  double left_over = 0.0;   // energy held at the end over the energy that the wave brought
  double closure = 0.0;
};
Slope slope(Integrator integrator, Sides sides, double duration) {
  const Ground ground{44.0, 6.0, 9.0, 20.0, 23.0};
  Shaken shaken(ground, true, sides);
  shaken.monitor(0.0, ground.left);
  shaken.monitor(ground.width, ground.right);
  shaken.go(integrator, duration, 0.6);
  // The wave reaches the toe after left/c_s; pressure waves from the toe reach the sides at this time or later.
  const double scattered = ground.left / wave_speed(true) + ground.toe / wave_speed(false);
  Look look(shaken, {ground.left, ground.right}, scattered);
  Driver run(shaken.model, shaken.plan, methods());
  run.add_sink(look);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const double brought = kDensity * wave_speed(true) * kSpeed * kSpeed * (35.0 / 128.0) * kPulse * ground.width;
  const Ledger& ledger = run.state().ledger;
  const Slope found{look.error, ledger.held() / brought, std::abs(ledger.closure()) / ledger.moved()};
  std::printf("%s: sides within %.5f and %.5f until %.4f s; energy left %.5f of what the wave brought; closure %.1e\n",
              name_of(sides), found.far[0], found.far[1], scattered, found.left_over, found.closure);
  return found;
}

TEST(FreeFieldSlope, sides_move_as_level_ground_and_scattered_waves_leave) {
  const Slope open = slope(Integrator::explicit_, Sides::ground, 0.3),
              held = slope(Integrator::explicit_, Sides::rollers, 0.3);
  for (const double error : open.far) EXPECT_LT(error, 0.02);
  EXPECT_LT(open.closure, 1e-12);
  EXPECT_LT(open.left_over, 0.2 * held.left_over);
}

/// A slope with weight, at rest between held blocks that are removed as the wave begins; their reactions are kept.
struct Heavy {
  double still = 0.0, far = 0.0, closure = 0.0;
};
Heavy heavy(Integrator integrator, double factor) {
  const Ground ground{40.0, 6.0, 9.0, 18.0, 21.0};
  Shaken shaken(ground, true, Sides::ground);
  shaken.model.gravity = {0.0, -9.81};
  GroundMotion::Setting setting = shaken.model.motions[0].setting();
  setting.stage = StageId{1};
  std::vector<double> a = shaken.model.motions[0].accelerations();
  for (double& x : a) x *= factor;
  shaken.model.motions[0] = GroundMotion(shaken.model.motions[0].times(), a, Vec2(1.0, 0.0), setting);
  const std::vector<BlockId> around{
      shaken.add("bed", rectangle(-2.0, -2.0, ground.width + 2.0, 0.0), true),
      shaken.add("left", rectangle(-2.0, 0.0, 0.0, ground.left), true),
      shaken.add("right", rectangle(ground.width, 0.0, ground.width + 2.0, ground.right), true)};
  shaken.monitor(0.0, ground.left);
  shaken.monitor(ground.width, ground.right);
  shaken.monitor(ground.toe, ground.left);
  Stage& rest = shaken.stage("nmm", Integrator::implicit, 2.0, 0.1, 0.75);
  rest.rest = true;
  const double begin = seconds(rest.duration);
  shaken.go(integrator, 0.12, 0.75);
  shaken.plan.stages[1].construction.absent = around;
  shaken.plan.stages[1].construction.release = 0.0;
  struct Watched final : Sink {
    void history(const HistoryView& h) override {
      const double t = h.time - begin;
      if (t <= 0.0) return;
      for (std::size_t k = 0; k < 6; ++k) fastest = std::max(fastest, std::abs(h.velocity[k]) / t);
      if (t > scattered) return;
      for (std::size_t k = 0; k < 2; ++k) {
        const double free = 2.0 * pulse_at(t - height[k] / wave_speed(true));
        far = std::max(far, std::hypot(h.velocity[2 * k] - free, h.velocity[2 * k + 1]) / (2.0 * kSpeed));
      }
    }
    double begin = 0.0, scattered = 0.0, fastest = 0.0, far = 0.0;
    std::array<double, 2> height{};
  } look;
  look.begin = begin + 1e-9;
  look.scattered = ground.left / wave_speed(true) + ground.toe / wave_speed(false);
  look.height = {ground.left, ground.right};
  Driver run(shaken.model, shaken.plan, methods());
  run.add_sink(look);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const Ledger& ledger = run.state().ledger;
  return {look.fastest / 9.81, look.far, std::abs(ledger.closure()) / ledger.moved()};
}

class FreeFieldWeight : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(schemes, FreeFieldWeight, testing::Values(Integrator::explicit_, Integrator::implicit));

TEST_P(FreeFieldWeight, slope_stays_at_rest_on_kept_reactions_and_its_sides_move_as_level_ground) {
  const Heavy still = heavy(GetParam(), 0.0), shaken = heavy(GetParam(), 1.0);
  std::printf("still: mean acceleration %.2e g; shaken: sides within %.5f; closure %.1e and %.1e\n", still.still,
              shaken.far, still.closure, shaken.closure);
  EXPECT_LT(still.still, 1e-6);
  EXPECT_LT(shaken.far, 0.02);
  EXPECT_LT(shaken.closure, 1e-12);
}

class FreeFieldBits : public testing::TestWithParam<Integrator> {};
INSTANTIATE_TEST_SUITE_P(schemes, FreeFieldBits, testing::Values(Integrator::explicit_, Integrator::implicit));

TEST_P(FreeFieldBits, go_on_from_a_checkpoint_and_do_not_depend_on_threads) {
  Shaken shaken(Ground{20.0, 6.0, 8.0, 8.0, 11.0}, true, Sides::ground);
  shaken.go(GetParam(), 0.06, 0.5);
  if (GetParam() == Integrator::implicit) shaken.plan.stages[0].dt = 5e-4;
  std::vector<std::uint64_t> hash;
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    KeepOne keeper(61);
    Driver whole(shaken.model, shaken.plan, methods());
    whole.set_keeper(keeper);
    ASSERT_EQ(whole.run().status, RunEnd::Status::done);
    ASSERT_EQ(keeper.kept.size(), 1U);
    hash.push_back(state_hash(whole.state()));
    Driver rest(shaken.model, shaken.plan, methods());
    rest.continue_from(keeper.kept[0]);
    ASSERT_EQ(rest.run().status, RunEnd::Status::done);
    EXPECT_EQ(state_hash(rest.state()), hash.back());
    EXPECT_GT(whole.state().ledger[Column::viscous_edges], 0.0);
  }
  EXPECT_EQ(hash[0], hash[1]);
}

/// Level ground bonded to a shaken block: the free field beside it stands on a rigid base.
TEST(FreeFieldRigidBase, ground_moves_as_the_layer_beside_it_through_reflections) {
  const Ground ground;
  for (const Sides sides : {Sides::ground, Sides::viscous}) {
    Shaken shaken(ground, true, sides);
    shaken.model.viscous_edges.erase(shaken.model.viscous_edges.begin());  // the compliant base
    const BlockId base = shaken.add("base", rectangle(-1.0, -1.0, ground.width + 1.0, 0.0));
    shaken.model.block_supports.push_back({base, MotionId{0}});
    JointLaw& law = shaken.model.joints[0];
    law.cohesion = 1e9;
    law.tensile_strength = 1e9;
    law.normal_stiffness = law.shear_stiffness = 1e11;  // 500 times the stiffness of a cover of ground
    for (const double x : {0.0, 4.0, 8.0}) shaken.monitor(x, ground.left);
    const double travel = ground.left / wave_speed(true);
    shaken.go(Integrator::implicit, 5.0 * travel + kPulse, 0.5, true);
    struct Reflections final : Sink {
      void history(const HistoryView& h) override {
        // Velocity of the free top: twice the upgoing wave, then its reflections at the base with alternating sign.
        double free = 0.0, sign = 2.0;
        for (int k = 0; k < 4; ++k, sign = -sign) free += sign * pulse_at(h.time - (2 * k + 1) * travel);
        for (std::size_t k = 0; k < 3; ++k)
          error = std::max(error, std::hypot(h.velocity[2 * k] - free, h.velocity[2 * k + 1]) / (2.0 * kSpeed));
      }
      double travel = 0.0, error = 0.0;
    } look;
    look.travel = travel;
    Driver run(shaken.model, shaken.plan, methods());
    run.add_sink(look);
    const RunEnd end = run.run();
    ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
    const Ledger& ledger = run.state().ledger;
    std::printf("rigid base, %s: largest difference %.5f, closure %.1e\n", name_of(sides), look.error,
                std::abs(ledger.closure()) / ledger.moved());
    if (sides == Sides::ground) {
      EXPECT_LT(look.error, 0.03);
      EXPECT_LT(std::abs(ledger.closure()), 1e-12 * ledger.moved());
    } else {
      EXPECT_GT(look.error, 0.2);
    }
  }
}

}  // namespace
}  // namespace scree::test::free_field_test
