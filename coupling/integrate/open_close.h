// Open-close iteration: contact states of an implicit step.
#pragma once

#include <string>
#include <vector>

#include "coupling/contact/contact_energy.h"
#include "coupling/contact/law/dilation.h"
#include "coupling/contact/law/joint_strength.h"
#include "coupling/integrate/implicit_system.h"
#include "coupling/integrate/low_rank.h"
#include "coupling/integrate/time_integrator.h"
#include "coupling/linear/cholesky.h"
#include "coupling/linear/conjugate_residuals.h"

namespace scree::coupling {

/// Things of stiffness k between bodies or to the ground that stay as they are during a step: force -k (at + u) along
/// their rows, u the change. Supports; dashpots with k = 2 c/h and at = -h v_n/2.
struct StepSprings {
  DofRows rows;
  std::vector<double> k;   // [N/m]
  std::vector<double> at;  // elongation at the start of the step [m]
  [[nodiscard]] std::size_t size() const { return k.size(); }
  [[nodiscard]] double force(std::size_t i, std::span<const double> d) const {
    return -k[i] * (at[i] + rows[i].change(d));
  }
  void clear() {
    rows.clear();
    k.clear();
    at.clear();
  }
};

/// Solves (A + springs + closed contacts) d = rhs and switches contact states until none is violated. Friction of
/// sliding points follows their normal force, which makes the system unsymmetric: conjugate residuals, preconditioned
/// by the factor of the symmetric part. So does the normal force of points that dilate, which follows their slip. Water
/// in joints is a load along the gaps, that of the step's start. Gaps and stretches are linear in d, about the start of
/// the step. A factor is kept from step to step as that preconditioner while it is less work than a new one:
/// State::factored tells what it is of. Where it is not, the factor of the step's matrix follows the states that switch
/// by rank updates.
/// @source docs/theory/time-integration.md, "Open-close iteration"; [Qu2013] 3.2.2, 4.5
class OpenClose {
 public:
  struct Trial {  // a contact point during the iteration
    ContactStatus status = ContactStatus::open;
    double direction = 0.0;  // sign of the friction force while slipping
    double load = 0.0;       // normal force that its friction limit was taken from [N]
    bool opens = false;      // it dilates while it slips: not at the end of dilation yet
    double opened = 0.0;     // by dilation in the step; the gap below is less by it [m]
    double fn = 0.0, ft = 0.0, gap = 0.0, stretch = 0.0, moved = 0.0;  // linear outcome; moved: tangential change
    // Normal spring and dashpot of a step h as one spring: k = k_n + c_n/h, k at = k_n g_n, so that
    //   -k_n g - c_n (g - g_n)/h = -k (at + g - g_n).
    double k = 0.0, at = 0.0;  // [N/m], [m]
    // Closed, but the dashpot would pull by more than the point bears: it has the force that it bears, and no more.
    bool slack = false;
  };

  struct Pass {        // of the last step, all Newton iterations
    int switched = 0;  // points that changed state before it
    int updates = 0;   // rank-1 changes of the factor
    bool factorised = false;
    double factor_seconds = 0.0, seconds = 0.0;  // processor time for the factor, and in all
  };

  /// How the factor follows the states.
  enum class Factor {
    anew,     // one a pass, for comparison
    updated,  // one a step, rank updates while they are less work
    kept      // the same, and from step to step
  };
  /// @param allowed  false: a contact that closes makes the step fail (schemes without contacts)
  OpenClose(const Setup& setup, const StepControl& control, const ImplicitSystem& system, bool allowed, Factor factor);

