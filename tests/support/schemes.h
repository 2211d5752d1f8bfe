// A method with a time scheme, for tests that hold for several, and a look at every frame of a run.
#pragma once

#include <functional>
#include <ostream>

#include "tests/support/scene.h"

namespace scree::test {

/// Method and integrator of a test's parameter.
struct Scheme {
  const char* name;
  const char* method;
  coupling::Integrator integrator;
  [[nodiscard]] bool implicit() const { return integrator == coupling::Integrator::implicit; }
};
inline std::ostream& operator<<(std::ostream& out, const Scheme& s) { return out << s.name; }

inline const coupling::Methods& methods() {
  static const coupling::Methods kAll = coupling::standard_methods();
  return kAll;
}

/// The NMM and DDA, explicit and implicit.
inline constexpr Scheme kAllSchemes[] = {{"nmm", "nmm", coupling::Integrator::explicit_},
                                         {"dda", "dda", coupling::Integrator::explicit_},
                                         {"nmm_implicit", "nmm", coupling::Integrator::implicit},
                                         {"dda_implicit", "dda", coupling::Integrator::implicit}};

/// Shows the time of every step of a run to a function.
struct EveryStep final : coupling::Sink {
  std::function<void(double)> see;
  void step(double time, const coupling::RunStats&, const coupling::Ledger&) override { see(time); }
};

/// Shows every frame of a run to a function.
struct Watch final : coupling::Sink {
  std::function<void(const coupling::FrameView&)> see;
  void frame(const coupling::FrameView& view) override { see(view); }
};

}  // namespace scree::test
