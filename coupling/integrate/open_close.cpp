#include "coupling/integrate/open_close.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "coupling/contact/law/joint_strength.h"
#include "coupling/sink.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

/// Iterations with a kept factor that cost what a new one does: seen 14, 11 and 13 at 600, 6,000 and 60,000 unknowns of
/// blocks. The work counts of CHOLMOD say 4 to 44: dense blocks get quicker and solutions slower as both grow.
constexpr int kCorrectionsPerFactor = 12;

}  // namespace

OpenClose::OpenClose(const Setup& setup, const StepControl& control, const ImplicitSystem& system, bool allowed,
                     Factor factor)
    : setup_(&setup), control_(control), system_(&system), allowed_(allowed), factor_(factor), blocks_(system) {
  cholesky_.set_pattern(system.pattern());
  chart_of_node_.assign(setup.outlines().nodes.size(), -1);
  for (const Body& b : setup.bodies()) {
    const Model& model = setup.model();
    mass_.push_back(model.material_of(b.block).density * moments(model.blocks[b.block.index()].polygon).area);
  }
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
  (void)cholesky_.factorise(matrix);  // not definite: neither was it for the run that wrote it, which goes on without
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
      kept.patience = patience_;  // a kept factor that failed in this step may have made it longer
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
    // What the factor costs beyond what it did when it was new has paid for another one, sooner or later.
    patience_.next_wait = 0;
    const int taken = kCorrectionsPerFactor - corrections_left_;
    if (patience_.least < 0 || taken < patience_.least) patience_.least = taken;
    patience_.excess += std::max(0, taken - patience_.least - 1);
    if (patience_.excess >= kCorrectionsPerFactor) patience_.wait = 1;
  }
  kept.patience = patience_;
}

const ChartRow& OpenClose::chart(std::int32_t node, std::span<const double> q) {
  const Outlines& o = setup_->outlines();
  const auto n = static_cast<std::size_t>(node);
  if (chart_of_node_[n] < 0) {
    chart_of_node_[n] = static_cast<std::int32_t>(charts_.size());
    charts_.push_back(system_->chart(o.node_body[n], o.nodes[n], q));
  }
  return charts_[static_cast<std::size_t>(chart_of_node_[n])];
}

void OpenClose::add_rows(const ContactPoint& p, const ContactMemory& m, std::span<const double> q,
                         std::span<const Vec2> driven_move) {
  const Outlines& o = setup_->outlines();
  for (const ContactRow& row : {gap_row(p.at), stretch_row(p.at, m.anchor)}) {
    rows_.begin_row();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto body = static_cast<std::size_t>(o.node_body[static_cast<std::size_t>(p.node[i])]);
      if (setup_->bodies()[body].driven)
        rows_.add_known(row[i].dot(driven_move[body]));
      else
        ImplicitSystem::add_point(chart(p.node[i], q), row[i], rows_);
    }
  }
}

