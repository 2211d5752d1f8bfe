#include "app/studies/oscillator.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <stdexcept>

#include "coupling/integrate/central_difference.h"
#include "coupling/integrate/newmark.h"
#include "coupling/transfer/transfer.h"

namespace scree::app {
namespace {

constexpr double kOscillatorStep = 1e-3;  // h [s]: a whole number of ticks
constexpr double kMass = 1000.0;          // [kg]
constexpr double kSpeed = 1.0;            // at the start [m/s]
constexpr double kRoom = 1e30;  // displacement allowed per step [m]: growth beyond the stable step is measured

Model model_of(double Omega) {
  Model model;
  model.gravity = Vec2(0.0, 0.0);
  // So soft that its own frequencies are negligible beside that of the spring.
  model.materials.push_back({"rock", kMass, 1e-3, 0.0});
  model.joints.emplace_back();
  model.default_joint = JointId{0};
  Block block;
  block.name = "mass";
  block.polygon = {{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, {}};
  block.material = MaterialId{0};
  block.joint = JointId{0};
  model.blocks.push_back(block);
  PointSupport spring;
  spring.block = BlockId{0};
  spring.fix_y = false;
  spring.stiffness = kMass * (Omega / kOscillatorStep) * (Omega / kOscillatorStep);
  model.point_supports.push_back(spring);
  model.initial_velocities.push_back({BlockId{0}, {kSpeed, 0.0}, 0.0});
  return model;
}

/// z at the start and after every step.
std::vector<Vec2> steps_of(coupling::TimeIntegrator& integrator, coupling::State& state, int steps) {
  (void)integrator.enter(state);
  std::vector<Vec2> z{{state.q[0], kOscillatorStep * state.v[0]}};
  for (int i = 0; i < steps; ++i) {
    const coupling::StepReport report = integrator.step(state, ticks(kOscillatorStep));
    if (report.status != coupling::StepReport::Status::ok)
      throw std::runtime_error("the oscillator's step failed: " + report.cause);
    z.emplace_back(state.q[0], kOscillatorStep * state.v[0]);
  }
  return z;
}

}  // namespace

std::vector<Vec2> oscillator_steps(coupling::Integrator integrator, double Omega, int steps) {
  const Model model = model_of(Omega);
  coupling::Stage stage;
  stage.method = "dda";
  stage.integrator = integrator;
  coupling::State state;
  state.bodies = coupling::initial_records(model, coupling::body_requests(model, stage));
  const coupling::Setup setup(model, coupling::standard_methods(), state.bodies);
  state.q.assign(2 * static_cast<std::size_t>(setup.nodes()), 0.0);
  state.v = state.q;
  AffineMotion start;
  start.vc = model.initial_velocities.front().velocity;
  setup.pool(0).place(0, start, state.q, state.v);
  state.ledger.open(std::array{0.5 * kMass * kSpeed * kSpeed});

  // The integrators by themselves: a driver would refuse explicit steps beyond the stable one.
  coupling::StepControl control;
  control.max_displacement = kRoom;
  if (integrator == coupling::Integrator::implicit) {
    coupling::Newmark time_integrator(setup, control, kRoom, {});
    return steps_of(time_integrator, state, steps);
  }
  coupling::CentralDifference time_integrator(setup, control, kRoom, {});
  return steps_of(time_integrator, state, steps);
}

MeasuredStep measured_step(const std::vector<Vec2>& z) {
  Mat2 before = Mat2::Zero(), across = Mat2::Zero();
  for (std::size_t i = 0; i + 1 < z.size(); ++i) {
    const double weight = 1.0 / z[i].squaredNorm();  // equal weight for all steps, however far z has decayed or grown
    before += weight * z[i] * z[i].transpose();
    across += weight * z[i + 1] * z[i].transpose();
  }
  MeasuredStep step{across * before.inverse()};
  for (std::size_t i = 0; i + 1 < z.size(); ++i)
    step.misfit = std::max(step.misfit, (z[i + 1] - step.A * z[i]).norm() / z[i].norm());
  return step;
}

}  // namespace scree::app
