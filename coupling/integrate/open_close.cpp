#include "coupling/integrate/open_close.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>

#include "coupling/contact/joint_strength.h"
#include "coupling/integrate/anderson.h"
#include "coupling/integrate/gmres.h"

namespace scree::coupling {
namespace {

/// Sum of the sizes of what DofRow::change() adds up.
double size_of_change(const DofRow& row, std::span<const double> d) {
  double size = std::abs(row.known);
  for (std::size_t j = 0; j < row.dof.size(); ++j) size += std::abs(row.h[j] * d[static_cast<std::size_t>(row.dof[j])]);
  return size;
}

/// out += force along a row.
void add_to(std::span<double> out, const DofRow& row, double force) {
  for (std::size_t j = 0; j < row.dof.size(); ++j) out[static_cast<std::size_t>(row.dof[j])] += force * row.h[j];
}

}  // namespace

OpenClose::OpenClose(const Setup& setup, const StepControl& control, const ImplicitSystem& system, bool allowed,
                     bool rank_updates)
    : setup_(&setup), control_(control), system_(&system), allowed_(allowed), rank_updates_(rank_updates) {
  cholesky_.set_pattern(system.pattern());
  for (const Body& b : setup.bodies()) {
    const Model& model = setup.model();
    mass_.push_back(model.material_of(b.block).density * moments(model.blocks[b.block.index()].polygon).area);
  }
}

DofRow OpenClose::dof_row(const ContactPoint& p, const ContactRow& row, std::span<const double> q,
                          std::span<const Vec2> driven_move) const {
  const Outlines& o = setup_->outlines();
  DofRow out;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto node = static_cast<std::size_t>(p.node[i]);
    const std::int32_t body = o.node_body[node];
    system_->add_point(out, body, o.nodes[node], row[i], q, driven_move[static_cast<std::size_t>(body)]);
  }
  return out;
}

void OpenClose::begin(const ContactList& list, std::span<const double> q, std::span<const Vec2> driven_move,
                      std::vector<StepSpring> springs) {
  list_ = &list;
  springs_ = std::move(springs);
  factored_ = false;
  passes_.clear();
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
    Trial& t = trial_[i];
    t.normal = dof_row(p, gap_row(p.at), q, driven_move);
    t.tangential = dof_row(p, stretch_row(p.at, m.anchor), q, driven_move);
    t.status = p.suppressed ? ContactStatus::open : m.status;
    t.direction = m.ft < 0.0 ? -1.0 : 1.0;
    t.load = m.fn;
    t.opened = 0.0;
    weight_[i] = std::min(weight(p.node[0]), weight(p.node[1]));
  }
}

const JointLaw& OpenClose::law_of(std::size_t i) const {
  return setup_->model().joints[static_cast<std::size_t>(list_->memory[i].joint)];
}

double OpenClose::limit(std::size_t i) const { return friction_limit(law_of(i), list_->memory[i], trial_[i].load); }

double OpenClose::slip_of(std::size_t i) const {
  const Trial& t = trial_[i];
  const ContactMemory& m = list_->memory[i];
  const double before = m.status == ContactStatus::open ? 0.0 : m.stretch;
  return std::max(0.0, -t.direction * (before + t.moved - t.stretch));
}

double OpenClose::normal_stiffness(std::size_t i) const {
  return trial_[i].status == ContactStatus::open ? 0.0 : list_->memory[i].kn;
}

double OpenClose::tangential_stiffness(std::size_t i) const {
  return trial_[i].status == ContactStatus::stick ? list_->memory[i].kt : 0.0;
}

template <class See>
void OpenClose::for_springs(See&& see) const {
  for (const StepSpring& s : springs_) see(s.row, s.k, s.at);
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const ContactMemory& m = list_->memory[i];
    see(trial_[i].normal, normal_stiffness(i), m.gap);
    see(trial_[i].tangential, tangential_stiffness(i), m.status == ContactStatus::open ? 0.0 : m.stretch);
  }
}

bool OpenClose::factorise(bool fresh, StepReport& report) {
  rhs_ = base_;
  scale_.clear();
  for_springs([&](const DofRow& row, double k, double at) {
    scale_.push_back(k);
    if (k != 0.0)
      for (std::size_t j = 0; j < row.dof.size(); ++j)
        rhs_[static_cast<std::size_t>(row.dof[j])] -= k * (at + row.known) * row.h[j];
  });
  if (factored_ && !fresh && (scale_ == factored_scale_ || update(report))) return true;
  return factorise_anew(report);
}

