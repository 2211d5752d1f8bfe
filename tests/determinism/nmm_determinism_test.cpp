// The NMM with all features: bitwise equal states for any number of threads, and from a copy of the state.
#include <gtest/gtest.h>
#include <omp.h>

#include "coupling/integrate/central_difference.h"
#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::nmm_determinism_test {
namespace {

using namespace coupling;

/// A cracked block on a base with a small one on top, with every kind of load; more than 4096 covers at cover size 1.
Scene loaded(bool cracks, bool stressed) {
  Scene scene(1e8, 0.25, 2200.0, 25.0);
  scene.add("base", rectangle(-20, -5, 100, 0), true);
  const BlockId block = scene.add("block", rectangle(0, 0, 80, 60));
  scene.add("top", rectangle(20, 60, 32, 66));
  Model& m = scene.model;
  m.functions.push_back({"pulse", TimeFunction::Shape::sine_squared, 1.0, 0.0, 0.02, 0.0, {}, {}, {}});
  m.tractions.push_back({{block, {0, 3}, 0.0, 1.0}, {2e4, -1e3}, FunctionId{0}});
  m.point_loads.push_back({block, {60.0, 60.0}, {-1e4, -5e4}, FunctionId{0}});
  m.body_accelerations.push_back({{}, {0.5, 0.0}, FunctionId{0}});
  m.viscous_edges.push_back({{block, {0, 1}, 0.0, 1.0}});
  if (stressed)
    m.materials[0].initial_stress = InitialStress{(Mat2() << -1e4, 2e3, 2e3, -3e4).finished(), Mat2::Zero(), 0.0};
  if (cracks) {
    m.cracks.push_back({{-1, 20}, {81, 33}, JointId{0}, block});
    m.cracks.push_back({{40, 61}, {45, 10}, JointId{0}, block});
    m.cracks.push_back({{10, 40}, {30, 44}, JointId{0}, block});
  }
  return scene;
}

struct Case {
  const char* name;
  Integrator integrator;
  bool cracks;
  void (*change)(Stage&);
  int steps;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

class NmmBits : public testing::TestWithParam<Case> {
 protected:
  static Scene scene_of(const Case& c) {
    Scene scene = loaded(c.cracks, true);
    Stage& s = scene.stage("nmm", c.integrator, 1.0, std::nullopt, 1.0);
    s.cracks = c.cracks;
    if (c.integrator == Integrator::implicit) s.dt = 1e-3;
    s.control.max_displacement = 1.0;
    c.change(s);
    const double step = s.dt ? *s.dt : 1e-3;
    s.duration = ticks(step * c.steps);
    scene.plan.output.every = scene.plan.output.history_every = s.duration;
    scene.plan.detection = 0.2;
    return scene;
  }
};

TEST_P(NmmBits, do_not_depend_on_threads) {
  const Case& c = GetParam();
  const Scene scene = scene_of(c);
  std::vector<std::uint64_t> hash;
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    Driver run(scene.model, scene.plan, methods());
    const RunEnd end = run.run();
    ASSERT_TRUE(end.status == RunEnd::Status::done || scene.plan.stages[0].rest) << end.reason;
    ASSERT_GT(run.state().q.size() / 2, 4096U);
    ASSERT_GT(run.state().step, 1);
    ASSERT_FALSE(run.state().contacts.empty());
    hash.push_back(state_hash(run.state()));
  }
  EXPECT_EQ(hash[0], hash[1]);
  EXPECT_EQ(hash[0], hash[2]);
}

TEST_P(NmmBits, continue_from_a_copy_of_the_state) {
  const Case& c = GetParam();
  const Scene scene = scene_of(c);
  const Stage& stage = scene.plan.stages[0];
  omp_set_num_threads(2);
  ByHand hand(scene.model, stage);
  State& state = hand.state;
  const coupling::Setup& setup = *hand.setup;
  const auto make = [&]() -> std::unique_ptr<TimeIntegrator> {
    if (stage.integrator == Integrator::implicit)
      return std::make_unique<Newmark>(setup, stage.control, 0.2,
                                       ImplicitOptions{stage.newmark, stage.rest ? 0.0 : stage.dynamics, stage.damping,
                                                       stage.damp_rigid_motion, stage.stiffness_damping});
    return std::make_unique<CentralDifference>(
        setup, stage.control, 0.2,
        ExplicitDamping{stage.damping, stage.damp_rigid_motion, stage.stiffness_damping, stage.local_damping},
        stage.rest);
  };
  auto first = make();
  first->enter(state);
  const Tick h =
      stage.integrator == Integrator::implicit ? ticks(1e-3) : ticks(0.5 * first->stable_step(state, nullptr));
  const auto advance = [&](TimeIntegrator& integrator, State& s, int steps) {
    for (int i = 0; i < steps; ++i) {
      const StepReport report = integrator.step(s, h);
      ASSERT_EQ(report.status, StepReport::Status::ok) << report.cause;
    }
  };
  const int half = std::max(2, c.steps / 2);
  advance(*first, state, half);
  State copy = state;
  advance(*first, state, half);
  auto second = make();
  const Tick last = copy.last_step;
  second->enter(copy);
  copy.last_step = last;  // enter() begins a stage; a restart continues within one
  advance(*second, copy, half);
  EXPECT_EQ(state_hash(copy), state_hash(state));
}

INSTANTIATE_TEST_SUITE_P(
    All, NmmBits,
    testing::Values(Case{"explicit_loads", Integrator::explicit_, false, [](Stage&) {}, 30},
                    Case{"explicit_cracked", Integrator::explicit_, true, [](Stage&) {}, 30},
                    Case{"explicit_rayleigh", Integrator::explicit_, true,
                         [](Stage& s) {
                           s.damping = 3.0;
                           s.stiffness_damping = 1e-4;
                         },
                         30},
                    Case{"explicit_local", Integrator::explicit_, true, [](Stage& s) { s.local_damping = 0.4; }, 30},
                    Case{"explicit_damped_whole", Integrator::explicit_, true,
                         [](Stage& s) {
                           s.damping = 5.0;
                           s.damp_rigid_motion = true;
                           s.mass = MassKind::lumped;
                         },
                         30},
                    Case{"explicit_rest", Integrator::explicit_, true, [](Stage& s) { s.rest = true; }, 60},
                    Case{"explicit_linear", Integrator::explicit_, true,
                         [](Stage& s) { s.kinematics = Kinematics::linear; }, 30},
                    Case{"implicit_contacts", Integrator::implicit, false, [](Stage&) {}, 4},
                    Case{"implicit_cracked_lumped", Integrator::implicit, true,
                         [](Stage& s) {
                           s.mass = MassKind::lumped;
                           s.stiffness_damping = 1e-4;
                         },
                         4},
                    Case{"implicit_damped", Integrator::implicit, true, [](Stage& s) { s.damping = 3.0; }, 4},
                    Case{"implicit_rest", Integrator::implicit, true,
                         [](Stage& s) {
                           s.rest = true;
                           s.rest_force = 1e-3;
                         },
                         4}),
    [](const testing::TestParamInfo<Case>& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace scree::test::nmm_determinism_test
