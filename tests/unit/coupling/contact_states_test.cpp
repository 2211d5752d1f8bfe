// Contact states of a step against the limit by hand. Each point has its own unknowns: the changes of gap and stretch.
#include "coupling/integrate/contact_states.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/contact/table/contact_finder.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::coupling::contact_states_test {
namespace {

using test::rectangle;

constexpr double kFriction = 30.0;  // [degrees]

/// A block that rests on its base with two points, which touch without force.
struct Resting {
  test::Scene scene{1e9, 0.2, 2500.0, kFriction};
  std::unique_ptr<test::ByHand> hand;
  ContactList list;
  DofRows rows;
  std::unique_ptr<ContactStates> states;

  Resting() {
    scene.add("base", rectangle(-1, -1, 2, 0), true);
    scene.add("block", rectangle(0, 0, 1, 1));
    scene.stage("dda", Integrator::implicit, 1.0, 1e-3);
    hand = std::make_unique<test::ByHand>(scene.model, scene.plan.stages[0]);
    ContactFinder(*hand->setup, 0.05).find(hand->state.q, {}, true, list);
    for (std::size_t i = 0; i < list.points.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        rows.begin_row();
        rows.add(static_cast<std::int32_t>(2 * i + k), 1.0);
      }
  }
  /// Begins a step and evaluates the forces with the gap of all points changed by dg and the stretch by ds.
  void at(double dg, double ds, double dashpot = 0.0) {
    states = std::make_unique<ContactStates>(*hand->setup);
    states->begin(list, rows, 0, hand->state.q, dashpot);
    evaluate(dg, ds);
  }
  void evaluate(double dg, double ds) { states->evaluate(changes(dg, ds)); }
  [[nodiscard]] std::vector<double> changes(double dg, double ds) const {
    std::vector<double> d;
    for (std::size_t i = 0; i < list.points.size(); ++i) d.insert(d.end(), {dg, ds});
    return d;
  }
  /// The points that touch.
  [[nodiscard]] std::vector<std::size_t> touching() const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < list.points.size(); ++i)
      if (list.memory[i].status != ContactStatus::open) out.push_back(i);
    return out;
  }
};

TEST(ContactStates, pressed_points_stick_up_to_their_friction) {
  Resting r;
  const std::size_t i = r.touching().at(0);
  const ContactMemory& m = r.list.memory[i];
  const double most = std::tan(kFriction * test::kDegree) * m.kn / m.kt * 1e-5;  // stretch at the limit
  r.at(-1e-5, 0.99 * most);
  EXPECT_EQ(r.states->change(false), 0);
  EXPECT_DOUBLE_EQ((*r.states)[i].fn, m.kn * 1e-5);
  EXPECT_DOUBLE_EQ((*r.states)[i].ft, -m.kt * 0.99 * most);
  r.at(-1e-5, 1.01 * most);
  EXPECT_EQ(r.states->change(false), static_cast<int>(r.touching().size()));
  EXPECT_EQ((*r.states)[i].status, ContactStatus::slip);
  r.evaluate(-1e-5, 1.01 * most);
  EXPECT_NEAR((*r.states)[i].ft, -std::tan(kFriction * test::kDegree) * m.kn * 1e-5, 1e-9 * m.kn * 1e-5);
  EXPECT_EQ(r.states->change(false), 0);
  // Friction would drive the slip: the point sticks again.
  r.evaluate(-1e-5, -most);
  EXPECT_GT(r.states->change(false), 0);
  EXPECT_EQ((*r.states)[i].status, ContactStatus::stick);
}

TEST(ContactStates, points_open_and_close) {
  Resting r;
  const std::size_t i = r.touching().at(0);
  r.at(1e-5, 0.0);
  EXPECT_EQ(r.states->change(false), static_cast<int>(r.touching().size()));
  EXPECT_EQ((*r.states)[i].status, ContactStatus::open);
  r.evaluate(1e-5, 0.0);
  EXPECT_EQ((*r.states)[i].fn, 0.0);
  EXPECT_EQ(r.states->change(false), 0);
  EXPECT_EQ(r.states->closing(), nullptr);
  r.evaluate(-1e-5, 0.0);
  EXPECT_NE(r.states->closing(), nullptr);
  EXPECT_EQ(r.states->close(r.changes(1e-6, 0.0)), 0);
  EXPECT_EQ(r.states->close(r.changes(-2e-5, 0.0)), static_cast<int>(r.touching().size()));
  EXPECT_EQ((*r.states)[i].status, ContactStatus::stick);
  EXPECT_EQ(r.states->close(r.changes(-3e-5, 0.0)), 0);  // closed ones stay as they were evaluated
  EXPECT_NEAR((*r.states)[i].gap, -2e-5, 1e-12);
}

/// A normal force below the tolerance must not hide a tangential force above it: the dashpot of a point that hardly
/// opens pulls with a negligible force, but its friction is a thousand times larger.
TEST(ContactStates, friction_of_a_point_that_hardly_opens_is_within_its_limit) {
  Resting r;
  const std::vector<std::size_t> touching = r.touching();
  const ContactMemory& m = r.list.memory[touching.at(0)];
  const double little = 1e-10 * 2500.0 * 9.81;  // a tenth of the tolerance [N]
  ASSERT_GT(r.list.points[touching[0]].cn, 0.0);
  r.at(little / m.kn / 2.0, 1e3 * little / m.kt, 1.0);
  EXPECT_LT((*r.states)[touching[0]].fn, 0.0);
  EXPECT_EQ(r.states->change(false), static_cast<int>(touching.size()));
  EXPECT_EQ((*r.states)[touching[0]].status, ContactStatus::slip);
}

TEST(ContactStates, states_have_a_hash) {
  Resting r;
  const std::vector<std::size_t> touching = r.touching();
  r.at(-1e-5, 0.0);
  const std::size_t all = r.states->hash(), some = r.states->hash(touching);
  r.evaluate(1e-5, 0.0);
  EXPECT_EQ(r.states->hash(), all);  // of the states, not of the forces
  EXPECT_TRUE(r.states->change_among(touching, true));
  EXPECT_NE(r.states->hash(), all);
  EXPECT_NE(r.states->hash(touching), some);
}

}  // namespace
}  // namespace scree::coupling::contact_states_test
