// The law of one bolt: forces for given lengths of its segments and shear displacements at its crossings.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/bolt_memory.h"
#include "model/bolt.h"

namespace scree::coupling {

/// The slips s of the bar's nodes are those that balance it:
///   N_j = law(k_j (l_j - rest_j + s_{j+1} - s_j - plastic_j)),  T_i = law(b_i (s_i - slipped_i)),
///   N_i - N_{i-1} - T_i = 0 at every node that is not held,
/// both laws linear up to their strength and plastic there. That is the minimum of a convex function of s, found by
/// Newton's method. The force on the rock along segment j is N_j for any bond force, because the bar has no mass.
/// A liner is held at all nodes, so that no s are unknown; its turns take the place of shears.
/// Plastic parts follow by the implicit Euler rule: what they dissipate is N d(plastic) + T d(slipped) + Q d(sheared).
/// @source docs/theory/bolts.md, "The bar in its grout"
class BoltResponse {
 public:
  explicit BoltResponse(const Bolt& bolt);

  /// @param before  at the start of the step   @param lengths  per segment [m]   @param shears  per crossing [m]
  /// @param after   at the end of the step; must not be `before`. Nothing breaks here.
  /// @return false: the slips were not found, as with numbers that are not finite
  bool solve(const BoltMemory& before, std::span<const double> lengths, std::span<const double> shears,
             BoltMemory& after);
  /// dN_j/dl_m of the last solve(): symmetric, positive semi-definite [N/m].
  void tangent(const BoltMemory& after, Eigen::MatrixXd& out);
  /// True if the slopes of the tangent at the last solve() are not those given, which are then replaced.
  [[nodiscard]] bool tangent_changed(std::vector<double>& slopes, const BoltMemory& after);
  /// dQ/d(shear) of a crossing after the last solve() [N/m].
  [[nodiscard]] double shear_tangent(std::size_t crossing) const { return shear_slope_[crossing]; }
  /// Half of the sum of squares of the elastic changes times stiffness between two states, and the jump of a slack
  /// segment as it is pulled tight: the damping of implicit Euler beside the dissipation [J].
  [[nodiscard]] double elastic_change(const BoltMemory& before, const BoltMemory& after) const;
  /// Pulls the head to the pretension while the rock does not move: sets `rest`, slips and forces.
  void install(std::span<const double> lengths, std::span<const double> shears, BoltMemory& memory);
  /// Marks segments as broken whose plastic elongation, or shear at a crossing, has passed its rupture value.
  /// @return true if one was; solve() then finds the forces of the rest
  [[nodiscard]] bool rupture(BoltMemory& memory) const;

 private:
  [[nodiscard]] bool held(std::size_t node) const { return bolt_->nodes[node].length == 0.0; }
  [[nodiscard]] double bond_stiffness(std::size_t node) const {
    return bolt_->bond_stiffness * bolt_->nodes[node].length;
  }
  [[nodiscard]] double bond_strength(std::size_t node) const {
    return bolt_->bond_strength * bolt_->nodes[node].length;
  }
  [[nodiscard]] bool carries(std::size_t segment) const { return broken_[segment] == 0; }
  /// True if the segment of a crossing carries, or both segments of a turn.
  [[nodiscard]] bool carries_across(std::size_t c) const;
  /// Forces and slopes of the trial slips; returns the largest unbalanced force of a free node [N].
  double evaluate(const BoltMemory& before, std::span<const double> lengths);
  /// Error of a segment's force from round-off of slips and lengths [N].
  [[nodiscard]] double round_off(const BoltMemory& before, std::span<const double> lengths) const;
  /// Sets the slips to old_ plus `part` of the Newton step.   @return the largest unbalanced force there [N]
  double go(double part, const BoltMemory& before, std::span<const double> lengths);
  /// Finds the minimum along the Newton step by bisection.   @return the largest unbalanced force there [N]
  double search(const BoltMemory& before, std::span<const double> lengths);
  /// step_ = -H^-1 residual, H tridiagonal.
  void newton_step();
  void shear_forces(const BoltMemory& before, std::span<const double> shears, BoltMemory& after);

  const Bolt* bolt_;
  double pulled_ = -1.0;  // force in place of the slack segment while the head is pulled; < 0: none [N]
  std::span<const std::int8_t> broken_;
  std::vector<double> k_;  // per segment [N/m]
  std::vector<double> slip_, force_, slope_, bond_, bond_slope_, residual_, step_, shear_slope_, old_;
  std::vector<double> diagonal_, scratch_;
};

/// The elastic energy of a bolt with its present forces [J].
[[nodiscard]] double bolt_energy(const Bolt& bolt, const BoltMemory& memory);

}  // namespace scree::coupling
