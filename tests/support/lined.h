// Scenes with liners, run in every method and scheme.
#pragma once

#include "tests/support/bolted.h"

namespace scree::test {

inline constexpr double kLinerYoung = 30e9;  // [Pa], poisson 0

/// A liner along a line, by default of shotcrete 0.1 m thick.
inline Bolt lining(std::vector<Vec2> along, double spacing, double thickness = 0.1) {
  Bolt b;
  b.name = "liner";
  b.along = std::move(along);
  b.segment = spacing;
  b.tolerance = 1e-3;
  b.plate = false;
  b.stiffness = kLinerYoung * thickness;
  b.bending = kLinerYoung * thickness * thickness * thickness / 12.0;
  return b;
}

struct Lined : Bolted {
  using Bolted::Bolted;
  void line(Bolt b) {
    if (const std::string wrong = lay_out_liner(model, {}, b); !wrong.empty()) throw std::runtime_error(wrong);
    model.bolts.push_back(std::move(b));
  }
};

inline const Way kWays[] = {{"dda", coupling::Integrator::explicit_},
                            {"dda", coupling::Integrator::implicit},
                            {"nmm", coupling::Integrator::explicit_},
                            {"nmm", coupling::Integrator::implicit}};

}  // namespace scree::test
