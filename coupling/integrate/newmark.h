// Implicit Newmark steps with open-close iteration, for every method with a chart.
#pragma once

#include <limits>
#include <vector>

#include "coupling/contact/audit/friction_check.h"
#include "coupling/contact/law/friction_evolution.h"
#include "coupling/contact/table/contact_finder.h"
#include "coupling/integrate/deformation_damping.h"
#include "coupling/integrate/implicit_bolts.h"
#include "coupling/integrate/load_vectors.h"
#include "coupling/integrate/lost_state.h"
#include "coupling/integrate/open_close.h"
#include "coupling/integrate/point_books.h"
#include "coupling/integrate/point_springs.h"
#include "coupling/integrate/sliding_damping.h"
#include "coupling/integrate/stack_damping.h"
#include "coupling/integrate/support_release.h"
#include "coupling/integrate/time_integrator.h"
#include "coupling/integrate/viscous_edges.h"
#include "coupling/interface/interface_iteration.h"

namespace scree::coupling {

/// Choices of an implicit stage.
struct ImplicitOptions {
  NewmarkScheme scheme = NewmarkScheme::damped;
  double dynamics = 1.0;           // fraction of the velocity handed to the next step; 0: a static solution
  double damping = 0.0;            // mass-proportional [1/s]
  bool damp_rigid_motion = false;  // it acts on the whole velocity, not only on its non-affine part
  double stiffness_damping = 0.0;  // [s]
  double sliding_damping = 0.0;    // of the deformation of sliding blocks, a fraction of critical
  double together = 1e-9;          // of the interface iteration: largest residual force over the largest force
  OpenClose::Factor factor = OpenClose::Factor::chosen;
};

/// With v' = 2 d/h - v in both schemes, at the end of the step:
///   beta = 1/2, gamma = 1:    2 M (d - h v)/h^2      + C v' = f(x + d),  f internal, contact, supports, loads
///   beta = 1/4, gamma = 1/2:  4 M (d - h v)/h^2 - M a + C v' = f(x + d),  a' = 4 (d - h v)/h^2 - a
///   C = damping M + stiffness_damping K_material + dashpots + damping of the deformation of sliding blocks.
/// Closed contacts have dashpots, and sliding blocks that damping, where velocity is physical: dynamics = 1.
/// The internal force of co-rotational bodies is balanced by Newton's method about the iterate, open-close iteration
/// inside, to 1e-11 of the largest force or to round-off; one stiffness and its factor are kept while every iteration
/// reduces the residual to a twentieth. Contact geometry is that of the step's start. Then every body is retracted
/// through its chart; the difference of linear forms and exact geometry is booked in its own columns. The impulse of
/// StackDamping over the step then acts on the velocities.
/// @source docs/theory/time-integration.md, "Newmark steps"; [Newmark1959]; [Qu2013] 3.3.2, 3.2.2, 4.5; [Shi1988]
class Newmark final : public TimeIntegrator {
 public:
  Newmark(const Setup& setup, const StepControl& control, double detection, const ImplicitOptions& options = {});

  double enter(State& state) override;
  void resume(State& state, const IntegratorMemory& memory) override;
  [[nodiscard]] IntegratorMemory lend() override;
  void take_back(IntegratorMemory& memory) override;
  void set_control(Control* control) override { contacts_.set_control(control); }
  StepReport step(State& state, Tick ticks_of_step) override;
  void leave(State& state) override;
  void update_ledger(State& state) override;
  double stable_step(const State& state, std::string* binding) override;
  void contact_forces(const State& state, std::span<double> f) const override;

  /// Interface force that acts in every step from now on; null: none. It must outlive the steps.
  void set_interface(InterfaceForce* force) { interface_.set(force); }
  /// True if the next step will use the tangent of an earlier one: InterfaceForce::springs() must be that one's too.
  [[nodiscard]] bool keeps_tangent(Tick ticks_of_step) const {
    return tangent_.step == ticks_of_step && list_->points.empty();
  }
  /// The next step uses nothing of earlier ones, and makes a new tangent.
  void renew() { renew_ = true; }
  /// State::contacts of the entered state.
  [[nodiscard]] const ContactList& list() const { return *list_; }
  /// See ExplicitContact.
  void list_contacts_always_anew() { always_anew_ = true; }
  [[nodiscard]] std::int64_t contact_steps_in_place() const { return steps_in_place_; }
  /// Contacts of another integrator with bodies of this one; sliding on them counts as well. Null: none. The outlines
  /// and the list must outlive the steps.
  void also_touch(const Outlines* outlines, const ContactList* list) {
    outlines_elsewhere_ = outlines;
    list_elsewhere_ = list;
  }

  [[nodiscard]] const Cholesky& cholesky() const { return contacts_.cholesky(); }
  [[nodiscard]] const ImplicitSystem& system() const { return system_; }
  [[nodiscard]] const OpenClose& contacts() const { return contacts_; }

