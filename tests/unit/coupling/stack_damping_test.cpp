// Dashpots between blocks that slide on each other and lose friction: forces, momenta and energy, at any step.
#include "coupling/integrate/stack_damping.h"

#include <gtest/gtest.h>

#include "coupling/contact/table/contact_finder.h"
#include "coupling/transfer/transfer.h"
#include "tests/support/scene.h"

namespace scree::coupling::stack_damping_test {
namespace {

using test::rectangle;
using test::Scene;

/// Two stacked blocks of one method that approach each other, slide and turn.
struct Pair {
  Scene scene{1e9, 0.2, 2600.0, 30.0};
  State state;
  std::unique_ptr<Setup> setup;
  ContactList list;

  explicit Pair(const std::string& method) {
    scene.add("low", rectangle(0, 0, 4, 2));
    scene.add("high", rectangle(0.5, 2, 4.5, 4.5));
    Stage& stage = scene.stage(method, Integrator::implicit, 1.0, 1e-3, 0.8);
    state.bodies = initial_records(scene.model, body_requests(scene.model, stage));
    setup = std::make_unique<Setup>(scene.model, methods(), state.bodies);
    state.q.assign(2 * static_cast<std::size_t>(setup->nodes()), 0.0);
    state.v = state.q;
    place(0, Vec2(2.0, 1.0), Vec2(0.3, 0.05), 0.02);
    place(1, Vec2(2.5, 3.25 - 1e-5), Vec2(-0.4, -0.03), -0.01);
    ContactFinder finder(*setup, 0.05);
    ContactList none;
    finder.find(state.q, none, true, list);
    for (std::size_t k = 0; k < list.points.size(); ++k) {
      ContactMemory& m = list.memory[k];
      m.status = ContactStatus::slip;
      m.fn = 1e4 * (1.0 + static_cast<double>(k));
      m.ft = -std::tan(30.0 * test::kDegree) * m.fn;
      m.slide.last.slip = 1.0F;
      m.slide.lost = 1;
    }
  }
  /// The damping rates of the two sliding blocks.
  [[nodiscard]] SlidingDamping sliding() const {
    SlidingDamping out(*setup, 1.0);
    out.begin();
    out.count(setup->outlines(), list);
    EXPECT_TRUE(out.find());
    return out;
  }
  static const Methods& methods() {
    static const Methods kAll = standard_methods();
    return kAll;
  }
  void place(std::size_t body, const Vec2& c, const Vec2& velocity, double spin) {
    const Body& b = setup->bodies()[body];
    const auto p = static_cast<std::size_t>(b.pool);
    AffineMotion m;
    m.c = c;
    m.vc = velocity;
    m.Fdot = (Mat2() << 0.01, -spin, spin, -0.02).finished();  // with a strain rate
    setup->pool_of(b).place(b.index, m, setup->part(std::span<double>(state.q), p),
                            setup->part(std::span<double>(state.v), p));
  }
  /// M u of all bodies.
  [[nodiscard]] std::vector<double> momentum(const std::vector<double>& u) const {
    std::vector<double> out(u.size(), 0.0);
    for (const Body& b : setup->bodies()) {
      const auto p = static_cast<std::size_t>(b.pool);
      setup->pool_of(b).mass_apply(b.index, setup->part(std::span<const double>(state.q), p),
                                   setup->part(std::span<const double>(u), p), setup->part(std::span<double>(out), p));
    }
    return out;
  }
  [[nodiscard]] double energy(const std::vector<double>& v) const {
    const std::vector<double> P = momentum(v);
    double sum = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += 0.5 * P[i] * v[i];
    return sum;
  }
  /// Momentum, and angular momentum about the origin, of momenta given at nodes.
  [[nodiscard]] Eigen::Vector3d totals(const std::vector<double>& P) const {
    Eigen::Vector3d out = Eigen::Vector3d::Zero();
    for (const Body& b : setup->bodies()) {
      const std::span<const double> t = setup->pool_of(b).translation(b.index);
      for (std::size_t k = 0; k < t.size(); ++k) {
        const std::size_t i = 2 * (static_cast<std::size_t>(b.first_node) + k);
        out += Eigen::Vector3d(t[k] * P[i], t[k] * P[i + 1], state.q[i] * P[i + 1] - state.q[i + 1] * P[i]);
      }
    }
    return out;
  }
};

class StackDamping : public testing::TestWithParam<std::string> {};

TEST_P(StackDamping, keeps_momenta_and_takes_the_energy_that_it_says) {
  Pair pair(GetParam());
  ASSERT_GE(pair.list.points.size(), 2U);
  const SlidingDamping sliding = pair.sliding();
  coupling::StackDamping stacks(*pair.setup, sliding);
  ASSERT_TRUE(stacks.find(sliding, pair.setup->outlines(), pair.list));
  for (const double time : {1e-7, 1e-5, 1e-3, 1.0}) {
    stacks.act(pair.setup->outlines(), pair.list, pair.state.q, pair.state.v, time);
    std::vector<double> after = pair.state.v, force(after.size(), 0.0), change(after.size(), 0.0);
    stacks.add_acceleration(time, after);
    stacks.add_force(pair.state.q, force);
    stacks.add_acceleration(1.0, change);
    const std::vector<double> by_mass = pair.momentum(change);
    const Eigen::Vector3d left = pair.totals(force);
    double largest = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      largest = std::max(largest, std::abs(force[i]));
      EXPECT_NEAR(force[i], by_mass[i], 1e-9 * std::abs(by_mass[i]) + 1e-6) << i;
    }
    ASSERT_GT(largest, 1.0);
    EXPECT_LT(left.cwiseAbs().maxCoeff(), 1e-10 * largest) << time;
    const double work = pair.energy(after) - pair.energy(pair.state.v);
    EXPECT_NEAR(time * stacks.power(), work, 1e-11 * pair.energy(pair.state.v)) << time;
    EXPECT_LT(work, 0.0);
    EXPECT_LT(stacks.power() - stacks.friction(), 0.0) << time;  // dissipation of the dashpots beside that of friction
  }
}

TEST_P(StackDamping, brings_the_approach_of_two_blocks_to_rest_and_does_not_throw_them_back) {
  // In a short time the force is c times the normal velocity, c = 2 a m; in a long one the impulse is at most the one
  // that stops the approach. It is less by what one contact after the other leaves of the other's as rotation.
  Pair pair(GetParam());
  for (ContactMemory& m : pair.list.memory) {
    m.ft = 0.0;
    m.fn = 1e4;
  }
  for (const std::size_t b : {std::size_t{0}, std::size_t{1}})
    pair.place(b, b == 0 ? Vec2(2.0, 1.0) : Vec2(2.5, 3.25 - 1e-5), b == 0 ? Vec2(0.3, 0.0) : Vec2(0.0, -0.1), 0.0);
  const SlidingDamping sliding = pair.sliding();
  coupling::StackDamping stacks(*pair.setup, sliding);
  ASSERT_TRUE(stacks.find(sliding, pair.setup->outlines(), pair.list));
  const auto normal_force = [&](double time) {
    stacks.act(pair.setup->outlines(), pair.list, pair.state.q, pair.state.v, time);
    std::vector<double> force(pair.state.q.size(), 0.0);
    stacks.add_force(pair.state.q, force);
    const Body& low = pair.setup->bodies()[0];
    const std::span<const double> t = pair.setup->pool_of(low).translation(low.index);
    Vec2 sum(0.0, 0.0);
    for (std::size_t k = 0; k < t.size(); ++k) {
      const std::size_t i = 2 * (static_cast<std::size_t>(low.first_node) + k);
      sum += t[k] * Vec2(force[i], force[i + 1]);
    }
    return sum;
  };
  const double m1 = 2600.0 * 8.0, m2 = 2600.0 * 10.0, m = m1 * m2 / (m1 + m2);
  const double a = std::max(sliding.moderate_rate(0), sliding.moderate_rate(1));
  const Vec2 soon = normal_force(1e-9);
  EXPECT_NEAR(soon.x(), 0.0, 1e-9 * std::abs(soon.y()));
  EXPECT_NEAR(-soon.y(), 2.0 * a * m * 0.1, 1e-4 * 2.0 * a * m * 0.1);
  const double whole = -normal_force(1.0).y() * 1.0;  // impulse [N s]
  EXPECT_LT(whole, m * 0.1 * (1.0 + 1e-9));
  EXPECT_GT(whole, 0.5 * m * 0.1);
}

TEST_P(StackDamping, is_nothing_where_no_slide_has_lost_friction) {
  Pair pair(GetParam());
  for (ContactMemory& m : pair.list.memory) m.slide.lost = 0;
  const SlidingDamping sliding = pair.sliding();
  coupling::StackDamping stacks(*pair.setup, sliding);
  EXPECT_FALSE(stacks.find(sliding, pair.setup->outlines(), pair.list));
}

INSTANTIATE_TEST_SUITE_P(Methods, StackDamping, testing::Values("dda", "nmm"), [](const auto& of) { return of.param; });

}  // namespace
}  // namespace scree::coupling::stack_damping_test
