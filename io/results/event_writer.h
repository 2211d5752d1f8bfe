// Events and the balances of every transfer in the results file.
#pragma once

#include <array>

#include "coupling/sink.h"
#include "io/results/series_group.h"

namespace scree::io {

/// /events/{time, kind, text} and /transfers/{time, block, from, to, before/..., after/..., errors, by_rule,
/// measures/...}.
class EventWriter : public SeriesGroup<EventWriter> {
 public:
  explicit EventWriter(const h5::Growing& in);
  void append(const coupling::Event& event);

 private:
  friend SeriesGroup<EventWriter>;
  struct Totals {
    h5::Series<double> mass, centre, momentum, angular_momentum, kinetic, elastic;
    void append(const BodyTotals& totals);
  };
  template <class Visitor>
  void each(Visitor&& see) {
    see(kind_), see(text_), see(time_);
    for (Totals& t : totals_)
      see(t.mass), see(t.centre), see(t.momentum), see(t.angular_momentum), see(t.kinetic), see(t.elastic);
    see(block_), see(from_), see(to_), see(reservoir_kinetic_), see(reservoir_elastic_), see(booked_);
    see(mass_error_), see(momentum_error_), see(angular_error_), see(energy_error_), see(row_time_);
    see(by_rule_);
    for (h5::Series<double>& m : measures_) see(m);
  }
  void append(const coupling::TransferRow& row);

  h5::Series<double> time_;
  h5::TextSeries kind_, text_;
  h5::Series<double> row_time_, reservoir_kinetic_, reservoir_elastic_, booked_;
  h5::Series<double> mass_error_, momentum_error_, angular_error_, energy_error_;
  h5::Series<std::int32_t> block_, by_rule_;
  std::array<h5::Series<double>, 8> measures_;  // of changes by a rule, else 0
  h5::TextSeries from_, to_;
  std::array<Totals, 2> totals_;  // before, after
};

}  // namespace scree::io
