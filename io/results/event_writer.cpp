#include "io/results/event_writer.h"

namespace scree::io {

EventWriter::EventWriter(const h5::Growing& in)
    : time_(in, "/events/time", 1, {"s", "time of the event"}),
      kind_(in, "/events/kind", {"none", "kind of the event"}),
      text_(in, "/events/text", {"none", "what happened"}) {
  const std::string t = "/transfers/";
  row_time_ = {in, t + "time", 1, {"s", "time of the hand-over"}};
  block_ = {in, t + "block", 1, {"1", "block, counted from 0 in /blocks"}};
  from_ = {in, t + "from", {"none", "method before"}};
  to_ = {in, t + "to", {"none", "method after"}};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string when = i == 0 ? "before" : "after", g = t + when + "/", end = " " + when + " the hand-over";
    totals_[i].mass = {in, g + "mass", 1, {"kg", "mass for unit thickness" + end}};
    totals_[i].centre = {in, g + "centre", 2, {"m", "centre of mass x, y" + end}};
    totals_[i].momentum = {in, g + "momentum", 2, {"kg m/s", "momentum x, y for unit thickness" + end}};
    totals_[i].angular_momentum = {
        in, g + "angular_momentum", 1, {"kg m2/s", "angular momentum about the origin" + end}};
    totals_[i].kinetic = {in, g + "kinetic", 1, {"J", "kinetic energy for unit thickness" + end}};
    totals_[i].elastic = {in, g + "elastic", 1, {"J", "elastic energy for unit thickness" + end}};
  }
  reservoir_kinetic_ = {in, t + "reservoir_kinetic", 1, {"J", "kinetic energy kept in the block's reservoir"}};
  reservoir_elastic_ = {in, t + "reservoir_elastic", 1, {"J", "elastic energy kept in the block's reservoir"}};
  booked_ = {in, t + "booked", 1, {"J", "energy booked in the ledger column transfer"}};
  mass_error_ = {in, t + "mass_error", 1, {"1", "relative error of mass"}};
  momentum_error_ = {in, t + "momentum_error", 1, {"1", "relative error of momentum"}};
  angular_error_ = {in, t + "angular_error", 1, {"1", "relative error of angular momentum about the block's centre"}};
  energy_error_ = {in, t + "energy_error", 1, {"1", "relative error of energy with reservoir and booked"}};
  by_rule_ = {in, t + "by_rule", 1, {"1", "1: during a stage, by its rules for methods; 0: as a stage begins"}};
  const std::string m = t + "measures/";
  measures_[0] = {in, m + "kinetic", 1, {"1", "kinetic energy beside the affine motion over the block's energy"}};
  measures_[1] = {in, m + "elastic", 1, {"1", "elastic energy beside the affine stress over the block's energy"}};
  measures_[2] = {in, m + "inhomogeneity", 1, {"1", "root of that part of the elastic energy"}};
  measures_[3] = {in, m + "strain_rate", 1, {"1/s", "largest principal strain rate of the affine motion"}};
  measures_[4] = {in, m + "stress", 1, {"Pa", "largest principal stress of the affine part, without its sign"}};
  measures_[5] = {in, m + "acceleration", 1, {"m/s2", "resultant of the contact forces over the mass"}};
  measures_[6] = {
      in, m + "cost_before", 1, {"1", "predicted cost before: unknowns a step, explicit a second; 0: not asked"}};
  measures_[7] = {in, m + "cost_after", 1, {"1", "predicted cost after, likewise"}};
}

void EventWriter::Totals::append(const BodyTotals& totals) {
  mass.append(totals.mass);
  centre.append(std::span(totals.centre.data(), 2));
  momentum.append(std::span(totals.momentum.data(), 2));
  angular_momentum.append(totals.angular_momentum);
  kinetic.append(totals.kinetic);
  elastic.append(totals.elastic);
}

void EventWriter::append(const coupling::Event& event) {
  time_.append(event.time);
  kind_.append(std::string(coupling::name(event.kind)));
  text_.append(event.text);
  if (event.transfer != nullptr) append(*event.transfer);
}

void EventWriter::append(const coupling::TransferRow& row) {
  row_time_.append(row.time);
  block_.append(row.block.value);
  from_.append(row.from);
  to_.append(row.to);
  totals_[0].append(row.before);
  totals_[1].append(row.after);
  reservoir_kinetic_.append(row.reservoir_kinetic);
  reservoir_elastic_.append(row.reservoir_elastic);
  booked_.append(row.booked);
  mass_error_.append(row.mass_error);
  momentum_error_.append(row.momentum_error);
  angular_error_.append(row.angular_error);
  energy_error_.append(row.energy_error);
  by_rule_.append(row.by_rule ? 1 : 0);
  const coupling::MethodMeasures& m = row.measures;
  const std::array<double, 8> measures{m.kinetic, m.elastic,      m.inhomogeneity, m.strain_rate,
                                       m.stress,  m.acceleration, m.cost_before,   m.cost_after};
  for (std::size_t i = 0; i < measures.size(); ++i) measures_[i].append(measures[i]);
}

}  // namespace scree::io
