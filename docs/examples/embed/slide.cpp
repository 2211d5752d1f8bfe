// A block on a plane of 30 degrees, built without a case file: how far it slides in half a second, and the energy.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "coupling/stages/driver.h"
#include "model/model.h"

int main() {
  using namespace scree;
  Model model;
  model.materials.push_back({"rock", 2500.0, 5e9, 0.25});
  model.joints.emplace_back();
  model.joints[0].name = "plane";
  model.joints[0].friction = 5.0 * std::numbers::pi / 180.0;
  model.default_joint = JointId{0};
  const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
  const auto add = [&](const char* name, const Ring& corners) {
    Block block;
    block.name = name;
    block.polygon = {corners, {}};
    orient(block.polygon);
    block.material = MaterialId{0};
    model.blocks.push_back(block);
  };
  add("slope", {{0, 0}, {10 * c, 0}, {0, 10 * s}});
  const Vec2 foot(2 * c, 8 * s), along(c, -s), up(s, c);
  add("slider", {foot, foot + along, foot + along + up, foot + up});
  model.block_supports.push_back({BlockId{0}, MotionId{}});

  coupling::Plan plan;
  coupling::Stage stage;
  stage.name = "slide";
  stage.method = "dda";
  stage.integrator = coupling::Integrator::implicit;
  stage.dt = 2e-3;
  stage.duration = ticks(0.5);
  plan.stages.push_back(stage);
  plan.output.every = plan.output.history_every = ticks(0.1);

  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver driver(model, plan, methods);
  const coupling::RunEnd end = driver.run();
  const coupling::State& state = driver.state();
  const double slid = driver.travels().back().farthest;
  const double theory = 0.5 * 9.81 * 0.25 * (s - c * std::tan(model.joints[0].friction));
  std::printf("%s: slid %.5f m, a rigid block %.5f m; ledger closes to %.1e of %.4g J\n",
              end.status == coupling::RunEnd::Status::done ? "done" : end.reason.c_str(), slid, theory,
              state.ledger.relative_closure(), state.ledger.moved());
  return std::abs(slid / theory - 1.0) < 1e-3 ? 0 : 1;
}
