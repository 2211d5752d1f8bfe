// Explicit and implicit bodies in one step.
#pragma once

#include <memory>

#include "coupling/integrate/central_difference.h"
#include "coupling/integrate/newmark.h"
#include "coupling/integrate/step_rollback.h"
#include "coupling/interface/interface_force.h"

namespace scree::coupling {

/// Moves some bodies by central difference in m steps of h, the others by Newmark's method in one of H = m h, with all
/// contacts between them:
///   1. In substep j of the explicit side the implicit bodies are at x_n + (j/m) u; contact is evaluated in each.
///   2. On the implicit side the mean force (1/m)[f_0/2 + f_1 + ... + f_m/2] of those contacts acts over the step H.
///   3. u is found so that both hold: the substeps are repeated within Newton's method (InterfaceForce, FixedPoint).
/// Impulses on both sides are equal and opposite, and so is the work, whatever u: momentum is exact and the ledger has
/// no term of its own. Stable under the explicit bound with the implicit bodies fixed, whatever H and their mass.
/// Contacts among implicit bodies are those of Newmark's open-close iteration, or all are evaluated at the substeps.
/// The two halves of a divided block are one continuum: nodes at one place (Pool::interface_constraints) are held
/// together by forces that are constant through H, equal and opposite, and such that both have the same displacement
/// over H. They do no work and the nodes do not drift apart. All contacts of a divided block belong to the explicit
/// side.
/// @source docs/theory/explicit-implicit-coupling.md, "Partitioned steps";
///         docs/theory/explicit-implicit-coupling.md, "Divided blocks"; [Qu2013] 6.3, ch. 7, 7.2.2
class Partitioned final : public TimeIntegrator, private InterfaceForce {
 public:
  struct Choice {
    ExplicitDamping explicit_damping;
    ImplicitOptions implicit;
    double safety = 0.8;           // fraction of the certified bound that automatic substeps take
    std::int32_t substeps = 0;     // 0: automatic
    bool shared_contacts = false;  // contacts between implicit bodies belong to the explicit side too
  };
  /// @param whole  the setup whose states are moved; its bodies are discretised once more for each side
  /// @param state  the one that enter() or resume() will be called with
  Partitioned(const Setup& whole, const Methods& methods, const State& state, const StepControl& control,
              double detection, const Choice& choice);

  double enter(State& state) override;
  void resume(State& state, const IntegratorMemory& memory) override;
  [[nodiscard]] IntegratorMemory lend() override;
  void take_back(IntegratorMemory& memory) override;
  StepReport step(State& state, Tick ticks_of_step) override;
  void leave(State& state) override;
  void update_ledger(State& state) override;
  /// Step bound of the substeps.
  double stable_step(const State& state, std::string* binding) override;
  void contact_forces(const State& state, std::span<double> f) const override;
  void set_control(Control* control) override { implicit_->set_control(control); }
  [[nodiscard]] bool step_still_stable() const override { return explicit_->step_still_stable(); }

  [[nodiscard]] const Newmark& implicit_side() const { return *implicit_; }
  /// Number of substeps of the last step, and how often they were computed.
  [[nodiscard]] std::int32_t substeps() const { return substeps_; }
  [[nodiscard]] int repeats() const { return repeats_; }

 private:
  /// One side: its own bodies, and the others as ghosts, with nodes in its own order.
  struct Side {
    Side(const Setup& whole, const Methods& methods, const State& state, bool is_explicit, bool shared);
    Setup setup;
    State state;
  };
  [[nodiscard]] static Ghosts ghosts(const Setup& whole, const State& state, bool is_explicit, bool shared);
  [[nodiscard]] static std::vector<BodyRecord> records(const State& state, bool is_explicit);
  /// Node values that are contiguous in all three orders: of the whole, the explicit and the implicit side.
  struct Run {
    std::size_t whole, of_explicit, of_implicit, count;
  };
  void find_runs();
  /// Finds the pairs of nodes in divided blocks.   @param memory  of a resumed run; null: the stage begins
  void find_interface_constraints(const IntegratorMemory* memory);
  void find_constraint_mass();
  static void copy(std::span<const Run> runs, std::size_t Run::*from, std::span<const double> all, std::size_t Run::*to,
                   std::span<double> out);
  /// Copies values of the whole to a side.
  void take(std::span<const double> all, std::size_t Run::*to, std::vector<double>& out) const;
  void split(const State& state);
  void open_ledgers();
  /// Copies the results of both sides into the state.
  void join(State& state);
  /// Finds the stiffness of closed contacts with ghosts, and the springs.   @param keep  the springs stay as they are
  void find_springs(bool keep);
  void rewind();

  [[nodiscard]] std::span<const Spring> springs() const override { return springs_; }
  [[nodiscard]] double stiffness() const override { return stiffness_; }
  [[nodiscard]] double largest_stiffness() const override { return largest_stiffness_; }
  [[nodiscard]] std::span<const double> present() const override { return present_; }
  [[nodiscard]] std::span<const InterfaceConstraint> interface_constraints() const override {
    return interface_constraints_;
  }
  [[nodiscard]] std::span<const double> constraint_factor() const override { return constraint_factor_; }
  [[nodiscard]] std::span<const double> held() const override { return held_; }
  bool foresee(std::span<const double> end, std::span<double> force) override;
  StepReport mean(std::span<const double> end, std::span<const double> held, std::span<double> force,
                  std::span<double> apart) override;
  /// sum_ += weight times the forces on ghosts.
  void add_to_ghosts(double weight, std::span<const double> f);

  const Setup* whole_;
  Choice choice_;
  Side explicit_side_, implicit_side_;
  std::unique_ptr<CentralDifference> explicit_;
  std::unique_ptr<Newmark> implicit_;
  std::vector<Run> all_, explicit_runs_, implicit_runs_;    // of all nodes, and of those that a side moves
  std::vector<InterfaceConstraint> interface_constraints_;  // with rows of the implicit side
  // Cholesky's factor of the explicit half's mass at the interface constraints, and its multiple in a step.
  std::vector<double> constraint_mass_, constraint_factor_;
  std::vector<std::size_t> explicit_at_, implicit_at_;  // per interface constraint: first value of its nodes
  std::vector<double> apart_, held_,
      held_back_;  // x, y per interface constraint; held_back_: on the explicit side
  std::vector<std::size_t> explicit_bolts_, implicit_bolts_;  // that each side applies
  Ledger base_;                                               // of the run before the first step
  bool has_base_ = false;
  double bound_ = 0.0;  // certified step of the explicit side [s]; 0: to be found
  std::vector<Spring> springs_;
  double stiffness_ = 0.0;                         // k/2 + c/H of closed contacts with ghosts, summed [N/m]
  double largest_stiffness_ = 0.0;                 // the largest of them [N/m]
  IndexedVector<OutlineNode, char> is_ghost_;      // 1 for outline nodes of ghosts
  IndexedVector<OutlineNode, double> compliance_;  // of outline nodes of ghosts [1/kg]
  std::vector<double> present_;                    // forces on ghosts, in the order of the implicit side
  std::vector<double> end_, sum_, ahead_;          // in the order of the explicit side
  Tick step_ = 0;
  std::int32_t substeps_ = 0;
  int repeats_ = 0;
  bool gone_ = false;      // the explicit side is at the end of the step
  bool foreseen_ = false;  // the forces of the step have been foreseen
  StepRollback rollback_;
};

}  // namespace scree::coupling