 private:
  [[nodiscard]] bool trapezoidal() const { return options_.scheme == NewmarkScheme::trapezoidal; }
  /// Slides are followed where velocities are physical.
  [[nodiscard]] bool checks_friction() const { return options_.dynamics == 1.0; }
  [[nodiscard]] double kinetic_energy(const State& state) const;

  void enter_stage(const State& state);

  // newmark.cpp: the step's equations
  void prepare(const State& state, double h);
  struct Damping {  // forces in the unknowns; empty where there are none
    std::vector<double> mass, stiffness, sliding;

    /// A force on unknown i, with those of the first two.
    [[nodiscard]] double added_to(double force, std::size_t i) const {
      if (!mass.empty()) force += mass[i];
      return stiffness.empty() ? force : force + stiffness[i];
    }
  };
  void prepare_damping(const State& state);
  void damping_forces(const State& state, std::span<const double> rate, Damping& out);
  /// True if dashpots of contacts and the damping of sliding blocks act.
  [[nodiscard]] bool velocity_is_physical() const { return !trapezoidal() && options_.dynamics == 1.0; }
  void find_sliding(const State& state, double h);
  void find_step_springs(const State& state, double h);
  void move_to_iterate(const State& state);
  // newmark_interface.cpp: steps with an interface force
  void begin_interface_iteration(const State& state, double h);
  [[nodiscard]] InterfaceIteration::Iterate iterate(const State& state) const { return {state.q, d_, q_new_}; }
  /// As InterfaceIteration::evaluate().   @return false: the report contains the reason
  [[nodiscard]] bool evaluate_interface_force(const State& state, StepReport& report);
  /// Before accept(): what the next step takes from this one, which took so many iterations.
  void keep_for_next_step(Tick ticks_of_step, int iterations);
  /// Makes the kept tangent and its factor those of the system again.
  void take_tangent(const State& state, double h);
  void add_affine_damping(const State& state, std::span<const double> rate, std::span<double> out);
  struct NewtonLoop {                   // Newton's iteration of one step
    std::vector<double> affine, moved;  // damping forces that exclude affine motion [N]; d_ of nonlinear unknowns
    Stiffness kind = Stiffness::exact;  // of the linear system
    bool iterative = false;             // one solution is not enough
    bool fresh = true;                  // the linear system is new
    bool at_round_off = false;          // the residual is round-off of the system's forces
    double left = 0.0, largest = 0.0;   // residual and largest force of the iterate [N]
    double last = std::numeric_limits<double>::infinity();  // residual of the previous iterate [N]
    double apart = 0.0;                                     // InterfaceIteration::residual() [N]
  };
  void begin_balance(const State& state, double h, NewtonLoop& loop);
  /// Solves for the next iterate and finds its residual.   @return false: the report contains the reason
  [[nodiscard]] bool solve_iterate(const State& state, double h, NewtonLoop& loop, StepReport& report);
  enum class Settled { no, yes, failed };
  /// Tests whether the iterate balances, and whether the interface force of a partitioned step has converged.
  [[nodiscard]] Settled settle(const State& state, double h, NewtonLoop& loop, StepReport& report);
  [[nodiscard]] bool evaluate_iterate(const State& state, double h, NewtonLoop& loop, StepReport& report);
  /// Corrects a balanced iterate as long as the work of its residual matters for the ledger.   @return as solve_iterate
  [[nodiscard]] bool refine(const State& state, double h, NewtonLoop& loop, StepReport& report);
  void prepare_iterate(const State& state, double h, NewtonLoop& loop);
  [[nodiscard]] bool balance(const State& state, double h, StepReport& report);
  /// Factor of M d in the balance [1/s2]: half (trapezoidal: all) of the square of 2/h, the factor of d in the new
  /// velocity. To the last place, since the ledger adds the difference up over the steps.
  [[nodiscard]] double mass_factor(double h) const { return (trapezoidal() ? 1.0 : 0.5) * (2.0 / h) * (2.0 / h); }
  void linear_system(double h);
  /// Right-hand side at the present iterate.   @param moved  d_ of nonlinear unknowns   @param affine  damping forces
  void find_right_side(std::span<const double> moved, std::span<const double> affine);
  /// True if mass damping excludes affine motion: its force then depends on the iterate.
  [[nodiscard]] bool spares_affine() const { return options_.damping > 0.0 && !options_.damp_rigid_motion; }
  /// Report of an iterate that is not finite, with the body.
  [[nodiscard]] StepReport not_finite(const StepReport& report, const State& state, double h) const;
  void describe_imbalance(double left, StepReport& report) const;
  [[nodiscard]] double residual(const State& state, double h, double& largest);
  struct RoundOff {
    double system = 0.0;  // of the linear system's forces, inertia included [N]
    double bodies = 0.0;  // of forces inside the bodies, which depend on positions [N]
  };
  [[nodiscard]] RoundOff round_off(const State& state) const;
  /// Residual of balance(), as far as it is round_off(): its largest force, and the work of all its forces along d.
  struct LeftOver {
    double force = 0.0;  // [N]
    double work = 0.0;   // StepReport::left_work [J]
  };
  [[nodiscard]] LeftOver left_over(const State& state) const;
  [[nodiscard]] bool reach(const State& state, Tick ticks_of_step, StepReport& report);
  /// The report of a step that ends in a meaningless state.
  [[nodiscard]] static StepReport lost(const StepReport& report, const LostPlace& place, const State& state, double h);

