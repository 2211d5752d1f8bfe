// Damping of the deformation of sliding blocks in the unknowns of an implicit step.
#pragma once

#include <span>
#include <vector>

#include "coupling/integrate/low_rank.h"
#include "coupling/unknowns/implicit_system.h"

namespace scree::coupling {

/// C = a (M - M R (R^T M R)^-1 R^T M) of every body with a rate a > 0, R its rigid motions: mass-proportional damping
/// of the velocities less their rigid part (SlidingDamping). M R (R^T M R)^-1 R^T M is dense on a body: part of the
/// matrix where the pattern of the body is full, as for affine bodies, else a term of rank three beside it.
class DeformationDamping {
 public:
  /// @param setup,system  must outlive it
  DeformationDamping(const Setup& setup, const ImplicitSystem& system);

  /// Finds C at the start of a step.   @pre system.compute_masses() at the same state
  /// @param rates   per body [1/s]
  /// @param factor  of C in the matrix of the step [1/s]
  void find(std::span<const double> q, std::span<const double> rates, double factor);
  /// Ends the damping of all bodies.
  void clear() {
    bodies_.clear();
    terms_.clear();
  }
  [[nodiscard]] bool acts() const { return !bodies_.empty(); }
  /// A += factor C on the pattern; terms() returns the rest.
  void add_matrix(std::span<double> A) const;
  /// The part that does not fit the pattern; valid until the next find().
  [[nodiscard]] std::span<const LowRank> terms() const { return terms_; }
  /// out += factor C rate.
  void add_force(double factor, std::span<const double> rate, std::span<double> out) const;

 private:
  struct Damped {
    std::size_t first = 0, count = 0;                   // unknowns in which C has rows
    double rate = 0.0;                                  // [1/s]
    bool full = false;                                  // its pattern is full
    std::size_t momenta = 0;                            // into momenta_: M R, three columns
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();  // (R^T M R)^-1
  };
  /// y += factor M x on the rows of C of a body.
  void multiply(const Damped& b, double factor, std::span<const double> x, std::span<double> y) const;

  const Setup* setup_;
  const ImplicitSystem* system_;
  double factor_ = 0.0;
  std::vector<Damped> bodies_;
  std::vector<double> momenta_;
  std::vector<LowRank> terms_;
  std::vector<double> x_, y_, turn_, rates_, product_, motion_;  // scratch
};

}  // namespace scree::coupling
