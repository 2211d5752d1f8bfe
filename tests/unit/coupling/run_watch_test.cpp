// Errors that a closed ledger does not reveal: each check with a planted fault and without it.
#include "coupling/stages/run_watch.h"

#include <gtest/gtest.h>

#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"
#include "tests/third_method/rigid_pool.h"

namespace scree::test::run_watch_test {
namespace {

using namespace coupling;

Ledger opened(double energy) {
  Ledger ledger;
  ledger.open(std::array{energy});
  return ledger;
}

TEST(LedgerScale, of_a_blow_up_is_what_was_given_and_not_what_moved) {
  // Above its bound the central difference conserves T + U + shadow to the last bit while T and U grow without limit.
  Ledger ledger = opened(5.0);
  for (const double grown : {1e3, 1e6, 1e11}) {
    ledger.set(Column::kinetic, grown);
    ledger.set(Column::elastic, grown + 5.0);
    ledger.set(Column::shadow, -2.0 * grown);
    ledger.pass();
  }
  EXPECT_EQ(ledger.closure(), 0.0);
  EXPECT_LT(ledger.relative_closure(), 1e-15);
  EXPECT_EQ(ledger.passed_given(), 5.0);
  EXPECT_NEAR(ledger.gain(), 0.1 * 2e11, 1e-3 * 2e11);
  EXPECT_TRUE(energy_from_nowhere(ledger, 1.0, 0.0, true));
  EXPECT_TRUE(energy_from_nowhere(ledger, 1.0, 0.0, false));
  EXPECT_FALSE(energy_from_nowhere(ledger, 0.0, 0.0, true));  // the check is off
}

TEST(LedgerScale, counts_every_source) {
  Ledger ledger = opened(2.0);
  ledger.set(Column::elastic, -3.0);  // released initial stress
  ledger.set(Column::kinetic, 5.0);
  EXPECT_EQ(ledger.passed_given(), 5.0);
  EXPECT_EQ(ledger.gain(), 0.0);
  for (const Column work : {Column::gravity, Column::loads, Column::water, Column::prescribed_motion}) {
    const double before = ledger.given();
    ledger.book(work, 7.0);
    ledger.set(Column::kinetic, ledger[Column::kinetic] + 7.0);
    EXPECT_EQ(ledger.given(), before + 7.0);
    EXPECT_EQ(ledger.gain(), 0.0);
  }
  // A block that returns to its method takes its energy out of the reservoir, plus or minus what its row books.
  ledger.set(Column::reservoir, 1.0);
  ledger.set(Column::kinetic, ledger[Column::kinetic] - 1.0);
  ledger.book(Column::transfer, 0.5);
  ledger.set(Column::elastic, ledger[Column::elastic] + 0.5);
  EXPECT_EQ(ledger.gain(), 0.0);
  EXPECT_EQ(ledger.closure(), 0.0);
  // Slip that dilates a joint lifts the bodies by work of friction: this reduces the energy given.
  ledger.book(Column::friction, 2.0);
  ledger.book(Column::dilation, -1.5);
  ledger.set(Column::kinetic, ledger[Column::kinetic] - 0.5);
  EXPECT_EQ(ledger.closure(), 0.0);
  EXPECT_EQ(ledger.gain(), -0.5);
}

TEST(LedgerScale, stays_with_the_run_through_what_comes_and_goes) {
  Ledger ledger = opened(0.0);
  ledger.book(Column::loads, 10.0);
  ledger.set(Column::elastic, 10.0);
  ledger.pass();
  ledger.book(Column::loads, -10.0);
  ledger.set(Column::elastic, 1e-14);
  ledger.pass();
  EXPECT_EQ(ledger.passed(), 10.0);
  EXPECT_LT(ledger.passed_closure(), 2e-15);
  const Ledger joined = Ledger::joined(ledger, opened(0.0), opened(0.0));
  EXPECT_EQ(joined.passed(), 10.0);
}

TEST(RunWatch, shadow_of_a_stable_step_is_no_gain) {
  // One spring at 0.95 of its bound, with elastic energy only: the energy given is U (1 - 0.9025).
  Ledger ledger = opened(1.0);
  const double elastic = 1.0 / (1.0 - 0.9025);
  ledger.set(Column::kinetic, 0.0);
  ledger.set(Column::elastic, elastic);
  ledger.set(Column::shadow, 1.0 - elastic);
  EXPECT_FALSE(energy_from_nowhere(ledger, 1.0, 0.0, true));
  EXPECT_FALSE(energy_from_nowhere(ledger, 1.0, 0.0, false));
}

TEST(RunWatch, numbers_that_are_not_finite_are_left_to_their_own_check) {
  Ledger ledger = opened(1.0);
  ledger.set(Column::elastic, std::numeric_limits<double>::quiet_NaN());
  EXPECT_FALSE(energy_from_nowhere(ledger, 1.0, 0.0, true));
  EXPECT_FALSE(energy_from_nowhere(ledger, 1.0, 0.0, false));
}

TEST(RunWatch, large_columns_of_the_scheme_are_told_once) {
  Ledger ledger = opened(100.0);
  ReportedWarnings reported;
  for (int c = 0; c < kColumns; ++c)
    if (info(static_cast<Column>(c)).side == Side::scheme) ledger.book(static_cast<Column>(c), 0.99);
  EXPECT_TRUE(large_scheme_columns(ledger, reported).empty());
  ledger.book(Column::contact_tributary, -2.0);
  ledger.book(Column::step_change, 50.0);  // the change of the shadow term: no error
  const std::vector<std::string> lines = large_scheme_columns(ledger, reported);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_NE(lines[0].find("'contact_tributary'"), std::string::npos) << lines[0];
  ledger.book(Column::deformation_damping, 2.0);  // damping that regularises sliding is one of these columns
  const std::vector<std::string> more = large_scheme_columns(ledger, reported);
  ASSERT_EQ(more.size(), 1U);
  EXPECT_NE(more[0].find("sliding_damping"), std::string::npos) << more[0];
  EXPECT_TRUE(large_scheme_columns(ledger, reported).empty());
}

// ---------------------------------------------------------------------------------------------------------------

struct Warnings final : Sink {
  std::vector<std::string> texts;
  void event(const Event& e) override {
    if (e.kind == EventKind::warning) texts.push_back(e.text);
  }
  [[nodiscard]] bool name(const std::string& what) const {
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& t) { return t.find(what) != std::string::npos; });
  }
};

