// Unknowns, masses and stiffnesses of all free bodies in an implicit step.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "coupling/bodies/setup.h"
#include "coupling/linear/dof_rows.h"
#include "coupling/linear/symmetric_pattern.h"

namespace scree::coupling {

/// Numbers the unknowns of free bodies and sums their element matrices on one pattern, found once per stage.
class ImplicitSystem {
 public:
  explicit ImplicitSystem(const Setup& setup);

  [[nodiscard]] std::int32_t dofs() const { return dofs_; }
  /// -1: the body is driven.
  [[nodiscard]] std::int32_t first_dof(std::size_t body) const { return first_dof_[body]; }
  [[nodiscard]] std::int32_t first_dof(BodyIndex body) const { return first_dof_[body.index()]; }
  /// 1 for unknowns of bodies whose force is not linear, else 0.
  [[nodiscard]] std::span<const double> nonlinear_dofs() const { return nonlinear_dof_; }
  /// Body of an unknown.
  [[nodiscard]] BodyIndex body_of(std::int32_t dof) const;
  [[nodiscard]] const SymmetricPattern& pattern() const { return pattern_; }
  [[nodiscard]] bool nonlinear() const { return nonlinear_; }
  /// True if every free body has six unknowns, all coupled, and forces that are linear in them: an affine block, or one
  /// cover around a whole block with linear kinematics.
  [[nodiscard]] bool affine() const { return affine_; }
  /// True if masses in the unknowns are the same at every state.
  [[nodiscard]] bool constant_charts() const { return constant_charts_; }

  /// Finds the units below from the bodies in their reference positions.
  void find_units(std::span<const double> reference);
  /// Largest displacement of the body's outline per unit of an unknown: 1 for a displacement, a length for a
  /// rotation or a strain. A force on the unknown divided by it is in newtons.
  [[nodiscard]] std::span<const double> unit() const { return unit_; }
  /// Masses and velocities in the unknowns at a state.
  void compute_masses(std::span<const double> q, std::span<const double> v);
  /// Stiffness and internal force of the bodies whose force is not linear, or of all.
  /// @param K      numbers on the pattern; empty: only the force
  /// @param force  one number per unknown
  /// @return elastic energy of the bodies whose force is not linear [J]
  double linearise(std::span<const double> q, Stiffness kind, bool all, std::span<double> K, std::span<double> force);
  [[nodiscard]] std::span<const double> mass() const { return mass_; }
  [[nodiscard]] std::span<const double> rate() const { return rate_; }

  /// A row of a free body in the unknowns.   @param q  positions at the start of the step
  [[nodiscard]] ChartRow chart(BodyIndex body, const Row& row, std::span<const double> q) const;
  /// The last row += c.(displacement of the point).
  static void add_point(const ChartRow& point, const Vec2& c, DofRows& out) {
    constexpr std::size_t kAffine = 6;  // unknowns of an affine body, in order
    bool run = point.n == kAffine;
    for (std::size_t k = 1; run && k < kAffine; ++k) run = point.dof[k] == point.dof[k - 1] + 1;
    if (run) {
      std::array<double, kAffine> h{};
      for (std::size_t k = 0; k < kAffine; ++k) h[k] = c.x() * point.tx[k] + c.y() * point.ty[k];
      out.add_run(point.dof[0], h);
      return;
    }
    for (std::size_t k = 0; k < static_cast<std::size_t>(point.n); ++k)
      out.add(point.dof[k], c.x() * point.tx[k] + c.y() * point.ty[k]);
  }
  /// out += forces on nodes, in the unknowns.   @param f  x, y per node of the state's arrays
  void add_forces(std::span<const double> f, std::span<const double> q, std::span<double> out) const;
  /// Accelerations of the free bodies' nodes in the unknowns, and back.   @pre constant charts
  void accelerations(std::span<const double> q, std::span<const double> nodes, std::span<double> dofs) const;
  void node_accelerations(std::span<const double> dofs, std::span<double> nodes) const;
  /// q, v of the free bodies, or only of those whose force is not linear.
  void retract(std::span<const double> d, std::span<const double> rate, bool all, std::span<double> q,
               std::span<double> v) const;

 private:
  [[nodiscard]] bool takes(std::size_t body, bool all) const {
    return first_dof_[body] >= 0 && (all || nonlinear_body_[body] != 0);
  }
  /// of(body) for the free bodies, or only for those whose force is not linear; on threads if all are affine.
  template <class Of>
  void for_bodies(bool all, Of&& of) const;
  /// Scratch for the lower triangles of a body's elements.
  [[nodiscard]] std::span<double> values_of(std::size_t body) {
    return std::span(scratch_).subspan(first_value_[body], first_value_[body + 1] - first_value_[body]);
  }
  void scatter(std::size_t body, std::span<const double> values, std::span<double> out) const;
  /// Sets the numbers of a body's columns to zero: bodies share no unknown, and its columns hold nothing else.
  void clear_columns(std::size_t first, std::size_t n, std::span<double> values) const;

  const Setup* setup_;
  std::vector<std::int32_t> first_dof_;   // per body
  std::vector<char> nonlinear_body_;      // per body
  std::vector<std::size_t> first_value_;  // per body: into place_
  std::int32_t dofs_ = 0;
  bool nonlinear_ = false, constant_charts_ = true, affine_ = true;
  bool has_masses_ = false;  // those of bodies with constant charts stay
  SymmetricPattern pattern_;
  std::vector<std::int32_t> place_;  // of every number of the lower triangles, body after body
  std::vector<double> mass_, rate_, nonlinear_dof_, unit_;
  std::vector<double> scratch_;  // a number for each in place_
};

}  // namespace scree::coupling
