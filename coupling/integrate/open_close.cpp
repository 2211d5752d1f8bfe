#include "coupling/integrate/open_close.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

#include "coupling/contact/law/joint_strength.h"
#include "coupling/sink.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

/// Iterations with a kept factor that cost as much as a new one: measured 14, 11 and 13 at 600, 6,000 and 60,000
/// unknowns of blocks. The work counts of CHOLMOD give 4 to 44: dense blocks get faster and solutions slower with size.
constexpr int kCorrectionsPerFactor = 12;

}  // namespace

OpenClose::OpenClose(const Setup& setup, const StepControl& control, const ImplicitSystem& system, bool allowed,
                     Factor factor)
    : setup_(&setup),
      control_(control),
      system_(&system),
      allowed_(allowed),
      factor_(factor),
      states_(setup),
      blocks_(system) {
  cholesky_.set_pattern(system.pattern());
  chart_of_node_.assign(setup.outlines().nodes.size(), -1);
}

void OpenClose::enter(const KeptFactor& kept) {
  patience_ = kept.patience;
  choice_ = kept.choice;
  made_ = false;
  cholesky_.set_pattern(system_->pattern());
  if (kept.column_start.empty()) return;
  SymmetricMatrix matrix;
  matrix.pattern.n = static_cast<std::int32_t>(kept.column_start.size()) - 1;
  matrix.pattern.column_start = kept.column_start;
  matrix.pattern.row = kept.row;
  matrix.value = kept.value;
  (void)cholesky_.factorise(matrix);  // if not definite, nor was it in the run that wrote it, which continues without
}

void OpenClose::accept(KeptFactor& kept) {
  if (factor_ != Factor::kept && factor_ != Factor::chosen) return;
  if (factor_ == Factor::chosen && system_->affine() && damping_.empty()) {
    choose_solver();
    kept.choice = choice_;
    if (choice_.direct == 0) {  // the next step needs none
      kept.column_start.clear();
      kept.row.clear();
      kept.value.clear();
      if (cholesky_.factored()) cholesky_.set_pattern(system_->pattern());
      made_ = false;
      kept.patience = patience_;  // a kept factor that failed in this step may have made the wait longer
      return;
    }
  }
  if (made_) {
    const SymmetricMatrix& matrix = cholesky_.matrix();
    kept.column_start = matrix.pattern.column_start;
    kept.row = matrix.pattern.row;
    kept.value = matrix.value;
    made_ = false;
    patience_.least = -1;
    patience_.excess = 0;
  }
  if (patience_.wait > 0) --patience_.wait;
  if (keep_) {
    // A new factor is made once the additional iterations with the old one have cost as much as a factor.
    patience_.next_wait = 0;
    const int taken = kCorrectionsPerFactor - corrections_left_;
    if (patience_.least < 0 || taken < patience_.least) patience_.least = taken;
    patience_.excess += std::max(0, taken - patience_.least - 1);
    if (patience_.excess >= kCorrectionsPerFactor) patience_.wait = 1;
  }
  kept.patience = patience_;
}

void OpenClose::begin(const ContactList& list, std::span<const double> q, std::span<const Vec2> driven_move,
                      const StepSprings& springs, double dashpot, std::span<const LowRank> damping) {
  list_ = &list;
  springs_ = &springs;
  damping_ = damping;
  current_ = updated_ = same_matrix_ = false;
  predict_ = allowed_;
  corrections_left_ = kCorrectionsPerFactor;
  counts_ = {};
  passes_.clear();
  rows_.clear();
  for (std::size_t i = 0; i < springs.size(); ++i) rows_.add_row(springs.rows[i]);
  add_rows(q, driven_move);
  states_.begin(list, rows_, springs.size(), q, dashpot);
  begin_blocks();
  keep_ = !blocks_.acts && (factor_ == Factor::kept || factor_ == Factor::chosen) && !system_->nonlinear() &&
          cholesky_.factored() && patience_.wait == 0;
  if (keep_) cholesky_.drop_updates();
}

