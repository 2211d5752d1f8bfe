// Bitwise equal states for any number of threads, and when a run continues from a copy of the state.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "coupling/integrate/central_difference.h"
#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"
#include "tests/support/scene.h"

namespace scree::test::determinism_test {
namespace {

using namespace coupling;

/// A block of some 20,000 elements dropped on a base, stepped without the driver.
struct Big {
  Scene scene{1e9, 0.25, 2500.0, 20.0};
  Methods methods = standard_methods();
  State state;
  std::unique_ptr<Setup> setup;
  Big() {
    scene.add("base", rectangle(-20, -5, 120, 0), true);
    scene.add("block", rectangle(0, 0, 100, 86.6));
    scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, 1.0).rules = {{{BlockId{0}}, "dda"}};
    state.bodies = initial_records(scene.model, body_requests(scene.model, scene.plan.stages[0]));
    setup = std::make_unique<Setup>(scene.model, methods, state.bodies);
    state.q.assign(2 * static_cast<std::size_t>(setup->nodes()), 0.0);
    state.v = state.q;
    for (const Body& b : setup->bodies()) {
      AffineMotion m;
      m.c = b.centre;
      const auto p = static_cast<std::size_t>(b.pool);
      setup->pool_of(b).place(b.index, m, setup->part(std::span<double>(state.q), p),
                              setup->part(std::span<double>(state.v), p));
    }
  }
  /// Hash and seconds of `steps` steps from the start.
  std::pair<std::uint64_t, double> run(int threads, int steps) {
    omp_set_num_threads(threads);
    State s = state;
    StepControl control;
    control.max_displacement = 1.0;
    CentralDifference integrator(*setup, control, 0.5, {.mass = 10.0});
    integrator.enter(s);
    const Tick h = ticks(0.5 * integrator.stable_step(s, nullptr));
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < steps; ++i) EXPECT_EQ(integrator.step(s, h).status, StepReport::Status::ok);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    integrator.update_ledger(s);
    return {state_hash(s), seconds};
  }
};

TEST(Threads, explicit_run_has_the_same_hash_and_two_threads_are_faster) {
  Big big;
  MeshPart mesh;
  for (std::size_t p = 0; p < big.setup->pools(); ++p) {
    MeshPart part;
    big.setup->pool(p).topology(part);
    if (part.body.size() > mesh.body.size()) mesh = part;
  }
  ASSERT_GT(mesh.body.size(), 19000U);
  std::vector<double> ratio;
  for (int k = 0; k < 5; ++k) {  // interleaved: the machine may be busy
    const auto [hash1, time1] = big.run(1, 150);
    const auto [hash2, time2] = big.run(2, 150);
    EXPECT_EQ(hash1, hash2);
    ratio.push_back(time1 / time2);
  }
  EXPECT_EQ(big.run(1, 20).first, big.run(3, 20).first);
  std::sort(ratio.begin(), ratio.end());
  std::printf("%zu elements, two threads over one: %.2f (median of 5, best %.2f)\n", mesh.body.size(), ratio[2],
              ratio[4]);
  if (omp_get_num_procs() >= 2 && std::getenv("SCREE_TIMING") != nullptr) {
    EXPECT_GE(ratio[2], 1.5);
  }
}

TEST(Copies, of_a_state_run_twice_give_the_same_end) {
  Big big;
  EXPECT_EQ(big.run(2, 30).first, big.run(2, 30).first);
}

TEST(Copies, new_integrators_on_a_copied_state_continue_bit_for_bit) {
  // As in a restart: the state is copied, and all else is created anew.
  for (const bool implicit : {false, true}) {
    Scene scene(1e8, 0.2, 2000.0, 20.0);
    scene.add("base", transformed(rectangle(-2, -1, 8, 0), {0, 0}, rotation(-0.5)), true);
    scene.add("block", transformed(rectangle(0, 0, 1, 1), {0, 0}, rotation(-0.5)));
    scene.add("upper", transformed(rectangle(0.1, 1, 0.9, 1.4), {0, 0}, rotation(-0.5)));
    scene.stage("dda", implicit ? Integrator::implicit : Integrator::explicit_, 1.0, 1e-4);
    // Damping uses the velocity of half a step before, which is part of the state.
    if (!implicit) scene.model.viscous_edges.push_back({{BlockId{2}, {0, 2}, 0.0, 1.0}});
    const Methods methods = standard_methods();
    ByHand hand(scene.model, scene.plan.stages[0]);
    State& state = hand.state;
    const coupling::Setup& setup = *hand.setup;
    StepControl control;
    control.max_displacement = 0.01;
    const auto make = [&]() -> std::unique_ptr<TimeIntegrator> {
      if (implicit) return std::make_unique<Newmark>(setup, control, 0.05);
      return std::make_unique<CentralDifference>(setup, control, 0.05, ExplicitDamping{5.0, true, 1e-6, 0.05});
    };
    auto first = make();
    first->enter(state);
    const auto advance = [&](TimeIntegrator& integrator, State& s, int steps) {
      for (int i = 0; i < steps; ++i) ASSERT_EQ(integrator.step(s, ticks(2e-5)).status, StepReport::Status::ok);
    };
    advance(*first, state, 300);
    State copy = state;
    advance(*first, state, 300);
    auto second = make();
    const Tick last = copy.last_step;
    second->enter(copy);
    copy.last_step = last;  // enter() begins a stage; a restart continues within one
    advance(*second, copy, 300);
    EXPECT_EQ(state_hash(copy), state_hash(state)) << (implicit ? "implicit" : "explicit");
  }
}

}  // namespace
}  // namespace scree::test::determinism_test
