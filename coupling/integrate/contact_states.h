// Contact states of an implicit step: open, stick or slip, their forces, and the states that they violate.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "coupling/contact/audit/audit.h"
#include "coupling/contact/contact_energy.h"
#include "coupling/contact/law/dilation.h"
#include "coupling/contact/law/joint_strength.h"
#include "coupling/integrate/block_system.h"
#include "coupling/integrate/contact_trial.h"
#include "coupling/linear/dof_rows.h"

namespace scree::coupling {

/// The active set of the open-close iteration: each contact point of a step has a state, in which its forces are
/// linear in the unknowns d of the step. The unknowns found with given states determine which states are violated,
/// and which states those points change to.
/// @source docs/theory/time-integration.md, "Open-close iteration"; [Qu2013] 3.2.2, 4.5
class ContactStates {
 public:
  /// A state that a point changes to.
  struct ProposedState {
    ContactStatus status = ContactStatus::open;
    double direction = 0.0;
    bool opens = false, slack = false;
    double violation = 0.0;  // of the present state, as a force [N]
  };

  explicit ContactStates(const Setup& setup);

  /// Begins a step with the points of a list, in the states that they had at its start. List and rows must outlive it.
  /// @param rows     from `first` on the gap and the stretch of each point
  /// @param q        positions at the start of the step [m]
  /// @param dashpot  1/h where closed contacts are damped, 0 where they are not [1/s]
  void begin(const ContactList& list, const DofRows& rows, std::size_t first, std::span<const double> q,
             double dashpot);

  [[nodiscard]] std::size_t size() const { return trial_.size(); }
  [[nodiscard]] const ContactTrial& operator[](std::size_t i) const { return trial_[i]; }
  [[nodiscard]] const std::vector<ContactTrial>& trials() const { return trial_; }
  /// Rows of a point's gap and stretch in the step.
  [[nodiscard]] DofRow normal(std::size_t i) const { return (*rows_)[first_ + 2 * i]; }
  [[nodiscard]] DofRow tangential(std::size_t i) const { return (*rows_)[first_ + 2 * i + 1]; }

  // Forces of a point in its state.
  [[nodiscard]] double normal_stiffness(std::size_t i) const;      // [N/m]
  [[nodiscard]] double tangential_stiffness(std::size_t i) const;  // [N/m]
  /// Derivatives of its forces by gap and stretch.
  [[nodiscard]] PointTangent tangent(std::size_t i) const;
  [[nodiscard]] LinearContactForce linear_force(std::size_t i) const;
  /// Stretch of its spring at the start of the step [m].
  [[nodiscard]] double stretch_before(std::size_t i) const;
  /// Decrease of the friction force of a slipping point per opening of its gap [N/m].
  [[nodiscard]] double friction_per_gap(std::size_t i) const;
  /// Friction force of a slipping point without a normal force: cohesion, along its direction [N].
  [[nodiscard]] double cohesion(std::size_t i) const { return trial_[i].direction * strength_[i].friction_limit(0.0); }
  /// True if a point slips and its normal force depends on its slip.
  [[nodiscard]] bool dilates(std::size_t i) const {
    return trial_[i].status == ContactStatus::slip && law_of(i).dilation > 0.0 && !trial_[i].slack;
  }
  /// Normal force of a slipping point that dilates, linear in gap and stretch.
  [[nodiscard]] DilatingForce dilation(std::size_t i) const;
  /// The force of a slack point [N].
  [[nodiscard]] double slack_force(std::size_t i) const {
    return trial_[i].status == ContactStatus::stick ? -strength_[i].tension : 0.0;
  }

  /// Finds gaps, stretches and forces at d, in the states that the points have.
  void evaluate(std::span<const double> d);
  void evaluate_point(std::size_t i, std::span<const double> d);

