// What a case must show: expected.toml, measured on a finished run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "coupling/stages/driver.h"

namespace scree::app {

/// One row of expected.toml ([[quantity]]):
///   name     what a person calls it
///   measure  blocks_moved_above | blocks_moved_below (of = distance [m]) | monitor_displacement (of = monitor;
///   magnitude)
///            | drift_in_stage (of = stage; farthest displacement of a free block [m])
///            | kinetic_at_handover | ledger_closure | scheme_share | transfer_momentum_error | transfer_energy_error
///   at_least, at_most, or reference with tolerance (relative)
///   tier     quick (default) | full
///   reason   why this bound
struct Quantity {
  std::string name, measure, text, reason;  // text: `of` where it names something
  double of = 0.0;
  double low = 0.0, high = 0.0;  // bounds; infinite where open
  std::string wanted;            // the bounds as text
  bool full = false;
};
/// @throws io::CaseError with the place in expected.toml
[[nodiscard]] std::vector<Quantity> read_expected(const std::filesystem::path& file);

/// Kinetic energy after each hand-over, collected during the run.
class HandOverWatch final : public coupling::Sink {
 public:
  void event(const coupling::Event& e) override;
  [[nodiscard]] double kinetic() const { return kinetic_; }

 private:
  double kinetic_ = 0.0, time_ = -1.0;
};

[[nodiscard]] double measure(const Quantity& quantity, const Model& model, const coupling::Driver& run,
                             const HandOverWatch& watch);

}  // namespace scree::app
