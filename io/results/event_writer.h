// Events and the books of every hand-over in the results file.
#pragma once

#include <array>

#include "coupling/sink.h"
#include "io/results/h5_series.h"

namespace scree::io {

/// /events/{time, kind, text} and /transfers/{time, block, from, to, before/..., after/..., errors}.
class EventWriter {
 public:
  explicit EventWriter(const h5::File& file);
  void append(const coupling::Event& event);
  void flush();
  void close();

 private:
  struct Totals {
    h5::Series<double> mass, centre, momentum, angular_momentum, kinetic, elastic;
    void append(const BodyTotals& totals);
  };
  template <class Visitor>
  void each(Visitor&& see);
  void append(const coupling::TransferRow& row);

  h5::Series<double> time_;
  h5::TextSeries kind_, text_;
  h5::Series<double> row_time_, reservoir_kinetic_, reservoir_elastic_, booked_;
  h5::Series<double> mass_error_, momentum_error_, angular_error_, energy_error_;
  h5::Series<std::int32_t> block_;
  h5::TextSeries from_, to_;
  std::array<Totals, 2> totals_;  // before, after
};

}  // namespace scree::io
