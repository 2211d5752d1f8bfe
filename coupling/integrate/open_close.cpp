#include "coupling/integrate/open_close.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "coupling/contact/joint_strength.h"

namespace scree::coupling {

OpenClose::OpenClose(const Setup& setup, const StepControl& control, const ImplicitSystem& system, bool allowed,
                     Factor factor)
    : setup_(&setup), control_(control), system_(&system), allowed_(allowed), factor_(factor) {
  cholesky_.set_pattern(system.pattern());
  chart_of_node_.assign(setup.outlines().nodes.size(), -1);
  for (const Body& b : setup.bodies()) {
    const Model& model = setup.model();
    mass_.push_back(model.material_of(b.block).density * moments(model.blocks[b.block.index()].polygon).area);
  }
}

void OpenClose::enter(const KeptFactor& kept) {
  patience_ = kept.patience;
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
  if (factor_ != Factor::kept) return;
  if (made_) {
    const SymmetricMatrix& matrix = cholesky_.matrix();
    kept.column_start = matrix.pattern.column_start;
    kept.row = matrix.pattern.row;
    kept.value = matrix.value;
    made_ = false;
  }
  if (keep_) patience_.next_wait = 0;
  if (patience_.wait > 0) --patience_.wait;
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
                      const StepSprings& springs) {
  list_ = &list;
  springs_ = &springs;
  current_ = updated_ = false;
  keep_ = factor_ == Factor::kept && !system_->nonlinear() && cholesky_.factored() && patience_.wait == 0;
  if (keep_) cholesky_.drop_updates();
  corrections_left_ = cholesky_.solves_per_factorisation();
  passes_.clear();
  rows_.clear();
  for (std::size_t i = 0; i < springs.size(); ++i) rows_.add_row(springs.rows[i]);
  charts_.clear();
  std::fill(chart_of_node_.begin(), chart_of_node_.end(), -1);
  trial_.resize(list.points.size());
  weight_.resize(trial_.size());
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
    trial_[i] = {p.suppressed ? ContactStatus::open : m.status, m.ft < 0.0 ? -1.0 : 1.0, m.fn};
    trial_[i].opens = law_of(i).dilation > 0.0 && slip_left(i) > 0.0;
    weight_[i] = std::min(weight(p.node[0]), weight(p.node[1]));
  }
}

const JointLaw& OpenClose::law_of(std::size_t i) const {
  return setup_->model().joints[static_cast<std::size_t>(list_->memory[i].joint)];
}

double OpenClose::stretch_before(std::size_t i) const {
  const ContactMemory& m = list_->memory[i];
  return m.status == ContactStatus::open ? 0.0 : m.stretch;
}

double OpenClose::limit(std::size_t i) const { return friction_limit(law_of(i), list_->memory[i], trial_[i].load); }

double OpenClose::slip_left(std::size_t i) const {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return std::max(0.0, law_of(i).dilation_slip.value_or(kInf) - list_->memory[i].slip);
}

OpenClose::Dilation OpenClose::dilation(std::size_t i) const {
  // The spring is pressed by tan psi times the slip |s|, |s| = -dir e - (c + tan phi f)/k_t, so that
  //   f = -k_n g + k_n tan psi |s| has f on both sides; after the end of dilation |s| is what was left.
  const ContactMemory& m = list_->memory[i];
  const JointLaw& law = law_of(i);
  const double slope = m.kn * std::tan(law.dilation);
  if (!trial_[i].opens) return {m.kn, 0.0, -slope * slip_left(i)};
  const double part = 1.0 / (1.0 + slope / m.kt * friction_coefficient(law, m));
  return {part * m.kn, part * slope * trial_[i].direction, part * slope * friction_limit(law, m, 0.0) / m.kt};
}

double OpenClose::normal_stiffness(std::size_t i) const {
  return trial_[i].status == ContactStatus::open ? 0.0 : list_->memory[i].kn;
}

double OpenClose::tangential_stiffness(std::size_t i) const {
  return trial_[i].status == ContactStatus::stick ? list_->memory[i].kt : 0.0;
}