bool OpenClose::factorise_anew(StepReport& report) {
  cholesky_.begin(A_);
  for_springs([&](const DofRow& row, double k, double) { cholesky_.add_outer(row.dof, row.h, k); });
  factored_ = cholesky_.factorise();
  updated_ = false;
  ++report.factorisations;
  factored_scale_ = scale_;
  if (factored_) return true;
  report.status = StepReport::Status::not_definite;
  report.cause = "the implicit matrix is not positive definite";
  return false;
}

bool OpenClose::update(StepReport& report) {
  if (!rank_updates_) return false;
  changes_.clear();
  std::size_t n = 0;
  for_springs([&](const DofRow& row, double k, double) {
    if (const double delta = k - factored_scale_[n++]; delta != 0.0 && !row.dof.empty())
      changes_.push_back({row.dof, row.h, delta});
  });
  if (cholesky_.relative_work(changes_) > 1.0 || !cholesky_.update(changes_)) return false;
  report.updates += static_cast<int>(changes_.size());
  factored_scale_ = scale_;
  updated_ = true;
  return true;
}

bool OpenClose::solve_linear(std::span<const double> rhs, std::span<double> d) {
  cholesky_.solve(rhs, d);
  if (!updated_) return true;
  constexpr double kExact = 1e-12;  // of the largest force: what a factorisation leaves
  for (int refined = 0;; ++refined) {
    residual_.assign(rhs.begin(), rhs.end());
    system_->pattern().multiply_add(-1.0, A_, d, residual_);
    double size = 0.0, left = 0.0;
    for (std::size_t i = 0; i < residual_.size(); ++i)
      size = std::max({size, std::abs(rhs[i]), std::abs(residual_[i] - rhs[i])});
    for_springs([&](const DofRow& row, double k, double) {
      if (k == 0.0) return;
      double force = 0.0;
      for (std::size_t j = 0; j < row.dof.size(); ++j) force += row.h[j] * d[static_cast<std::size_t>(row.dof[j])];
      force *= k;
      size = std::max(size, std::abs(force));
      for (std::size_t j = 0; j < row.dof.size(); ++j)
        residual_[static_cast<std::size_t>(row.dof[j])] -= force * row.h[j];
    });
    for (const double r : residual_) left = std::max(left, std::abs(r));
    if (left <= kExact * size) return true;
    if (refined == 3 || !std::isfinite(left)) return false;
    correction_.resize(d.size());
    cholesky_.solve(residual_, correction_);
    for (std::size_t i = 0; i < d.size(); ++i) d[i] += correction_[i];
  }
}

void OpenClose::evaluate_points(std::span<const double> d) {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    Trial& t = trial_[i];
    const ContactMemory& m = list_->memory[i];
    if (t.status != ContactStatus::slip) t.opened = 0.0;
    t.gap = m.gap + t.normal.change(d) - t.opened;
    t.moved = t.tangential.change(d);
    t.fn = t.status == ContactStatus::open ? 0.0 : -m.kn * t.gap;
    const double before = m.status == ContactStatus::open ? 0.0 : m.stretch;
    if (t.status == ContactStatus::stick) {
      t.stretch = before + t.moved;
      t.ft = -m.kt * t.stretch;
    } else if (t.status == ContactStatus::slip) {
      t.ft = t.direction * limit(i);
      t.stretch = -t.ft / m.kt;
    } else {
      t.ft = t.stretch = 0.0;
    }
  }
}

void OpenClose::gather_friction() {
  Friction& f = friction_;
  f.slipping.clear();
  f.dilating.clear();
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    if (trial_[i].status != ContactStatus::slip) continue;
    f.slipping.push_back(i);
    if (law_of(i).dilation > 0.0) f.dilating.push_back(i);
  }
  const auto n = static_cast<Eigen::Index>(f.slipping.size());
  f.load.resize(n + static_cast<Eigen::Index>(f.dilating.size()));
  f.found.resize(f.load.size());
  for (Eigen::Index k = 0; k < n; ++k) f.load[k] = trial_[f.slipping[static_cast<std::size_t>(k)]].load;
  for (std::size_t k = 0; k < f.dilating.size(); ++k)
    f.load[n + static_cast<Eigen::Index>(k)] = list_->memory[f.dilating[k]].kn * trial_[f.dilating[k]].opened;
}

