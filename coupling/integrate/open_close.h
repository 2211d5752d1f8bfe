// Open-close iteration: contact states of an implicit step.
#pragma once

#include <array>
#include <vector>

#include "coupling/integrate/block_solver.h"
#include "coupling/integrate/contact_states.h"
#include "coupling/integrate/low_rank.h"
#include "coupling/integrate/time_integrator.h"
#include "coupling/linear/cholesky.h"
#include "coupling/linear/conjugate_residuals.h"
#include "coupling/unknowns/implicit_system.h"
#include "coupling/unknowns/step_springs.h"

namespace scree::coupling {

/// Solves (A + springs + closed contacts) d = rhs and switches contact states until none is violated. Friction of
/// slipping points depends on their normal force, and the normal force of dilating points on their slip: the system is
/// unsymmetric, and solved by conjugate residuals, preconditioned by the factor of the symmetric part. Water in joints
/// is a load along the gaps, with its value at the start of the step. Gaps and stretches are linear in d, about the
/// start of the step. A factor is kept from step to step as that preconditioner while it is less work than a new one;
/// State::factored contains its matrix. Otherwise the factor of the step's matrix is adapted to switched states by
/// rank updates.
/// @source docs/theory/time-integration.md, "Open-close iteration"; [Qu2013] 3.2.2, 4.5
class OpenClose {
 public:
  using Trial = ContactTrial;
  struct Pass {        // of the last step, all Newton iterations
    int switched = 0;  // points that changed state before the pass
    int updates = 0;   // rank-1 changes of the factor
    bool factorised = false;
    double factor_seconds = 0.0, seconds = 0.0;  // processor time for the factor, and in all
  };

  /// How the factor is adapted to the states.
  enum class Factor {
    anew,     // a new one per pass, for comparison
    updated,  // a new one per step, then rank updates while they are less work
    kept,     // as updated, and kept from step to step
    chosen    // if all free bodies are affine, an incomplete one of blocks, or a kept one if that is less work
  };
  /// @param allowed  false: a contact that closes makes the step fail (schemes without contacts)
  OpenClose(const Setup& setup, const StepControl& control, const ImplicitSystem& system, bool allowed, Factor factor);

  /// Controller that solve() polls once per pass for a request to give up; null: none.
  void set_control(Control* control) { control_of_run_ = control; }
  /// Makes the factor of the matrix that a state contains.
  void enter(const KeptFactor& kept);
  /// Begins a step with the points of a list and other springs, which must outlive it.
  /// @param dashpot  1/h where closed contacts are damped, 0 where they are not [1/s]
  /// @param damping  terms of sliding blocks outside the pattern; must outlive the step
  void begin(const ContactList& list, std::span<const double> q, std::span<const Vec2> driven_move,
             const StepSprings& springs, double dashpot = 0.0, std::span<const LowRank> damping = {});
  /// After begin(): matrix and springs' rows are those of the last factor, and there are no contact points.
  void keep_matrix() { current_ = same_matrix_ = cholesky_.factored(); }
  /// After solve(): adds to d what balances the forces `left` in the present states. They are far smaller than those of
  /// solve(), stiffness times displacement, and so is their round-off.
  void correct(std::span<const double> left, std::span<double> d, StepReport& report);
  /// Takes over the springs' rows again, on the same unknowns: their coefficients have changed.
  void change_springs() {
    for (std::size_t i = 0; i < springs_->size(); ++i) rows_.take_row(i, springs_->rows[i]);
  }
  /// @param A    values on the system's pattern   @param fresh  they have changed since the last call
  /// @param d    a first guess; the unknowns found
  /// @return false: the report contains the reason
  [[nodiscard]] bool solve(std::span<const double> A, bool fresh, std::span<const double> rhs, std::span<double> d,
                           StepReport& report);
  /// After solve(): the forces that it left out of balance, if it knows them.   @return false: left is unchanged
  [[nodiscard]] bool find_left(std::span<double> left) const;
  /// Checks unknowns found against states, laws and balance; before accept().
  /// @param unbalanced  force that round-off leaves on a body: contact forces are not more accurate [N]
  void check(std::span<const double> d, double unbalanced, Audit& audit);
  /// Called after an accepted step: writes what the next one begins with into `kept`.
  void accept(KeptFactor& kept);
  /// out += forces of springs, contacts and the water in joints, at the unknowns last found. Returns the largest
  /// force [N].
  double add_forces(std::span<const double> d, std::span<double> out) const;

