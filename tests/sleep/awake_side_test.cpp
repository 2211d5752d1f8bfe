// The integrator of blocks that are awake: what it moves, what it leaves, and what it hands back to the state.
#include "coupling/integrate/awake_side.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "coupling/bolts/bolt_rows.h"
#include "tests/support/bolted.h"
#include "tests/support/by_hand.h"

namespace scree::test::awake_side_test {
namespace {

using namespace coupling;

constexpr double kDetection = 0.05;

std::unique_ptr<TimeIntegrator> explicit_steps(const Setup& setup) {
  return std::make_unique<CentralDifference>(setup, StepControl{.max_displacement = 0.02}, kDetection);
}

/// Two stacks on a held base, pressed together by their weight; the blocks of the first are awake.
struct Halves {
  Halves() : scene(5e9, 0.2, 2500.0, 31.0) {
    for (const double x : {0.0, 4.0})
      for (const double y : {0.0, 0.5})
        scene.add("b" + std::to_string(scene.model.blocks.size()), rectangle(x, y, x + 1.0, y + 0.5));
    scene.add("base", rectangle(-1.0, -1.0, 6.0, 0.0), true);
    // Blocks of two methods: the pools of the whole and of the awake side have different orders.
    scene.stage("dda", Integrator::explicit_, 1.0, 5e-5, 0.25).rules.push_back({{BlockId{1}, BlockId{3}}, "nmm"});
    hand = std::make_unique<ByHand>(scene.model, scene.plan.stages[0]);
    whole = explicit_steps(*hand->setup);
    whole->enter(hand->state);
    for (int i = 0; i < 4000; ++i) EXPECT_EQ(whole->step(hand->state, ticks(5e-5)).status, StepReport::Status::ok);
    whole->update_ledger(hand->state);
    hand->state.sleep.island = {-1, -1, 2, 2, -1};
    hand->state.contacts.forget_points();
  }
  std::unique_ptr<AwakeSide> side() {
    return std::make_unique<AwakeSide>(*hand->setup, hand->methods, hand->state, StrengthPlan{}, 1.0, explicit_steps);
  }
  Scene scene;
  std::unique_ptr<ByHand> hand;
  std::unique_ptr<TimeIntegrator> whole;
};

TEST(AwakeSide, moves_the_blocks_that_are_awake_as_the_whole_would_and_no_others) {
  Halves one, two;
  coupling::Setup again(one.scene.model, one.hand->methods, one.hand->state.bodies);
  const std::unique_ptr<TimeIntegrator> all = explicit_steps(again), awake = two.side();
  all->enter(one.hand->state);
  awake->enter(two.hand->state);
  const State before = two.hand->state;
  for (int i = 0; i < 200; ++i) {
    ASSERT_EQ(all->step(one.hand->state, ticks(5e-5)).status, StepReport::Status::ok);
    ASSERT_EQ(awake->step(two.hand->state, ticks(5e-5)).status, StepReport::Status::ok);
  }
  const State &a = one.hand->state, &b = two.hand->state;
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.time, b.time);
  for (const Body& body : again.bodies())
    for (std::size_t i = 2 * static_cast<std::size_t>(body.first_node);
         i < 2 * static_cast<std::size_t>(body.first_node + body.nodes); ++i) {
      const bool asleep = b.sleep.asleep(body.block.index());
      EXPECT_EQ(b.q[i], asleep ? before.q[i] : a.q[i]) << body.block.value;
      if (!asleep) {
        EXPECT_EQ(b.v[i], a.v[i]) << body.block.value;
      }
    }
}

TEST(AwakeSide, keeps_the_contacts_of_blocks_that_are_asleep_and_their_energies) {
  Halves at;
  State& state = at.hand->state;
  const ContactList before = state.contacts;
  const Ledger ledger = state.ledger;
  const std::unique_ptr<TimeIntegrator> awake = at.side();
  EXPECT_NEAR(awake->enter(state), ledger[Column::contact_springs], 1e-12 * ledger[Column::contact_springs]);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(awake->step(state, ticks(5e-5)).status, StepReport::Status::ok);
  awake->update_ledger(state);
  ASSERT_EQ(state.contacts.size(), before.size());
  int parked = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(state.contacts[i].key, before[i].key);
    if (!state.sleep.asleep(static_cast<std::size_t>(before[i].key.block_p)) &&
        !state.sleep.asleep(static_cast<std::size_t>(before[i].key.block_e)))
      continue;
    ++parked;
    EXPECT_EQ(state.contacts[i].fn, before[i].fn);
    EXPECT_EQ(state.contacts[i].stretch, before[i].stretch);
  }
  EXPECT_GT(parked, 4);
  // The columns are those of a run in which the others move too; by less than they still oscillate.
  Halves again;
  const std::unique_ptr<TimeIntegrator> all = explicit_steps(*again.hand->setup);
  all->enter(again.hand->state);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(all->step(again.hand->state, ticks(5e-5)).status, StepReport::Status::ok);
  for (const Column c : {Column::elastic, Column::contact_springs})
    EXPECT_NEAR(state.ledger[c] / again.hand->state.ledger[c], 1.0, 1e-5) << info(c).name;
  EXPECT_EQ(state.ledger[Column::prescribed_motion], 0.0);
}

