// Joints between edges with different laws: the law with less friction applies, and a block that slides to other ground
// takes the law of that ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/schemes.h"

namespace scree::test::two_laws_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81, kDensity = 2600.0;

JointId law(Scene& scene, const char* name, double friction_deg) {
  JointLaw l;
  l.name = name;
  l.friction = friction_deg * kDegree;
  l.damping = 0.5;
  scene.model.joints.push_back(l);
  return JointId{static_cast<std::int32_t>(scene.model.joints.size()) - 1};
}

/// A flat block that slides on level ground; its ends lie over joints of the ground.
struct Slide {
  Scene scene{1e9, 0.2, kDensity, 45.0};
  BlockId slider;
  Slide(const Scheme& scheme, double speed, double time) {
    slider = scene.add("slider", rectangle(-1.2, 0, -0.2, 0.2));
    scene.model.initial_velocities.push_back({slider, {speed, 0.0}, 0.0});
    scene.stage(scheme.method, scheme.integrator, time, scheme.implicit() ? std::optional<double>(1e-3) : std::nullopt,
                0.5);
  }
};

class TwoLaws : public testing::TestWithParam<Scheme> {};

TEST_P(TwoLaws, block_slides_by_the_smaller_friction_whichever_side_has_it) {
  for (const bool on_the_ground : {true, false}) {
    Slide s(GetParam(), 0.5, 0.1);
    const JointId smooth = law(s.scene, "smooth", 10.0), rough = law(s.scene, "rough", 40.0);
    s.scene.add("ground", rectangle(-3, -1, 3, 0), true);
    s.scene.model.blocks[0].joint = on_the_ground ? rough : smooth;
    s.scene.model.blocks[1].joint = on_the_ground ? smooth : rough;
    Driver run(s.scene.model, s.scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const BodyTotals t = totals_of(run, s.slider);
    // Under its sudden weight the block bounces; the mean of the normal force is still the weight.
    EXPECT_NEAR((0.5 - t.momentum.x() / t.mass) / (kGravity * std::tan(10.0 * kDegree) * 0.1), 1.0, 0.05);
    for (const ContactMemory& m : run.state().contacts)
      if (m.status != ContactStatus::open) {
        EXPECT_EQ(m.joint, smooth.value);
      }
  }
}

/// From smooth ground to rougher ground, which is the next block or the next edge of the same block: once the whole
/// slider is there, the second law decelerates it.
TEST_P(TwoLaws, block_that_goes_to_other_ground_slides_by_the_law_there) {
  for (const bool one_block : {false, true}) {
    Slide s(GetParam(), 3.0, 0.7);
    const JointId smooth = law(s.scene, "smooth", 5.0), rough = law(s.scene, "rough", 20.0);
    if (one_block) {
      s.scene.add("ground", {{{-3, -1}, {4, -1}, {4, 0}, {0, 0}, {-3, 0}}, {}}, true);
      s.scene.model.blocks[1].joint = smooth;
      s.scene.model.blocks[1].edges = {{smooth, smooth, rough, smooth, smooth}};  // the third from (4, 0) to (0, 0)
    } else {
      s.scene.add("first", rectangle(-3, -1, 0, 0), true);
      s.scene.add("second", rectangle(0, -1, 4, 0), true);
      s.scene.model.blocks[1].joint = smooth;
      s.scene.model.blocks[2].joint = rough;
    }
    s.scene.plan.output.every = ticks(0.02);
    Driver run(s.scene.model, s.scene.plan, methods());
    double first_time = 0.0, first_speed = 0.0, last_time = 0.0, last_speed = 0.0;
    int closed = 0;
    Watch watch;
    watch.see = [&](const FrameView& view) {
      const BodyTotals t = totals_of(run, s.slider);
      if (t.centre.x() < 0.55) return;  // the end of the slider has not left the smooth ground
      last_time = view.time;
      last_speed = t.momentum.x() / t.mass;
      if (first_time == 0.0) {
        first_time = last_time;
        first_speed = last_speed;
      }
      for (const ContactMemory& m : view.state->contacts) {
        if (m.status == ContactStatus::open) continue;
        ++closed;
        EXPECT_EQ(m.joint, rough.value) << view.time;
      }
    };
    run.add_sink(watch);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    EXPECT_GT(closed, 4);
    ASSERT_GT(last_time - first_time, 0.1);
    const double slowed = (first_speed - last_speed) / (last_time - first_time);
    std::printf("%s%s: slowed by %.4f of %.4f m/s2\n", GetParam().name, one_block ? ", one block" : "", slowed,
                kGravity * std::tan(20.0 * kDegree));
    EXPECT_NEAR(slowed / (kGravity * std::tan(20.0 * kDegree)), 1.0, 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(schemes, TwoLaws, testing::ValuesIn(kAllSchemes),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace scree::test::two_laws_test