  /// Whom solve() asks, once a pass, whether to give up; null: nobody.
  void set_control(Control* control) { control_of_run_ = control; }
  /// Takes over the factor that a state tells of.
  void enter(const KeptFactor& kept);
  /// Begins a step with the points of a list and other springs, which must outlive it.
  /// @param dashpot  1/h where closed contacts are damped, 0 where they are not [1/s]
  /// @param damping  of blocks, beside the pattern; must outlive the step
  void begin(const ContactList& list, std::span<const double> q, std::span<const Vec2> driven_move,
             const StepSprings& springs, double dashpot = 0.0, std::span<const LowRank> damping = {});
  /// @param A    numbers on the system's pattern   @param fresh  they have changed since the last call
  /// @param d    a first guess; the unknowns found
  /// @return false: the report says why
  [[nodiscard]] bool solve(std::span<const double> A, bool fresh, std::span<const double> rhs, std::span<double> d,
                           StepReport& report);
  /// Checks unknowns found against states, laws and balance; before accept().
  /// @param unbalanced  force that round-off leaves on a body: contacts are known to no better [N]
  void check(std::span<const double> d, double unbalanced, Audit& audit) const;
  /// Called once the step is taken: what the next one begins with.
  void accept(KeptFactor& kept);
  /// out += forces of springs and contacts, of the water in them too, at the unknowns last found; also the largest of
  /// them.
  double add_forces(std::span<const double> d, std::span<double> out) const;

  [[nodiscard]] const std::vector<Trial>& trials() const { return trial_; }
  [[nodiscard]] const StepSprings& springs() const { return *springs_; }
  /// Rows of a point's gap and stretch in the step.
  [[nodiscard]] DofRow normal(std::size_t i) const { return rows_[springs_->size() + 2 * i]; }
  [[nodiscard]] DofRow tangential(std::size_t i) const { return rows_[springs_->size() + 2 * i + 1]; }
  [[nodiscard]] const std::vector<Pass>& passes() const { return passes_; }
  [[nodiscard]] const Cholesky& cholesky() const { return cholesky_; }

 private:
  void add_rows(const ContactPoint& p, const ContactMemory& m, std::span<const double> q,
                std::span<const Vec2> driven_move);
  [[nodiscard]] const ChartRow& chart(std::int32_t node, std::span<const double> q);
  /// Stiffnesses and right-hand side of the states of the points.
  void apply_states();
  /// Brings the factor to them, or leaves a kept one.
  [[nodiscard]] bool factorise(bool fresh, StepReport& report);
  [[nodiscard]] bool factorise_anew(StepReport& report);
  [[nodiscard]] bool update(StepReport& report);
  /// y = (A + springs + closed contacts, with friction of those that slip) x.
  void multiply(std::span<const double> x, std::span<double> y) const;
  /// What the friction force of a slipping point loses as its gap opens [N/m].
  [[nodiscard]] double friction_per_gap(std::size_t i) const;
  [[nodiscard]] bool dilates(std::size_t i) const { return law_of(i).dilation > 0.0; }
  /// Normal force of a slipping point that dilates, linear in gap and stretch.
  [[nodiscard]] DilatingForce dilation(std::size_t i) const;
  /// Slip left at the start of the step until dilation ends [m]; infinite: it does not.
  [[nodiscard]] double slip_left(std::size_t i) const;
  /// Stretch of a point's spring at the start of the step.
  [[nodiscard]] double stretch_before(std::size_t i) const;
  [[nodiscard]] const JointLaw& law_of(std::size_t i) const;
  /// The largest force that a solution is made of [N].
  [[nodiscard]] double force_scale(std::span<const double> d) const;
  /// What round-off leaves of the forces inside the bodies and of the springs between them [N].
  [[nodiscard]] double round_off(std::span<const double> d) const;
  /// The factor is not that of the whole matrix: points slip, or blocks are damped beside the pattern.
  [[nodiscard]] bool unsymmetric() const { return !slipping_.empty() || !damping_.empty(); }
  /// Conjugate residuals with the factor as it is.   @return iterations; -1: not enough
  int improve(int most, std::span<double> d, StepReport& report);
  /// The unknowns that go with the states; makes a factor where the one at hand takes too long.
  [[nodiscard]] bool solve_states(std::span<double> d, StepReport& report);
  void evaluate_points(std::span<const double> d);
  [[nodiscard]] double limit(std::size_t i) const;
  /// Normal force of a closed point that is not slack, at a change of its gap from the start of the step [N].
  [[nodiscard]] double pressed(const Trial& t, double change) const { return -t.k * (t.at + change); }
  /// The force of a slack point [N].
  [[nodiscard]] double slack_force(std::size_t i) const {
    return trial_[i].status == ContactStatus::stick ? -strength_[i].tension : 0.0;
  }
  /// Normal force that strength is taken from: bonds fail by the spring's force, not by the dashpot's [N].
  [[nodiscard]] double bearing_force(std::size_t i) const;
  [[nodiscard]] double normal_stiffness(std::size_t i) const;
  [[nodiscard]] double tangential_stiffness(std::size_t i) const;
  [[nodiscard]] bool may_close(std::size_t i) const;
  /// True if the corner of a point is held by an edge beside it that faces the same way: once its foot has left that
  /// edge, the contact passes over with its force.
  [[nodiscard]] bool held_beside(std::size_t i) const;
  /// A force by which a point may violate its state: what the numbers of a step leave, not what it is about [N].
  [[nodiscard]] double tolerance(std::size_t i) const;
  /// The state that a point's forces and motions ask for, and how far they violate the one it has, as a force [N].
  struct ProposedState {
    ContactStatus status = ContactStatus::open;
    double direction = 0.0;
    bool opens = false, slack = false;
    double violation = 0.0;
  };
  /// A point whose dashpot pulls too much goes slack, and back.   @return true if it should switch
  [[nodiscard]] bool switch_slack(std::size_t i, ProposedState& w) const;
  [[nodiscard]] ProposedState proposed_state(std::size_t i) const;
  /// @param only_worst  of all points of a body the one that violates its state most   @return points switched
  [[nodiscard]] int switch_states(bool only_worst);
  [[nodiscard]] bool refuse(StepReport& report) const;
  /// Of the states of all points, so that a pass is known which had them before.
  [[nodiscard]] std::size_t hash_of_states();

