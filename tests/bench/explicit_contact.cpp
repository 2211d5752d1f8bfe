// Cost of contact in explicit steps: whole steps of DDA brick walls at rest and shaken, by number of contact points.
// Prints processor time per step and per contact point, and the cost of a step without contacts; a hash of the last
// state, to be compared between two programs and between numbers of threads.
//
//   usage: bench_explicit_contact [steps] [threads] [blocks ...]
#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "tests/support/by_hand.h"

namespace scree::bench {
namespace {

double cpu() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double wall() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Bricks of 2 m x 1 m in running bond, 30 per course, on a course that is held.
/// @param apart  gaps between bricks [m]: with wide gaps nothing touches
test::Scene bricks(int blocks, double apart) {
  test::Scene scene{5e9, 0.2, 2500.0};
  scene.model.joints[0].friction = 0.6;
  constexpr int kCourse = 30;
  for (int i = 0; i < blocks + kCourse; ++i) {
    const int row = i / kCourse;
    const double x = (2.0 + apart) * (i % kCourse) + (row % 2), y = row * (1.0 + apart);
    scene.add("b", test::rectangle(x, y, x + 2.0, y + 1.0), row == 0);
  }
  scene.stage("dda", coupling::Integrator::explicit_, 1.0, std::nullopt);
  return scene;
}

struct Cost {
  double points = 0.0, cpu = 0.0, wall = 0.0;  // points; times per step [s]
  std::uint64_t hash = 0;
};

/// @param speed  initial speed of the bricks, each in its own direction [m/s]
Cost measure(int blocks, double apart, double speed, int steps) {
  const test::Scene scene = bricks(blocks, apart);
  test::ByHand hand(scene.model, scene.plan.stages[0]);
  for (const coupling::Body& b : hand.setup->bodies()) {
    if (b.driven) continue;
    const double angle = 2.4 * static_cast<double>(b.block.value);
    hand.place(b.block.index(), speed * Vec2(std::cos(angle), std::sin(angle)), Mat2::Zero());
  }
  coupling::StepControl control;
  control.max_displacement = 0.05;
  coupling::ExplicitDamping damping;
  damping.sliding = 0.15;
  coupling::CentralDifference mover(*hand.setup, control, 0.02, damping);
  mover.enter(hand.state);
  const double bound = mover.stable_step(hand.state, nullptr);
  const Tick h = ticks(std::isfinite(bound) ? 0.5 * bound : 1e-4);
  Cost cost;
  double begin = 0.0, begin_wall = 0.0;
  for (int step = -10; step < steps; ++step) {
    if (step == 0) {
      begin = cpu();
      begin_wall = wall();
    }
    if (mover.step(hand.state, h).status != coupling::StepReport::Status::ok) std::abort();
    if (step >= 0) cost.points += static_cast<double>(mover.contacts().points.size()) / steps;
    (void)mover.step_still_stable();
  }
  cost.cpu = (cpu() - begin) / steps;
  cost.wall = (wall() - begin_wall) / steps;
  mover.update_ledger(hand.state);
  cost.hash = coupling::state_hash(hand.state);
  return cost;
}

}  // namespace
}  // namespace scree::bench

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::atoi(argv[1]) : 200;
  omp_set_num_threads(argc > 2 ? std::atoi(argv[2]) : 1);
  std::vector<int> sizes;
  for (int i = 3; i < argc; ++i) sizes.push_back(std::atoi(argv[i]));
  if (sizes.empty()) sizes = {120, 915, 10000};
  fmt::print("{:>7} {:>8} {:>8} {:>12} {:>12} {:>14} {:>14}   {}\n", "blocks", "motion", "points", "CPU us/step",
             "wall us/step", "without, us", "ns a point", "hash");
  for (const int blocks : sizes) {
    const scree::bench::Cost free = scree::bench::measure(blocks, 0.5, 0.0, steps);
    for (const double speed : {0.0, 0.2}) {
      const scree::bench::Cost c = scree::bench::measure(blocks, 0.0, speed, steps);
      fmt::print("{:>7} {:>8} {:>8.0f} {:>12.1f} {:>12.1f} {:>14.1f} {:>14.1f}   {:016x}\n", blocks,
                 speed == 0.0 ? "rest" : "shaken", c.points, 1e6 * c.cpu, 1e6 * c.wall, 1e6 * free.cpu,
                 1e9 * (c.cpu - free.cpu) / c.points, c.hash);
      std::fflush(stdout);
    }
  }
}
