// A method with a time scheme, for tests that hold for several, looks at the frames of a run, one of its checkpoints.
#pragma once

#include <functional>
#include <ostream>
#include <vector>

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

/// Keeps a checkpoint after a given step.
struct KeepOne final : coupling::Keeper {
  explicit KeepOne(std::int64_t at) : step(at) {}
  bool due(std::int64_t now) override { return now == step; }
  void keep(const coupling::Checkpoint& checkpoint) override {
    if (checkpoint.state.step == step) kept.push_back(checkpoint);
  }
  std::int64_t step;
  std::vector<coupling::Checkpoint> kept;
};

}  // namespace scree::test