  [[nodiscard]] const std::vector<Trial>& trials() const { return states_.trials(); }
  [[nodiscard]] const StepSprings& springs() const { return *springs_; }
  /// Rows of a point's gap and stretch in the step.
  [[nodiscard]] DofRow normal(std::size_t i) const { return states_.normal(i); }
  [[nodiscard]] DofRow tangential(std::size_t i) const { return states_.tangential(i); }
  [[nodiscard]] const std::vector<Pass>& passes() const { return passes_; }
  [[nodiscard]] const Cholesky& cholesky() const { return cholesky_; }
  /// True if the last step was solved by blocks.
  [[nodiscard]] bool by_blocks() const { return blocks_.acts; }

 private:
  // open_close_rows.cpp: gaps and stretches of the points as rows of the unknowns
  void add_rows(std::span<const double> q, std::span<const Vec2> driven_move);
  void add_rows(const ContactPoint& p, const ContactMemory& m, std::span<const double> q,
                std::span<const Vec2> driven_move);
  [[nodiscard]] const ChartRow& chart(OutlineNode node, std::span<const double> q);
  /// add_rows() for affine bodies, on threads.   @return false: a chart does not have six successive unknowns
  [[nodiscard]] bool add_affine_rows(std::span<const double> q, std::span<const Vec2> driven_move);
  /// Finds the charts of the points' nodes, and the sizes of their rows.
  [[nodiscard]] bool find_affine_charts(std::span<const double> q);
  void fill_affine_rows(std::size_t point, std::span<const Vec2> driven_move);
  /// Closes the points that the first guess d of a step closes, and decides whether to solve exactly at once.
  void predict(std::span<const double> d, StepReport& report);
  /// Adds the forces of the water in joints to base_.
  void add_water();
  /// Finds stiffnesses and right-hand side for the states of the points, where a complete factor solves.
  void apply_states();
  /// Adds the forces of springs and points at no displacement to rhs_.
  void add_state_forces();
  /// Adapts the factor to these states, or leaves a kept one as it is.
  [[nodiscard]] bool factorise(bool fresh, StepReport& report);
  [[nodiscard]] bool factorise_anew(StepReport& report);
  [[nodiscard]] bool update(StepReport& report);
  /// y = (A + springs + closed contacts, with friction of those that slip) x.
  void multiply(std::span<const double> x, std::span<double> y) const;
  /// The largest force in the equations at a solution [N].
  [[nodiscard]] double force_scale(std::span<const double> d) const;
  /// Round-off of the forces inside the bodies and of the springs between them [N].
  [[nodiscard]] double round_off(std::span<const double> d) const;
  /// True if the factor is not that of the whole matrix: points slip, or damping has terms outside the pattern.
  [[nodiscard]] bool unsymmetric() const { return !slipping_.empty() || !damping_.empty(); }
  /// Conjugate residuals with the factor as it is, for the matrix of the present states.
  /// @return iterations; -1: not converged
  int iterate(std::span<const double> rhs, double enough, int most, std::span<double> d);
  /// iterate() to the accuracy that the pass requires.
  int improve(int most, std::span<double> d, StepReport& report);
  /// Finds the unknowns for the states; makes a new factor if the present one takes too many iterations.
  [[nodiscard]] bool solve_states(std::span<double> d, StepReport& report);
  // open_close_blocks.cpp: the solution by blocks
  /// Decides whether the step is solved by blocks.
  void begin_blocks();
  /// Assembles the matrix for the states, and makes a factor if there is no useful one.   @return false: a pivot failed
  [[nodiscard]] bool take_blocks(bool fresh, StepReport& report);
  [[nodiscard]] bool factorise_blocks(StepReport& report);
  /// Conjugate residuals for the matrix of blocks, until what is left is below a part of the largest force, or `least`.
  /// @return iterations; -1: not converged
  int iterate_blocks(double part_of, double least, int most, std::span<double> d);
  /// @return false: the iteration stalls; d is unchanged
  [[nodiscard]] bool solve_blocks(std::span<double> d, StepReport& report);
  /// Changes to a complete factor for the rest of the step.
  void leave_blocks(StepReport& report);
  // open_close_clusters.cpp: states settled around the points that have switched
  /// The bodies of the points that have switched, and one ring of closed contacts around them, form clusters. In each
  /// cluster that is not too large, states are settled with the bodies outside fixed: passes of all bodies would
  /// propagate these changes by one body per pass.
  /// @pre blocks act   @param d  the unknowns that the states were found with; changed in clusters
  void settle_clusters(std::span<double> d, StepReport& report);
  void find_cluster_bodies();
  void settle_cluster(std::span<double> d, StepReport& report);
  void begin_cluster();
  /// Finds the residual forces on the bodies of the cluster at d.   @return the largest force in their sums [N]
  double find_cluster_residual(std::span<const double> d);
  [[nodiscard]] bool solve_cluster(std::span<double> d);
  /// Chooses the solver that the next step begins with, from the work counted in this one.
  void choose_solver();
  [[nodiscard]] bool refuse(StepReport& report) const;

