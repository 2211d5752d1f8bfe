// Explicit central difference for every method at once: kick, drift, kick.
#pragma once

#include <memory>
#include <optional>

#include "coupling/contact/explicit_contact.h"
#include "coupling/integrate/bolt_forces.h"
#include "coupling/integrate/force_term.h"
#include "coupling/integrate/held_force.h"
#include "coupling/integrate/loads.h"
#include "coupling/integrate/node_chunks.h"
#include "coupling/integrate/sliding_damping.h"
#include "coupling/integrate/stack_damping.h"
#include "coupling/integrate/step_bound.h"
#include "coupling/integrate/time_integrator.h"

namespace scree::coupling {

///   v_{n+1/2} = v_n + h/2 M^-1 F(x_n),  x_{n+1} = x_n + h v_{n+1/2},  v_{n+1} = v_{n+1/2} + h/2 M^-1 F(x_{n+1})
/// The stored velocity is the synchronised one, so the step may change; the ledger books (h'^2 - h^2)/8 a.M.a.
/// Stress and weights are summed in the integrator's own loops; all other forces are ForceTerms and contacts, and
/// each books its own work. Mass-proportional damping at the rate a acts on w = v minus its affine part, or on all of
/// v: w_n = w*/(1 + a h/2), force -a M w_n, which is [(1 - a h/2) w_{n-1/2} + h M^-1 F]/(1 + a h/2) of [Qu2013]
/// 4.3.3 on synchronised velocities. Everything else that damps (stiffness, viscous edges, contacts) lags half a
/// step behind: F(x_n, v_{n-1/2}). Local damping: -alpha |F| sign(v_{n-1/2}) on every component of every free node, F
/// the unbalanced force [Cundall1987]; on DDA blocks the nodes are the centre and the columns of the gradient.
/// @source docs/theory/time-integration.md, "Central difference"; [Qu2013] 4.3, 6.5
class CentralDifference final : public TimeIntegrator {
 public:
  /// @param rest  kinetic damping: all velocities are dropped when the kinetic energy has passed a peak
  CentralDifference(const Setup& setup, const StepControl& control, double detection,
                    const ExplicitDamping& damping = {}, bool rest = false);

  double enter(State& state) override;
  void resume(State& state, const IntegratorMemory& memory) override;
  [[nodiscard]] IntegratorMemory lend() override;
  void take_back(IntegratorMemory& memory) override;
  StepReport step(State& state, Tick ticks_of_step) override;
  void leave(State& state) override;
  void update_ledger(State& state) override;
  double stable_step(const State& state, std::string* binding) override;
  void contact_forces(const State&, std::span<double> f) const override { contact_.add(f); }
  [[nodiscard]] bool step_still_stable() const override;

  /// From now to `time` ghosts move along straight lines from their present positions.
  /// @param end  x, y per node at that time
  void lead_ghosts(const State& state, std::span<const double> end, Tick time);
  /// Finds the contact forces f on nodes of ghosts at the end of a step in which ghosts move along straight lines;
  /// the step is not taken.
  /// @param end    x, y per node at the end
  /// @param again  the ghosts alone move otherwise than in the last call, by little: contacts are those of that call
  /// @param f      x, y per node, zero at first
  void foresee(const State& state, std::span<const double> end, Tick ticks_of_step, bool again, std::span<double> f);
  /// Sets the weight of the internal force of slow bodies (Ghosts::slow) at the end of the next step; 0: the force is
  /// not evaluated there, and its energy stays as it was.
  void weigh_next(double weight) { slow_.next = weight; }
  /// Sets the weight of that force at the present instant, where it has been evaluated. The acceleration jumps.
  void weigh(State& state, double weight);
  /// Sets the nodes that the forces of hold() act on; called before enter() or resume().
  void hold_nodes(std::vector<std::int32_t> nodes);
  /// From now on these forces act on those nodes, x, y per node [N]. The acceleration and the shadow energy jump.
  void hold(State& state, std::span<const double> force);
  [[nodiscard]] std::span<const double> held() const { return held_ ? held_->force() : std::span<const double>(); }
  /// Forces at the present instant; on nodes of ghosts those of contacts alone [N].
  [[nodiscard]] std::span<const double> forces() const { return total_; }
  [[nodiscard]] const ContactList& contacts() const { return contact_.list(); }
  /// See ExplicitContact.
  void list_contacts_always_anew() { contact_.list_always_anew(); }
  [[nodiscard]] std::int64_t contact_steps_in_place() const { return contact_.steps_in_place(); }
  /// What steps change in the integrator.
  struct Mark {
    ContactList contacts;
    std::vector<double> stress, total, stiffness, local, held;
    double slow_weight = 1.0, slow_energy = 0.0;
  };
  void mark(Mark& out) const;
  void check(const State& state, Audit& audit) const { contact_.check(state.q, audit); }
  /// Returns to an earlier instant of the stage. The caller has restored the state before, except its contacts.
  void go_back(State& state, const Mark& mark);

  /// Adds a force beside the model's own (stress, weights, loads, supports, viscous edges).
  void add_term(std::unique_ptr<ForceTerm> term);

