// Methods with time schemes for parametrised tests; sinks that observe steps and frames of a run or keep a checkpoint.
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

/// Calls a function with the time of every step of a run.
struct EveryStep final : coupling::Sink {
  std::function<void(double)> see;
  void step(double time, const coupling::RunStats&, const coupling::Ledger&) override { see(time); }
};

/// Calls a function with every frame of a run.
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
