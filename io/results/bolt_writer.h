// Bolts in the results file.
#pragma once

#include <vector>

#include "coupling/sink.h"
#include "io/results/series_group.h"

namespace scree::io {

/// /bolts/<name>/{time, force, shear, slip, plastic_strain, broken} and /liners/<name>/{time, thrust, moment,
/// plastic_strain, broken}, with rows at the times of the monitors; and, for every frame, the nodes of the installed
/// bolts: /bolt_nodes/{bolt, position, force} and /bolt_nodes/frames/{first, count}, one row per frame. The nodes of
/// frame k are the rows first[k] to first[k] + count[k] - 1.
class BoltWriter : public SeriesGroup<BoltWriter> {
 public:
  BoltWriter(const h5::File& file, const Model& model);
  void append(const coupling::HistoryView& history);
  void frame(const coupling::FrameView& frame);

 private:
  friend SeriesGroup<BoltWriter>;
  struct Bolt {
    h5::Series<double> time, force, shear, slip, strain;  // for a liner: force = thrust, shear = moment, no slip
    h5::Series<std::int32_t> broken;
    bool liner = false;
  };
  void add_liner(const h5::File& file, const scree::Bolt& liner, std::size_t index);
  template <class Visitor>
  void each(Visitor&& see) {
    // The rows are written before the datasets that refer to them.
    for (Bolt& b : bolts_) {
      see(b.force), see(b.shear);
      if (!b.liner) see(b.slip);
      see(b.strain), see(b.broken), see(b.time);
    }
    see(bolt_), see(position_), see(force_);
    see(first_), see(count_);
  }

  std::vector<Bolt> bolts_;
  h5::Series<std::int32_t> bolt_;
  h5::Series<double> position_, force_;
  h5::Series<std::int64_t> first_, count_;
};

/// Columns of history.csv for a model's bolts, after those of the monitors: names and units.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> bolt_columns(const Model& model);
/// Appends the values of these columns to a row.
void add_bolt_values(const coupling::HistoryView& history, std::vector<double>& row);

}  // namespace scree::io