 private:
  /// Damping forces that lag half a step, x, y per node; empty if the plan has no damping of the kind.
  struct Lagged {
    std::vector<double> force;
    double left = 0.0;  // first half of a step's work
  };
  [[nodiscard]] bool damps_all() const { return damping_.rigid && damping_.mass > 0.0; }
  [[nodiscard]] bool damps_rest() const { return !damping_.rigid && damping_.mass > 0.0; }
  [[nodiscard]] bool lags() const { return lags_; }

  /// Finds v_{n+1/2}, x_{n+1} of the free nodes and the work over the first half, and sets their stress to zero;
  /// returns a bound of the largest node displacement (in its own unit: axes of an affine body are dimensionless).
  [[nodiscard]] double kick_off(const State& state, double h);
  /// Finds how far the points of the outlines would move: too_far, non_finite or ok.
  [[nodiscard]] StepReport refuse(double h) const;
  /// False if contact forces, or the bodies that they act on, may not be finite: the step has to be undone if so.
  [[nodiscard]] bool forces_stay_finite() const;
  StepReport lost(const State& state, std::span<const double> forces, double t) const;
  void move_driven(const State& state, double h, double end, double& farthest);
  void move_ghosts(const State& state, Tick arrival, double& farthest);
  void turn(const State& state, double h);  // corrects moved positions where nodes rotate
  void leave_instant(const State& state, double h);
  [[nodiscard]] double add_stress(std::span<const double> q);
  /// q_new_, set to zero.
  [[nodiscard]] std::span<double> scratch();
  /// Adds the forces in q_new_ to those at the present instant.
  void jump(State& state);
  void add_terms(const State& state);
  void restore_stress(const State& state);  // at the positions of the state, after an unfinished step
  void sum_up(const Instant& at);
  void book_step(double h, double stress_energy, double driven_before, Ledger& ledger);
  /// Swaps the arrays that are as large as the model with those of `memory`.
  void exchange(IntegratorMemory& memory);
  void accelerate(std::span<const double> q, std::span<double> a) const;
  [[nodiscard]] bool arrive(double h);
  [[nodiscard]] double damp_rest(double factor, State& state);
  /// Reduces the new velocities and accelerations by the damping of sliding blocks, and finds its forces.
  /// @param half  half of the step that ends now [s]; 0: there is none
  void damp_sliding(std::span<const double> q, double half, State& state);
  void damp(double h, State& state);
  void relax(State& state);
  [[nodiscard]] Instant lagging(const State& state) const;

  [[nodiscard]] double forces_power(const State& state, const double* v) const;  // of all forces but mass damping
  [[nodiscard]] double acceleration_energy(const State& state) const;            // a.M.a of the free bodies
  [[nodiscard]] double kinetic_energy(std::span<const double> q, std::span<const double> v) const;
  void change_step(State& state, double h);  // books (h^2 - h_last^2)/8 a.M.a

  const Setup* setup_;
  StepControl control_;
  ExplicitDamping damping_;
  bool rest_, lags_;
  double outline_weights_ = 1.0;  // sum |w| of a row: ratio of outline to node displacement, at most
  ExplicitContact contact_;
  NodeChunks chunks_;
  SlidingDamping sliding_;
  StackDamping stacks_;
  // Scratch of damp_sliding(): rotation of a body, momenta of its velocity and of its rotation.
  std::vector<double> rigid_turn_, momentum_, turn_momentum_;
  std::vector<double> unit_mass_;  // M of a translation by 1
  std::vector<BodyLoad> weights_;
  std::vector<double> factor_;  // per weight: its factor at the present instant
  std::vector<std::unique_ptr<ForceTerm>> terms_;
  HeldForce* held_ = nullptr;      // one of terms_
  BoltForces* bolts_ = nullptr;    // one of terms_
  struct Slow {                    // internal force of slow bodies
    double now = 1.0, next = 1.0;  // weights at the present and the next instant
    double energy = 0.0;           // at its last evaluation [J]
  };
  Slow slow_;
  // Forces at the present instant; total_ contains all but the mass-proportional damping; on driven nodes, contacts
  // alone.
  std::vector<double> stress_, total_;
  Lagged stiffness_, local_;
  std::vector<double> q_new_, v_half_, v_new_, a_new_;  // the unfinished step: the state changes at its end
  bool resting_placed_ = false;                         // bodies that rest are in both q_new_ and v_half_
  double stress_left_ = 0.0, stress_right_ = 0.0, mass_left_ = 0.0, sliding_left_ = 0.0;
  double stack_friction_ = 0.0;       // power of friction from stacks_ [W]
  std::vector<double> weight_power_;  // per weight: force at a factor of 1 times velocity
  std::vector<double> partial_;       // per chunk and sum
  struct Left {                       // sums over a chunk at v_{n+1/2}: work of forces at x_n, and |v|
    double stress = 0.0, mass = 0.0, stiffness = 0.0, local = 0.0, sliding = 0.0, largest = 0.0;
  };
  std::vector<Left> left_;  // per chunk
  struct Lead {             // straight paths of the ghosts
    Tick begin = 0, end = 0;
    std::vector<double> from, to;
  };
  Lead lead_;
  std::optional<StepBound> step_bound_;         // made by the first stable_step()
  std::vector<IntegratorMemory::Bound> bound_;  // contact stiffnesses at the last stable_step(), with its margin
};

}  // namespace scree::coupling