void OpenClose::take_states() {
  k_.assign(springs_->k.begin(), springs_->k.end());
  at_.assign(springs_->at.begin(), springs_->at.end());
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const ContactMemory& m = list_->memory[i];
    k_.push_back(normal_stiffness(i));
    at_.push_back(m.gap);
    k_.push_back(tangential_stiffness(i));
    at_.push_back(stretch_before(i));
  }
  rhs_ = base_;
  for (std::size_t r = 0; r < rows_.size(); ++r)
    if (k_[r] != 0.0) rows_[r].add_force(-k_[r] * (at_[r] + rows_[r].known), rhs_);
  // Coulomb's force c + tan phi f_n on what slips: with the gap, of which f_n is a multiple, and without.
  slipping_.clear();
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    Trial& t = trial_[i];
    if (t.status != ContactStatus::slip) continue;
    slipping_.push_back(i);
    t.load = 0.0;
    const double gap = list_->memory[i].gap + normal(i).known;
    if (!dilates(i)) {
      tangential(i).add_force(t.direction * limit(i) - friction_per_gap(i) * gap, rhs_);
      continue;
    }
    const Dilation f = dilation(i);
    const double force = -(f.per_gap * gap + f.per_stretch * (stretch_before(i) + tangential(i).known) + f.constant),
                 spring = -list_->memory[i].kn * gap;  // that it would be without, which rhs has
    normal(i).add_force(force - spring, rhs_);
    tangential(i).add_force(t.direction * limit(i) + friction_per_gap(i) / list_->memory[i].kn * force, rhs_);
  }
}

bool OpenClose::factorise(bool fresh, StepReport& report) {
  take_states();
  if (keep_ || (current_ && !fresh && (k_ == factored_k_ || update(report)))) return true;
  return factorise_anew(report);
}

bool OpenClose::factorise_anew(StepReport& report) {
  keep_ = updated_ = false;
  current_ = cholesky_.factorise(A_, rows_, k_);
  made_ = true;
  ++report.factorisations;
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
  if (cholesky_.relative_work(rows_, changes_) > 1.0 || !cholesky_.update(rows_, changes_)) return false;
  report.updates += static_cast<int>(changes_.size());
  factored_k_ = k_;
  updated_ = true;
  return true;
}

void OpenClose::multiply(std::span<const double> x, std::span<double> y) const {
  system_->pattern().multiply(A_, x, y);
  for (std::size_t r = 0; r < rows_.size(); ++r)
    if (k_[r] != 0.0) rows_[r].add_force(k_[r] * (rows_[r].change(x) - rows_[r].known), y);
  for (const std::size_t i : slipping_) {
    const double gap = normal(i).change(x) - normal(i).known;
    if (!dilates(i)) {
      tangential(i).add_force(friction_per_gap(i) * gap, y);
      continue;
    }
    const Dilation f = dilation(i);
    const double loss = f.per_gap * gap + f.per_stretch * (tangential(i).change(x) - tangential(i).known),
                 kn = list_->memory[i].kn;
    normal(i).add_force(loss - kn * gap, y);
    tangential(i).add_force(friction_per_gap(i) / kn * loss, y);
  }
}

double OpenClose::friction_per_gap(std::size_t i) const {
  const ContactMemory& m = list_->memory[i];
  return trial_[i].direction * m.kn * friction_coefficient(law_of(i), m);
}

double OpenClose::force_scale(std::span<const double> d) const {
  double size = 0.0;
  const auto unit = system_->unit();
  for (std::size_t i = 0; i < rhs_.size(); ++i)
    size = std::max({size, std::abs(rhs_[i]) / unit[i], std::abs(base_[i]) / unit[i]});
  for (std::size_t r = 0; r < rows_.size(); ++r)
    if (k_[r] != 0.0) size = std::max(size, k_[r] * std::abs(at_[r] + rows_[r].change(d)));
  return size;
}

double OpenClose::round_off(std::span<const double> d) const {
  const SymmetricPattern& p = system_->pattern();
  std::vector<double> size(d.size(), 0.0);
  for (std::int32_t c = 0; c < p.n; ++c)
    for (std::int32_t k = p.column_start[static_cast<std::size_t>(c)];
         k < p.column_start[static_cast<std::size_t>(c) + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k), row = static_cast<std::size_t>(p.row[at]),
                 column = static_cast<std::size_t>(c);
      size[row] += std::abs(A_[at] * d[column]);
      if (row != column) size[column] += std::abs(A_[at] * d[row]);
    }
  for (std::size_t i = 0; i < size.size(); ++i) size[i] /= system_->unit()[i];
  return 4.0 * std::numeric_limits<double>::epsilon() * *std::max_element(size.begin(), size.end());
}