  const Setup* setup_;
  StepControl control_;
  const ImplicitSystem* system_;
  bool allowed_;
  Factor factor_;
  Control* control_of_run_ = nullptr;
  const ContactList* list_ = nullptr;
  const StepSprings* springs_ = nullptr;
  std::span<const LowRank> damping_;
  DofRows rows_;                // springs, then gap and stretch of every point
  std::vector<double> k_, at_;  // of the rows, as the states are: stiffness, elongation at the start of the step
  std::vector<Trial> trial_;
  std::vector<Strength> strength_;  // of the points
  std::vector<double> mass_;        // of a body, as the model has it [kg]
  std::vector<double> weight_;      // of the lighter free body at a point [N]
  double largest_force_ = 0.0;      // of the points' normal forces in a pass [N]
  double gap_round_off_ = 0.0;      // to which positions define a gap [m]
  std::vector<ChartRow> charts_;
  std::vector<std::int32_t> chart_of_node_;  // -1: not yet this step
  std::span<const double> A_;
  std::vector<double> rhs_, base_, factored_k_;
  std::vector<std::size_t> active_;  // rows whose stiffness is not zero
  /// A point that slips in a pass.
  struct Slipping {
    std::size_t point = 0;
    double friction_per_gap = 0.0;
    bool dilates = false;
    DilatingForce dilation;
  };
  std::vector<Slipping> slipping_;
  std::vector<std::pair<std::size_t, ProposedState>> proposed_;  // of points that switch in a pass
  std::vector<double> worst_;                                    // violation of a body's points [N]
  std::string states_;                                           // of all points in a pass, a character each
  std::vector<std::size_t> seen_;                                // hashes of the states that the passes have had
  ConjugateResiduals residuals_;
  std::vector<Cholesky::Change> changes_;
  std::vector<Pass> passes_;
  bool current_ = false;  // the factor is that of the step's matrix, with updates
  bool updated_ = false;
  bool exact_ = false;            // the pass is to solve to round-off: not before states seem to have settled
  bool rough_ = false;            // the solution at hand is not so good
  bool friction_settled_ = true;  // in the last pass
  bool keep_ = false;             // this step may use the kept factor
  int corrections_left_ = 0;      // iterations that this step may still take with it
  bool made_ = false;             // a factor was made since the last accept()
  KeptFactor::Patience patience_;
  Cholesky cholesky_;
};

}  // namespace scree::coupling
