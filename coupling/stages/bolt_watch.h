// Reports bolts that break.
#pragma once

#include <string>
#include <vector>

#include "coupling/state.h"
#include "model/model.h"

namespace scree::coupling {

/// Broken segments that have been reported. Constructed from a state, it takes those of the state as reported.
class BoltWatch {
 public:
  BoltWatch() = default;
  explicit BoltWatch(const State& state) { (void)new_breaks(nullptr, state); }
  /// A line for every segment that has broken since the last call.
  [[nodiscard]] std::vector<std::string> new_breaks(const Model& model, const State& state) {
    return new_breaks(&model, state);
  }

 private:
  [[nodiscard]] std::vector<std::string> new_breaks(const Model* model, const State& state);

  std::vector<std::vector<std::int8_t>> broken_;  // per bolt, per segment
};

}  // namespace scree::coupling
