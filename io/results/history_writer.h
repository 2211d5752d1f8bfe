// Monitors and the energy ledger in the results file.
#pragma once

#include <string>
#include <vector>

#include "coupling/sink.h"
#include "io/results/series_group.h"

namespace scree::io {

/// Name of a side of the ledger in files: energy, work, dissipated, scheme.
[[nodiscard]] std::string_view side_name(coupling::Side side);

/// Names of the monitors as names of groups: '/' becomes '_', an empty name "monitor", a repeated name gets a number.
[[nodiscard]] std::vector<std::string> monitor_names(const Model& model);

/// /history/<monitor>/{time, position, displacement, velocity, stress} and /energy/{time, one dataset per
/// ledger column, energy, closure, moved, passed}. Ledger columns have the attribute `side`;
/// closure = E - E_0 - W + D - R by those sides.
class HistoryWriter : public SeriesGroup<HistoryWriter> {
 public:
  HistoryWriter(const h5::Growing& in, const Model& model);
  /// Adds one row to every dataset.   @pre spans hold every monitor of the model; ledger is set
  void append(const coupling::HistoryView& history);

 private:
  friend SeriesGroup<HistoryWriter>;
  struct Monitor {
    h5::Series<double> time, position, displacement, velocity, stress;
  };
  template <class Visitor>
  void each(Visitor&& see) {
    for (Monitor& m : monitors_) see(m.position), see(m.displacement), see(m.velocity), see(m.stress), see(m.time);
    for (h5::Series<double>& column : columns_) see(column);
    see(energy_), see(closure_), see(moved_), see(passed_), see(time_);
  }
  std::vector<Monitor> monitors_;
  std::vector<h5::Series<double>> columns_;
  h5::Series<double> time_, energy_, closure_, moved_, passed_;
};

}  // namespace scree::io
