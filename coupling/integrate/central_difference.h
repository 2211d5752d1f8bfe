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
/// Stress and weights are summed in the integrator's own loops, the rest comes through ForceTerms and the contacts;
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

  /// From now to `time` ghosts go along straight lines from where they are.   @param end  x, y per node at that time
  void lead_ghosts(const State& state, std::span<const double> end, Tick time);
  /// Forces f of contacts on nodes of ghosts at the end of a step in which they go along straight lines; nothing
  /// changes.
  /// @param end  x, y per node there   @param f  x, y per node, zero at first
  void foresee(const State& state, std::span<const double> end, Tick ticks_of_step, std::span<double> f);
  /// Slow bodies (Ghosts::slow): their internal force counts this many times where the next step arrives; 0: it is not
  /// met there, and its energy stays as it was.
  void weigh_next(double weight) { slow_.next = weight; }
  /// It counts so many times at the present instant, where it has been met. The acceleration jumps.
  void weigh(State& state, double weight);
  /// Nodes that hold() has forces for; before enter() or resume().
  void hold_nodes(std::vector<std::int32_t> nodes);
  /// From now on these forces act on them, x, y per node [N]. The acceleration jumps, and with it the shadow.
  void hold(State& state, std::span<const double> force);
  [[nodiscard]] std::span<const double> held() const { return held_ ? held_->force() : std::span<const double>(); }
  /// Forces at the present instant; those of contacts alone on nodes of ghosts [N].
  [[nodiscard]] std::span<const double> forces() const { return total_; }
  [[nodiscard]] const ContactList& contacts() const { return contact_.list(); }
  /// See ExplicitContact.
  void list_contacts_always_anew() { contact_.list_always_anew(); }
  [[nodiscard]] std::int64_t contact_steps_in_place() const { return contact_.steps_in_place(); }
  /// What steps change beside the state.
  struct Mark {
    ContactList contacts;
    std::vector<double> stress, total, stiffness, local, held;
    double slow_weight = 1.0, slow_energy = 0.0;
  };
  void mark(Mark& out) const;
  void check(const State& state, Audit& audit) const { contact_.check(state.q, audit); }
  /// Goes back to an earlier instant of the stage, whose state its owner has brought back but for the contacts.
  void go_back(State& state, const Mark& mark);

  /// Adds a force beside the model's own (stress, weights, loads, supports, viscous edges).
  void add_term(std::unique_ptr<ForceTerm> term);

 private:
  /// Forces that damp and lag, a number each of a node; empty while the plan has none of the kind.
  struct Lagged {
    std::vector<double> force;
    double left = 0.0;  // first half of a step's work
  };
  [[nodiscard]] bool damps_all() const { return damping_.rigid && damping_.mass > 0.0; }
  [[nodiscard]] bool damps_rest() const { return !damping_.rigid && damping_.mass > 0.0; }
  [[nodiscard]] bool lags() const { return lags_; }

  /// v_{n+1/2}, x_{n+1} of the free nodes and the work over the first half, for which their stress is used up; returns
  /// a bound of the farthest way of a node (in its own unit: the axes of an affine body are numbers).
  [[nodiscard]] double kick_off(const State& state, double h);
  /// How far the points of the outlines would go: too_far, or ok.
  [[nodiscard]] StepReport refuse(double h) const;
  /// False if the forces of contacts, or what they act on, may be no numbers: the step has to be undone then.
  [[nodiscard]] bool forces_stay_finite() const;
  StepReport lost(const State& state, std::span<const double> forces, double t) const;
  void move_driven(const State& state, double h, double end, double& farthest);
  void move_ghosts(const State& state, Tick arrival, double& farthest);
  void turn(const State& state, double h);  // what was moved, where nodes turn
  void leave_instant(const State& state, double h);
  [[nodiscard]] double add_stress(std::span<const double> q);
  /// q_new_, zero.
  [[nodiscard]] std::span<double> scratch();
  /// The forces in q_new_ come on top of those at the present instant.
  void jump(State& state);
  void add_terms(const State& state);
  void restore_stress(const State& state);  // as it is at the state, whatever a step in the making has left
  void sum_up(const Instant& at);
  void book_step(double h, double stress_energy, double driven_before, Ledger& ledger);
  /// Lends what is as large as the model, and takes it back.
  void exchange(IntegratorMemory& memory);
  void accelerate(std::span<const double> q, std::span<double> a) const;
  [[nodiscard]] bool arrive(double h);
  [[nodiscard]] double damp_rest(double factor, State& state);
  /// Velocities and accelerations of the instant at hand less what the damping of sliding blocks takes, and its forces.
  /// @param half  half of the step that led here [s]; 0: none did
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
  double outline_weights_ = 1.0;  // sum |w| of a row: how much farther than the nodes an outline may go
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
  HeldForce* held_ = nullptr;      // among them
  BoltForces* bolts_ = nullptr;    // likewise
  struct Slow {                    // internal force of slow bodies
    double now = 1.0, next = 1.0;  // how often it counts at the present and the next instant
    double energy = 0.0;           // where it was last met [J]
  };
  Slow slow_;
  // Forces at the present instant; total_ has all but the mass-proportional damping, and contacts alone on driven
  // nodes.
  std::vector<double> stress_, total_;
  Lagged stiffness_, local_;
  std::vector<double> q_new_, v_half_, v_new_, a_new_;  // a step in the making: the state changes when it is done
  bool resting_placed_ = false;                         // bodies that rest are in both q_new_ and v_half_
  double stress_left_ = 0.0, stress_right_ = 0.0, mass_left_ = 0.0, sliding_left_ = 0.0;
  double stack_friction_ = 0.0;       // power of friction from stacks_ [W]
  std::vector<double> weight_power_;  // per weight: force at a factor of 1 times velocity
  std::vector<double> partial_;       // a chunk and a sum
  struct Left {                       // sums over a chunk at v_{n+1/2}: work of forces at x_n, and |v|
    double stress = 0.0, mass = 0.0, stiffness = 0.0, local = 0.0, sliding = 0.0, largest = 0.0;
  };
  std::vector<Left> left_;  // per chunk
  struct Lead {             // the way of the ghosts
    Tick begin = 0, end = 0;
    std::vector<double> from, to;
  };
  Lead lead_;
  std::optional<StepBound> step_bound_;         // once the step is asked for
  std::vector<IntegratorMemory::Bound> bound_;  // contacts as stable_step() saw them, with the margin it took
};

}  // namespace scree::coupling
