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

/// Shows every frame of a run to a function.
struct Watch final : coupling::Sink {
  std::function<void(const coupling::FrameView&)> see;
  void frame(const coupling::FrameView& view) override { see(view); }
};

}  // namespace scree::test
