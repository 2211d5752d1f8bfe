// Tells of bolts that break.
#pragma once

#include <string>
#include <vector>

#include "coupling/state.h"
#include "model/model.h"

namespace scree::coupling {

/// Where the bolts of a run are broken: what has been told. Made anew from a state, it tells nothing twice.
class BoltWatch {
 public:
  BoltWatch() = default;
  explicit BoltWatch(const State& state) { (void)look(nullptr, state); }
  /// A line for every segment that has broken since the last look.
  [[nodiscard]] std::vector<std::string> look(const Model& model, const State& state) { return look(&model, state); }

 private:
  [[nodiscard]] std::vector<std::string> look(const Model* model, const State& state);

  std::vector<std::vector<std::int8_t>> broken_;  // a bolt
};

}  // namespace scree::coupling
