// A friction law defined by the user, registered before a case is read: friction that grows with the slip rate, as in a
// viscous gouge, so that a block on a plane of 30 degrees tends to a steady speed.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "coupling/contact/law/friction_laws.h"
#include "coupling/stages/driver.h"
#include "io/case/read_case.h"

namespace {

using Constants = scree::FrictionLaw::Constants;

/// tan phi = tan phi_p + v / velocity, with v the slip rate of the step.
void evolve(double, Constants c, double step, std::span<scree::FrictionRow> rows) {
  for (scree::FrictionRow& row : rows) row.change = row.slip / step / c[0];
}
double least(double tan_peak, Constants) { return tan_peak; }
std::string fault(double, Constants) { return {}; }

constexpr const char* kCase = R"(
[material.rock]
density = 2500.0
young = "5 GPa"
poisson = 0.25
[joint.gouge]
friction_deg = 20.0
viscous_friction = { velocity = "4 m/s" }
[[support]]
block = "plane"
[[block]]
name = "plane"
material = "rock"
polygon = [[-4, -12], [20, -12], [-4, 1.856406461]]
[[block]]
name = "block"
material = "rock"
polygon = [[0, -0.4529946162], [1, -1.0303448850], [1.5, -0.1643194812], [0.5, 0.4130307876]]
[[stage]]
name = "slide"
method = "dda"
integrator = "implicit"
dt = "1 ms"
duration = 2.0
)";

}  // namespace

int main() {
  using namespace scree;
  FrictionLaw law;
  law.name = "viscous_friction";
  law.meaning = "Friction that grows with the slip rate.";
  law.keys = {{"velocity", "m/s", 0.0, true, 1e3, false, "Slip rate at which tan phi has grown by one."}};
  law.evolve = evolve;
  law.least = least;
  law.fault = fault;
  coupling::register_friction_law(law);

  const std::vector<std::string> names = {"dda", "nmm"};
  const io::Case c = io::read_case_text(kCase, "own_law", {}, names);
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver driver(c.model, c.plan, methods);
  const coupling::RunEnd end = driver.run();

  // x'' = g (sin a - cos a (tan phi + x'/velocity)): a steady speed, approached with the time constant tau.
  const double g = 9.81, a = std::numbers::pi / 6, peak = std::tan(20.0 * std::numbers::pi / 180.0), t = 2.0;
  const double steady = 4.0 * (std::tan(a) - peak), tau = 4.0 / (g * std::cos(a));
  const double theory = steady * (t - tau * (1.0 - std::exp(-t / tau))), slid = driver.travels().back().farthest;
  std::printf("%s: slid %.5f m, a rigid block %.5f m; %.3f m/s in the end\n",
              end.status == coupling::RunEnd::Status::done ? "done" : end.reason.c_str(), slid, theory, steady);
  return std::abs(slid / theory - 1.0) < 3e-3 ? 0 : 1;
}
