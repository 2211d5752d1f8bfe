// The data of a finished run that measures need: plain data, so that several runs can be compared.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "coupling/stages/driver.h"

namespace scree::app {

/// Components of a monitor: position, displacement, velocity, recovered stress, and the magnitudes u and v.
[[nodiscard]] const std::vector<std::string>& components();

/// One monitor through a run, one number per sample.
struct MonitorHistory {
  std::string name;
  std::vector<Vec2> position, displacement, velocity;  // positions in the coordinates of the case
  std::vector<Eigen::Vector3d> stress;                 // xx, yy, xy [Pa]; not a number where the run has none

  /// @pre the component is one of components()
  [[nodiscard]] std::vector<double> component(std::string_view wanted) const;
};

struct RunRecord {
  coupling::RunEnd end;
  std::string refused;  // why the plan was refused; empty: it was carried out
  std::uint64_t hash = 0;
  std::vector<double> time;  // of the samples [s]
  std::vector<MonitorHistory> monitors;
  std::vector<Vec2> moved;  // displacement of each free block's centre from its position in the model [m]
  std::vector<coupling::StageTravel> travels;
  std::vector<coupling::TransferRow> transfers;
  coupling::Ledger ledger;
  coupling::RunStats stats;
  double stepping = 0.0;           // processor time of the steps, the least of the repeats [s]
  double stepping_implicit = 0.0;  // as `stepping`, of implicit and partitioned stages [s]
  double wall = 0.0;               // of everything, all repeats [s]
  double least_wall = 0.0;         // of one repeat, the least [s]

  [[nodiscard]] bool done() const { return refused.empty() && end.status == coupling::RunEnd::Status::done; }
  /// Why the run has no measures; empty if it has.
  [[nodiscard]] std::string trouble() const { return refused.empty() ? end.reason : refused; }
  [[nodiscard]] const MonitorHistory* monitor(std::string_view name) const;
};

/// Runs a plan once, writing nothing, with the number of threads of the plan if it sets one.
[[nodiscard]] RunRecord record_run(const Model& model, const coupling::Plan& plan);

}  // namespace scree::app
