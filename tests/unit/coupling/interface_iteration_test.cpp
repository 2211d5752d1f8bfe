#include "coupling/interface/interface_iteration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::coupling::interface_iteration_test {
namespace {

using test::rectangle;

constexpr double kStiffness = 5e7, kStep = 1e-3;  // [N/m], [s]
const StepControl kWide{.max_displacement = 0.1};

test::Scene hanging_block(const std::string& method) {
  test::Scene scene(2e9, 0.2, 2500.0);
  scene.add("block", rectangle(0.0, 0.0, 2.0, 1.0));
  scene.model.gravity = Vec2(0.0, -9.81);
  scene.stage(method, Integrator::implicit, 1.0, kStep, 0.5);
  return scene;
}

/// The outline node at the corner (2, 1).
OutlineNode corner(const test::ByHand& hand) {
  const Outlines& o = hand.setup->outlines();
  for (const OutlineNode k : o.nodes.indices())
    if ((position(o.nodes[k], hand.state.q) - Vec2(2.0, 1.0)).norm() < 1e-9) return k;
  throw std::logic_error("no node at the corner");
}

/// The other side: it holds the corner by a spring, for whose stiffness the iteration is given `told`.
class SpringElsewhere : public InterfaceForce {
 public:
  SpringElsewhere(const test::ByHand& hand, double told, bool foretold, double error = 2e3)
      : node_(corner(hand)),
        row_(hand.setup->outlines().nodes[node_]),
        anchor_(position(row_, hand.state.q)),
        told_(told),
        foretold_(foretold),
        error_(error),
        present_(hand.state.q.size(), 0.0) {
    for (const Vec2& axis : {Vec2(1.0, 0.0), Vec2(0.0, 1.0)}) {
      Spring s;
      s.count = 1;
      s.node[0] = node_;
      s.direction[0] = axis;
      s.k = told;
      springs_.push_back(s);
    }
  }
  [[nodiscard]] std::span<const Spring> springs() const override {
    return told_ > 0.0 ? std::span<const Spring>(springs_) : std::span<const Spring>{};
  }
  [[nodiscard]] double stiffness() const override { return 2.0 * kStiffness; }
  [[nodiscard]] double largest_stiffness() const override { return largest; }
  [[nodiscard]] std::span<const double> present() const override { return present_; }
  bool foresee(std::span<const double> end, std::span<double> force) override {
    ++predictions;
    if (foretold_) add(kStiffness, error_, end, force);  // a prediction need not be exact
    return foretold_;
  }
  StepReport mean(std::span<const double> end, std::span<const double>, std::span<double> force,
                  std::span<double>) override {
    ++evaluations;
    StepReport report;
    if (evaluations > most) report.status = StepReport::Status::given_up;
    add(kStiffness, 0.0, end, force);
    return report;
  }
  /// Sets the force at the start of the next step.
  void arrive(std::span<const double> q) {
    std::fill(present_.begin(), present_.end(), 0.0);
    add(kStiffness, 0.0, q, present_);
  }
  int predictions = 0, evaluations = 0, most = 1000;
  double largest = kStiffness;

 private:
  void add(double stiffness, double more, std::span<const double> at, std::span<double> force) const {
    const Vec2 f = -stiffness * (position(row_, at) - anchor_) + Vec2(more, -more);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = 2 * static_cast<std::size_t>(row_.node[k]);
      force[i] += row_.w[k] * f.x();
      force[i + 1] += row_.w[k] * f.y();
    }
  }
  OutlineNode node_;
  Row row_;
  Vec2 anchor_;
  double told_;
  bool foretold_;
  double error_;  // of the prediction [N]
  std::vector<Spring> springs_;
  std::vector<double> present_;
};

/// 20 steps of a block on the spring.   @return contact points at the end
std::size_t swing(test::ByHand& hand, SpringElsewhere& spring) {
  Newmark integrator(*hand.setup, kWide, 0.05);
  integrator.set_interface(&spring);
  hand.state.ledger.open(std::array{integrator.enter(hand.state)});
  for (int i = 0; i < 20; ++i) {
    const StepReport report = integrator.step(hand.state, ticks(kStep));
    EXPECT_EQ(report.status, StepReport::Status::ok) << report.cause;
    spring.arrive(hand.state.q);
  }
  return integrator.list().points.size();
}

class InterfaceSpring : public testing::TestWithParam<std::string> {};

TEST_P(InterfaceSpring, a_spring_elsewhere_acts_as_a_support_does) {
  test::Scene held = hanging_block(GetParam());
  held.model.point_supports.push_back({BlockId{0}, {2.0, 1.0}, true, true, kStiffness});
  test::ByHand reference(held.model, held.plan.stages[0]);
  Newmark supported(*reference.setup, kWide, 0.05);
  reference.state.ledger.open(std::array{supported.enter(reference.state)});
  for (int i = 0; i < 20; ++i) ASSERT_EQ(supported.step(reference.state, ticks(kStep)).status, StepReport::Status::ok);

  const test::Scene scene = hanging_block(GetParam());
  for (const double told : {0.0, 0.6 * kStiffness, kStiffness})
    for (const bool foretold : {false, true}) {
      test::ByHand hand(scene.model, scene.plan.stages[0]);
      SpringElsewhere spring(hand, told, foretold);
      EXPECT_EQ(swing(hand, spring), 0U);
      double way = 0.0, apart = 0.0;
      for (std::size_t i = 0; i < hand.state.q.size(); ++i) {
        way = std::max(way, std::abs(reference.state.v[i] * 20.0 * kStep));
        apart = std::max(apart, std::abs(hand.state.q[i] - reference.state.q[i]));
      }
      EXPECT_LT(apart, 1e-5 * way) << told << ' ' << foretold;  // a support's row is linear in the step's rotation
    }
}