void OpenClose::begin(const ContactList& list, std::span<const double> q, std::span<const Vec2> driven_move,
                      const StepSprings& springs, double dashpot, std::span<const LowRank> damping) {
  list_ = &list;
  springs_ = &springs;
  damping_ = damping;
  current_ = updated_ = false;
  predict_ = allowed_;
  corrections_left_ = kCorrectionsPerFactor;
  counts_ = {};
  passes_.clear();
  rows_.clear();
  for (std::size_t i = 0; i < springs.size(); ++i) rows_.add_row(springs.rows[i]);
  charts_.clear();
  std::fill(chart_of_node_.begin(), chart_of_node_.end(), -1);
  trial_.resize(list.points.size());
  weight_.resize(trial_.size());
  strength_.resize(trial_.size());
  double farthest = 0.0;
  for (const double x : q) farthest = std::max(farthest, std::abs(x));
  gap_round_off_ = 8.0 * std::numeric_limits<double>::epsilon() * farthest;
  const double g = setup_->model().gravity.norm();
  const auto weight = [&](std::int32_t node) {
    const auto b = static_cast<std::size_t>(setup_->outlines().node_body[static_cast<std::size_t>(node)]);
    return setup_->bodies()[b].driven ? std::numeric_limits<double>::infinity() : g * mass_[b];
  };
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const ContactPoint& p = list.points[i];
    const ContactMemory& m = list.memory[i];
    add_rows(p, m, q, driven_move);
    strength_[i] = strength(law_of(i), m);
    trial_[i] = {p.suppressed ? ContactStatus::open : m.status, m.ft < 0.0 ? -1.0 : 1.0, m.fn};
    Trial& t = trial_[i];
    t.opens = law_of(i).dilation > 0.0 && slip_left(i) > 0.0;
    // A contact that closes in this step is not damped yet: the dashpot could hold it open.
    t.k = m.kn + (t.status != ContactStatus::open ? dashpot * p.cn : 0.0);
    t.at = m.kn / t.k * m.gap;
    weight_[i] = std::min(weight(p.node[0]), weight(p.node[1]));
  }
  begin_blocks();
  keep_ = !blocks_.acts && (factor_ == Factor::kept || factor_ == Factor::chosen) && !system_->nonlinear() &&
          cholesky_.factored() && patience_.wait == 0;
  if (keep_) cholesky_.drop_updates();
}

const JointLaw& OpenClose::law_of(std::size_t i) const {
  return setup_->laws()[static_cast<std::size_t>(list_->memory[i].joint)];
}

double OpenClose::stretch_before(std::size_t i) const {
  const ContactMemory& m = list_->memory[i];
  return m.status == ContactStatus::open ? 0.0 : m.stretch;
}

double OpenClose::limit(std::size_t i) const { return strength_[i].friction_limit(trial_[i].load); }

double OpenClose::slip_left(std::size_t i) const {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return std::max(0.0, law_of(i).dilation_slip.value_or(kInf) - list_->memory[i].slip);
}

DilatingForce OpenClose::dilation(std::size_t i) const {
  const Trial& t = trial_[i];
  return dilating_force(law_of(i), strength_[i], t.k, list_->memory[i].kt, t.direction, t.opens, slip_left(i));
}

double OpenClose::normal_stiffness(std::size_t i) const {
  return trial_[i].status == ContactStatus::open || trial_[i].slack ? 0.0 : trial_[i].k;
}

double OpenClose::tangential_stiffness(std::size_t i) const {
  return trial_[i].status == ContactStatus::stick ? list_->memory[i].kt : 0.0;
}

void OpenClose::apply_states() {
  k_.assign(springs_->k.begin(), springs_->k.end());
  at_.assign(springs_->at.begin(), springs_->at.end());
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    k_.push_back(normal_stiffness(i));
    at_.push_back(trial_[i].at);
    k_.push_back(tangential_stiffness(i));
    at_.push_back(stretch_before(i));
  }
  rhs_ = base_;
  active_.clear();
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (k_[r] == 0.0) continue;
    active_.push_back(r);
    rows_[r].add_force(-k_[r] * (at_[r] + rows_[r].known), rhs_);
  }
  for (std::size_t i = 0; i < trial_.size(); ++i)
    if (trial_[i].slack) normal(i).add_force(slack_force(i), rhs_);
  // Coulomb's force c + tan phi f_n on what slips: with the gap, of which f_n is a multiple, and without.
  slipping_.clear();
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    Trial& t = trial_[i];
    if (t.status != ContactStatus::slip) continue;
    t.load = 0.0;
    const bool dilating = dilates(i) && !t.slack;
    const Slipping s{i, friction_per_gap(i), dilating, dilating ? dilation(i) : DilatingForce{}};
    slipping_.push_back(s);
    const double gap = t.at + normal(i).known;
    if (!s.dilates) {
      tangential(i).add_force(t.direction * limit(i) - s.friction_per_gap * gap, rhs_);
      continue;
    }
    const double force = -(s.dilation.per_gap * gap +
                           s.dilation.per_stretch * (stretch_before(i) + tangential(i).known) + s.dilation.constant),
                 spring = -t.k * gap;  // that it would be without, which rhs has
    normal(i).add_force(force - spring, rhs_);
    tangential(i).add_force(t.direction * limit(i) + s.friction_per_gap / t.k * force, rhs_);
  }
}

