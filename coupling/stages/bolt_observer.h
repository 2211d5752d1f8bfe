// Converts the memories of bolts into the view for sinks.
#pragma once

#include <vector>

#include "coupling/bolts/bolt_rows.h"
#include "coupling/sink.h"

namespace scree::coupling {

class BoltObserver {
 public:
  BoltObserver(const Setup& setup, const State& state);
  /// Valid until the next call; nullptr where the model has no bolts.
  [[nodiscard]] const BoltsView* view(const State& state);

 private:
  std::vector<BoltRows> rows_;  // of all bolts
  std::vector<double> force_, shear_, slip_, strain_, position_, node_force_;
  std::vector<std::int32_t> broken_, node_bolt_, liner_;
  BoltsView view_;
};

}  // namespace scree::coupling