/// A vibrating bar: no contact, no work, about 5 kJ of energy.
Scene ringing(const char* method) {
  Scene scene(1e8, 0.2, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  const BlockId id = scene.add("bar", rectangle(0, 0, 4, 1));
  PointSupport s;
  s.block = id;
  s.point = {0.0, 0.0};
  scene.model.point_supports.push_back(s);
  scene.model.initial_velocities.push_back({id, Vec2(0.05, 0.03), 0.1});
  scene.stage(method, Integrator::explicit_, 2.0, std::nullopt, 0.5);
  return scene;
}

/// The certified step of a scene's first stage.
double bound_of(const Scene& scene) {
  ByHand hand(scene.model, scene.plan.stages[0]);
  CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05);
  integrator.enter(hand.state);
  return integrator.stable_step(hand.state, nullptr);
}

TEST(RunWatch, step_above_the_bound_ends_the_run_before_numbers_do) {
  for (const char* method : {"nmm", "dda"}) {
    Scene scene = ringing(method);
    Driver sound(scene.model, scene.plan, methods());
    ASSERT_EQ(sound.run().status, RunEnd::Status::done);
    const double given = sound.state().ledger.given();
    EXPECT_LT(sound.state().ledger.held(), 1.5 * given) << method;

    scene.plan.stages[0].dt = 1.5 * bound_of(scene);
    scene.plan.stages[0].force_dt = true;
    Driver run(scene.model, scene.plan, methods());
    const RunEnd end = run.run();
    const Ledger& l = run.state().ledger;
    std::printf("%s: %ld steps, %.3g J of %.3g J, closes to %.1e of moved: %s\n", method,
                static_cast<long>(run.stats().steps), l.held(), l.given(), l.relative_closure(), end.reason.c_str());
    EXPECT_EQ(end.status, RunEnd::Status::not_converged);
    EXPECT_NE(end.reason.find("the rest has no source"), std::string::npos) << end.reason;
    EXPECT_NE(end.reason.find("force_dt"), std::string::npos) << end.reason;
    EXPECT_LT(l.held(), 1e4 * given);
    EXPECT_LT(l.relative_closure(), 1e-9);  // the closure alone shows no fault
  }
}

/// Rigid blocks on springs to their initial positions, with Percent % of the force that their energy implies.
template <int Percent>
class Sprung final : public RigidPool {
 public:
  double internal_force(std::span<const double> q, std::span<double> f) const override {
    constexpr double k = 1e6;
    double energy = 0.0;
    for (int b = 0; b < bodies(); ++b)
      for (std::size_t d = 0; d < 2; ++d) {
        const std::size_t i = 6 * static_cast<std::size_t>(b) + d;
        const double u = q[i] - 0.5;
        f[i] -= 0.01 * Percent * k * u;
        energy += 0.5 * k * u * u;
      }
    return energy;
  }
};