TEST(AwakeSide, energies_of_supports_bolts_and_in_situ_stress_stay_in_the_ledger) {
  Bolted scene(30.0, 1e9);
  scene.model.materials[0].initial_stress = InitialStress{-1e5 * Mat2::Identity()};
  const BlockId held = scene.add("held", rectangle(0.0, 0.0, 1.0, 1.0)),
                hung = scene.add("hung", rectangle(3.0, 0.0, 4.0, 1.0)),
                tied = scene.add("tied", rectangle(4.2, 0.0, 5.2, 1.0));
  scene.add("free", rectangle(9.0, 0.0, 10.0, 1.0));
  scene.model.edge_supports.push_back({{held, {0, 0}}, Mat2::Identity(), {}});
  scene.model.point_supports.push_back({hung, {3.0, 1.0}, true, true, {}});
  scene.model.point_supports.push_back({tied, {5.0, 0.5}, true, true, {}});
  scene.bolt(bar({3.5, 0.5}, {4.7, 0.5}));
  scene.model.bolts[0].pretension = 1e5;
  scene.stage("dda", Integrator::explicit_, 1.0, 5e-5, 0.5).rules.push_back({{held}, "nmm"});
  ByHand hand(scene.model, scene.plan.stages[0]);
  State& state = hand.state;
  state.bolts.resize(1);
  install_bolts(*hand.setup, state);
  const std::unique_ptr<TimeIntegrator> whole = explicit_steps(*hand.setup);
  whole->enter(state);
  for (int i = 0; i < 50; ++i) ASSERT_EQ(whole->step(state, ticks(5e-5)).status, StepReport::Status::ok);
  state.sleep.island = {0, 1, 1, -1};
  for (const std::size_t b : {0U, 1U, 2U}) {
    const Body& body = hand.setup->bodies()[b];
    std::fill_n(state.v.begin() + 2 * body.first_node, 2 * body.nodes, 0.0);
  }
  whole->update_ledger(state);
  const auto others = [&](Column c) {  // of all but the block that is awake, which expands
    return state.ledger[c] - (c == Column::elastic ? hand.totals(hand.setup->bodies()[3]).elastic : 0.0);
  };
  const std::array columns{Column::elastic, Column::support_springs, Column::bolts};
  std::vector<double> before;
  before.reserve(columns.size());
  for (const Column c : columns) before.push_back(others(c));
  state.contacts.forget_points();
  AwakeSide awake(*hand.setup, hand.methods, state, StrengthPlan{}, 1.0, explicit_steps);
  awake.enter(state);
  for (int i = 0; i < 50; ++i) ASSERT_EQ(awake.step(state, ticks(5e-5)).status, StepReport::Status::ok);
  awake.update_ledger(state);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    EXPECT_GT(before[i], 0.1) << info(columns[i]).name;
    EXPECT_NEAR(others(columns[i]) / before[i], 1.0, 1e-12) << info(columns[i]).name;
  }
  EXPECT_GT(state.ledger[Column::kinetic], 1.0);  // of the block that falls
}