int OpenClose::improve(int most, std::span<double> d, StepReport& report) {
  constexpr double kExact = 1e-13;  // of the largest force: about what a factorisation leaves
  constexpr int kAtOnce = ConjugateResiduals::kDepth;
  double enough = kExact * force_scale(d);
  int taken = 0;
  for (bool looked = false;;) {
    const int part = std::min(most - taken, kAtOnce);
    const int more = residuals_.solve([this](std::span<const double> x, std::span<double> y) { multiply(x, y); },
                                      [this](std::span<const double> r, std::span<double> z) { cholesky_.solve(r, z); },
                                      rhs_, system_->unit(), enough, part, d);
    taken += more >= 0 ? more : part;
    if (more >= 0 || (looked && taken >= most)) {
      report.corrections += taken;
      return more >= 0 ? taken : -1;
    }
    // Static steps of stiff meshes: forces inside are far larger than those on the blocks, and so is what they leave.
    enough = std::max(kExact * force_scale(d), round_off(d));
    looked = true;
  }
}

bool OpenClose::solve_states(std::span<double> d, StepReport& report) {
  constexpr int kRefinements = 6, kFriction = 200;
  friction_settled_ = true;
  if (keep_) {
    const int taken = improve(corrections_left_, d, report);
    corrections_left_ -= std::max(taken, 0);
    if (taken >= 0) return true;
    constexpr std::int32_t kLongest = 15;
    patience_.wait = patience_.next_wait = std::min(2 * patience_.next_wait + 1, kLongest);
    if (!factorise_anew(report)) return false;
  }
  if (updated_) {
    if (improve(slipping_.empty() ? kRefinements : kFriction, d, report) >= 0) return true;
    if (!factorise_anew(report)) return false;
  }
  if (slipping_.empty())
    cholesky_.solve(rhs_, d);
  else
    friction_settled_ = improve(kFriction, d, report) >= 0;
  return true;
}

void OpenClose::evaluate_points(std::span<const double> d) {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    Trial& t = trial_[i];
    const ContactMemory& m = list_->memory[i];
    t.gap = m.gap + normal(i).change(d);
    t.moved = tangential(i).change(d);
    t.opened = 0.0;
    if (t.status == ContactStatus::slip && dilates(i)) {
      const Dilation f = dilation(i);
      const double force = -(f.per_gap * t.gap + f.per_stretch * (stretch_before(i) + t.moved) + f.constant);
      t.opened = t.gap + force / m.kn;
      t.gap = -force / m.kn;
    }
    t.fn = t.status == ContactStatus::open ? 0.0 : -m.kn * t.gap;
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
}

bool OpenClose::may_close(std::size_t i) const {
  // The foot must be on the edge where the step ends; of two edges at a convex corner the one that is nearer takes
  // over.
  const ContactPoint& p = list_->points[i];
  const double foot = p.at.xi * p.at.length + trial_[i].moved;
  if (foot < p.s_low || foot > p.s_high) return false;
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

int OpenClose::switch_states(bool only_worst) {
  // How far each point violates its state, as a force; the worst one alone is switched once a cycle was seen.
  int switched = 0;
  largest_force_ = 0.0;
  for (const Trial& t : trial_) largest_force_ = std::max(largest_force_, std::abs(t.fn));
  double worst = 0.0;
  std::size_t worst_point = 0;
  ContactStatus worst_status = ContactStatus::open;
  double worst_direction = 0.0;
  bool worst_opens = false;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    Trial& t = trial_[i];
    const ContactMemory& m = list_->memory[i];
    if (list_->points[i].suppressed) continue;
    const JointLaw& law = law_of(i);
    ContactStatus to = t.status;
    double violation = 0.0, direction = t.direction;
    bool opens = t.opens;
    if (t.status == ContactStatus::open) {
      if (t.gap < 0.0 && may_close(i)) {
        // By what its springs would carry if the bodies did not mind: a point that sticks while the joint slides may be
        // lifted by its own tangential spring, and never settle.
        violation = -m.kn * t.gap;
        const double ft = -m.kt * (stretch_before(i) + t.moved);
        const bool slips = std::abs(ft) > friction_limit(law, m, violation);
        to = slips ? ContactStatus::slip : ContactStatus::stick;
        direction = ft < 0.0 ? -1.0 : 1.0;
      }
    } else if (t.gap > 0.0) {
      // A bond that sticks bears the pull, unless that or the shear under it is too much: then nothing holds it closed.
      const double pull = m.kn * t.gap, bears = t.status == ContactStatus::stick ? tension_limit(law, m) : 0.0;
      violation = bears > 0.0 ? std::max(pull - bears, std::abs(t.ft) - friction_limit(law, m, t.fn)) : pull;
      if (violation > 0.0) to = ContactStatus::open;
    } else if (t.status == ContactStatus::stick) {
      const double cap = friction_limit(law, m, t.fn);
      if (std::abs(t.ft) > cap) {
        to = ContactStatus::slip;
        violation = std::abs(t.ft) - cap;
        direction = t.ft < 0.0 ? -1.0 : 1.0;
      }
    } else {
      const double slip = stretch_before(i) + t.moved - t.stretch;
      if (t.ft * slip > 0.0) {
        to = ContactStatus::stick;
        violation = m.kt * std::abs(slip);
      } else if (dilates(i) && (std::abs(slip) < slip_left(i)) != t.opens) {
        opens = !t.opens;
        violation = m.kn * std::tan(law.dilation) * std::abs(std::abs(slip) - slip_left(i));
      }
    }
    if ((to == t.status && opens == t.opens) || violation <= tolerance(i)) continue;
    ++switched;
    if (only_worst) {
      if (violation > worst) {
        worst = violation;
        worst_point = i;
        worst_status = to;
        worst_direction = direction;
        worst_opens = opens;
      }
      continue;
    }
    t.status = to;
    t.direction = direction;
    t.opens = opens;
    t.load = std::max(t.fn, 0.0);
  }
  if (only_worst && switched > 0) {
    trial_[worst_point].status = worst_status;
    trial_[worst_point].direction = worst_direction;
    trial_[worst_point].opens = worst_opens;
    trial_[worst_point].load = std::max(trial_[worst_point].fn, 0.0);
  }
  return only_worst ? std::min(switched, 1) : switched;
}