bool OpenClose::follow_friction(std::span<double> d, StepReport& report) {
  Friction& f = friction_;
  const auto n = static_cast<Eigen::Index>(f.slipping.size());
  friction_rhs_ = rhs_;
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t i = f.slipping[static_cast<std::size_t>(k)];
    Trial& t = trial_[i];
    t.load = std::max(f.load[k], 0.0);
    add_to(friction_rhs_, t.tangential, t.direction * limit(i));
  }
  for (std::size_t k = 0; k < f.dilating.size(); ++k) {
    Trial& t = trial_[f.dilating[k]];
    const double press = std::max(f.load[n + static_cast<Eigen::Index>(k)], 0.0);
    t.opened = press / list_->memory[f.dilating[k]].kn;
    add_to(friction_rhs_, t.normal, press);
  }
  if (!solve_linear(friction_rhs_, d)) {
    if (!factorise_anew(report)) return false;
    cholesky_.solve(friction_rhs_, d);
  }
  evaluate_points(d);
  double size = 0.0, round_off = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t i = f.slipping[static_cast<std::size_t>(k)];
    f.found[k] = std::max(trial_[i].fn, 0.0);
    round_off = std::max(round_off, list_->memory[i].kn * size_of_change(trial_[i].normal, d));
  }
  for (std::size_t k = 0; k < f.dilating.size(); ++k) {
    const ContactMemory& m = list_->memory[f.dilating[k]];
    const JointLaw& law = law_of(f.dilating[k]);
    f.found[n + static_cast<Eigen::Index>(k)] =
        m.kn * (opened_by_slip(law, m.slip + slip_of(f.dilating[k])) - opened_by_slip(law, m.slip));
  }
  double change = 0.0;
  for (Eigen::Index k = 0; k < f.found.size(); ++k) {
    change = std::max(change, std::abs(f.found[k] - f.load[k]));
    size = std::max(size, std::abs(f.found[k]));
  }
  for (const Trial& t : trial_) size = std::max(size, std::abs(t.fn));
  // No absolute force: it would be large for small blocks. A gap is known to some last places of what it is a sum of.
  f.settled = change <= 1e-11 * size + 64.0 * std::numeric_limits<double>::epsilon() * round_off;
  return true;
}

Eigen::VectorXd OpenClose::friction_response(const Eigen::VectorXd& change) {
  // Derivative of what follow_friction() finds from its loads: those that are cut off at zero count for nothing.
  const Friction& f = friction_;
  const auto n = static_cast<Eigen::Index>(f.slipping.size());
  const auto friction_of = [&](Eigen::Index k) {
    const std::size_t i = f.slipping[static_cast<std::size_t>(k)];
    if (f.load[k] <= 0.0 || limit(i) == 0.0) return 0.0;
    return trial_[i].direction * friction_coefficient(law_of(i), list_->memory[i]) * change[k];
  };
  const auto press_of = [&](std::size_t k) {
    const auto at = n + static_cast<Eigen::Index>(k);
    return f.load[at] >= 0.0 ? change[at] : 0.0;
  };
  std::vector<double> rhs(rhs_.size(), 0.0), d(rhs_.size());
  for (Eigen::Index k = 0; k < n; ++k)
    add_to(rhs, trial_[f.slipping[static_cast<std::size_t>(k)]].tangential, friction_of(k));
  for (std::size_t k = 0; k < f.dilating.size(); ++k) add_to(rhs, trial_[f.dilating[k]].normal, press_of(k));
  cholesky_.solve(rhs, d);
  const auto along = [&](const DofRow& row) { return row.change(d) - row.known; };
  Eigen::VectorXd out(change.size());
  std::size_t dilating = 0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t i = f.slipping[static_cast<std::size_t>(k)];
    const Trial& t = trial_[i];
    const ContactMemory& m = list_->memory[i];
    const bool dilates = dilating < f.dilating.size() && f.dilating[dilating] == i;
    out[k] = t.fn > 0.0 ? -m.kn * along(t.normal) + (dilates ? press_of(dilating) : 0.0) : 0.0;
    if (!dilates) continue;
    const JointLaw& law = law_of(i);
    const double slip = slip_of(i);
    const bool opens =
        slip > 0.0 && m.slip + slip < law.dilation_slip.value_or(std::numeric_limits<double>::infinity());
    const double slips = -t.direction * (along(t.tangential) + friction_of(k) / m.kt);
    out[n + static_cast<Eigen::Index>(dilating++)] = opens ? m.kn * std::tan(law.dilation) * slips : 0.0;
  }
  return out;
}

