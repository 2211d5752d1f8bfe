// Open-close iteration: contact states of an implicit step.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/contact/contact_energy.h"
#include "coupling/integrate/cholesky.h"
#include "coupling/integrate/implicit_system.h"
#include "coupling/integrate/mover.h"

namespace scree::coupling {

/// Something of stiffness k between bodies or to the ground that stays as it is during a step: force -k (at + u) along
/// the row, u its change. Supports; dashpots with k = 2 c/h and at = -h v_n/2.
struct StepSpring {
  DofRow row;
  double k = 0.0;   // [N/m]
  double at = 0.0;  // elongation at the start of the step [m]
  [[nodiscard]] double force(std::span<const double> d) const { return -k * (at + row.change(d)); }
};

/// Solves (A + springs + closed contacts) d = rhs and switches contact states until none is violated. Friction of
/// sliding points is a load of the right-hand side that follows their normal force, and so is what dilation presses
/// their normal springs by, which follows their slip: Anderson acceleration (GMRES for a linear iteration), and where
/// that does not settle, Newton's method with GMRES and the factor. Water in joints is a load along the gaps, that of
/// the step's start. Gaps and stretches are linear in d, about the start of the step.
/// @source thesis 3.2.2, 4.5
class OpenClose {
 public:
  struct Trial {  // a contact point during the iteration
    DofRow normal, tangential;
    ContactStatus status = ContactStatus::open;
    double direction = 0.0;  // sign of the friction force while slipping
    double load = 0.0;       // normal force that its friction limit was taken from [N]
    double opened = 0.0;     // by dilation in the step, while slipping; the gap below is less by it [m]
    double fn = 0.0, ft = 0.0, gap = 0.0, stretch = 0.0, moved = 0.0;  // linear outcome; moved: tangential change
  };

  struct Pass {        // of the last step, all Newton iterations
    int switched = 0;  // points that changed state before it
    int updates = 0;   // rank-1 changes of the factor
    bool factorised = false;
    double seconds = 0.0;
  };

  /// @param allowed       false: a contact that closes makes the step fail (schemes without contacts)
  /// @param rank_updates  contacts that switch change the factor while that is less work than factorising anew
  OpenClose(const Setup& setup, const StepControl& control, const ImplicitSystem& system, bool allowed,
            bool rank_updates);

  /// Begins a step with the points of a list, which must outlive it.
  void begin(const ContactList& list, std::span<const double> q, std::span<const Vec2> driven_move,
             std::vector<StepSpring> springs);
  /// @param A    numbers on the system's pattern   @param fresh  they have changed since the last call
  /// @param d    the unknowns found
  /// @return false: the report says why
  [[nodiscard]] bool solve(std::span<const double> A, bool fresh, std::span<const double> rhs, std::span<double> d,
                           StepReport& report);
  /// out += forces of springs and contacts, of the water in them too, at the unknowns last found; also the largest of
  /// them.
  double add_forces(std::span<const double> d, std::span<double> out) const;

  [[nodiscard]] const std::vector<Trial>& trials() const { return trial_; }
  [[nodiscard]] const std::vector<StepSpring>& springs() const { return springs_; }
  [[nodiscard]] const std::vector<Pass>& passes() const { return passes_; }
  [[nodiscard]] const Cholesky& cholesky() const { return cholesky_; }

 private:
  [[nodiscard]] DofRow dof_row(const ContactPoint& p, const ContactRow& row, std::span<const double> q,
                               std::span<const Vec2> driven_move) const;
  /// see(row, stiffness, elongation at the start of the step) for all springs, supports and contacts.
  template <class See>
  void for_springs(See&& see) const;
  /// Brings factor and right-hand side to the states of the points.
  [[nodiscard]] bool factorise(bool fresh, StepReport& report);
  [[nodiscard]] bool factorise_anew(StepReport& report);
  [[nodiscard]] bool update(StepReport& report);
  /// d = A^-1 rhs, refined where the factor was updated. False: the updates have lost too much.
  [[nodiscard]] bool solve_linear(std::span<const double> rhs, std::span<double> d);
  /// Friction of the points that slip, and what dilation presses their springs by: loads that have to be those found.
  struct Friction {
    std::vector<std::size_t> slipping, dilating;  // points
    Eigen::VectorXd load, found;                  // of slipping ones the normal force, of dilating ones k_n opening [N]
    bool settled = false;
  };
  [[nodiscard]] bool solve_with_friction(std::span<double> d, StepReport& report);
  void gather_friction();
  /// Unknowns under the loads, and the loads that these give. False: there is no factor.
  [[nodiscard]] bool follow_friction(std::span<double> d, StepReport& report);
  /// Change of the loads found with a change of those taken.   @pre a new factor
  [[nodiscard]] Eigen::VectorXd friction_response(const Eigen::VectorXd& change);
  void evaluate_points(std::span<const double> d);
  [[nodiscard]] double limit(std::size_t i) const;
  [[nodiscard]] const JointLaw& law_of(std::size_t i) const;
  /// Slip of a slipping point in the step, in the direction that it slips in; 0 if it goes the other way [m].
  [[nodiscard]] double slip_of(std::size_t i) const;
  [[nodiscard]] double normal_stiffness(std::size_t i) const;
  [[nodiscard]] double tangential_stiffness(std::size_t i) const;
  [[nodiscard]] bool may_close(std::size_t i) const;
  /// A force by which a point may violate its state: what the numbers of a step leave, not what it is about [N].
  [[nodiscard]] double tolerance(std::size_t i) const;
  [[nodiscard]] int switch_states(bool only_worst);
  [[nodiscard]] bool refuse(StepReport& report) const;

  const Setup* setup_;
  StepControl control_;
  const ImplicitSystem* system_;
  bool allowed_, rank_updates_;
  const ContactList* list_ = nullptr;
  std::vector<StepSpring> springs_;
  std::vector<Trial> trial_;
  std::vector<double> mass_;    // of a body, as the model has it [kg]
  std::vector<double> weight_;  // of the lighter free body at a point [N]
  double largest_force_ = 0.0;  // of the points' normal forces in a pass [N]
  double gap_round_off_ = 0.0;  // to which positions define a gap [m]
  std::span<const double> A_;
  std::vector<double> rhs_, base_, scale_, factored_scale_, residual_, correction_;
  std::vector<double> friction_rhs_;
  Friction friction_;
  std::vector<Cholesky::Change> changes_;
  std::vector<Pass> passes_;
  bool factored_ = false, updated_ = false;
  Cholesky cholesky_;
};

}  // namespace scree::coupling
