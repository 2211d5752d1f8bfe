// Implicit steps of a wall of DDA blocks in running bond, at rest and on a base that shakes: processor time per step,
// and its contributions: passes of the open-close iteration, solutions, factors, cuts.
//
//   usage: bench_implicit_wall [courses [steps [settling steps [dt in s [positions]]]]]
// Courses of n + 1 and n blocks of 1 x 0.5 m in turn, n courses: 915 blocks are 30 courses, 10,050 are 100 and 100,014
// are 316. The wall settles in static steps of 20 ms first; the same settled state is then stepped at rest and shaken
// (2 Hz, 4 m/s2 horizontally). If a file name is given as `positions`, the final positions are written there in binary
// form, to compare runs.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <numbers>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::bench {
namespace {

/// Processor time [s]: independent of other processes.
double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr double kSettlingStep = 0.02;

/// @param shaken  the base moves after the settling
test::Scene wall(int courses, int settling, bool shaken) {
  test::Scene scene{5e9, 0.2, 2500.0, 31.0};
  scene.add("base", test::rectangle(-3.0, -2.0, courses + 4.0, 0.0));
  for (int j = 0; j < courses; ++j) {
    const int count = j % 2 == 0 ? courses + 1 : courses;
    for (int i = 0; i < count; ++i) {
      const double x = i + (j % 2 == 0 ? 0.0 : 0.5);
      scene.add(fmt::format("b{}-{}", j, i), test::rectangle(x, 0.5 * j, x + 1.0, 0.5 * (j + 1)));
    }
  }
  MotionId motion;
  if (shaken) {
    std::vector<double> time, acceleration;
    for (int i = 0; i <= 2000; ++i) {
      time.push_back(1e-3 * i);
      acceleration.push_back(4.0 * std::sin(2.0 * std::numbers::pi * 2.0 * time.back()));
    }
    scene.model.motions.emplace_back(time, acceleration, Vec2(1.0, 0.0),
                                     GroundMotion::Setting{.start = kSettlingStep * settling, .name = "shaking"});
    motion = MotionId{0};
  }
  scene.model.block_supports.push_back({BlockId{0}, motion});
  scene.stage("dda", coupling::Integrator::implicit, 1.0, 1e-3, 1.0);
  return scene;
}

struct Phase {
  coupling::StepReport all;
  int steps = 0, cuts = 0;
  double seconds = 0.0, longest = 0.0;
};

template <class Integrator>
bool take(Integrator& integrator, test::ByHand& hand, Tick step, int count, Phase& phase) {
  for (int i = 0; i < count; ++i) {
    double spent = 0.0;
    for (Tick left = step, h = step; left > 0;) {
      const double begin = now();
      const coupling::StepReport report = integrator.step(hand.state, std::min(h, left));
      spent += now() - begin;
      phase.all.passes += report.passes;
      phase.all.switches += report.switches;
      phase.all.updates += report.updates;
      phase.all.factorisations += report.factorisations;
      phase.all.corrections += report.corrections;
      phase.all.block_iterations += report.block_iterations;
      phase.all.incomplete_factors += report.incomplete_factors;
      phase.all.local_passes += report.local_passes;
      phase.all.fallbacks += report.fallbacks;
      if (report.status == coupling::StepReport::Status::ok) {
        left -= std::min(h, left);
        continue;
      }
      ++phase.cuts;
      h /= 3;
      if (h < 1000) {
        fmt::print("a step failed: {}\n", report.cause);
        return false;
      }
    }
    phase.seconds += spent;
    phase.longest = std::max(phase.longest, spent);
    ++phase.steps;
  }
  return true;
}

void show(const char* name, std::size_t blocks, const Phase& p) {
  const double n = p.steps;
  fmt::print(
      "{:>8} {:>8} {:>6} {:>7.2f} {:>7.2f} {:>9.1f} {:>7.2f} {:>7.2f} {:>8.2f} {:>8.2f} {:>8.1f} {:>5} {:>5} {:>10.2f} "
      "{:>10.2f}\n",
      blocks, name, p.steps, p.all.passes / n, p.all.local_passes / n, p.all.switches / n, p.all.corrections / n,
      p.all.block_iterations / n, p.all.incomplete_factors / n, p.all.factorisations / n, p.all.updates / n,
      p.all.fallbacks, p.cuts, 1e3 * p.seconds / n, 1e3 * p.longest);
  std::fflush(stdout);
}

}  // namespace
}  // namespace scree::bench

int main(int argc, char** argv) {
  using namespace scree;
  const int courses = argc > 1 ? std::atoi(argv[1]) : 30, steps = argc > 2 ? std::atoi(argv[2]) : 200,
            settling = argc > 3 ? std::atoi(argv[3]) : 60;
  const double dt = argc > 4 ? std::atof(argv[4]) : 1e-3;
  std::ofstream positions;
  if (argc > 5) positions.open(argv[5], std::ios::binary);
  fmt::print("{:>8} {:>8} {:>6} {:>7} {:>7} {:>9} {:>7} {:>7} {:>8} {:>8} {:>8} {:>5} {:>5} {:>10} {:>10}\n", "blocks",
             "phase", "steps", "passes", "local", "switches", "solves", "blocks", "ilu", "factors", "updates", "falls",
             "cuts", "ms a step", "longest");
  for (const bool shaken : {false, true}) {
    const test::Scene scene = bench::wall(courses, settling, shaken);
    test::ByHand hand(scene.model, scene.plan.stages[0]);
    coupling::StepControl control;
    control.max_displacement = 0.05;
    const std::size_t blocks = hand.setup->bodies().size() - 1;
    {
      const double begin = bench::now();
      coupling::Newmark still(*hand.setup, control, 0.05, coupling::ImplicitOptions{.dynamics = 0.0});
      (void)still.enter(hand.state);
      if (!shaken) fmt::print("entering a stage {:.2f} s\n", bench::now() - begin);
      bench::Phase phase;
      if (!bench::take(still, hand, ticks(bench::kSettlingStep), settling, phase)) return 1;
      if (!shaken) bench::show("settling", blocks, phase);
      still.leave(hand.state);
    }
    coupling::Newmark integrator(*hand.setup, control, 0.05);
    (void)integrator.enter(hand.state);
    bench::Phase phase;
    if (!bench::take(integrator, hand, ticks(dt), steps, phase)) return 1;
    bench::show(shaken ? "shaken" : "rest", blocks, phase);
    if (positions.is_open())
      positions.write(reinterpret_cast<const char*>(hand.state.q.data()),
                      static_cast<std::streamsize>(sizeof(double) * hand.state.q.size()));
  }
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM")) fmt::print("peak memory {:.0f} MB\n", std::atof(line.substr(6).c_str()) / 1024.0);
  return 0;
}