  /// Changes the states that the last evaluation violates.
  /// @param only_worst  only the point of each body that violates its state most   @return number of points
  [[nodiscard]] int change(bool only_worst);
  /// change() for some points.   @param only_worst  one of all of them   @return false: none violates its state
  [[nodiscard]] bool change_among(std::span<const std::size_t> points, bool only_worst);
  /// Closes the open points whose state d violates: the first guess of a step. Others are not evaluated.
  /// @return number of points
  [[nodiscard]] int close(std::span<const double> d);
  /// Points of the last change().
  [[nodiscard]] const std::vector<std::size_t>& changed() const { return changed_; }

  /// Hash of the states of all points, or of some: detects states that an earlier pass had.
  [[nodiscard]] std::size_t hash();
  [[nodiscard]] std::size_t hash(std::span<const std::size_t> points);

  /// A point that is closed, or closes according to the last evaluation; null: there is none.
  [[nodiscard]] const ContactKey* closing() const;
  /// Checks unknowns found against states and laws.
  /// @param unbalanced  force that round-off leaves on a body: contact forces are not more accurate [N]
  void check(std::span<const double> d, double unbalanced, Audit& audit) const;

 private:
  [[nodiscard]] const JointLaw& law_of(std::size_t i) const;
  /// Slip left at the start of the step until dilation ends [m]; infinite: it does not end.
  [[nodiscard]] double slip_left(std::size_t i) const;
  /// Normal force of a closed point that is not slack, at a change of its gap from the start of the step [N].
  [[nodiscard]] static double pressed(const ContactTrial& t, double change) { return -t.k * (t.at + change); }
  /// Normal force that strength is taken from: bonds fail by the spring's force, not by the dashpot's [N].
  [[nodiscard]] double bearing_force(std::size_t i) const;
  [[nodiscard]] bool may_close(std::size_t i) const;
  /// True if the vertex of a point has a closed contact with another edge of nearly the same normal: once its foot has
  /// left that edge, the contact moves to this one with its force.
  [[nodiscard]] bool held_beside(std::size_t i) const;
  /// Force by which a point may violate its state: numerical error of a step, no physical violation [N].
  [[nodiscard]] double tolerance(std::size_t i) const;
  /// A point whose dashpot pulls too much becomes slack; a slack one may return.   @return true if it should change
  [[nodiscard]] bool proposes_slack(std::size_t i, ProposedState& w) const;
  /// True if an open point that touched at the start of the step is closed where it slips: its own slip opens the joint
  /// there by more than its gap. Both states could be without contradiction, since an open point does not dilate; but a
  /// joint that slides in contact rides up as a whole.   @param w  receives that state
  [[nodiscard]] bool rides(std::size_t i, ProposedState& w) const;
  [[nodiscard]] ProposedState proposed_state(std::size_t i) const;
  [[nodiscard]] ProposedState proposed_of_open(std::size_t i) const;
  using Proposals = std::vector<std::pair<std::size_t, ProposedState>>;
  /// Lists a point in `out` if it is to change.
  void propose(std::size_t i, Proposals& out) const;
  /// Finds proposed_ among the points that `may` is true for, in their order.
  template <class May>
  void propose_all(May&& may);
  void adopt(std::size_t i, const ProposedState& w);
  /// A character for the state of a point.
  [[nodiscard]] static char letter(const ContactTrial& t);

  const Setup* setup_;
  const DofRows* rows_ = nullptr;
  std::size_t first_ = 0;
  const ContactList* list_ = nullptr;
  std::vector<double> mass_;  // per body, from its polygon in the model [kg]
  std::vector<ContactTrial> trial_;
  std::vector<Strength> strength_;          // of the points
  std::vector<double> weight_;              // of the lighter free body at a point [N]
  double largest_force_ = 0.0;              // of the points' normal forces in a pass [N]
  double gap_round_off_ = 0.0;              // of a gap, from that of positions [m]
  Proposals proposed_;                      // of points that change in a pass
  std::vector<Proposals> by_chunk_;         // scratch: the same, of every chunk of points
  IndexedVector<BodyIndex, double> worst_;  // per body: largest violation of its points [N]
  std::vector<std::size_t> changed_;
  std::string letters_;
};

}  // namespace scree::coupling
