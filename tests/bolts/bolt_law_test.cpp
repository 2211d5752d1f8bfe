// The law of a single bolt: balance of the bar, dissipation; tangent and shape against finite differences.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "coupling/bolts/bolt_response.h"
#include "coupling/bolts/bolt_rows.h"
#include "model/dense_algebra.h"
#include "model/random.h"
#include "tests/support/bolted.h"

namespace scree::test::bolt_law_test {
namespace {

using namespace coupling;

/// Two blocks, a bolt bonded in both.
struct Law {
  Model model;
  Bolt bolt;
  explicit Law(bool plate) {
    Scene scene;
    scene.add("a", rectangle(0, 0, 1, 1));
    scene.add("b", rectangle(1, 0, 3, 1));
    model = scene.model;
    bolt = bar({0.0, 0.5}, {2.5, 0.5});
    bolt.plate = plate;
    bolt.bond_length = plate ? 1.8 : 2.5;
    bolt.bond_stiffness = 300e6;
    bolt.bond_strength = 60e3;
    bolt.yield = 25e3;
    bolt.shear_stiffness = 40e6;
    bolt.shear_strength = 30e3;
    EXPECT_EQ(lay_out(model, bolt), "");
  }
  [[nodiscard]] std::vector<double> lengths() const {
    std::vector<double> out;
    for (std::size_t s = 0; s + 1 < bolt.nodes.size(); ++s) out.push_back(bolt.nodes[s + 1].at - bolt.nodes[s].at);
    return out;
  }
};

double draw(Random& random, double most) { return most * (2.0 * random.uniform() - 1.0); }

TEST(BoltLaw, layout_puts_nodes_into_their_blocks_and_crossings_on_joints) {
  const Law law(true);
  ASSERT_EQ(law.bolt.crossings.size(), 1U);
  EXPECT_NEAR(law.bolt.crossings[0].leaves, 1.0, 1e-12);
  EXPECT_NEAR(law.bolt.crossings[0].enters, 1.0, 1e-12);
  double bonded = 0.0;
  for (const Bolt::Node& n : law.bolt.nodes) {
    EXPECT_EQ(n.block.value, n.at < 1.0 ? 0 : 1) << n.at;
    bonded += n.length;
  }
  EXPECT_NEAR(bonded, 1.8, 1e-12);
  EXPECT_TRUE(law.bolt.slack(0));
  EXPECT_FALSE(Law(false).bolt.slack(0));
}

TEST(BoltLaw, bar_balances_at_every_node_whatever_yields) {
  Random random(7);
  for (const bool plate : {true, false}) {
    const Law law(plate);
    BoltResponse response(law.bolt);
    std::vector<double> lengths = law.lengths(), shears{0.0};
    BoltMemory before, after;
    response.install(lengths, shears, before);
    double dissipated = 0.0;
    int yielded = 0, slipped = 0;
    for (int step = 0; step < 200; ++step) {
      double work = 0.0;
      const std::vector<double> old = lengths;
      for (double& l : lengths) l += draw(random, 4e-4);
      shears[0] += draw(random, 5e-4);
      ASSERT_TRUE(response.solve(before, lengths, shears, after));
      for (std::size_t s = 0; s < lengths.size(); ++s) {
        EXPECT_LE(std::abs(after.force[s]), law.bolt.yield * (1.0 + 1e-12));
        EXPECT_GE(after.force[s], law.bolt.slack(s) ? 0.0 : -law.bolt.yield * (1.0 + 1e-12));
        work += after.force[s] * (lengths[s] - old[s]);
        if (after.plastic[s] != before.plastic[s]) ++yielded;
      }
      for (std::size_t i = 0; i < law.bolt.nodes.size(); ++i) {
        const double length = law.bolt.nodes[i].length;
        if (length == 0.0) continue;
        EXPECT_LE(std::abs(after.bond[i]), law.bolt.bond_strength * length * (1.0 + 1e-12));
        const double left =
            after.bond[i] + (i > 0 ? after.force[i - 1] : 0.0) - (i + 1 < law.bolt.nodes.size() ? after.force[i] : 0.0);
        EXPECT_LT(std::abs(left), 1e-7) << i;  // [N]
        if (after.slipped[i] != before.slipped[i]) ++slipped;
      }
      EXPECT_GE(after.dissipated, before.dissipated);
      // Work of the rock = elastic change + dissipation + damping of implicit Euler; shear separately.
      const double shear_work = after.shear[0] * (after.shear[0] - before.shear[0]) / law.bolt.shear_stiffness +
                                after.shear[0] * (after.sheared[0] - before.sheared[0]);
      EXPECT_NEAR(
          work + shear_work,
          after.energy - before.energy + after.dissipated - before.dissipated + response.elastic_change(before, after),
          1e-9);
      dissipated = after.dissipated;
      before = after;
    }
    EXPECT_GT(dissipated, 0.0);
    EXPECT_GT(yielded, 10);
    EXPECT_GT(slipped, 100);
  }
}

TEST(BoltLaw, tangent_is_the_derivative_of_the_forces) {
  Random random(11);
  for (const bool plate : {true, false}) {
    const Law law(plate);
    BoltResponse response(law.bolt);
    std::vector<double> lengths = law.lengths(), shears{0.0};
    BoltMemory before, after, moved;
    response.install(lengths, shears, before);
    int checked = 0;
    for (int trial = 0; trial < 30; ++trial) {
      std::vector<double> at = lengths;
      for (double& l : at) l += draw(random, 3e-4);
      ASSERT_TRUE(response.solve(before, at, shears, after));
      Eigen::MatrixXd tangent;
      response.tangent(after, tangent);
      const double largest = tangent.cwiseAbs().maxCoeff();
      EXPECT_LT((tangent - tangent.transpose()).cwiseAbs().maxCoeff(), 1e-9 * largest);
      EXPECT_GT(symmetric_eigenvalues(tangent)(0), -1e-7 * largest);
      constexpr double kStep = 1e-9;
      for (std::size_t m = 0; m < at.size(); ++m) {
        std::vector<double> plus = at, minus = at;
        plus[m] += kStep;
        minus[m] -= kStep;
        BoltMemory up, down;
        ASSERT_TRUE(response.solve(before, plus, shears, up));
        ASSERT_TRUE(response.solve(before, minus, shears, down));
        for (std::size_t j = 0; j < at.size(); ++j) {
          // With a kink of the law between the two states, neither slope is the derivative.
          const double right = (up.force[j] - after.force[j]) / kStep, left = (after.force[j] - down.force[j]) / kStep;
          if (std::abs(right - left) > 1e-4 * largest) continue;
          EXPECT_NEAR(0.5 * (right + left), tangent(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(m)),
                      2e-5 * largest);
          ++checked;
        }
      }
      if (trial % 10 == 9) before = after, lengths = at;
    }
    EXPECT_GT(checked, 1000);
  }
}

/// Three blocks; the free length passes two joints, so that two crossings share a segment.
struct Crossed : Bolted {
  Crossed() {
    model.gravity = {0.0, 0.0};
    add("a", rectangle(0, 0, 1, 1));
    add("b", rectangle(1, 0, 2, 1));
    add("c", rectangle(2, 0, 4, 1));
    Bolt b = bar({0.2, 0.3}, {3.5, 0.8});
    b.bond_length = 1.2;
    b.bond_stiffness = 1e8;
    b.shear_stiffness = 5e6;
    bolt(b);
    stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  }
};

TEST(BoltShape, lengths_and_shears_change_by_their_forms) {
  Crossed scene;
  scene.plan.stages[0].duration = ticks(1e-6);
  scene.run();
  const BoltRows rows = bolt_rows(scene.driver->setup(), scene.driver->state(), 0);
  ASSERT_EQ(rows.crossings(), 2U);
  ASSERT_EQ(rows.segment[0], rows.segment[1]);
  Random random(5);
  std::vector<double> q = scene.driver->state().q;
  for (double& x : q) x += draw(random, 0.05);
  BoltShape shape, up, down;
  shape.measure(rows, q);
  std::vector<double> dq(q.size());
  for (double& x : dq) x = draw(random, 1.0);
  constexpr double kStep = 1e-6;
  std::vector<double> plus = q, minus = q;
  for (std::size_t i = 0; i < q.size(); ++i) {
    plus[i] += kStep * dq[i];
    minus[i] -= kStep * dq[i];
  }
  up.measure(rows, plus);
  down.measure(rows, minus);
  for (std::size_t s = 0; s < rows.segments; ++s)
    EXPECT_NEAR((up.lengths()[s] - down.lengths()[s]) / (2.0 * kStep),
                shape.direction(s).dot(position(rows.row[s + 1], dq) - position(rows.row[s], dq)), 1e-7);
  for (std::size_t c = 0; c < rows.crossings(); ++c) {
    double sum = 0.0;
    shape.shear_form(rows, c, [&](std::size_t row, const Vec2& form) { sum += form.dot(position(rows.row[row], dq)); });
    EXPECT_NEAR((up.shears()[c] - down.shears()[c]) / (2.0 * kStep), sum, 1e-7) << c;
  }
}

TEST(BoltShape, forces_have_no_resultant_and_no_moment) {
  Crossed scene;
  scene.plan.stages[0].duration = ticks(1e-6);
  scene.run();
  const BoltRows rows = bolt_rows(scene.driver->setup(), scene.driver->state(), 0);
  Random random(9);
  std::vector<double> q = scene.driver->state().q;
  for (double& x : q) x += draw(random, 0.05);
  BoltShape shape;
  shape.measure(rows, q);
  BoltMemory memory = scene.memory();
  for (double& f : memory.force) f = draw(random, 1e5);
  for (double& f : memory.shear) f = draw(random, 1e5);
  std::vector<Vec2> force(rows.row.size());
  shape.push(rows, memory, force);
  Vec2 sum(0.0, 0.0);
  double moment = 0.0;
  for (std::size_t k = 0; k < force.size(); ++k) {
    sum += force[k];
    moment += cross(position(rows.row[k], q), force[k]);
  }
  EXPECT_LT(sum.norm(), 1e-9);
  EXPECT_LT(std::abs(moment), 1e-9);
}

}  // namespace
}  // namespace scree::test::bolt_law_test
