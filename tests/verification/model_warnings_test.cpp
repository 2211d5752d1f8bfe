// Warnings about stiffnesses and sizes that differ by orders of magnitude, about units, and about joints without a law.
#include "coupling/stages/model_warnings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "coupling/stages/plan_warnings.h"
#include "tests/support/scene.h"

namespace scree::test::model_warnings_test {
namespace {

using namespace coupling;

TEST(ModelWarnings, stiffnesses_far_apart_are_told_with_their_names) {
  Scene scene(1e9);
  scene.add("block", rectangle(0, 0, 2, 2));
  scene.model.joints[0].normal_stiffness = 1e10;
  EXPECT_TRUE(stiffness_warnings(scene.model).empty());
  scene.model.joints[0].normal_stiffness = 1e16;
  const auto told = stiffness_warnings(scene.model);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("normal_stiffness of joint 'joint'"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("2e+07"), std::string::npos) << told[0];
}

TEST(ModelWarnings, sizes_far_apart_are_told_with_their_blocks) {
  Scene scene;
  scene.add("mountain", rectangle(0, 0, 2000, 2000), true);
  scene.add("boulder", rectangle(0, 2000, 3, 2003));
  EXPECT_TRUE(size_warnings(scene.model).empty());
  scene.add("pebble", rectangle(10, 2000, 11, 2001));
  const auto told = size_warnings(scene.model);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("'pebble' 1 m"), std::string::npos) << told[0];
}

TEST(ModelWarnings, numbers_in_another_unit_are_told) {
  Scene scene(25e9, 0.2, 2600.0);
  scene.add("block", rectangle(0, 0, 2, 2));
  EXPECT_TRUE(unit_warnings(scene.model).empty());
  for (const double rock : {500.0, 1000.0, 4500.0, 7850.0}) {  // pumice, water, ore, steel
    scene.model.materials[0].density = rock;
    EXPECT_TRUE(unit_warnings(scene.model).empty()) << rock;
  }
  for (const double wrong : {2.6, 26.0, 26000.0, 2.6e6}) {  // t/m3, kN/m3, N/m3, g/m3
    scene.model.materials[0].density = wrong;
    const auto told = unit_warnings(scene.model);
    ASSERT_EQ(told.size(), 1u) << wrong;
    EXPECT_NE(told[0].find("density of 'rock'"), std::string::npos) << told[0];
  }
  scene.model.materials[0].density = 2600.0;
  scene.model.materials[0].young = 25.0;  // GPa
  ASSERT_EQ(unit_warnings(scene.model).size(), 1u);
  EXPECT_NE(unit_warnings(scene.model)[0].find("25 Pa"), std::string::npos);
  // A material that no block uses gives no warning.
  scene.model.materials.push_back({"spare", 2.6, 25.0, 0.2});
  EXPECT_EQ(unit_warnings(scene.model).size(), 1u);
  scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  const auto all = plan_warnings(scene.model, scene.plan);
  EXPECT_EQ(std::count(all.begin(), all.end(), unit_warnings(scene.model)[0]), 1);
}

TEST(ModelWarnings, gravity_that_is_given_twice_is_told) {
  Scene scene;
  scene.add("block", rectangle(0, 0, 2, 2));
  scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  Model& model = scene.model;
  const auto told = [&] { return weight_warnings(model); };
  for (const Vec2& other : {Vec2(0.0, 9.81), Vec2(0.0, -4.9), Vec2(-9.81, 0.0)}) {
    model.body_accelerations = {{{}, other, {}}};
    EXPECT_TRUE(told().empty()) << other.transpose();
  }
  model.body_accelerations = {{{}, Vec2(0.0, -9.8), {}}};
  ASSERT_EQ(told().size(), 1u);
  EXPECT_NE(told()[0].find("(0, -9.8) m/s2 acts in addition to gravity"), std::string::npos) << told()[0];
  const auto all = plan_warnings(model, scene.plan);
  EXPECT_EQ(std::count(all.begin(), all.end(), told()[0]), 1);
  TimeFunction f;
  f.duration = 0.1;
  model.body_accelerations[0].function = FunctionId{static_cast<std::int32_t>(model.functions.size())};
  model.functions.push_back(f);
  for (const auto& [shape, doubles] :
       {std::pair(TimeFunction::Shape::ramp, true), std::pair(TimeFunction::Shape::sine, false)}) {
    model.functions.back().shape = shape;  // shaking by 1 g does not double the weight
    EXPECT_EQ(told().size(), doubles ? 1u : 0u);
  }
  model.functions.back().shape = TimeFunction::Shape::ramp;
  model.gravity.setZero();
  EXPECT_TRUE(told().empty());
}

TEST(ModelWarnings, faces_without_any_law_are_told) {
  Scene scene;
  scene.add("base", rectangle(0, 0, 4, 1), true);
  scene.add("slider", rectangle(1, 1, 2, 2));
  EXPECT_TRUE(lawless_warnings(scene.model, touching_blocks(scene.model)).empty());
  scene.model.joints[0].name = "smooth";
  scene.model.joints[0].friction = 0.0;
  const auto told = lawless_warnings(scene.model, touching_blocks(scene.model));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("1 m of faces"), std::string::npos) << told[0];
}

TEST(ModelWarnings, a_model_on_lines_is_held_along_what_they_fix) {
  Scene scene;
  const BlockId block = scene.add("block", rectangle(0, 0, 2, 2));
  scene.stage("dda", Integrator::implicit, 0.1, 1e-3);
  const auto told = [&] { return support_warnings(scene.model, touching_blocks(scene.model)); };
  EXPECT_FALSE(told().empty());
  Mat2 y = Mat2::Zero();
  y(1, 1) = 1.0;
  scene.model.edge_supports.push_back({{block, {0, 0}, 0.0, 1.0}, y, {}});
  EXPECT_TRUE(told().empty());
  scene.model.edge_supports[0].held = Mat2::Identity() - y;  // along x only
  EXPECT_FALSE(told().empty());
}

}  // namespace
}  // namespace scree::test::model_warnings_test