bool OpenClose::solve_with_friction(std::span<double> d, StepReport& report) {
  constexpr int kAccelerated = 40, kNewton = 12;
  gather_friction();
  Friction& f = friction_;
  const Eigen::VectorXd begin = f.load;
  Anderson anderson(10);
  for (int pass = 0; pass < kAccelerated; ++pass) {
    if (!follow_friction(d, report)) return false;
    if (f.settled) return true;
    f.load = anderson.next(f.load, f.found);
  }
  // Steep wedges with many points: Newton's method, where the accelerated iteration began; the loads are linear but for
  // those that are cut off.
  if (updated_ && !factorise_anew(report)) return false;
  f.load = begin;
  for (int pass = 0; pass < kNewton; ++pass) {
    if (!follow_friction(d, report)) return false;
    if (f.settled) return true;
    Eigen::VectorXd step;
    const auto newton = [this](const Eigen::VectorXd& x) { return Eigen::VectorXd(x - friction_response(x)); };
    // What it leaves the next pass takes up.
    if (!gmres(newton, f.found - f.load, 1e-10, step) && !step.allFinite()) break;
    f.load += step;
  }
  report.status = StepReport::Status::no_friction;
  report.cause = "friction forces did not settle (a wedge whose friction exceeds what its walls can balance?)";
  return false;
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
        (t.gap > trial_[i].gap || (t.gap == trial_[i].gap && other < static_cast<std::int32_t>(i))))
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
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    Trial& t = trial_[i];
    const ContactMemory& m = list_->memory[i];
    if (list_->points[i].suppressed) continue;
    const JointLaw& law = law_of(i);
    ContactStatus to = t.status;
    double violation = 0.0, direction = t.direction;
    if (t.status == ContactStatus::open) {
      if (t.gap < 0.0 && may_close(i)) {
        // By what its springs would carry if the bodies did not mind: a point that sticks while the joint slides may be
        // lifted by its own tangential spring, and never settle.
        violation = -m.kn * t.gap;
        const double ft = -m.kt * ((m.status == ContactStatus::open ? 0.0 : m.stretch) + t.moved);
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
      const double before = m.status == ContactStatus::open ? 0.0 : m.stretch;
      const double slip = before + t.moved - t.stretch;
      if (t.ft * slip > 0.0) {
        to = ContactStatus::stick;
        violation = m.kt * std::abs(slip);
      }
    }
    if (to == t.status || violation <= tolerance(i)) continue;
    ++switched;
    if (only_worst) {
      if (violation > worst) {
        worst = violation;
        worst_point = i;
        worst_status = to;
        worst_direction = direction;
      }
      continue;
    }
    t.status = to;
    t.direction = direction;
    t.load = std::max(t.fn, 0.0);
  }
  if (only_worst && switched > 0) {
    trial_[worst_point].status = worst_status;
    trial_[worst_point].direction = worst_direction;
    trial_[worst_point].load = std::max(trial_[worst_point].fn, 0.0);
  }
  return only_worst ? std::min(switched, 1) : switched;
}

bool OpenClose::solve(std::span<const double> A, bool fresh, std::span<const double> rhs, std::span<double> d,
                      StepReport& report) {
  base_.assign(rhs.begin(), rhs.end());
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const DofRow& row = trial_[i].normal;
    for (std::size_t j = 0; j < row.dof.size(); ++j)
      base_[static_cast<std::size_t>(row.dof[j])] += list_->memory[i].water * row.h[j];
  }
  A_ = A;
  std::set<std::vector<std::int8_t>> seen;
  bool only_worst = false;
  // After a cycle points switch one at a time, which takes more, cheaper-to-trust passes.
  int switched = 0;
  for (int most = control_.max_passes, pass = 0; pass < most; ++pass) {
    ++report.passes;
    const auto begin = std::chrono::steady_clock::now();
    const int updates = report.updates, factorisations = report.factorisations;
    if (!factorise(fresh && pass == 0, report) || !solve_with_friction(d, report)) return false;
    if (!allowed_ && refuse(report)) return false;
    std::vector<std::int8_t> states;
    for (const Trial& t : trial_)
      states.push_back(static_cast<std::int8_t>(static_cast<int>(t.status) * (t.direction < 0.0 ? -1 : 1)));
    if (!seen.insert(states).second && !only_worst) {
      only_worst = true;
      most = 3 * control_.max_passes;
    }
    const int before_it = switched;
    switched = switch_states(only_worst);
    passes_.push_back({before_it, report.updates - updates, report.factorisations > factorisations,
                       std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()});
    if (switched == 0) return true;
    report.switches += switched;
  }
  report.status = StepReport::Status::no_states;
  report.cause = fmt::format("contact states did not settle in {} passes", report.passes);
  return false;
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
    if (force == 0.0) return;
    for (std::size_t j = 0; j < row.dof.size(); ++j) out[static_cast<std::size_t>(row.dof[j])] += force * row.h[j];
  };
  for (const StepSpring& s : springs_) add(s.row, s.force(d));
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    add(trial_[i].normal, trial_[i].fn);
    add(trial_[i].normal, list_->memory[i].water);
    add(trial_[i].tangential, trial_[i].ft);
  }
  return largest;
}

}  // namespace scree::coupling
