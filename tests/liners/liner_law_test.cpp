// The law of a single liner: forms and tangent against finite differences, rigid motions, balance of its forces.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "coupling/bolts/bolt_response.h"
#include "coupling/bolts/bolt_rows.h"
#include "model/random.h"
#include "tests/support/by_hand.h"
#include "tests/support/circle.h"
#include "tests/support/lined.h"

namespace scree::test::liner_law_test {
namespace {

using namespace coupling;

double draw(Random& random, double most) { return most * (2.0 * random.uniform() - 1.0); }

/// A ring of blocks round a hole, with a liner on its wall: closed, or open over most of it.
struct Wall {
  Scene scene;
  Stage stage;
  explicit Wall(bool closed) {
    constexpr int kBlocks = 6;
    const Ring in = circle(1.0, kBlocks, false), out = circle(2.0, kBlocks, false);
    for (std::size_t k = 0; k < kBlocks; ++k) {
      const std::size_t next = (k + 1) % kBlocks;
      scene.add("b" + std::to_string(k), {{in[k], out[k], out[next], in[next]}, {}});
    }
    std::vector<Vec2> along(in.begin(), in.end());
    along.push_back(in.front());
    if (!closed) along.resize(5);
    Bolt b = lining(along, 0.4);
    EXPECT_EQ(lay_out_liner(scene.model, {}, b), "");
    scene.model.bolts.push_back(b);
    stage = scene.stage("dda", Integrator::implicit, 1.0, 1e-3);
  }
};

/// Changes every unknown of the bodies at random, by at most `most`.
void shake(State& state, Random& random, double most) {
  for (double& x : state.q) x += draw(random, most);
}

TEST(LinerLaw, forms_of_lengths_and_turns_are_their_derivatives) {
  Random random(3);
  for (const bool closed : {true, false}) {
    const Wall wall(closed);
    ByHand hand(wall.scene.model, wall.stage);
    shake(hand.state, random, 0.02);
    const BoltRows rows = bolt_rows(*hand.setup, hand.state, 0);
    BoltShape shape, up, down;
    shape.measure(rows, hand.state.q);
    std::vector<double> direction(hand.state.q.size());
    for (double& x : direction) x = draw(random, 1.0);
    const double h = 1e-5;
    std::vector<double> q_up = hand.state.q, q_down = q_up;
    for (std::size_t i = 0; i < q_up.size(); ++i) {
      q_up[i] += h * direction[i];
      q_down[i] -= h * direction[i];
    }
    up.measure(rows, q_up);
    down.measure(rows, q_down);
    ASSERT_EQ(rows.crossings(), closed ? rows.segments : rows.segments - 1);
    for (std::size_t s = 0; s < rows.segments; ++s) {
      const double slope =
          shape.direction(s).dot(position(rows.row[s + 1], direction) - position(rows.row[s], direction));
      EXPECT_NEAR(slope, (up.lengths()[s] - down.lengths()[s]) / (2.0 * h), 1e-7) << s;
    }
    for (std::size_t c = 0; c < rows.crossings(); ++c) {
      double slope = 0.0;
      shape.shear_form(
          rows, c, [&](std::size_t row, const Vec2& form) { slope += form.dot(position(rows.row[row], direction)); });
      EXPECT_NEAR(slope, (up.shears()[c] - down.shears()[c]) / (2.0 * h), 1e-7 * std::max(1.0, std::abs(slope))) << c;
    }
  }
}

/// Elastic energy of the liner with the bodies at q, from the state `memory` of its installation.
double energy_at(const Model& model, const BoltRows& rows, const BoltMemory& memory, std::span<const double> q,
                 BoltMemory* out = nullptr) {
  BoltShape shape;
  shape.measure(rows, q);
  BoltResponse response(model.bolts[0]);
  BoltMemory after;
  EXPECT_TRUE(response.solve(memory, shape.lengths(), shape.shears(), after));
  if (out != nullptr) *out = after;
  return after.energy;
}

TEST(LinerLaw, forces_are_minus_the_derivative_of_the_energy_and_have_no_resultant_and_no_moment) {
  Random random(5);
  for (const bool closed : {true, false}) {
    const Wall wall(closed);
    ByHand hand(wall.scene.model, wall.stage);
    const Model& model = wall.scene.model;
    install_bolts(*hand.setup, hand.state);
    const BoltRows rows = bolt_rows(*hand.setup, hand.state, 0);
    const BoltMemory installed = hand.state.bolts[0];
    EXPECT_EQ(installed.energy, 0.0);
    shake(hand.state, random, 0.01);
    const double energy = energy_at(model, rows, installed, hand.state.q, &hand.state.bolts[0]);
    EXPECT_GT(energy, 1e3);
    std::vector<double> f(hand.state.q.size(), 0.0), direction(f.size());
    add_bolt_forces(*hand.setup, hand.state, f);
    for (double& x : direction) x = draw(random, 1.0);
    const double h = 1e-6;
    std::vector<double> up = hand.state.q, down = up;
    double power = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      up[i] += h * direction[i];
      down[i] -= h * direction[i];
      power += f[i] * direction[i];
      scale += std::abs(f[i] * direction[i]);
    }
    const double slope = (energy_at(model, rows, installed, up) - energy_at(model, rows, installed, down)) / (2.0 * h);
    EXPECT_NEAR(power, -slope, 1e-7 * scale);

    BoltShape shape;
    shape.measure(rows, hand.state.q);
    std::vector<Vec2> force(rows.row.size());
    shape.push(rows, hand.state.bolts[0], force);
    Vec2 sum(0.0, 0.0);
    double moment = 0.0, size = 0.0;
    for (std::size_t k = 0; k < force.size(); ++k) {
      sum += force[k];
      moment += cross(position(rows.row[k], hand.state.q), force[k]);
      size += force[k].norm();
    }
    EXPECT_LT(sum.norm(), 1e-14 * size);
    EXPECT_LT(std::abs(moment), 1e-14 * size);
  }
}

TEST(LinerLaw, turning_and_moving_everything_gives_no_force) {
  for (const bool closed : {true, false}) {
    const Wall wall(closed);
    ByHand hand(wall.scene.model, wall.stage);
    install_bolts(*hand.setup, hand.state);
    const BoltRows rows = bolt_rows(*hand.setup, hand.state, 0);
    const BoltMemory installed = hand.state.bolts[0];
    for (const double angle : {0.3, 1.9, 3.1, -2.5}) {
      std::vector<double> q = hand.state.q;
      for (const Body& b : hand.setup->bodies()) {
        AffineMotion m;
        m.F = rotation(angle);
        m.c = Vec2(3.0, -2.0) + m.F * b.centre;
        hand.setup->pool_of(b).place(b.index, m, q, hand.state.v);
      }
      BoltMemory after;
      (void)energy_at(wall.scene.model, rows, installed, q, &after);
      const double k = wall.scene.model.bolts[0].segment_stiffness(0), kb = wall.scene.model.bolts[0].turn_stiffness(0);
      for (const double N : after.force) EXPECT_LT(std::abs(N), 1e-14 * k);
      for (const double M : after.shear) EXPECT_LT(std::abs(M), 1e-14 * kb);
    }
  }
}

TEST(LinerLaw, tangent_is_the_derivative_of_thrusts_and_moments_below_and_beyond_the_strengths) {
  Random random(9);
  const Wall wall(true);
  Bolt liner = wall.scene.model.bolts[0];
  liner.yield = 0.02 * liner.stiffness;
  liner.crushing = 0.04 * liner.stiffness;
  BoltResponse response(liner);
  std::vector<double> lengths, shears(liner.turns());
  for (std::size_t s = 0; s + 1 < liner.nodes.size(); ++s) lengths.push_back(liner.nodes[s + 1].at - liner.nodes[s].at);
  BoltMemory before, up, down, at;
  response.install(lengths, shears, before);
  for (double& l : lengths) l += draw(random, 0.06 * 0.4);
  for (double& t : shears) t += draw(random, 0.1);
  ASSERT_TRUE(response.solve(before, lengths, shears, at));
  Eigen::MatrixXd tangent;
  response.tangent(at, tangent);
  std::vector<double> bend(shears.size());
  for (std::size_t c = 0; c < shears.size(); ++c) bend[c] = response.shear_tangent(c);
  int yields = 0, crushes = 0;
  for (std::size_t s = 0; s < lengths.size(); ++s) {
    yields += at.force[s] == liner.yield ? 1 : 0;
    crushes += at.force[s] == -liner.crushing ? 1 : 0;
    const double h = 1e-6, keep = lengths[s];
    lengths[s] = keep + h;
    ASSERT_TRUE(response.solve(before, lengths, shears, up));
    lengths[s] = keep - h;
    ASSERT_TRUE(response.solve(before, lengths, shears, down));
    lengths[s] = keep;
    for (std::size_t r = 0; r < lengths.size(); ++r)
      EXPECT_NEAR(tangent(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(s)),
                  (up.force[r] - down.force[r]) / (2.0 * h), 1e-7 * liner.segment_stiffness(s));
  }
  EXPECT_GT(yields, 0);
  EXPECT_GT(crushes, 0);
  for (std::size_t c = 0; c < shears.size(); ++c) {
    const double h = 1e-6, keep = shears[c];
    shears[c] = keep + h;
    ASSERT_TRUE(response.solve(before, lengths, shears, up));
    shears[c] = keep - h;
    ASSERT_TRUE(response.solve(before, lengths, shears, down));
    shears[c] = keep;
    EXPECT_NEAR(bend[c], (up.shear[c] - down.shear[c]) / (2.0 * h), 1e-7 * bend[c]);
  }
}

TEST(LinerLaw, a_broken_bar_bears_neither_thrust_nor_moment_and_its_plastic_work_is_dissipated) {
  const Wall wall(true);
  Bolt liner = wall.scene.model.bolts[0];
  liner.yield = 0.001 * liner.stiffness;
  liner.rupture_strain = 0.01;
  BoltResponse response(liner);
  std::vector<double> lengths, shears(liner.turns(), 0.0);
  for (std::size_t s = 0; s + 1 < liner.nodes.size(); ++s) lengths.push_back(liner.nodes[s + 1].at - liner.nodes[s].at);
  BoltMemory before, after, broken;
  response.install(lengths, shears, before);
  const double stretch = 0.012 * lengths[4];
  lengths[4] += stretch;
  for (double& t : shears) t = 0.01;
  ASSERT_TRUE(response.solve(before, lengths, shears, after));
  const double plastic = stretch - liner.yield / liner.segment_stiffness(4);
  EXPECT_NEAR(after.dissipated, liner.yield * plastic, 1e-12 * liner.yield);
  ASSERT_TRUE(response.rupture(after));
  ASSERT_TRUE(response.solve(after, lengths, shears, broken));
  for (std::size_t s = 0; s < lengths.size(); ++s) EXPECT_EQ(broken.broken[s], s == 4 ? 1 : 0);
  EXPECT_EQ(broken.force[4], 0.0);
  for (std::size_t c = 0; c < shears.size(); ++c)
    EXPECT_EQ(broken.shear[c] == 0.0, c == 3 || c == 4) << c;  // at both ends of the broken bar
}

}  // namespace
}  // namespace scree::test::liner_law_test