void OpenClose::apply_states() {
  const std::size_t springs = springs_->size();
  k_.resize(rows_.size());
  at_.resize(rows_.size());
  std::copy(springs_->k.begin(), springs_->k.end(), k_.begin());
  std::copy(springs_->at.begin(), springs_->at.end(), at_.begin());
  const auto take_point = [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    k_[springs + 2 * i] = states_.normal_stiffness(i);
    at_[springs + 2 * i] = states_[i].at;
    k_[springs + 2 * i + 1] = states_.tangential_stiffness(i);
    at_[springs + 2 * i + 1] = states_.stretch_before(i);
  };
  parallel_for(static_cast<std::int64_t>(states_.size()), take_point, kFewPoints);
  parallel_list(
      std::ssize(k_), active_by_chunk_, active_,
      [&](std::int64_t r, std::vector<std::size_t>& out) {
        if (k_[static_cast<std::size_t>(r)] != 0.0) out.push_back(static_cast<std::size_t>(r));
      },
      2 * kFewPoints);
  parallel_list(
      static_cast<std::int64_t>(states_.size()), slipping_by_chunk_, slipping_,
      [&](std::int64_t at, std::vector<Slipping>& out) {
        const auto i = static_cast<std::size_t>(at);
        if (states_[i].status != ContactStatus::slip) return;
        const bool dilating = states_.dilates(i);
        out.push_back({i, states_.friction_per_gap(i), dilating, dilating ? states_.dilation(i) : DilatingForce{}});
      },
      kFewPoints);
  rhs_ = base_;
  add_state_forces();
}

void OpenClose::add_state_forces() {
  for (const std::size_t r : active_) rows_[r].add_force(-k_[r] * (at_[r] + rows_[r].known), rhs_);
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (states_[i].slack) states_.normal(i).add_force(states_.slack_force(i), rhs_);
  // Coulomb's force c + tan phi f_n of slipping points: a part that varies with the gap, as f_n does, and a constant.
  for (const Slipping& s : slipping_) {
    const std::size_t i = s.point;
    const Trial& t = states_[i];
    const DofRow normal = states_.normal(i), tangential = states_.tangential(i);
    const double gap = t.at + normal.known;
    if (!s.dilates) {
      tangential.add_force(states_.cohesion(i) - s.friction_per_gap * gap, rhs_);
      continue;
    }
    const double force =
                     -(s.dilation.per_gap * gap +
                       s.dilation.per_stretch * (states_.stretch_before(i) + tangential.known) + s.dilation.constant),
                 spring = -t.k * gap;  // without dilation, which rhs_ includes
    normal.add_force(force - spring, rhs_);
    tangential.add_force(states_.cohesion(i) + s.friction_per_gap / t.k * force, rhs_);
  }
}

bool OpenClose::factorise(bool fresh, StepReport& report) {
  if (blocks_.acts) {
    if (take_blocks(fresh, report)) return true;
    leave_blocks(report);
  } else {
    apply_states();
  }
  if (keep_ || (current_ && !fresh && (same_matrix_ || k_ == factored_k_ || update(report)))) return true;
  return factorise_anew(report);
}

bool OpenClose::factorise_anew(StepReport& report) {
  keep_ = updated_ = same_matrix_ = false;
  current_ = cholesky_.factorise(A_, rows_, k_);
  made_ = true;
  ++report.factorisations;
  ++counts_.factorisations;
  factored_k_ = k_;
  if (current_) return true;
  report.status = StepReport::Status::not_definite;
  report.cause = "the implicit matrix is not positive definite";
  return false;
}

bool OpenClose::update(StepReport& report) {
  if (factor_ == Factor::anew) return false;
  changes_.clear();
  for (std::size_t r = 0; r < rows_.size(); ++r)
    if (const double delta = k_[r] - factored_k_[r]; delta != 0.0 && !rows_[r].dof.empty())
      changes_.push_back({r, delta});
  if (!cholesky_.update_pays(rows_, changes_) || !cholesky_.update(rows_, changes_)) return false;
  report.updates += static_cast<int>(changes_.size());
  factored_k_ = k_;
  updated_ = true;
  return true;
}

void OpenClose::predict(std::span<const double> d, StepReport& report) {
  const int closed = states_.close(d);
  report.switches += closed;
  // Probably no state will change. A rough solution first would take two more passes over all points; where a state
  // changes all the same, a few iterations were in vain, which by blocks take less time than that.
  exact_ = blocks_.acts && closed == 0;
}

void OpenClose::add_water() {
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (const double water = list_->memory[i].water; water != 0.0) states_.normal(i).add_force(water, base_);
}