/// Oscillation of a block on such springs; `allowed` is Plan::max_gain.
template <int Percent>
RunEnd swing(double allowed, Warnings& warnings, double* held = nullptr) {
  Scene scene(1e9, 0.2, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  const BlockId id = scene.add("block", rectangle(0, 0, 1, 1));
  scene.model.initial_velocities.push_back({id, Vec2(1e-4, 5e-5), 0.0});
  scene.stage("sprung", Integrator::explicit_, 0.4, 1e-3);
  scene.plan.max_gain = allowed;
  Methods all = standard_methods();
  all["sprung"] = [] { return std::make_unique<Sprung<Percent>>(); };
  Driver run(scene.model, scene.plan, all);
  run.add_sink(warnings);
  RunEnd end = run.run();
  if (held != nullptr) *held = run.state().ledger.held() / run.state().ledger.given();
  return end;
}

TEST(RunWatch, wrong_sign_of_an_internal_force_ends_the_run) {
  Warnings warnings;
  double held = 0.0;
  EXPECT_EQ(swing<100>(1.0, warnings, &held).status, RunEnd::Status::done);
  EXPECT_LT(held, 1.001);
  EXPECT_TRUE(warnings.texts.empty());
  const RunEnd end = swing<-100>(1.0, warnings, &held);
  EXPECT_EQ(end.status, RunEnd::Status::not_converged);
  EXPECT_NE(end.reason.find("the rest has no source"), std::string::npos) << end.reason;
  EXPECT_NE(end.reason.find("'elastic_trapezoid'"), std::string::npos) << end.reason;
  EXPECT_LT(held, 1e3);
  EXPECT_EQ(swing<-100>(0.0, warnings, &held).status, RunEnd::Status::done);  // the check is off
  EXPECT_GT(held, 1e3);
}

TEST(RunWatch, internal_force_that_is_off_by_a_tenth_shows_in_a_column) {
  Warnings warnings;
  EXPECT_EQ(swing<110>(1.0, warnings).status, RunEnd::Status::done);
  EXPECT_TRUE(warnings.name("'elastic_trapezoid'"));
}

TEST(RunWatch, closure_of_what_passed_has_a_limit_of_its_own) {
  // A long oscillation: the energy moved is hundreds of times the energy passed. A force that no column books is small
  // against the energy moved.
  class Leaks final : public RigidPool {
   public:
    void mass_solve(std::span<const double> q, std::span<const double> f, std::span<double> a) const override {
      RigidPool::mass_solve(q, f, a);
      a[0] -= 1e-6;  // m/s2
    }
  };
  const auto end_of = [](double allowed) {
    Scene scene(1e9, 0.2, 2000.0);
    scene.model.gravity = {0.0, 0.0};
    const BlockId id = scene.add("block", rectangle(0, 0, 1, 1));
    scene.model.initial_velocities.push_back({id, Vec2(0.1, 0.05), 0.0});
    scene.stage("leaks", Integrator::explicit_, 2.0, 1e-3);
    scene.plan.max_passed_closure = allowed;
    Methods all = standard_methods();
    all["leaks"] = [] { return std::make_unique<Leaks>(); };
    Driver run(scene.model, scene.plan, all);
    return run.run();
  };
  EXPECT_EQ(end_of(0.0).status, RunEnd::Status::done);
  EXPECT_EQ(end_of(1e-3).status, RunEnd::Status::done);
  const RunEnd open = end_of(1e-6);
  EXPECT_EQ(open.status, RunEnd::Status::not_converged);
  EXPECT_NE(open.reason.find("run.max_passed_closure"), std::string::npos) << open.reason;
}

/// An undamped impact of two blocks, in steps that are long compared with the impact.
TEST(RunWatch, impact_in_long_steps_shows_in_a_column) {
  for (const double safety : {0.8, 0.1}) {
    Scene scene(1e9, 0.2, 2000.0);
    scene.model.gravity = {0.0, 0.0};
    scene.model.joints[0].damping = 0.0;
    scene.model.joints[0].friction = 0.0;
    scene.model.joints[0].penalty = 1e9;  // with less of the block's own: the whole of it is on the contact
    scene.add("wall", rectangle(-1, -1, 0, 2), true);
    const BlockId id = scene.add("block", rectangle(0.003, 0, 1.003, 1));
    scene.model.initial_velocities.push_back({id, Vec2(-1.0, 0.0), 0.0});
    scene.stage("dda", Integrator::explicit_, 0.1, std::nullopt).safety = safety;
    Warnings warnings;
    Driver run(scene.model, scene.plan, methods());
    run.add_sink(warnings);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const Ledger& l = run.state().ledger;
    std::printf("safety %g: transition %.4f of what passed\n", safety, l[Column::contact_transition] / l.passed());
    EXPECT_EQ(warnings.name("'contact_transition'"), std::abs(l[Column::contact_transition]) > 0.01 * l.passed());
  }
}

}  // namespace
}  // namespace scree::test::run_watch_test
