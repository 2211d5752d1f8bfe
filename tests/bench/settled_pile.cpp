// A pile of DDA blocks of unequal sizes, settled under gravity: time per step, and its growth with the number of
// blocks.
//
//   usage: bench_settled_pile [steps] [courses[xlength] ...]
// By default the length of a pile [m] is twice its number of courses. The time that a high pile takes to settle grows
// with the square of its height; piles of one height and different lengths show the cost of the number of blocks.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::bench {
namespace {

/// Processor time [s]: independent of other processes.
double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Size {
  int courses = 0, length = 0;
};

/// Courses of blocks of unequal widths on a base that is held, each a little narrower than the one below.
test::Scene pile(const Size& size) {
  const int rows = size.courses;
  test::Scene scene{1e9, 0.2, 2500.0};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> width(0.8, 1.2), height(0.9, 1.1);
  scene.model.joints[0].friction = 0.6;
  const double below = size.length;
  scene.add("base", test::rectangle(-2.0, -1.0, below + 2.0, 0.0), true);
  double y = 0.0, end = below;  // top of the course below, and its right end
  for (int j = 0; j < rows; ++j) {
    const double top = y + height(random);
    const double room = end - 0.3;
    for (double x = 0.5 * j + 0.1 * width(random); x + 1.2 < room;) {
      const double right = x + width(random);
      scene.add(fmt::format("b{}-{:.3f}", j, x), test::rectangle(x, y, right, top));
      x = right + 0.01;
      end = right;
    }
    y = top;
  }
  scene.stage("dda", coupling::Integrator::implicit, 1.0, 1e-3, 1.0);
  return scene;
}

struct Timing {
  int blocks = 0;
  double ms = 0.0;  // median time per step
};

Timing settled(const Size& size, int steps) {
  const test::Scene scene = pile(size);
  test::ByHand hand(scene.model, scene.plan.stages[0]);
  coupling::StepControl control;
  control.max_displacement = 0.05;
  const auto run = [&](double dynamics, double dt, int count) {
    coupling::Newmark integrator(*hand.setup, control, 0.05, coupling::ImplicitOptions{.dynamics = dynamics});
    integrator.enter(hand.state);
    coupling::StepReport all;
    int cuts = 0;
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
      const double begin = now();
      coupling::StepReport report;
      for (Tick h = ticks(dt); h > 1000; h /= 3) {
        report = integrator.step(hand.state, h);
        if (report.status == coupling::StepReport::Status::ok) break;
        ++cuts;
      }
      times.push_back(1e3 * (now() - begin));
      all.passes += report.passes;
      all.switches += report.switches;
      all.updates += report.updates;
      all.factorisations += report.factorisations;
      all.corrections += report.corrections;
    }
    std::sort(times.begin(), times.end());
    integrator.update_ledger(hand.state);
    fmt::print("{:>7} {:>8.1f} {:>6} {:>8} {:>8} {:>8} {:>8} {:>9} {:>5} {:>9.2f} {:>9.2f} {:>10.2e}\n",
               hand.setup->bodies().size() - 1, dynamics, count, all.passes, all.switches, all.updates,
               all.factorisations, all.corrections, cuts, times[times.size() / 2], times.back(),
               hand.state.ledger[coupling::Column::kinetic]);
    std::fflush(stdout);
    return times[times.size() / 2];
  };
  for (int k = 0; k < 3; ++k) (void)run(0.0, 0.02, 40);
  (void)run(0.5, 1e-3, 20);
  (void)run(1.0, 1e-3, 20);
  return {static_cast<int>(hand.setup->bodies().size()) - 1, run(1.0, 1e-3, steps)};
}

}  // namespace
}  // namespace scree::bench

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::atoi(argv[1]) : 100;
  fmt::print("{:>7} {:>8} {:>6} {:>8} {:>8} {:>8} {:>8} {:>9} {:>5} {:>9} {:>9} {:>10}\n", "blocks", "dynamics",
             "steps", "passes", "switches", "updates", "factors", "solves", "cuts", "ms a step", "longest",
             "kinetic, J");
  std::vector<scree::bench::Timing> all;
  std::vector<scree::bench::Size> sizes;
  sizes.reserve(static_cast<std::size_t>(argc));
  for (int i = 2; i < argc; ++i) {
    char* end = nullptr;
    const int courses = static_cast<int>(std::strtol(argv[i], &end, 10));
    sizes.push_back({courses, *end == 'x' ? std::atoi(end + 1) : 2 * courses});
  }
  if (sizes.empty()) sizes = {{9, 18}, {29, 58}, {29, 380}};
  all.reserve(sizes.size());
  for (const scree::bench::Size& size : sizes) all.push_back(scree::bench::settled(size, steps));
  for (std::size_t i = 1; i < all.size(); ++i)
    fmt::print("{} to {} blocks: {:.2f} to {:.2f} ms a step, exponent {:.2f}\n", all[i - 1].blocks, all[i].blocks,
               all[i - 1].ms, all[i].ms,
               std::log(all[i].ms / all[i - 1].ms) / std::log(1.0 * all[i].blocks / all[i - 1].blocks));
}