TEST(AwakeSide, contact_forces_are_those_of_the_blocks_that_are_awake) {
  Halves at;
  std::vector<double> all(at.hand->state.q.size(), 0.0), awake = all;
  const std::unique_ptr<TimeIntegrator> whole = explicit_steps(*at.hand->setup), side = at.side();
  whole->enter(at.hand->state);
  whole->contact_forces(at.hand->state, all);
  at.hand->state.contacts.forget_points();
  side->enter(at.hand->state);
  side->contact_forces(at.hand->state, awake);
  for (const Body& b : at.hand->setup->bodies())
    for (std::size_t i = 2 * static_cast<std::size_t>(b.first_node);
         i < 2 * static_cast<std::size_t>(b.first_node + b.nodes); ++i)
      if (!b.driven) {
        EXPECT_EQ(awake[i], at.hand->state.sleep.asleep(b.block.index()) ? 0.0 : all[i]);
      }
}

TEST(AwakeSide, contacts_that_begin_and_end_are_in_the_order_of_their_keys) {
  Scene scene(5e9, 0.2, 2500.0, 10.0);
  scene.add("left", rectangle(-3.0, -1.0, 0.0, 0.0), true);
  const BlockId slider = scene.add("slider", rectangle(-0.7, 0.0, -0.2, 0.5));
  scene.add("right", rectangle(0.0, -1.0, 9.0, 0.0), true);
  scene.add("low", rectangle(4.0, 0.0, 5.0, 0.5));
  scene.add("high", rectangle(4.0, 0.5, 5.0, 1.0));
  scene.model.initial_velocities.push_back({slider, {3.0, 0.0}, 0.0});
  scene.stage("dda", Integrator::explicit_, 1.0, 5e-5);
  ByHand one(scene.model, scene.plan.stages[0]), two(scene.model, scene.plan.stages[0]);
  const std::unique_ptr<TimeIntegrator> first = explicit_steps(*two.setup);
  first->enter(two.state);  // for the contacts of the stack
  two.state.contacts.forget_points();
  two.state.sleep.island = {-1, -1, -1, 3, 3};
  const std::unique_ptr<TimeIntegrator> all = explicit_steps(*one.setup);
  AwakeSide awake(*two.setup, two.methods, two.state, StrengthPlan{}, 1.0, explicit_steps);
  all->enter(one.state);
  awake.enter(two.state);
  const auto keys = [](const State& state, std::int32_t of) {
    std::vector<ContactKey> out;
    for (const ContactMemory& m : state.contacts)
      if (of < 0 || m.key.block_p == of || m.key.block_e == of) out.push_back(m.key);
    return out;
  };
  bool changed = false;
  for (int i = 0; i < 6000; ++i) {
    const std::vector<ContactKey> before = keys(two.state, -1);
    ASSERT_EQ(all->step(one.state, ticks(5e-5)).status, StepReport::Status::ok);
    ASSERT_EQ(awake.step(two.state, ticks(5e-5)).status, StepReport::Status::ok);
    const std::vector<ContactKey> after = keys(two.state, -1);
    ASSERT_TRUE(std::is_sorted(after.begin(), after.end())) << i;
    ASSERT_EQ(keys(two.state, slider.value), keys(one.state, slider.value)) << i;
    changed = changed || after != before;
  }
  EXPECT_TRUE(changed);
}

TEST(AwakeSide, a_step_that_fails_leaves_the_state) {
  Halves at;
  at.hand->place(0, {1e3, 0.0}, Mat2::Zero());
  const std::unique_ptr<TimeIntegrator> awake = at.side();
  awake->enter(at.hand->state);
  const std::uint64_t hash = state_hash(at.hand->state);
  EXPECT_EQ(awake->step(at.hand->state, ticks(5e-5)).status, StepReport::Status::too_far);
  EXPECT_EQ(state_hash(at.hand->state), hash);
}

}  // namespace
}  // namespace scree::test::awake_side_test