bool OpenClose::factorise(bool fresh, StepReport& report) {
  apply_states();
  if (blocks_.acts) {
    if (take_blocks(fresh, report)) return true;
    leave_blocks(report);
  }
  if (keep_ || (current_ && !fresh && (k_ == factored_k_ || update(report)))) return true;
  return factorise_anew(report);
}

bool OpenClose::factorise_anew(StepReport& report) {
  keep_ = updated_ = false;
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

double OpenClose::bearing_force(std::size_t i) const {
  const ContactMemory& m = list_->memory[i];
  const Trial& t = trial_[i];
  return m.failed == 0 && can_fail(law_of(i)) ? std::max(t.fn, -m.kn * t.gap) : t.fn;
}

double OpenClose::friction_per_gap(std::size_t i) const {
  return trial_[i].slack ? 0.0 : trial_[i].direction * trial_[i].k * strength_[i].coefficient;
}

void OpenClose::evaluate_points(std::span<const double> d) {
  parallel_for(
      static_cast<std::int64_t>(trial_.size()), [&](std::int64_t i) { evaluate_point(static_cast<std::size_t>(i), d); },
      kFewPoints);
}

void OpenClose::evaluate_point(std::size_t i, std::span<const double> d) {
  Trial& t = trial_[i];
  const ContactMemory& m = list_->memory[i];
  const double change = normal(i).change(d);
  t.moved = tangential(i).change(d);
  t.opened = 0.0;
  if (t.status == ContactStatus::slip && dilates(i) && !t.slack) {
    const DilatingForce f = dilation(i);
    const double force = -(f.per_gap * (t.at + change) + f.per_stretch * (stretch_before(i) + t.moved) + f.constant);
    t.opened = t.at + change + force / t.k;
  }
  t.gap = m.gap + change - t.opened;
  t.fn = t.status == ContactStatus::open ? 0.0 : (t.slack ? slack_force(i) : pressed(t, change - t.opened));
  if (t.status == ContactStatus::stick) {
    t.stretch = stretch_before(i) + t.moved;
    t.ft = -m.kt * t.stretch;
  } else if (t.status == ContactStatus::slip) {
    t.load = std::max(t.fn, 0.0);
    t.ft = t.direction * limit(i);
    t.stretch = -t.ft / m.kt;
  } else {
    t.ft = t.stretch = 0.0;
  }
}

bool OpenClose::held_beside(std::size_t i) const {
  // Points are sorted by their corner.
  const auto holds = [&](std::size_t j) {
    constexpr double kSameWay = 0.99;
    return trial_[j].status != ContactStatus::open && list_->points[j].at.n.dot(list_->points[i].at.n) > kSameWay;
  };
  const std::int32_t vertex = list_->points[i].vertex;
  for (std::size_t j = i; j-- > 0 && list_->points[j].vertex == vertex;)
    if (holds(j)) return true;
  for (std::size_t j = i + 1; j < trial_.size() && list_->points[j].vertex == vertex; ++j)
    if (holds(j)) return true;
  return false;
}

bool OpenClose::may_close(std::size_t i) const {
  // The foot must be on the edge where the step ends; of two edges at a convex corner the one that is nearer takes
  // over.
  const ContactPoint& p = list_->points[i];
  const double foot = p.at.xi * p.at.length + trial_[i].moved;
  if (foot < p.s_low || foot > p.s_high) return false;
  constexpr double kOver = 1e-12;  // at the start of the step the corner is not over this edge yet
  if ((p.at.xi < -kOver || p.at.xi > 1.0 + kOver) && held_beside(i)) return false;
  for (const std::int32_t other : p.partner) {
    if (other < 0 || list_->points[static_cast<std::size_t>(other)].suppressed) continue;
    const Trial& t = trial_[static_cast<std::size_t>(other)];
    if (t.status != ContactStatus::open) return false;
    const ContactPoint& po = list_->points[static_cast<std::size_t>(other)];
    const double foot_other = po.at.xi * po.at.length + t.moved;
    if (t.gap < 0.0 && foot_other >= po.s_low && foot_other <= po.s_high &&
        leaves_by(-t.gap, -trial_[i].gap, other == p.partner[0]))
      return false;
  }
  return true;
}

double OpenClose::tolerance(std::size_t i) const {
  return 1e-9 * weight_[i] + 1e-11 * largest_force_ + list_->memory[i].kn * gap_round_off_;
}

bool OpenClose::switch_slack(std::size_t i, ProposedState& w) const {
  const Trial& t = trial_[i];
  const ContactMemory& m = list_->memory[i];
  const double least = slack_force(i), force = pressed(t, t.gap - m.gap);
  if (t.slack ? force <= least : force >= least) return false;
  w.slack = !t.slack;
  w.violation = std::abs(force - least);
  return true;
}

OpenClose::ProposedState OpenClose::proposed_state(std::size_t i) const {
  const Trial& t = trial_[i];
  const ContactMemory& m = list_->memory[i];
  const Strength& s = strength_[i];
  ProposedState w{t.status, t.direction, t.opens, t.slack};
  if (t.status == ContactStatus::open) {
    if (t.gap >= 0.0 || !may_close(i)) return w;
    // By what its springs would carry if the bodies did not mind: a point that sticks while the joint slides may be
    // lifted by its own tangential spring, and never settle.
    w.violation = -m.kn * t.gap;
    const double ft = -m.kt * (stretch_before(i) + t.moved);
    w.status = std::abs(ft) > s.friction_limit(w.violation) ? ContactStatus::slip : ContactStatus::stick;
    w.direction = ft < 0.0 ? -1.0 : 1.0;
    w.slack = pressed(t, t.gap - m.gap) < 0.0;
    return w;
  }
  const double bears = t.status == ContactStatus::stick ? s.tension : 0.0;
  if (t.gap > 0.0 && (bears > 0.0 || t.slack || t.fn < 0.0 || t.k == m.kn)) {
    // A bond that sticks bears the pull, unless that or the shear under it is too much: then nothing holds it closed.
    const double pull = m.kn * t.gap;
    w.violation = bears > 0.0 ? std::max(pull - bears, std::abs(t.ft) - s.friction_limit(-pull)) : pull;
    if (w.violation > tolerance(i)) {
      w.status = ContactStatus::open;
      return w;
    }
    w.violation = 0.0;  // it hardly opens, and may slip, or its dashpot pull, as it is
    if (bears > 0.0) {
      (void)switch_slack(i, w);
      return w;
    }
  }
  if (switch_slack(i, w)) {
    if (w.violation > tolerance(i)) return w;
    w.slack = t.slack;  // the dashpot hardly pulls: the friction must be right all the same
    w.violation = 0.0;
  }
  if (t.status == ContactStatus::stick) {
    const double cap = s.friction_limit(bearing_force(i));
    if (std::abs(t.ft) <= cap) return w;
    w.status = ContactStatus::slip;
    w.violation = std::abs(t.ft) - cap;
    w.direction = t.ft < 0.0 ? -1.0 : 1.0;
  } else {
    const double slip = stretch_before(i) + t.moved - t.stretch;
    if (t.ft * slip > 0.0) {
      w.status = ContactStatus::stick;
      w.violation = m.kt * std::abs(slip);
    } else if (dilates(i) && (std::abs(slip) < slip_left(i)) != t.opens) {
      w.opens = !t.opens;
      w.violation = m.kn * std::tan(law_of(i).dilation) * std::abs(std::abs(slip) - slip_left(i));
    }
  }
  return w;
}

void OpenClose::propose(std::size_t i) {
  const Trial& t = trial_[i];
  const ProposedState w = proposed_state(i);
  const bool other = w.status != t.status || w.opens != t.opens || w.slack != t.slack;
  if (other && w.violation > tolerance(i)) proposed_.emplace_back(i, w);
}

void OpenClose::adopt(std::size_t i, const ProposedState& w) {
  Trial& t = trial_[i];
  t.status = w.status;
  t.direction = w.direction;
  t.opens = w.opens;
  t.slack = w.slack && w.status != ContactStatus::open;
  t.load = std::max(t.fn, 0.0);
}

int OpenClose::switch_states(bool only_worst) {
  largest_force_ = 0.0;
  for (const Trial& t : trial_) largest_force_ = std::max(largest_force_, std::abs(t.fn));
  proposed_.clear();
  for (std::size_t i = 0; i < trial_.size(); ++i)
    if (!list_->points[i].suppressed) propose(i);
  const auto bodies_of = [&](std::size_t i) {
    const auto& node = list_->points[i].node;
    const auto& body = setup_->outlines().node_body;
    return std::array{body[static_cast<std::size_t>(node[0])], body[static_cast<std::size_t>(node[1])]};
  };
  if (only_worst) {
    worst_.assign(setup_->bodies().size(), 0.0);
    for (const auto& [i, w] : proposed_)
      for (const std::int32_t b : bodies_of(i))
        worst_[static_cast<std::size_t>(b)] = std::max(worst_[static_cast<std::size_t>(b)], w.violation);
  }
  switched_.clear();
  for (const auto& [i, w] : proposed_) {
    if (only_worst) {
      // One of two that are as bad is enough.
      const auto is_worst = [&, &proposed = w](std::int32_t b) {
        return setup_->bodies()[static_cast<std::size_t>(b)].driven ||
               proposed.violation >= worst_[static_cast<std::size_t>(b)];
      };
      const std::array bodies = bodies_of(i);
      if (!is_worst(bodies[0]) || !is_worst(bodies[1])) continue;
      for (const std::int32_t b : bodies) worst_[static_cast<std::size_t>(b)] = std::numeric_limits<double>::infinity();
    }
    switched_.push_back(i);
    adopt(i, w);
  }
  return static_cast<int>(switched_.size());
}

int OpenClose::predict_states(std::span<const double> guess) {
  evaluate_points(guess);
  largest_force_ = 0.0;
  for (const Trial& t : trial_) largest_force_ = std::max(largest_force_, std::abs(t.fn));
  proposed_.clear();
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    if (!list_->points[i].suppressed && trial_[i].status == ContactStatus::open) propose(i);
  }
  for (const auto& [i, w] : proposed_) adopt(i, w);
  return static_cast<int>(proposed_.size());
}

