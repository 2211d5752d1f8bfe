#include "coupling/integrate/open_close.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>

#include "coupling/contact/joint_strength.h"
#include "coupling/integrate/anderson.h"

namespace scree::coupling {
namespace {

/// Sum of the sizes of what DofRow::change() adds up.
double size_of_change(const DofRow& row, std::span<const double> d) {
  double size = std::abs(row.known);
  for (std::size_t j = 0; j < row.dof.size(); ++j) size += std::abs(row.h[j] * d[static_cast<std::size_t>(row.dof[j])]);
  return size;
}

}  // namespace

OpenClose::OpenClose(const Setup& setup, const StepControl& control, const ImplicitSystem& system, bool allowed,
                     bool rank_updates)
    : setup_(&setup), control_(control), system_(&system), allowed_(allowed), rank_updates_(rank_updates) {
  cholesky_.set_pattern(system.pattern());
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
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const ContactPoint& p = list.points[i];
    const ContactMemory& m = list.memory[i];
    Trial& t = trial_[i];
    t.normal = dof_row(p, gap_row(p.at), q, driven_move);
    t.tangential = dof_row(p, stretch_row(p.at, m.anchor), q, driven_move);
    t.status = p.suppressed ? ContactStatus::open : m.status;
    t.direction = m.ft < 0.0 ? -1.0 : 1.0;
    t.load = m.fn;
  }
}

double OpenClose::limit(std::size_t i) const {
  const ContactMemory& m = list_->memory[i];
  return friction_limit(setup_->model().joints[static_cast<std::size_t>(m.joint)], m, trial_[i].load);
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
    t.gap = m.gap + t.normal.change(d);
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

bool OpenClose::solve_with_friction(std::span<double> d, StepReport& report) {
  std::vector<std::size_t> slipping;
  for (std::size_t i = 0; i < trial_.size(); ++i)
    if (trial_[i].status == ContactStatus::slip) slipping.push_back(i);
  const auto n = static_cast<Eigen::Index>(slipping.size());
  Eigen::VectorXd load(n), found(n);
  for (Eigen::Index k = 0; k < n; ++k) load[k] = trial_[slipping[static_cast<std::size_t>(k)]].load;
  Anderson anderson(10);
  std::vector<double> rhs(rhs_.size());
  for (int pass = 0; pass < 100; ++pass) {
    rhs = rhs_;
    for (Eigen::Index k = 0; k < n; ++k) {
      Trial& t = trial_[slipping[static_cast<std::size_t>(k)]];
      t.load = std::max(load[k], 0.0);
      const double ft = t.direction * limit(slipping[static_cast<std::size_t>(k)]);
      for (std::size_t j = 0; j < t.tangential.dof.size(); ++j)
        rhs[static_cast<std::size_t>(t.tangential.dof[j])] += ft * t.tangential.h[j];
    }
    if (!solve_linear(rhs, d)) {
      if (!factorise_anew(report)) return false;
      cholesky_.solve(rhs, d);
    }
    evaluate_points(d);
    double change = 0.0, size = 0.0, round_off = 0.0;
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::size_t i = slipping[static_cast<std::size_t>(k)];
      found[k] = std::max(trial_[i].fn, 0.0);
      change = std::max(change, std::abs(found[k] - load[k]));
      round_off = std::max(round_off, list_->memory[i].kn * size_of_change(trial_[i].normal, d));
    }
    for (const Trial& t : trial_) size = std::max(size, std::abs(t.fn));
    // No absolute force: it would be large for small blocks. A gap is known to some last places of what it is a sum of.
    if (change <= 1e-11 * size + 64.0 * std::numeric_limits<double>::epsilon() * round_off) return true;
    load = anderson.next(load, found);
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

int OpenClose::switch_states(bool only_worst) {
  // How far each point violates its state, as a force; the worst one alone is switched once a cycle was seen.
  int switched = 0;
  double worst = 0.0;
  std::size_t worst_point = 0;
  ContactStatus worst_status = ContactStatus::open;
  double worst_direction = 0.0;
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    Trial& t = trial_[i];
    const ContactMemory& m = list_->memory[i];
    if (list_->points[i].suppressed) continue;
    const JointLaw& law = setup_->model().joints[static_cast<std::size_t>(m.joint)];
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
    if (to == t.status) continue;
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
  for (const Trial& t : trial_) {
    add(t.normal, t.fn);
    add(t.tangential, t.ft);
  }
  return largest;
}

}  // namespace scree::coupling
