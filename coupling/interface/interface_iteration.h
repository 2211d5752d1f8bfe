// The interface force in an implicit step: its prediction, its evaluation, and the impulse of the remaining residual.
#pragma once

#include <span>
#include <vector>

#include "coupling/interface/interface_force.h"
#include "coupling/ledger/ledger.h"
#include "coupling/linear/cholesky.h"
#include "coupling/linear/fixed_point.h"
#include "coupling/unknowns/implicit_system.h"
#include "coupling/unknowns/step_springs.h"

namespace scree::coupling {

/// Iterates between the balance of an implicit step, which uses a predicted interface force, and the force of the other
/// side on the path to the balanced end. The prediction is linear in the end of the path:
///   predicted + K_s (d - d_at) + C C^T (u - u_at),
/// K_s of InterfaceForce::springs(), C of constraint_factor(), u the constrained nodes.
/// @source docs/theory/explicit-implicit-coupling.md, "Partitioned steps"
class InterfaceIteration {
 public:
  /// @param setup,system  of the implicit side; must outlive it
  InterfaceIteration(const Setup& setup, const ImplicitSystem& system) : setup_(&setup), system_(&system) {}

  /// Force that acts in every step from now on; null: none. It must outlive the steps.
  void set(InterfaceForce* force);
  [[nodiscard]] bool acts() const { return force_ != nullptr; }

  /// An iterate of the step.
  struct Iterate {
    std::span<const double> start;  // x, y per node at the start of the step [m]
    std::span<const double> d;      // change of the unknowns
    std::span<const double> end;    // x, y per node at this change [m]
  };

  /// Appends the springs that stand for the tangent of the force and of the interface constraints.
  /// @param q  x, y per node at the start of the step [m]   @param driven_move  per body [m]
  /// @param springs  must outlive the step
  void add_springs(std::span<const double> q, std::span<const Vec2> driven_move, StepSprings& springs);
  /// True where interface constraints act in the step.   @pre add_springs()
  [[nodiscard]] bool constrained() const { return rows_.size() != 0; }
  /// Begins the iteration of a step at its first iterate.
  /// @param use_kept  the iterates of accepted steps speed up this iteration
  void begin(const Iterate& at, bool use_kept);
  /// After an accepted step: later ones may use its iterates.
  void accept() { fixed_point_.accept(); }
  [[nodiscard]] FixedPoint::Kept& kept() { return fixed_point_.kept(); }
  /// Predicts the force, unless evaluate() would follow in any case: where the iterate has moved so little that the
  /// force cannot have changed by more than is allowed, and where the first one of a step is a balance and has moved so
  /// little that the force of the stiffest spring has changed by at most half of that.
  /// @param allowed  mismatch of the force [N]   @param first  iterate of the step, a balance
  /// @return false: it has to be evaluated
  [[nodiscard]] bool predict_where_useful(const Iterate& at, double allowed, bool first);
  /// Where the force was predicted for this iterate, or for one that hardly differs, the error of the prediction is
  /// kept and added to later ones.
  /// @return a status other than ok where the other side cannot follow the path
  [[nodiscard]] StepReport evaluate(const Iterate& at);
  /// Largest component of corrected less predicted force [N].
  /// @param left  residual of the balance, per unknown [N]: joins the residual whose impulse kick() applies
  [[nodiscard]] double residual(std::span<const double> left);
  /// The next force to balance, after an iterate that is no balance with the last one.   @param at  that iterate
  void next(const Iterate& at);
  /// Predicted force with the constraint forces, in the unknowns [N].
  [[nodiscard]] std::span<const double> predicted() const { return predicted_unknowns_force_; }
  /// Largest of the force and the constraint forces [N].
  [[nodiscard]] double largest() const;

  /// Applies the impulse of the remaining residual: rate += M^-1 h (residual).
  void kick(double h, std::span<double> rate);
  /// Books the work of the force in an accepted step.   @param rate  of the unknowns at its end
  void book(const Iterate& at, double h, std::span<const double> rate, Ledger& ledger) const;

 private:
  /// @return false: the force can only be evaluated
  [[nodiscard]] bool predict(const Iterate& at);
  void apply(const Iterate& at);
  /// Largest change of an unknown since the force was last evaluated or predicted, as a displacement [m].
  [[nodiscard]] double largest_change(std::span<const double> d) const;
  void find_along(std::span<const double> d);
  void find_predictor_error(const Iterate& at);
  void sum_predicted();
  /// out -= C C^T u of the interface constraints; `half` is C^T u.
  void subtract_constraint_forces(std::span<const double> half, std::span<double> out) const;

  const Setup* setup_;
  const ImplicitSystem* system_;
  InterfaceForce* force_ = nullptr;
  const StepSprings* springs_ = nullptr;
  std::size_t first_spring_ = 0, first_constraint_spring_ = 0;  // into springs_
  FixedPoint fixed_point_;
  std::vector<double> nodes_;  // mean force of the step, x, y per node [N]
  // One component per unknown. mean_: the mean force of the step; predicted_: the same plus the forces of the springs,
  // as the linear system uses it, followed by the constraint forces; corrected_: the values evaluated at the iterate,
  // in the same layout; mismatch_: corrected_ less predicted_ plus the residual of the balance.
  std::vector<double> mean_, predicted_, corrected_, mismatch_, kick_;
  bool foreseen_ = false;                         // mean_ is a prediction
  bool unforeseen_ = false;                       // mean_ was evaluated where a prediction would have been possible
  std::vector<double> predictor_;                 // mean_ as InterfaceForce::foresee() predicted it
  std::vector<double> evaluated_;                 // scratch of find_predictor_error(): corrected_
  std::vector<double> predictor_error_;           // evaluated less predicted
  std::vector<double> evaluated_at_;              // iterate at which mean_ was evaluated
  std::vector<double> predicted_unknowns_force_;  // predicted_ with the constraint forces added to the unknowns
  std::vector<double> units_;                     // scale of each component of predicted_
  DofRows rows_;                                  // of the constrained nodes, x, y per interface constraint
  std::vector<double> held_, apart_, along_;      // per constraint component: force, gap at the end, C^T u
  Cholesky mass_factor_;
  bool mass_made_ = false;
  std::vector<double> impulse_;
};

}  // namespace scree::coupling
