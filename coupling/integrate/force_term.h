// A force in explicit steps, with its place in the ledger. All forces are applied through it, except contacts, the
// stress inside the bodies and weights, which the integrator sums in its own loops.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coupling/integrate/point_springs.h"
#include "coupling/ledger/ledger.h"

namespace scree::coupling {

/// What a force may depend on.
struct Instant {
  std::span<const double> q;
  std::span<const double> v;  // at the half step before the instant: explicit damping uses it, lagged
  double t = 0.0;             // [s]
};

/// A force on some nodes of free bodies. A step calls leave(), add() at its end, arrive(); its work is the trapezoid
/// u.(f_n + f_{n+1})/2, one half per call.
class ForceTerm {
 public:
  ForceTerm() = default;
  ForceTerm(const ForceTerm&) = delete;
  ForceTerm& operator=(const ForceTerm&) = delete;
  virtual ~ForceTerm() = default;
  /// f += force at an instant. A repeated call at the same instant adds the same force.
  virtual void add(const Instant& at, std::span<double> f) = 0;
  /// Takes the first half, h/2 v.f with the force last added.   @param v  velocity of the step that begins
  virtual void leave(double h, std::span<const double> v) = 0;
  /// Takes the second half with the force added since, and books the step.
  virtual void arrive(double h, std::span<const double> v, Ledger& ledger) = 0;
};

class PointSupports final : public ForceTerm {
 public:
  explicit PointSupports(std::vector<PointSpring> springs) : springs_(std::move(springs)) {}
  void add(const Instant& at, std::span<double> f) override;
  void leave(double h, std::span<const double> v) override { work_ = half_work(h, v); }
  void arrive(double h, std::span<const double> v, Ledger& ledger) override;

 private:
  [[nodiscard]] double half_work(double h, std::span<const double> v) const;

  std::vector<PointSpring> springs_;
  std::vector<Vec2> force_;  // per spring
  double energy_ = 0.0, work_ = 0.0;
};

}  // namespace scree::coupling
