// The estimated size of a mesh against the mesh that is made.
#include "coupling/stages/mesh_estimate.h"

#include <gtest/gtest.h>

#include "coupling/transfer/transfer.h"
#include "tests/support/schemes.h"

namespace scree::test::mesh_estimate_test {
namespace {

using namespace coupling;

double elements_of(const Scene& scene) {
  const coupling::Setup setup(scene.model, methods(),
                              initial_records(scene.model, body_requests(scene.model, scene.plan.stages[0])));
  double cells = 0.0;
  for (std::size_t p = 0; p < setup.pools(); ++p) {
    MeshPart part;
    setup.pool(p).topology(part);
    cells += static_cast<double>(part.body.size());
  }
  return cells;
}

Scene one_block(double width, double cover_size) {
  Scene scene;
  scene.add("block", rectangle(0.0, 0.0, width, 1.0));
  scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, cover_size);
  return scene;
}

TEST(MeshEstimate, counts_at_least_the_elements_and_at_most_a_third_more) {
  for (const auto& [width, h] :
       {std::pair(1.0, 0.1), std::pair(4.0, 0.1), std::pair(1.0, 0.03), std::pair(4.0, 0.03)}) {
    const Scene scene = one_block(width, h);
    const MeshEstimate estimate = mesh_estimate(scene.model, scene.plan.stages[0]);
    const double real = elements_of(scene);
    EXPECT_GE(estimate.elements, real) << width << " m, covers of " << h;
    EXPECT_LE(estimate.elements, 1.33 * real) << width << " m, covers of " << h;
    EXPECT_EQ(estimate.cover_size, h);
    EXPECT_GT(estimate.bytes, 500.0 * real);
    EXPECT_LT(estimate.bytes, 3000.0 * real);
  }
}

TEST(MeshEstimate, sums_blocks_and_names_the_one_that_takes_most) {
  Scene scene = one_block(1.0, 0.1);
  const Stage stage = scene.plan.stages[0];
  const MeshEstimate one = mesh_estimate(scene.model, stage);
  scene.add("large", rectangle(2.0, 0.0, 5.0, 3.0));
  scene.add("small", rectangle(6.0, 0.0, 6.5, 1.0));
  const MeshEstimate all = mesh_estimate(scene.model, stage);
  EXPECT_EQ(all.finest, BlockId{1});
  EXPECT_GT(all.elements, 8.0 * one.elements);
  EXPECT_GT(all.bytes, 8.0 * one.bytes);
  EXPECT_LT(all.elements, 11.0 * one.elements);
}

TEST(MeshEstimate, implicit_steps_factor_a_matrix) {
  Scene scene = one_block(1.0, 0.05);
  const MeshEstimate lumped = mesh_estimate(scene.model, scene.plan.stages[0]);
  scene.plan.stages[0].integrator = Integrator::implicit;
  const MeshEstimate consistent = mesh_estimate(scene.model, scene.plan.stages[0]);
  EXPECT_EQ(lumped.elements, consistent.elements);
  EXPECT_GT(consistent.bytes, 3.0 * lumped.bytes);
}

TEST(MeshEstimate, affine_blocks_have_no_mesh) {
  Scene scene;
  scene.add("block", rectangle(0.0, 0.0, 1.0, 1.0));
  const MeshEstimate none = mesh_estimate(scene.model, scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt));
  EXPECT_EQ(none.elements, 0.0);
  EXPECT_EQ(none.bytes, 0.0);
  EXPECT_FALSE(none.finest.valid());
}

}  // namespace
}  // namespace scree::test::mesh_estimate_test
