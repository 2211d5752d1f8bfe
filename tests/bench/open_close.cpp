// Open-close iteration of a wall of DDA blocks that falls on its base: passes, switches, updates, factorisations and
// time per step, with rank updates of the factor and with a new factor in every pass, step by step in one run.
//
//   usage: bench_open_close [steps]
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <map>
#include <random>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::bench {
namespace {

/// Processor time [s]: independent of other processes.
double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double median(std::vector<double> x) {
  if (x.empty()) return 0.0;
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

/// Rows of blocks in running bond, each slightly displaced from its place, above a base that is held.
struct Wall {
  test::Scene scene{1e9, 0.2, 2500.0};
  coupling::StepControl control;

  Wall(int columns, int rows) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> off(-0.01, 0.01);
    scene.model.joints[0].friction = 0.6;
    scene.add("base", test::rectangle(-2.0, -1.0, 1.1 * columns + 2.0, 0.0), true);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        const double x = 1.02 * i + (j % 2 == 0 ? 0.0 : 0.5) + off(random), y = 1e-5 + 1.00002 * j + 1e-3 * off(random);
        scene.add(fmt::format("b{}-{}", j, i), test::rectangle(x, y, x + 1.0, y + 1.0));
      }
    scene.stage("dda", coupling::Integrator::implicit, 1.0, 1e-3, 1.0);
    control.max_displacement = 0.05;
    control.max_passes = 30;
  }
};

struct Side {
  test::ByHand hand;
  coupling::Newmark integrator;
  coupling::StepReport all;
  int cut = 0;
  double seconds = 0.0;
  std::map<int, std::vector<double>> pass,
      bringing;  // [s] by number of switches before a pass: whole pass, its factor

  Side(Wall& wall, coupling::OpenClose::Factor factor)
      : hand(wall.scene.model, wall.scene.plan.stages[0]),
        integrator(*hand.setup, wall.control, 0.05, coupling::ImplicitOptions{.factor = factor}) {
    integrator.enter(hand.state);
  }
  void step() {
    Tick h = ticks(1e-3);
    for (;;) {
      const double begin = now();
      const coupling::StepReport report = integrator.step(hand.state, h);
      seconds += now() - begin;
      all.passes += report.passes;
      all.switches += report.switches;
      all.updates += report.updates;
      all.factorisations += report.factorisations;
      for (const auto& p : integrator.contacts().passes())
        if (p.switched > 0) {
          pass[std::min(p.switched, 5)].push_back(p.seconds);
          bringing[std::min(p.switched, 5)].push_back(p.factor_seconds);
        }
      if (report.status == coupling::StepReport::Status::ok) return;
      ++cut;
      h /= 3;
    }
  }
};

void compare(int columns, int rows, int steps) {
  Wall wall(columns, rows);
  Side with(wall, coupling::OpenClose::Factor::updated), without(wall, coupling::OpenClose::Factor::anew);
  for (int i = 0; i < steps; ++i) {
    with.step();
    without.step();
  }
  for (const auto& [name, s] : {std::pair("updates", &with), std::pair("anew", &without)})
    fmt::print("{:>7} {:>8} {:>7} {:>9} {:>8} {:>9} {:>6} {:>10.2f}\n", columns * rows, name, s->all.passes,
               s->all.switches, s->all.updates, s->all.factorisations, s->cut, 1e3 * s->seconds / steps);
  const auto times_cheaper = [](const char* what, const auto& few, const auto& all) {
    fmt::print("        {:<13} after n switches, ms (updates / anew = how many times cheaper):", what);
    for (const auto& [n, times] : few)
      if (const auto other = all.find(n); other != all.end())
        fmt::print("  {}{}: {:.2f} / {:.2f} = {:.1f}", n, n == 5 ? "+" : "", 1e3 * median(times),
                   1e3 * median(other->second), median(other->second) / median(times));
    fmt::print("\n");
  };
  times_cheaper("a pass", with.pass, without.pass);
  times_cheaper("of it, factor", with.bringing, without.bringing);
}

}  // namespace
}  // namespace scree::bench

int main(int argc, char** argv) {
  const int steps = argc > 1 ? std::atoi(argv[1]) : 200;
  fmt::print("{:>7} {:>8} {:>7} {:>9} {:>8} {:>9} {:>6} {:>10}\n", "blocks", "factor", "passes", "switches", "updates",
             "factors", "cuts", "ms a step");
  for (const auto& [columns, rows] : {std::pair{10, 10}, {40, 25}, {80, 50}})
    scree::bench::compare(columns, rows, columns * rows > 2000 ? std::max(steps / 3, 10) : steps);
}
