// Role of a method: internal force, lumped mass, damping and the bound of explicit steps.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/body.h"

namespace scree {

/// What an explicit step needs. Spans q, v, f, a hold two numbers (x, y) per node of the pool.
class ExplicitOperator {
 public:
  ExplicitOperator() = default;
  ExplicitOperator(const ExplicitOperator&) = delete;
  ExplicitOperator& operator=(const ExplicitOperator&) = delete;
  virtual ~ExplicitOperator() = default;

  /// f += internal force; returns the elastic energy of every body summed in a fixed order [J]. Not a number if q is
  /// not a possible position of a body (turned inside out); find_fault() then reports which body.
  virtual double internal_force(std::span<const double> q, std::span<double> f) const = 0;
  /// f += body force of a uniform acceleration.
  virtual void body_force(const Vec2& acceleration, std::span<double> f) const = 0;
  /// Moves forces on nodes that follow others to the nodes that they follow, so that each is the unbalanced force of a
  /// free node; the motion is the same.
  virtual void fold_forces(std::span<double> f) const { (void)f; }
  /// a = M^-1 f (f is not changed); the acceleration is compatible with the method's constraints.
  virtual void mass_solve(std::span<const double> q, std::span<const double> f, std::span<double> a) const = 0;
  /// p = M v on the nodes of one body; zero on nodes that follow others.   @param p  [kg m/s], else unchanged
  virtual void mass_apply(int body, std::span<const double> q, std::span<const double> v,
                          std::span<double> p) const = 0;
  /// 1/2 v^T M v, bodies in `counted` only (one flag per body).
  [[nodiscard]] virtual double kinetic_energy(std::span<const double> q, std::span<const double> v,
                                              std::span<const char> counted) const = 0;
  /// Corrects moved = q + h v, and the velocities with it, if the method's nodes rotate. The default changes neither.
  virtual void turn(double h, std::span<const double> q, std::span<double> v, std::span<double> moved) const;
  /// w *= factor, then f = -rate M w and a -= rate w; w = v minus its affine part: mass-proportional damping that
  /// does not act on rigid motion and sliding. Methods whose bodies are affine have no w, and f = 0.
  /// @param rate [1/s], w taken after the scaling
  /// @return f.along, summed in a fixed order
  virtual double damp(double factor, double rate, std::span<const double> along, std::span<double> v,
                      std::span<double> f, std::span<double> a) const;
  /// f -= rate times the tangent stiffness of the bodies applied to v: Rayleigh damping proportional to stiffness.
  /// Rigid motion is not damped.   @param rate [s]
  virtual void stiffness_damping(std::span<const double> q, std::span<const double> v, double rate,
                                 std::span<double> f) const;
  /// Largest eigenvalue of D^-1 K of a body's own stiffness, D the method's diagonal mass: a certified bound [1/s2].
  [[nodiscard]] virtual double frequency_bound(int body) const = 0;
  /// Element that determines frequency_bound(), with its position, for messages. Empty: the body as a whole.
  [[nodiscard]] virtual std::string binding(int body) const;
  /// theta: D <= theta M. Squared frequencies in M are at most theta times those in D.
  [[nodiscard]] virtual double mass_ratio(int body) const = 0;
  /// J D^-1 J^T of a row: the acceleration of the point per unit force on it [1/kg].
  [[nodiscard]] virtual double compliance(int body, const Row& row) const = 0;
  /// Groups of unknowns on which a row depends (covers; or the whole body): contacts that share a group are summed in
  /// the bound.
  virtual void bound_groups(int body, const Row& row, std::vector<std::int32_t>& groups) const = 0;
};

}  // namespace scree
