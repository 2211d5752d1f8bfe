// The audit of blocks that are asleep finds forces that do not balance.
#include "coupling/stages/sleep_audit.h"

#include <gtest/gtest.h>

#include "tests/support/by_hand.h"

namespace scree::test::sleep_audit_test {
namespace {

using namespace coupling;

std::unique_ptr<TimeIntegrator> make(const Setup& setup) {
  return std::make_unique<CentralDifference>(setup, StepControl{.max_displacement = 0.02}, 0.05);
}

/// A block on a held base at its balance, asleep; another that falls, awake.
struct Resting {
  explicit Resting(double load_later) : scene(5e9, 0.2, 2500.0, 31.0) {
    scene.add("block", rectangle(0.0, 0.0, 1.0, 0.5));
    scene.add("falls", rectangle(5.0, 3.0, 6.0, 3.5));
    scene.add("base", rectangle(-1.0, -1.0, 7.0, 0.0), true);
    TimeFunction f;
    f.name = "later";
    f.shape = TimeFunction::Shape::table;
    f.time = {1.0, 2.0};
    f.table = {0.0, 1.0};
    scene.model.functions.push_back(f);
    scene.model.point_loads.push_back({BlockId{0}, {0.5, 0.5}, {0.0, -load_later}, FunctionId{0}});
    scene.stage("dda", Integrator::explicit_, 1.0, 5e-5);
    hand = std::make_unique<ByHand>(scene.model, scene.plan.stages[0]);
    const std::unique_ptr<TimeIntegrator> steps = make(*hand->setup);
    steps->enter(hand->state);
    for (int i = 0; i < 4000; ++i) EXPECT_EQ(steps->step(hand->state, ticks(5e-5)).status, StepReport::Status::ok);
    hand->state.sleep.island = {0, -1, -1};
    audit = std::make_unique<SleepAudit>(*hand->setup, hand->methods, hand->state, make);
  }
  /// The largest ratio of a value to its limit at a time, at a tolerance.
  double worst(double time, double tolerance) {
    Audit found;
    audit->check(ticks(time), tolerance, found);
    EXPECT_EQ(found.checks(), 1);  // of the block that is asleep
    text = found.text();
    return found.worst();
  }
  Scene scene;
  std::unique_ptr<ByHand> hand;
  std::unique_ptr<SleepAudit> audit;
  std::string text;
};

TEST(SleepAudit, passes_a_block_in_balance) { EXPECT_LT(Resting(0.0).worst(0.2, 1e-8), 1.0); }

TEST(SleepAudit, finds_a_load_that_did_not_wake_its_block) {
  const double weight = 2500.0 * 0.5 * 9.81;
  Resting at(0.01 * weight);
  EXPECT_LT(at.worst(1.0, 1e-8), 1.0);
  // A hundredth of the weight against 4 times the tolerance.
  EXPECT_NEAR(at.worst(2.0, 1e-3), 0.01 / 4e-3, 0.03);
  EXPECT_EQ(at.text.substr(0, 32), "block 'block', which is asleep, ") << at.text;
}

TEST(SleepAudit, finds_a_block_whose_contacts_do_not_carry_it) {
  Resting at(0.0);
  // Lifted out of its contacts, it has its weight alone.
  at.hand->state.q[1] += 1e-3;
  at.audit = std::make_unique<SleepAudit>(*at.hand->setup, at.hand->methods, at.hand->state, make);
  EXPECT_NEAR(at.worst(0.2, 1e-3), 1.0 / 4e-3, 1e-3 / 4e-3);
}

}  // namespace
}  // namespace scree::test::sleep_audit_test