bool OpenClose::solve(std::span<const double> A, bool fresh, std::span<const double> rhs, std::span<double> d,
                      StepReport& report) {
  base_.assign(rhs.begin(), rhs.end());
  if (!setup_->model().waters.empty()) add_water();
  A_ = A;
  seen_.clear();
  bool only_worst = false;
  constexpr int kPatience = 3;
  int switched = 0, stalled = 0;
  // After a cycle the points of a body switch one at a time, which takes more passes but is more reliable. Many points
  // take more passes than few: only passes that do not halve the number of switches count.
  int left = control_.max_passes, fewest = std::numeric_limits<int>::max();
  exact_ = false;
  if (std::exchange(predict_, false)) predict(d, report);
  for (int pass = 0; left > 0; ++pass, --left) {
    if (control_of_run_ != nullptr && control_of_run_->give_up_step()) {
      report.status = StepReport::Status::given_up;
      report.cause = "given up on request";
      return false;
    }
    ++report.passes;
    const std::clock_t begin = std::clock();
    const int updates = report.updates, factorisations = report.factorisations;
    if (!factorise(fresh && pass == 0, report)) return false;
    const std::clock_t factored = std::clock();
    if (!solve_states(d, report)) return false;
    states_.evaluate(d);
    if (!allowed_ && refuse(report)) return false;
    const std::size_t now = states_.hash();
    const bool cycle = std::find(seen_.begin(), seen_.end(), now) != seen_.end();
    seen_.push_back(now);
    if (cycle && !exact_) {
      exact_ = true;
      seen_.clear();
    } else if ((cycle || stalled >= kPatience) && !only_worst) {
      only_worst = true;
      left = 3 * control_.max_passes;
    }
    const int before_it = switched;
    switched = states_.change(only_worst);
    if (switched == 0 && rough_) {
      exact_ = true;
      if (!solve_states(d, report)) return false;
      states_.evaluate(d);
      switched = states_.change(only_worst);
    }
    const auto since = [&](std::clock_t end) { return static_cast<double>(end - begin) / CLOCKS_PER_SEC; };
    passes_.push_back({before_it, report.updates - updates, report.factorisations > factorisations, since(factored),
                       since(std::clock())});
    if (switched == 0 && friction_settled_) return true;
    if (switched == 0) {
      report.status = StepReport::Status::no_friction;
      report.cause = "friction forces did not settle (a wedge whose friction exceeds what its walls can balance?)";
      return false;
    }
    if (pass == 0) exact_ = false;
    if (blocks_.acts) settle_clusters(d, report);
    report.switches += switched;
    counts_.switches += switched;
    ++stalled;
    if (switched <= fewest / 2) {
      fewest = switched;
      stalled = 0;
      left = std::max(left, control_.max_passes + 1);
    }
  }
  report.status = StepReport::Status::no_states;
  report.cause = fmt::format("contact states did not settle in {} passes", report.passes);
  return false;
}

void OpenClose::check(std::span<const double> d, double unbalanced, Audit& audit) {
  states_.check(d, unbalanced, audit);
  if (d.empty()) return;             // every body is held, or explicit
  if (blocks_.acts) apply_states();  // so far in the blocks alone
  std::vector<double> residual(d.size());
  multiply(d, residual);
  double left = 0.0;
  for (std::size_t i = 0; i < residual.size(); ++i)
    left = std::max(left, std::abs(rhs_[i] - residual[i]) / system_->unit()[i]);
  audit.check(left, std::max(1e-11 * force_scale(d), 4.0 * round_off(d)),
              [&] { return fmt::format("the forces of a step are {:.3g} N out of balance", left); });
}

bool OpenClose::refuse(StepReport& report) const {
  const ContactKey* key = states_.closing();
  if (key == nullptr) return false;
  const auto& blocks = setup_->model().blocks;
  report.status = StepReport::Status::refused;
  report.cause = fmt::format(
      "blocks '{}' and '{}' touch, and the trapezoidal scheme has no contacts; use newmark = "
      "\"damped\"",
      blocks[static_cast<std::size_t>(key->block_p)].name, blocks[static_cast<std::size_t>(key->block_e)].name);
  return true;
}

double OpenClose::add_forces(std::span<const double> d, std::span<double> out) const {
  double largest = 0.0;
  const auto add = [&](const DofRow& row, double force) {
    largest = std::max(largest, std::abs(force));
    if (force != 0.0) row.add_force(force, out);
  };
  for (std::size_t i = 0; i < springs_->size(); ++i) add(springs_->rows[i], springs_->force(i, d));
  for (std::size_t i = 0; i < states_.size(); ++i) {
    add(states_.normal(i), states_[i].fn);
    add(states_.normal(i), list_->memory[i].water);
    add(states_.tangential(i), states_[i].ft);
  }
  return largest;
}

}  // namespace scree::coupling
