#include "coupling/integrate/force_term.h"

namespace scree::coupling {

void PointSupports::add(const Instant& at, std::span<double> f) {
  energy_ = 0.0;
  force_.resize(springs_.size());
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    force_[i] = spring_force(springs_[i], at.q);
    add_force(springs_[i].row, force_[i], f);
    energy_ += spring_energy(springs_[i], at.q);
  }
}

double PointSupports::half_work(double h, std::span<const double> v) const {
  double power = 0.0;
  for (std::size_t i = 0; i < springs_.size(); ++i) power += force_[i].dot(position(springs_[i].row, v));
  return 0.5 * h * power;
}

void PointSupports::arrive(double h, std::span<const double> v, Ledger& ledger) {
  const double change = energy_ - ledger[Column::support_springs];
  ledger.set(Column::support_springs, energy_);
  ledger.book(Column::support_trapezoid, change + work_ + half_work(h, v));
}

}  // namespace scree::coupling
