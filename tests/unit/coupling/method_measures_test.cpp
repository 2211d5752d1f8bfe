// Measures that decide on a change of method, against the energies of the block.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/stages/method_rules.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::method_measures_test {
namespace {

using namespace coupling;

/// A stretched and bent bar: its strain has an affine part and a remainder.
struct Bent {
  Scene scene{1e8, 0.2, 2500.0};
  std::unique_ptr<ByHand> hand;
  Bent() {
    scene.model.gravity = {0.0, 0.0};
    scene.add("bar", rectangle(0, 0, 4, 0.5));
    Stage& stage = scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, 0.25);
    stage.change.used = true;
    stage.change.hold = 0;
    hand = std::make_unique<ByHand>(scene.model, stage);
    std::vector<double>& q = hand->state.q;
    for (std::size_t i = 0; i < q.size(); i += 2) {
      const double x = q[i] - 2.0, y = q[i + 1] - 0.25;
      q[i] += 1e-4 * x + 2e-4 * x * y;
      q[i + 1] -= 1e-4 * x * x;
    }
    hand->setup->pool(0).settle(0, q, hand->state.v);
  }
  [[nodiscard]] SwitchRules& rules() { return scene.plan.stages[0].change; }
  /// The change of the bar to the DDA with its measures; empty: no change.
  std::vector<MethodChange> look() {
    CentralDifference integrator(*hand->setup, {.max_displacement = 0.1}, 0.05);
    integrator.enter(hand->state);
    hand->state.rules = {};
    MethodRules rules(scene.plan.stages[0], hand->methods, *hand->setup, hand->state);
    return rules.evaluate(hand->state, integrator);
  }
};

TEST(MethodMeasures, inhomogeneity_is_the_root_of_the_share_of_the_elastic_energy_beside_the_affine_one) {
  Bent bent;
  const Body& b = bent.hand->setup->bodies()[0];
  const Release r = bent.hand->setup->pool_of(b).release(b.index, bent.hand->state.q, bent.hand->state.v);
  const double share = r.elastic_rest / bent.hand->totals(b).elastic;
  ASSERT_GT(share, 0.05);
  ASSERT_LT(share, 0.95);
  bent.rules().inhomogeneity = 1.01 * std::sqrt(share);
  const std::vector<MethodChange> found = bent.look();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].measures.inhomogeneity, std::sqrt(share), 1e-6);
  EXPECT_NEAR(found[0].measures.elastic, share, 1e-6);  // at rest: share of the elastic energy alone
  EXPECT_EQ(found[0].measures.kinetic, 0.0);
  bent.rules().inhomogeneity = 0.99 * std::sqrt(share);
  EXPECT_TRUE(bent.look().empty());
  bent.rules().inhomogeneity = 0.0;
  bent.rules().elastic = 0.99 * share;
  EXPECT_TRUE(bent.look().empty());
  bent.rules().elastic = 1.01 * share;
  EXPECT_EQ(bent.look().size(), 1U);
}

TEST(MethodMeasures, stress_of_the_affine_part_is_its_largest_principal_value) {
  Bent bent;
  std::vector<double>& q = bent.hand->state.q;
  bent.hand->move(0, {0.0, 0.0}, Mat2::Zero());  // straight again
  for (std::size_t i = 0; i < q.size(); i += 2) q[i] *= 1.0 - 3e-4;
  // Uniaxial strain in plane strain: -(lambda + 2 mu) 3e-4 along, -lambda 3e-4 across.
  const double stress = 3e-4 * bent.scene.model.elasticity_of(BlockId{0}).p_modulus();
  bent.rules().back.stress = 0.99 * stress;
  EXPECT_TRUE(bent.look().empty());
  bent.rules().back.stress = 1.01 * stress;
  const std::vector<MethodChange> found = bent.look();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].measures.stress / stress, 1.0, 1e-3);
}

}  // namespace
}  // namespace scree::test::method_measures_test