char OpenClose::state_letter(const Trial& t) {
  return static_cast<char>((static_cast<int>(t.status) + (t.opens ? 4 : 0) + (t.slack ? 8 : 0)) *
                           (t.direction < 0.0 ? -1 : 1));
}

std::size_t OpenClose::hash_of_states() {
  states_.clear();
  for (const Trial& t : trial_) states_.push_back(state_letter(t));
  return std::hash<std::string>{}(states_);
}

bool OpenClose::solve(std::span<const double> A, bool fresh, std::span<const double> rhs, std::span<double> d,
                      StepReport& report) {
  base_.assign(rhs.begin(), rhs.end());
  for (std::size_t i = 0; i < trial_.size(); ++i)
    if (const double water = list_->memory[i].water; water != 0.0) normal(i).add_force(water, base_);
  A_ = A;
  seen_.clear();
  bool only_worst = false;
  constexpr int kPatience = 3;
  int switched = 0, stalled = 0;
  // A body's points switch one at a time after a cycle, which takes more, cheaper-to-trust passes. Many points take
  // more passes than few: those count that do not halve the number that switches.
  int left = control_.max_passes, fewest = std::numeric_limits<int>::max();
  exact_ = false;
  if (predict_) report.switches += predict_states(d);
  predict_ = false;
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
    evaluate_points(d);
    if (!allowed_ && refuse(report)) return false;
    const std::size_t now = hash_of_states();
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
    switched = switch_states(only_worst);
    if (switched == 0 && rough_) {
      exact_ = true;
      if (!solve_states(d, report)) return false;
      evaluate_points(d);
      switched = switch_states(only_worst);
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

void OpenClose::check(std::span<const double> d, double unbalanced, Audit& audit) const {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const Trial& t = trial_[i];
    const ContactMemory& m = list_->memory[i];
    if (list_->points[i].suppressed) continue;
    const double allowed = 2.0 * tolerance(i) + 8.0 * m.kn * gap_round_off_ + unbalanced,
                 gap = m.gap + normal(i).change(d) - t.opened;
    const auto name = [&] { return contact_name(setup_->model(), m.key); };
    if (t.status == ContactStatus::open) {
      audit.check(may_close(i) ? m.kn * std::max(0.0, -gap) : 0.0, allowed,
                  [&] { return fmt::format("{}: open and {:.3g} m deep", name(), -gap); });
      continue;
    }
    audit.check(t.fn - (t.slack ? slack_force(i) : pressed(t, gap - m.gap)), allowed,
                [&] { return fmt::format("{}: {:.6g} N is not the force of its spring", name(), t.fn); });
    audit.check(t.slack ? std::max(0.0, pressed(t, gap - m.gap) - t.fn) : 0.0, allowed,
                [&] { return fmt::format("{}: slack, and its spring presses more", name()); });
    // A gap is settled to what its spring makes of it; with the dashpot the same gap is more force.
    audit_law(*setup_, m, bearing_force(i), t.ft, allowed * t.k / m.kn, audit);
    const double slip = stretch_before(i) + t.moved - t.stretch;
    audit.check(t.ft * slip > 0.0 && t.status == ContactStatus::slip ? m.kt * slip : 0.0, allowed,
                [&] { return fmt::format("{}: friction drives it, {:.3g} m", name(), slip); });
  }
  if (d.empty()) return;  // every body is held, or explicit
  std::vector<double> residual(d.size());
  multiply(d, residual);
  double left = 0.0;
  for (std::size_t i = 0; i < residual.size(); ++i)
    left = std::max(left, std::abs(rhs_[i] - residual[i]) / system_->unit()[i]);
  audit.check(left, std::max(1e-11 * force_scale(d), 4.0 * round_off(d)),
              [&] { return fmt::format("the forces of a step are {:.3g} N out of balance", left); });
}

bool OpenClose::refuse(StepReport& report) const {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const bool closes = trial_[i].status != ContactStatus::open ||
                        (trial_[i].gap < 0.0 && !list_->points[i].suppressed && may_close(i));
    if (!closes) continue;
    const ContactKey& key = list_->memory[i].key;
    const auto& blocks = setup_->model().blocks;
    report.status = StepReport::Status::refused;
    report.cause = fmt::format(
        "blocks '{}' and '{}' touch, and the trapezoidal scheme has no contacts; use newmark = "
        "\"damped\"",
        blocks[static_cast<std::size_t>(key.block_p)].name, blocks[static_cast<std::size_t>(key.block_e)].name);
    return true;
  }
  return false;
}

double OpenClose::add_forces(std::span<const double> d, std::span<double> out) const {
  double largest = 0.0;
  const auto add = [&](const DofRow& row, double force) {
    largest = std::max(largest, std::abs(force));
    if (force != 0.0) row.add_force(force, out);
  };
  for (std::size_t i = 0; i < springs_->size(); ++i) add(springs_->rows[i], springs_->force(i, d));
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    add(normal(i), trial_[i].fn);
    add(normal(i), list_->memory[i].water);
    add(tangential(i), trial_[i].ft);
  }
  return largest;
}

}  // namespace scree::coupling
