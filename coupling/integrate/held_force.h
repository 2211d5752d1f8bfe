// Forces that are constant between two instants, and then jump.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "coupling/integrate/force_term.h"

namespace scree::coupling {

/// Forces on nodes, x, y per node [N], that the caller holds constant: their work over any time is force times
/// displacement.
class HeldForce final : public ForceTerm {
 public:
  explicit HeldForce(std::vector<std::int32_t> nodes) : nodes_(std::move(nodes)), force_(2 * nodes_.size(), 0.0) {}

  [[nodiscard]] std::span<const double> force() const { return force_; }
  /// @param change  receives new less old forces, x, y per node of the state; zero elsewhere
  void take(std::span<const double> force, std::span<double> change) {
    for (std::size_t k = 0; k < force_.size(); ++k) {
      change[at(k)] += force[k] - force_[k];
      force_[k] = force[k];
    }
  }

  void add(const Instant&, std::span<double> f) override {
    for (std::size_t k = 0; k < force_.size(); ++k) f[at(k)] += force_[k];
  }
  void leave(double h, std::span<const double> v) override { work_ = half_work(h, v); }
  void arrive(double h, std::span<const double> v, Ledger& ledger) override {
    ledger.book(Column::interface_constraints, work_ + half_work(h, v));
  }

 private:
  [[nodiscard]] std::size_t at(std::size_t k) const { return 2 * static_cast<std::size_t>(nodes_[k / 2]) + k % 2; }
  [[nodiscard]] double half_work(double h, std::span<const double> v) const {
    double power = 0.0;
    for (std::size_t k = 0; k < force_.size(); ++k) power += force_[k] * v[at(k)];
    return 0.5 * h * power;
  }

  std::vector<std::int32_t> nodes_;
  std::vector<double> force_;
  double work_ = 0.0;
};

}  // namespace scree::coupling
