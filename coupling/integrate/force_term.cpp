#include "coupling/integrate/force_term.h"

#include "model/parallel.h"

namespace scree::coupling {

void InternalForce::add(std::span<const double> q, double, std::span<double> f) {
  energy_ = 0.0;
  for (std::size_t p = 0; p < setup_->pools(); ++p)
    energy_ += setup_->pool(p).internal_force(setup_->part(q, p), setup_->part(f, p));
}

void InternalForce::book(double free, double driven, Ledger& ledger) {
  const double change = energy_ - ledger[Column::elastic];
  ledger.set(Column::elastic, energy_);
  ledger.book(Column::elastic_trapezoid, change + free + driven);
  ledger.book(Column::prescribed_motion, -driven);
}

Gravity::Gravity(const Setup& setup) : weight_(2 * static_cast<std::size_t>(setup.nodes()), 0.0) {
  for (std::size_t p = 0; p < setup.pools(); ++p)
    setup.pool(p).body_force(setup.model().gravity, setup.part(std::span<double>(weight_), p));
}

void Gravity::add(std::span<const double>, double, std::span<double> f) {
  parallel_for(static_cast<std::int64_t>(weight_.size()),
               [&](std::int64_t i) { f[static_cast<std::size_t>(i)] += weight_[static_cast<std::size_t>(i)]; });
}

void Gravity::book(double free, double, Ledger& ledger) { ledger.book(Column::gravity, free); }

void PointSupports::add(std::span<const double> q, double, std::span<double> f) {
  energy_ = 0.0;
  for (const PointSpring& s : springs_) {
    add_force(s.row, spring_force(s, q), f);
    energy_ += spring_energy(s, q);
  }
}

void PointSupports::book(double free, double, Ledger& ledger) {
  const double change = energy_ - ledger[Column::support_springs];
  ledger.set(Column::support_springs, energy_);
  ledger.book(Column::support_trapezoid, change + free);
}

}  // namespace scree::coupling