/// Where the stiffest spring of the interface hardly changes, the first iterate of a step is evaluated without a second
/// prediction. Where that is no balance after all, and where predictions are wrong, the result is the same.
TEST_P(InterfaceSpring, a_first_iterate_that_hardly_moves_is_evaluated_at_once) {
  const test::Scene scene = hanging_block(GetParam());
  for (const double error : {0.0, 2e3})
    for (const double told : {0.6 * kStiffness, kStiffness}) {
      std::array<std::vector<double>, 2> end;
      std::array<int, 2> predictions{}, evaluations{};
      for (const std::size_t at_once : {0U, 1U}) {
        test::ByHand hand(scene.model, scene.plan.stages[0]);
        SpringElsewhere spring(hand, told, true, error);
        if (at_once != 0) spring.largest = 0.0;
        EXPECT_EQ(swing(hand, spring), 0U);
        end[at_once] = hand.state.q;
        predictions[at_once] = spring.predictions;
        evaluations[at_once] = spring.evaluations;
      }
      if (error == 0.0 && told == kStiffness && GetParam() == "dda") {  // linear: one iterate a step
        EXPECT_EQ(predictions[0], 40);
        EXPECT_EQ(predictions[1], 20);
        EXPECT_EQ(evaluations[1], evaluations[0]);
      }
      EXPECT_LE(evaluations[1], evaluations[0] + 20);  // at most one more a step
      double apart = 0.0, way = 0.0;
      for (std::size_t i = 0; i < end[0].size(); ++i) {
        apart = std::max(apart, std::abs(end[0][i] - end[1][i]));
        way = std::max(way, std::abs(end[0][i]));
      }
      EXPECT_LT(apart, 1e-9 * way) << error << ' ' << told;
    }
}

TEST_P(InterfaceSpring, a_step_that_the_other_side_gives_up_changes_nothing) {
  const test::Scene scene = hanging_block(GetParam());
  test::ByHand hand(scene.model, scene.plan.stages[0]);
  SpringElsewhere spring(hand, 0.0, false);
  Newmark integrator(*hand.setup, kWide, 0.05);
  integrator.set_interface(&spring);
  hand.state.ledger.open(std::array{integrator.enter(hand.state)});
  const State before = hand.state;
  spring.most = 1;
  EXPECT_EQ(integrator.step(hand.state, ticks(kStep)).status, StepReport::Status::given_up);
  EXPECT_EQ(hand.state.q, before.q);
  EXPECT_EQ(hand.state.v, before.v);
}

/// The other side: immovable rock to which the corner is tied.
class Rock : public InterfaceForce {
 public:
  explicit Rock(const test::ByHand& hand) : present_(hand.state.q.size(), 0.0) {
    const OutlineNode k = corner(hand);
    constraint_ = {hand.setup->outlines().node_body[k], hand.setup->outlines().nodes[k]};
    anchor_ = position(constraint_.row, hand.state.q);
  }
  [[nodiscard]] std::span<const Spring> springs() const override { return {}; }
  [[nodiscard]] double stiffness() const override { return 0.0; }
  [[nodiscard]] double largest_stiffness() const override { return 0.0; }
  [[nodiscard]] std::span<const double> present() const override { return present_; }
  bool foresee(std::span<const double>, std::span<double>) override { return false; }
  [[nodiscard]] std::span<const InterfaceConstraint> interface_constraints() const override {
    return std::span(&constraint_, 1);
  }
  [[nodiscard]] std::span<const double> constraint_factor() const override { return std::span(&factor_, 1); }
  [[nodiscard]] std::span<const double> held() const override { return force; }
  StepReport mean(std::span<const double> end, std::span<const double> held, std::span<double>,
                  std::span<double> apart) override {
    force.assign(held.begin(), held.end());
    const Vec2 gap = position(constraint_.row, end) - anchor_;
    apart[0] = gap.x();
    apart[1] = gap.y();
    return {};
  }
  std::vector<double> force = {0.0, 0.0};

 private:
  InterfaceConstraint constraint_;
  Vec2 anchor_;
  double factor_ = 1e5;  // C C^T = 1e10 N/m, of the order of 2 M/h^2
  std::vector<double> present_;
};

TEST_P(InterfaceSpring, a_tied_corner_stays_and_its_force_balances_the_block) {
  const test::Scene scene = hanging_block(GetParam());
  test::ByHand hand(scene.model, scene.plan.stages[0]);
  const Body& block = hand.setup->bodies()[0];
  Rock rock(hand);
  const OutlineNode k = corner(hand);
  const Vec2 anchor(2.0, 1.0);
  Newmark integrator(*hand.setup, kWide, 0.05);
  integrator.set_interface(&rock);
  hand.state.ledger.open(std::array{integrator.enter(hand.state)});
  for (int i = 0; i < 20; ++i) {
    const Vec2 before = hand.totals(block).momentum;
    const StepReport report = integrator.step(hand.state, ticks(kStep));
    ASSERT_EQ(report.status, StepReport::Status::ok) << report.cause;
    EXPECT_LT((position(hand.setup->outlines().nodes[k], hand.state.q) - anchor).norm(), 1e-9) << i;
    // M (2 d/h - v - v)/h = f at the end of the step.
    const BodyTotals now = hand.totals(block);
    const Vec2 weight = now.mass * scene.model.gravity, given = (now.momentum - before) / kStep;
    EXPECT_LT((given - weight - Vec2(rock.force[0], rock.force[1])).norm(), 1e-6 * weight.norm()) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, InterfaceSpring, testing::Values("dda", "nmm"),
                         [](const auto& p) { return p.param; });

}  // namespace
}  // namespace scree::coupling::interface_iteration_test