  // newmark_books.cpp: state and ledger after an accepted step
  struct Energies {  // as in the equations of the step, before geometry is updated
    double elastic = 0.0, supports = 0.0, kinetic = 0.0, bolts = 0.0;
  };
  void accept(State& state, Tick ticks_of_step);
  void book_bodies(Ledger& ledger, Energies& after);
  void book_damping(Ledger& ledger) const;
  void book_springs(Ledger& ledger, Energies& after) const;
  void book_contact(std::size_t i, Ledger::Booking& booking) const;
  /// Sets the memory of point i to the end of the step, before its geometry is updated.
  void remember_contact(std::size_t i, const State& state, PointBooks::Chunk& chunk);
  void leave_contacts(State& state);
  /// @return true: the points were moved in place, with bitwise the result of a new list
  bool move_points(std::span<const double> q);
  void book_point_update(std::size_t i, Ledger::Booking& booking, PointBooks::Chunk& chunk);
  void book_contact_update(State& state);
  void book_update(State& state, const Energies& after);
  void damp_stacks(State& state, double h);

  const Setup* setup_;
  StepControl control_;
  ImplicitOptions options_;
  ContactFinder finder_;
  FrictionCheck friction_check_;
  FrictionEvolution friction_evolution_;
  ContactList* list_ = nullptr;  // of the state
  ContactList before_;
  PointBooks books_;
  bool always_anew_ = false;
  std::int64_t steps_in_place_ = 0;
  struct Linear {
    double kn, kt;  // at the start of the step [N/m]
    double energy;  // of the springs, as in the equations of the step [J]
  };
  std::vector<Linear> linear_;  // of the points, before geometry is updated
  ImplicitSystem system_;
  OpenClose contacts_;
  StepSprings springs_;
  std::size_t interface_springs_ = 0;  // index of the first spring of interface_
  SlidingDamping sliding_;
  StackDamping stacks_;
  DeformationDamping damper_;
  const Outlines* outlines_elsewhere_ = nullptr;
  const ContactList* list_elsewhere_ = nullptr;
  InterfaceIteration interface_;
  std::vector<PointSpring> supports_;
  std::vector<Dashpot> dashpots_;
  ImplicitBolts bolts_;
  std::vector<LoadVector> loads_;
  SupportRelease release_;
  std::vector<double> release_load_;      // of release_, part of load_
  std::vector<double> weight_;            // gravity on the nodes
  std::vector<Vec2> driven_move_;         // per body
  std::vector<double> reference_;         // the nodes of bodies in their reference shape
  double largest_interface_force_ = 0.0;  // largest force on bodies with an interface force [N]
  std::vector<double> gravity_, load_, load_before_, inertia_, force_before_, force_, force_after_, acceleration_, d_,
      rate_, rhs_, out_;
  Damping damped_before_, damped_after_;
  // One value per entry of the pattern.
  std::vector<double> K_, C_, A_;
  RoundOff largest_;                   // largest entry of the diagonals of A_ and K_ [N/m]
  IntegratorMemory::Tangent tangent_;  // of accepted steps
  bool has_tangent_ = false;           // K_, A_ and the factor are those of the tangent
  bool renew_ = false;                 // renew() was called
  bool renewed_ = false;               // for this step
  bool tangent_may_stay_ = false;      // at least while nothing but bodies, supports and the interface force acts
  bool keep_ = false;                  // the step uses the tangent of an earlier one
  bool made_ = false;                  // a tangent was made in this step
  bool has_end_ = false;               // force_after_ and springs_ are those of the last step, which was accepted
  bool still_ = false;                 // no driven body moves in the step
  double farthest_ = 0.0;              // displacement of an outline node in the step [m]
  double clear_ = 0.0;  // while there are no points: how far nodes may still move before there can be one [m]
  IntegratorMemory::Start start_;
  std::vector<double> plain_start_;                  // first guess of the step without its correction
  double energy_before_ = 0.0, energy_after_ = 0.0;  // elastic, of the bodies whose force is not linear
  std::vector<double> q_new_, v_new_, node_scratch_, node_scratch2_, node_scratch3_;
};

}  // namespace scree::coupling
