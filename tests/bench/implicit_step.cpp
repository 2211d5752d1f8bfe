// An implicit NMM step with 100,000 unknowns and a reused symbolic analysis: time, numbers in the factor, memory.
//
//   usage: bench_implicit_step [side in cover sizes]
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <fstream>

#include "coupling/integrate/newmark.h"
#include "nmm/nmm_pool.h"
#include "tests/support/by_hand.h"

int main(int argc, char** argv) {
  using namespace scree;
  const double side = argc > 1 ? std::atof(argv[1]) : 206.0;
  const auto now = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  test::Scene scene(1e9, 0.25, 2000.0);
  scene.add("block", test::rectangle(0.0, 0.0, side, side));
  for (const double x : {0.0, side}) scene.model.point_supports.push_back({BlockId{0}, {x, 0.0}, true, true, {}});
  coupling::Stage& stage = scene.stage("nmm", coupling::Integrator::implicit, 1.0, 1e-3, 1.0);
  test::ByHand hand(scene.model, stage);
  coupling::StepControl control;
  control.max_displacement = 1.0;
  coupling::Newmark integrator(*hand.setup, control, 0.1);
  double begin = now();
  integrator.enter(hand.state);
  const int unknowns = hand.setup->pool(0).dofs(0);
  fmt::print("{} unknowns, {} elements; entering {:.2f} s\n", unknowns,
             dynamic_cast<const nmm::NmmPool&>(hand.setup->pool(0)).elements().size(), now() - begin);
  for (int i = 0; i < 4; ++i) {
    begin = now();
    const coupling::StepReport report = integrator.step(hand.state, ticks(1e-3));
    if (report.status != coupling::StepReport::Status::ok) {
      fmt::print("the step failed: {}\n", report.cause);
      return 1;
    }
    fmt::print("step {}{}: {:.3f} s, {} factorisations\n", i + 1, i == 0 ? " (with the analysis)" : "", now() - begin,
               report.factorisations);
  }
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM")) fmt::print("peak memory {:.0f} MB\n", std::atof(line.substr(6).c_str()) / 1024.0);
  return 0;
}