  const Setup* setup_;
  StepControl control_;
  const ImplicitSystem* system_;
  bool allowed_;
  Factor factor_;
  Control* control_of_run_ = nullptr;
  const ContactList* list_ = nullptr;
  const StepSprings* springs_ = nullptr;
  std::span<const LowRank> damping_;
  DofRows rows_;  // springs, then gap and stretch of every point
  ContactStates states_;
  std::vector<double> k_, at_;  // of the rows, in the present states: stiffness, elongation at the start of the step
  std::vector<ChartRow> charts_;
  /// A ChartRow of six successive unknowns; ChartRow itself has room for three times as many.
  struct AffineChart {
    std::int32_t first = -1;  // unknown
    std::array<double, 6> tx{}, ty{};
  };
  std::vector<AffineChart> affine_charts_;
  std::vector<OutlineNode> charted_;                        // nodes with an affine chart
  std::vector<std::int32_t> row_size_;                      // scratch: unknowns of each row
  IndexedVector<OutlineNode, std::int32_t> chart_of_node_;  // -1: none yet in this step
  std::span<const double> A_;
  std::vector<double> rhs_, base_, factored_k_, correction_;
  std::vector<std::size_t> active_;  // rows whose stiffness is not zero
  /// A point that slips in a pass.
  struct Slipping {
    std::size_t point = 0;
    double friction_per_gap = 0.0;
    bool dilates = false;
    DilatingForce dilation;
  };
  std::vector<Slipping> slipping_;
  std::vector<std::vector<std::size_t>> active_by_chunk_;  // scratch, as the next
  std::vector<std::vector<Slipping>> slipping_by_chunk_;
  std::vector<std::size_t> seen_;  // hashes of the states of earlier passes
  ConjugateResiduals residuals_;
  std::vector<Cholesky::Change> changes_;
  std::vector<Pass> passes_;
  bool predict_ = false;      // the first solve() of the step has not begun yet
  bool current_ = false;      // the factor is that of the step's matrix, with updates
  bool same_matrix_ = false;  // keep_matrix() was called in the step
  bool updated_ = false;
  bool exact_ = false;            // the pass is to solve to round-off: not before states seem to have settled
  bool rough_ = false;            // the present solution is less accurate
  bool friction_settled_ = true;  // in the last pass
  bool keep_ = false;             // this step may use the kept factor
  int corrections_left_ = 0;      // iterations that this step may still take with that factor
  bool made_ = false;             // a factor was made since the last accept()
  KeptFactor::Patience patience_;
  KeptFactor::Choice choice_;
  BlockSolver blocks_;
  struct Counts {
    int switches = 0, corrections = 0, factorisations = 0;
  };
  Counts counts_;  // of the present step
  BodyClusters clusters_;
  Cholesky cholesky_;
};

}  // namespace scree::coupling
