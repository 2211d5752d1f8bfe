// Edges that absorb waves, in explicit steps.
#pragma once

#include <array>
#include <vector>

#include "coupling/integrate/edge_stretch.h"
#include "coupling/integrate/force_term.h"

namespace scree::coupling {

/// A stretch of a viscous edge: a dashpot at each of its ends, with half the length.
struct Dashpot {
  EdgeStretch stretch;
  double normal = 0.0, shear = 0.0;  // of one end: rho c_p L/2, rho c_s L/2 [N s/m]
};
/// @source [Lysmer1969]; c_p = sqrt((lambda + 2 mu)/rho) with the in-plane constants, c_s = sqrt(mu/rho)
[[nodiscard]] std::vector<Dashpot> dashpots(const Setup& setup, const State& state);

/// f = -L/2 rho (c_p n n^T + c_s t t^T) v at either end, n normal to the segment as it is now, v the velocity of the
/// half step before: lagged, which the step bound knows.
class ViscousEdges final : public ForceTerm {
 public:
  explicit ViscousEdges(std::vector<Dashpot> dashpots) : dashpots_(std::move(dashpots)) {}
  void add(const Instant& at, std::span<double> f) override;
  void leave(double h, std::span<const double> v) override { work_ = half_work(h, v); }
  void arrive(double h, std::span<const double> v, Ledger& ledger) override {
    ledger.book(Column::viscous_edges, -work_ - half_work(h, v));
  }

 private:
  [[nodiscard]] double half_work(double h, std::span<const double> v) const;

  std::vector<Dashpot> dashpots_;
  std::vector<std::array<Vec2, 2>> force_;  // a dashpot: at its two ends
  double work_ = 0.0;
};

}  // namespace scree::coupling
