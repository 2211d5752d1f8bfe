// Explicit contact of many blocks: bitwise equal states for any number of threads while points close, slide and open.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

#include "coupling/integrate/central_difference.h"
#include "tests/support/by_hand.h"

namespace scree::test::contact_determinism_test {
namespace {

using namespace coupling;

constexpr int kRows = 36, kColumns = 32;

/// Bricks in running bond, each with a velocity of its own, on a course that is held.
Scene shaken_wall(double speed) {
  Scene scene(1e9, 0.2, 2500.0);
  scene.model.joints[0].friction = 0.4;
  for (int row = 0; row < kRows; ++row)
    for (int i = 0; i < kColumns; ++i) {
      const double x = 2.0 * i + row % 2;
      const BlockId id = scene.add("b", rectangle(x, row, x + 2.0, row + 1.0), row == 0);
      const double angle = 2.4 * id.value;
      if (row > 0)
        scene.model.initial_velocities.push_back({id, {speed * std::cos(angle), speed * std::sin(angle)}, 0.0});
    }
  scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt, 0.7);
  return scene;
}

struct Outcome {
  std::uint64_t hash = 0;
  double seconds = 0.0;
  std::size_t points = 0;
  std::int64_t open = 0, slipping = 0;
  double closure = 0.0;  // of the ledger, over the energy moved
};

Outcome run(const Scene& scene, int threads, int steps) {
  omp_set_num_threads(threads);
  ByHand hand(scene.model, scene.plan.stages[0]);
  StepControl control;
  control.max_displacement = 1.0;
  ExplicitDamping damping;
  damping.sliding = 0.15;
  CentralDifference integrator(*hand.setup, control, 0.02, damping);
  integrator.enter(hand.state);
  const Tick h = ticks(0.5 * integrator.stable_step(hand.state, nullptr));
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) EXPECT_EQ(integrator.step(hand.state, h).status, StepReport::Status::ok);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  integrator.update_ledger(hand.state);
  const std::vector<ContactMemory>& contacts = hand.state.contacts.memory;
  const auto count = [&](ContactStatus status) {
    return std::count_if(contacts.begin(), contacts.end(), [&](const ContactMemory& m) { return m.status == status; });
  };
  return {state_hash(hand.state),
          seconds,
          contacts.size(),
          count(ContactStatus::open),
          count(ContactStatus::slip),
          hand.state.ledger.relative_closure()};
}

TEST(Threads, explicit_contact_has_the_same_hash_and_two_threads_are_faster) {
  const Scene moving = shaken_wall(0.3);
  const Outcome one = run(moving, 1, 200);
  EXPECT_GT(one.points, 4500U);
  EXPECT_GT(one.open, 500);
  EXPECT_GT(one.slipping, 500);
  EXPECT_LT(one.closure, 1e-12);
  for (const int threads : {2, 3}) EXPECT_EQ(run(moving, threads, 200).hash, one.hash) << threads << " threads";

  const Scene resting = shaken_wall(0.0);
  std::vector<double> ratio;
  for (int k = 0; k < 5; ++k) {  // interleaved: the machine may be busy
    const Outcome a = run(resting, 1, 60), b = run(resting, 2, 60);
    EXPECT_EQ(a.hash, b.hash);
    ratio.push_back(a.seconds / b.seconds);
  }
  std::sort(ratio.begin(), ratio.end());
  std::printf("%zu contact points, two threads over one: %.2f (median of 5, best %.2f)\n", one.points, ratio[2],
              ratio[4]);
  if (omp_get_num_procs() >= 2 && std::getenv("SCREE_TIMING") != nullptr) {
    EXPECT_GE(ratio[2], 1.3);
  }
}

}  // namespace
}  // namespace scree::test::contact_determinism_test