bool OpenClose::solve(std::span<const double> A, bool fresh, std::span<const double> rhs, std::span<double> d,
                      StepReport& report) {
  base_.assign(rhs.begin(), rhs.end());
  for (std::size_t i = 0; i < trial_.size(); ++i)
    if (const double water = list_->memory[i].water; water != 0.0) normal(i).add_force(water, base_);
  A_ = A;
  seen_.clear();
  bool only_worst = false;
  // After a cycle points switch one at a time, which takes more, cheaper-to-trust passes.
  int switched = 0;
  for (int most = control_.max_passes, pass = 0; pass < most; ++pass) {
    ++report.passes;
    const auto begin = std::chrono::steady_clock::now();
    const int updates = report.updates, factorisations = report.factorisations;
    if (!factorise(fresh && pass == 0, report) || !solve_states(d, report)) return false;
    evaluate_points(d);
    if (!allowed_ && refuse(report)) return false;
    states_.clear();
    for (const Trial& t : trial_)
      states_.push_back(
          static_cast<char>((static_cast<int>(t.status) + (t.opens ? 4 : 0)) * (t.direction < 0.0 ? -1 : 1)));
    const std::size_t now = std::hash<std::string>{}(states_);
    const bool cycle = std::find(seen_.begin(), seen_.end(), now) != seen_.end();
    seen_.push_back(now);
    if (cycle && !only_worst) {
      only_worst = true;
      most = 3 * control_.max_passes;
    }
    const int before_it = switched;
    switched = switch_states(only_worst);
    passes_.push_back({before_it, report.updates - updates, report.factorisations > factorisations,
                       std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()});
    if (switched == 0 && friction_settled_) return true;
    if (switched == 0) {
      report.status = StepReport::Status::no_friction;
      report.cause = "friction forces did not settle (a wedge whose friction exceeds what its walls can balance?)";
      return false;
    }
    report.switches += switched;
  }
  report.status = StepReport::Status::no_states;
  report.cause = fmt::format("contact states did not settle in {} passes", report.passes);
  return false;
}

void OpenClose::check(std::span<const double> d, Audit& audit) const {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const Trial& t = trial_[i];
    const ContactMemory& m = list_->memory[i];
    if (list_->points[i].suppressed) continue;
    const double allowed = 2.0 * tolerance(i), gap = m.gap + normal(i).change(d) - t.opened;
    const auto name = [&] { return contact_name(setup_->model(), m.key); };
    if (t.status == ContactStatus::open) {
      audit.check(may_close(i) ? m.kn * std::max(0.0, -gap) : 0.0, allowed,
                  [&] { return fmt::format("{}: open and {:.3g} m deep", name(), -gap); });
      continue;
    }
    audit.check(t.fn + m.kn * gap, allowed,
                [&] { return fmt::format("{}: {:.6g} N is not the force of its spring", name(), t.fn); });
    audit_law(*setup_, m, t.fn, t.ft, allowed, audit);
    const double slip = stretch_before(i) + t.moved - t.stretch;
    audit.check(t.ft * slip > 0.0 && t.status == ContactStatus::slip ? m.kt * slip : 0.0, allowed,
                [&] { return fmt::format("{}: friction drives it, {:.3g} m", name(), slip); });
  }
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
