// Implicit Newmark (beta = 1/2, gamma = 1) with open-close iteration, for every method with a chart.
#pragma once

#include <vector>

#include "coupling/contact/contact_energy.h"
#include "coupling/integrate/cholesky.h"
#include "coupling/integrate/mover.h"
#include "coupling/integrate/point_springs.h"

namespace scree::coupling {

/// A scalar of the step, linear in the unknowns: change = h.d + known.
struct DofRow {
  std::vector<std::int32_t> dof;
  std::vector<double> h;
  double known = 0.0;  // part of driven bodies
  [[nodiscard]] double change(std::span<const double> d) const;
};

///   (2 M/h^2 + K + sum_active k h h^T) d = f_int + f_ext + 2 M v/h - sum_active k g h,  v' = 2 d/h - v
/// Contact states are found by open-close iteration; friction of sliding points is a load of the right-hand side that
/// follows their normal force (Anderson acceleration, GMRES for a linear iteration). Then every body is retracted
/// through its chart. What linear forms and exact geometry differ by is booked in columns of its own.
/// @source nmm.md "Time integration"; thesis 3.3.2, 3.2.2, 4.5; Shi 1988
class Newmark final : public Mover {
 public:
  /// @param rest  velocities are dropped after every step: a static solution, reached by steps of the dynamic one
  Newmark(const Setup& setup, const StepControl& control, double detection, bool rest = false);

  double enter(State& state) override;
  StepReport step(State& state, Tick ticks_of_step) override;
  void leave(State& state) override;
  void update_ledger(State& state) override;
  double stable_step(const State& state, std::string* binding) override;

 private:
  struct Trial {  // a contact point during the iteration
    DofRow normal, tangential;
    ContactStatus status = ContactStatus::open;
    double direction = 0.0;  // sign of the friction force while slipping
    double load = 0.0;       // normal force that its friction limit was taken from [N]
    double fn = 0.0, ft = 0.0, gap = 0.0, stretch = 0.0, moved = 0.0;  // linear outcome; moved: tangential change
  };
  void linearise(const State& state, double h);
  [[nodiscard]] DofRow dof_row(const ContactPoint& p, const ContactRow& row, std::span<const double> q) const;
  void add_point(DofRow& out, std::int32_t body, const Row& row, const Vec2& c, std::span<const double> q) const;
  void assemble(double h);
  [[nodiscard]] bool solve_with_friction(StepReport& report);
  void evaluate_points();
  [[nodiscard]] double limit(std::size_t i) const;
  [[nodiscard]] bool may_close(std::size_t i) const;
  [[nodiscard]] int switch_states(bool only_worst);
  [[nodiscard]] bool iterate(double h, StepReport& report);
  void accept(State& state, Tick ticks_of_step);
  void book_linear(Ledger& ledger, double& spring_after, double& elastic_after, double& support_after,
                   double& kinetic_after, double h);

  const Setup* setup_;
  StepControl control_;
  bool rest_;
  ContactFinder finder_;
  ContactList list_, before_;
  std::vector<PointSpring> springs_;
  std::vector<std::array<DofRow, 2>> spring_rows_;
  std::vector<std::array<double, 2>> spring_offset_;
  std::vector<std::int32_t> first_dof_;  // a body; -1: driven
  std::int32_t dofs_ = 0;
  std::vector<ImplicitBlock> blocks_;  // first_dof counts over all bodies
  std::vector<Vec2> driven_move_;      // a body
  std::vector<Trial> trial_;
  std::vector<double> rhs_, base_, d_, rate_, gravity_, q_new_, v_new_;
  Cholesky cholesky_;
};

}  // namespace scree::coupling
