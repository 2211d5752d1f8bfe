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
  MotionId motion{};                 // of the incoming wave; invalid: none
  double upgoing = 1.0;              // factor of its velocity
};
/// @source [Lysmer1969]; c_p = sqrt((lambda + 2 mu)/rho) with the in-plane constants, c_s = sqrt(mu/rho)
[[nodiscard]] std::vector<Dashpot> dashpots(const Setup& setup, const State& state);

/// f += forces of the incoming waves at a time [s]: 2 (normal n n^T + shear t t^T) u at either end of a dashpot, n
/// normal to the segment at q, u the velocity of the wave.
void add_incoming_waves(const Setup& setup, std::span<const Dashpot> dashpots, double time, std::span<const double> q,
                        std::span<double> f);

/// f = -L/2 rho (c_p n n^T + c_s t t^T) v at either end, n normal to the segment as it is now, v the velocity of the
/// previous half step: lagged, which the step bound includes. At a compliant base the force of the incoming wave is
/// added; its work is booked as that of a load.
class ViscousEdges final : public ForceTerm {
 public:
  ViscousEdges(const Setup& setup, std::vector<Dashpot> dashpots) : setup_(&setup), dashpots_(std::move(dashpots)) {}
  void add(const Instant& at, std::span<double> f) override;
  void leave(double h, std::span<const double> v) override {
    work_ = half_work(h, v, force_);
    wave_work_ = half_work(h, v, wave_);
  }
  void arrive(double h, std::span<const double> v, Ledger& ledger) override {
    ledger.book(Column::viscous_edges, -work_ - half_work(h, v, force_));
    ledger.book(Column::loads, wave_work_ + half_work(h, v, wave_));
  }

 private:
  using EndForces = std::vector<std::array<Vec2, 2>>;  // per dashpot: at its two ends
  [[nodiscard]] double half_work(double h, std::span<const double> v, const EndForces& force) const;

  const Setup* setup_;
  std::vector<Dashpot> dashpots_;
  EndForces force_, wave_;
  double work_ = 0.0, wave_work_ = 0.0;
};

}  // namespace scree::coupling
