#include "coupling/integrate/contact_states.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "model/parallel.h"

namespace scree::coupling {

ContactStates::ContactStates(const Setup& setup) : setup_(&setup) {
  const Model& model = setup.model();
  for (const Body& b : setup.bodies())
    mass_.push_back(model.material_of(b.block).density * moments(model.blocks[b.block.index()].polygon).area);
}

void ContactStates::begin(const ContactList& list, const DofRows& rows, std::size_t first, std::span<const double> q,
                          double dashpot) {
  list_ = &list;
  rows_ = &rows;
  first_ = first;
  trial_.resize(list.points.size());
  weight_.resize(trial_.size());
  strength_.resize(trial_.size());
  double farthest = 0.0;
  for (const double x : q) farthest = std::max(farthest, std::abs(x));
  gap_round_off_ = 8.0 * std::numeric_limits<double>::epsilon() * farthest;
  const double g = setup_->model().gravity.norm();
  const auto weight = [&](OutlineNode node) {
    const BodyIndex b = setup_->outlines().node_body[node];
    return setup_->body(b).driven ? std::numeric_limits<double>::infinity() : g * mass_[b.index()];
  };
  const auto begin_point = [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    const ContactPoint& p = list.points[i];
    const ContactMemory& m = list.memory[i];
    strength_[i] = strength(law_of(i), setup_->laws().tan_friction(static_cast<std::size_t>(m.joint)), m);
    ContactTrial& t = trial_[i];
    t = {p.suppressed ? ContactStatus::open : m.status, m.ft < 0.0 ? -1.0 : 1.0};
    t.opens = law_of(i).dilation > 0.0 && slip_left(i) > 0.0;
    // A contact that closes in this step is not damped yet: the dashpot could hold it open.
    t.k = m.kn + (t.status != ContactStatus::open ? dashpot * p.cn : 0.0);
    t.at = m.kn / t.k * m.gap;
    weight_[i] = std::min(weight(p.node[0]), weight(p.node[1]));
  };
  parallel_for(std::ssize(trial_), begin_point, kFewPoints);
}

const JointLaw& ContactStates::law_of(std::size_t i) const {
  return setup_->laws()[static_cast<std::size_t>(list_->memory[i].joint)];
}

double ContactStates::stretch_before(std::size_t i) const {
  const ContactMemory& m = list_->memory[i];
  return m.status == ContactStatus::open ? 0.0 : m.stretch;
}

double ContactStates::slip_left(std::size_t i) const {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  return std::max(0.0, law_of(i).dilation_slip.value_or(kInf) - list_->memory[i].slip);
}

DilatingForce ContactStates::dilation(std::size_t i) const {
  const ContactTrial& t = trial_[i];
  return dilating_force(law_of(i), strength_[i], t.k, list_->memory[i].kt, t.direction, t.opens, slip_left(i));
}

double ContactStates::normal_stiffness(std::size_t i) const {
  return trial_[i].status == ContactStatus::open || trial_[i].slack ? 0.0 : trial_[i].k;
}

double ContactStates::tangential_stiffness(std::size_t i) const {
  return trial_[i].status == ContactStatus::stick ? list_->memory[i].kt : 0.0;
}

double ContactStates::bearing_force(std::size_t i) const {
  const ContactMemory& m = list_->memory[i];
  const ContactTrial& t = trial_[i];
  return m.failed == 0 && can_fail(law_of(i)) ? std::max(t.fn, -m.kn * t.gap) : t.fn;
}

double ContactStates::friction_per_gap(std::size_t i) const {
  return trial_[i].slack ? 0.0 : trial_[i].direction * trial_[i].k * strength_[i].coefficient;
}

PointTangent ContactStates::tangent(std::size_t i) const {
  PointTangent out{normal_stiffness(i), 0.0, 0.0, tangential_stiffness(i)};
  if (trial_[i].status != ContactStatus::slip) return out;
  const double friction = friction_per_gap(i);
  if (!dilates(i)) {
    out.tn = friction;
    return out;
  }
  const DilatingForce f = dilation(i);
  return {f.per_gap, f.per_stretch, friction / trial_[i].k * f.per_gap, friction / trial_[i].k * f.per_stretch};
}

LinearContactForce ContactStates::linear_force(std::size_t i) const {
  const ContactTrial& t = trial_[i];
  LinearContactForce out;
  out.k = tangent(i);
  if (t.status == ContactStatus::open) return out;
  out.normal = t.slack ? slack_force(i) : -t.k * t.at;
  if (t.status == ContactStatus::stick) {
    out.tangential = -out.k.tt * stretch_before(i);
    return out;
  }
  if (dilates(i)) {
    out.normal = -(out.k.nn * t.at + out.k.nt * stretch_before(i) + dilation(i).constant);
    out.tangential = cohesion(i) + friction_per_gap(i) / t.k * out.normal;
  } else {
    out.tangential = cohesion(i) - out.k.tn * t.at;
  }
  return out;
}

void ContactStates::evaluate(std::span<const double> d) {
  parallel_for(
      static_cast<std::int64_t>(trial_.size()), [&](std::int64_t i) { evaluate_point(static_cast<std::size_t>(i), d); },
      kFewPoints);
}

void ContactStates::evaluate_point(std::size_t i, std::span<const double> d) {
  ContactTrial& t = trial_[i];
  const ContactMemory& m = list_->memory[i];
  const double change = normal(i).change(d);
  t.moved = tangential(i).change(d);
  t.opened = 0.0;
  if (dilates(i)) {
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
    t.ft = t.direction * strength_[i].friction_limit(std::max(t.fn, 0.0));
    t.stretch = -t.ft / m.kt;
  } else {
    t.ft = t.stretch = 0.0;
  }
}

bool ContactStates::held_beside(std::size_t i) const {
  // Points are sorted by their vertex.
  const auto holds = [&](std::size_t j) {
    constexpr double kSameWay = 0.99;
    return trial_[j].status != ContactStatus::open && list_->points[j].at.n.dot(list_->points[i].at.n) > kSameWay;
  };
  const VertexIndex vertex = list_->points[i].vertex;
  for (std::size_t j = i; j-- > 0 && list_->points[j].vertex == vertex;)
    if (holds(j)) return true;
  for (std::size_t j = i + 1; j < trial_.size() && list_->points[j].vertex == vertex; ++j)
    if (holds(j)) return true;
  return false;
}

bool ContactStates::may_close(std::size_t i) const {
  // The foot must be on the edge at the end of the step; of two edges at a convex corner the nearer one gets the
  // contact.
  const ContactPoint& p = list_->points[i];
  const double foot = p.at.xi * p.at.length + trial_[i].moved;
  if (foot < p.s_low || foot > p.s_high) return false;
  constexpr double kOver = 1e-12;  // beyond it the vertex is not over this edge at the start of the step
  if ((p.at.xi < -kOver || p.at.xi > 1.0 + kOver) && held_beside(i)) return false;
  for (const std::int32_t other : p.partner) {
    if (other < 0 || list_->points[static_cast<std::size_t>(other)].suppressed) continue;
    const ContactTrial& t = trial_[static_cast<std::size_t>(other)];
    if (t.status != ContactStatus::open) return false;
    const ContactPoint& po = list_->points[static_cast<std::size_t>(other)];
    const double foot_other = po.at.xi * po.at.length + t.moved;
    if (t.gap < 0.0 && foot_other >= po.s_low && foot_other <= po.s_high &&
        leaves_by(-t.gap, -trial_[i].gap, other == p.partner[0]))
      return false;
  }
  return true;
}

double ContactStates::tolerance(std::size_t i) const {
  return 1e-9 * weight_[i] + 1e-11 * largest_force_ + list_->memory[i].kn * gap_round_off_;
}

bool ContactStates::proposes_slack(std::size_t i, ProposedState& w) const {
  const ContactTrial& t = trial_[i];
  const ContactMemory& m = list_->memory[i];
  const double least = slack_force(i), force = pressed(t, t.gap - m.gap);
  if (t.slack ? force <= least : force >= least) return false;
  w.slack = !t.slack;
  w.violation = std::abs(force - least);
  return true;
}

bool ContactStates::rides(std::size_t i, ProposedState& w) const {
  const ContactTrial& t = trial_[i];
  const ContactMemory& m = list_->memory[i];
  const double left = slip_left(i), e = stretch_before(i) + t.moved;
  const bool touched = m.status != ContactStatus::open || m.gap < 0.0;
  if (!(law_of(i).dilation > 0.0) || !(left > 0.0) || !touched || m.bonded != 0) return false;
  const double direction = e > 0.0 ? -1.0 : 1.0;
  double force = 0.0, slip = 0.0;
  for (const bool opens : {true, false}) {
    const DilatingForce f = dilating_force(law_of(i), strength_[i], t.k, m.kt, direction, opens, left);
    force = -(f.per_gap * (t.at + t.gap - m.gap) + f.per_stretch * e + f.constant);
    slip = std::abs(e) - strength_[i].friction_limit(force) / m.kt;
    w.opens = opens;
    if (slip < left) break;
  }
  if (!(force > 0.0) || !(slip > 0.0)) return false;
  w.status = ContactStatus::slip;
  w.direction = direction;
  w.slack = false;
  w.violation = force;
  return true;
}

ContactStates::ProposedState ContactStates::proposed_of_open(std::size_t i) const {
  const ContactTrial& t = trial_[i];
  const ContactMemory& m = list_->memory[i];
  ProposedState w{t.status, t.direction, t.opens, t.slack};
  if (!may_close(i)) return w;
  if (t.gap >= 0.0) {
    ProposedState riding = w;
    return rides(i, riding) ? riding : w;
  }
  // State and violation follow from the spring forces at the present positions of the bodies: a point that sticks while
  // the joint slides may be lifted by its own tangential spring, and its state would never settle.
  w.violation = -m.kn * t.gap;
  const double ft = -m.kt * (stretch_before(i) + t.moved);
  w.status = std::abs(ft) > strength_[i].friction_limit(w.violation) ? ContactStatus::slip : ContactStatus::stick;
  w.direction = ft < 0.0 ? -1.0 : 1.0;
  w.slack = pressed(t, t.gap - m.gap) < 0.0;
  return w;
}

ContactStates::ProposedState ContactStates::proposed_state(std::size_t i) const {
  const ContactTrial& t = trial_[i];
  const ContactMemory& m = list_->memory[i];
  const Strength& s = strength_[i];
  ProposedState w{t.status, t.direction, t.opens, t.slack};
  if (t.status == ContactStatus::open) return proposed_of_open(i);
  const double bears = t.status == ContactStatus::stick ? s.tension : 0.0;
  if (t.gap > 0.0 && (bears > 0.0 || t.slack || t.fn < 0.0 || t.k == m.kn)) {
    // A sticking bond bears the pull, unless the pull or the shear with it is too large: then nothing keeps it closed.
    const double pull = m.kn * t.gap;
    w.violation = bears > 0.0 ? std::max(pull - bears, std::abs(t.ft) - s.friction_limit(-pull)) : pull;
    if (w.violation > tolerance(i)) {
      w.status = ContactStatus::open;
      return w;
    }
    w.violation = 0.0;  // its opening is negligible; slip, or the pull of its dashpot, is still checked
    if (bears > 0.0) {
      (void)proposes_slack(i, w);
      return w;
    }
  }
  if (proposes_slack(i, w)) {
    if (w.violation > tolerance(i)) return w;
    w.slack = t.slack;  // the dashpot's pull is negligible; friction is still checked
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
    } else if (law_of(i).dilation > 0.0 && (std::abs(slip) < slip_left(i)) != t.opens) {
      w.opens = !t.opens;
      w.violation = m.kn * std::tan(law_of(i).dilation) * std::abs(std::abs(slip) - slip_left(i));
    }
  }
  return w;
}

void ContactStates::propose(std::size_t i, Proposals& out) const {
  const ContactTrial& t = trial_[i];
  const ProposedState w = proposed_state(i);
  const bool other = w.status != t.status || w.opens != t.opens || w.slack != t.slack;
  if (other && w.violation > tolerance(i)) out.emplace_back(i, w);
}

template <class May>
void ContactStates::propose_all(May&& may) {
  parallel_list(
      std::ssize(trial_), by_chunk_, proposed_,
      [&](std::int64_t at, Proposals& out) {
        if (const auto i = static_cast<std::size_t>(at); may(i)) propose(i, out);
      },
      kFewPoints);
}

void ContactStates::adopt(std::size_t i, const ProposedState& w) {
  ContactTrial& t = trial_[i];
  t.status = w.status;
  t.direction = w.direction;
  t.opens = w.opens;
  t.slack = w.slack && w.status != ContactStatus::open;
}

int ContactStates::change(bool only_worst) {
  largest_force_ = parallel_largest(
      std::ssize(trial_), [this](std::int64_t i) { return std::abs(trial_[static_cast<std::size_t>(i)].fn); },
      kFewPoints);
  propose_all([this](std::size_t i) { return !list_->points[i].suppressed; });
  const auto bodies_of = [&](std::size_t i) {
    const auto& node = list_->points[i].node;
    const auto& body = setup_->outlines().node_body;
    return std::array{body[node[0]], body[node[1]]};
  };
  if (only_worst) {
    worst_.assign(setup_->bodies().size(), 0.0);
    for (const auto& [i, w] : proposed_)
      for (const BodyIndex b : bodies_of(i)) worst_[b] = std::max(worst_[b], w.violation);
  }
  changed_.clear();
  for (const auto& [i, w] : proposed_) {
    if (only_worst) {
      // Of two equal violations one is enough.
      const auto is_worst = [&, &proposed = w](BodyIndex b) {
        return setup_->body(b).driven || proposed.violation >= worst_[b];
      };
      const std::array bodies = bodies_of(i);
      if (!is_worst(bodies[0]) || !is_worst(bodies[1])) continue;
      for (const BodyIndex b : bodies) worst_[b] = std::numeric_limits<double>::infinity();
    }
    changed_.push_back(i);
    adopt(i, w);
  }
  return static_cast<int>(changed_.size());
}

bool ContactStates::change_among(std::span<const std::size_t> points, bool only_worst) {
  proposed_.clear();
  for (const std::size_t i : points) propose(i, proposed_);
  if (proposed_.empty()) return false;
  if (only_worst) {
    const auto worst = std::max_element(proposed_.begin(), proposed_.end(), [](const auto& a, const auto& b) {
      return a.second.violation < b.second.violation;
    });
    std::swap(*proposed_.begin(), *worst);
    proposed_.resize(1);
  }
  for (const auto& [i, w] : proposed_) adopt(i, w);
  return true;
}

int ContactStates::close(std::span<const double> d) {
  const auto may = [this](std::size_t i) {
    return trial_[i].status == ContactStatus::open && !list_->points[i].suppressed;
  };
  const auto evaluate_open = [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    if (may(i)) evaluate_point(i, d);
  };
  parallel_for(std::ssize(trial_), evaluate_open, kFewPoints);
  largest_force_ = parallel_largest(  // as the step begins
      std::ssize(trial_), [this](std::int64_t i) { return std::abs(list_->memory[static_cast<std::size_t>(i)].fn); },
      kFewPoints);
  propose_all(may);
  for (const auto& [i, w] : proposed_) adopt(i, w);
  return static_cast<int>(proposed_.size());
}

char ContactStates::letter(const ContactTrial& t) {
  return static_cast<char>((static_cast<int>(t.status) + (t.opens ? 4 : 0) + (t.slack ? 8 : 0)) *
                           (t.direction < 0.0 ? -1 : 1));
}

std::size_t ContactStates::hash() {
  letters_.resize(trial_.size());
  parallel_for(
      std::ssize(trial_),
      [this](std::int64_t i) { letters_[static_cast<std::size_t>(i)] = letter(trial_[static_cast<std::size_t>(i)]); },
      kFewPoints);
  return std::hash<std::string>{}(letters_);
}

std::size_t ContactStates::hash(std::span<const std::size_t> points) {
  letters_.clear();
  for (const std::size_t i : points) letters_.push_back(letter(trial_[i]));
  return std::hash<std::string>{}(letters_);
}

const ContactKey* ContactStates::closing() const {
  for (std::size_t i = 0; i < trial_.size(); ++i)
    if (trial_[i].status != ContactStatus::open ||
        (!list_->points[i].suppressed && proposed_of_open(i).status != ContactStatus::open))
      return &list_->memory[i].key;
  return nullptr;
}

void ContactStates::check(std::span<const double> d, double unbalanced, Audit& audit) const {
  for (std::size_t i = 0; i < trial_.size(); ++i) {
    const ContactTrial& t = trial_[i];
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
                [&] { return fmt::format("{}: counted as slack, but its spring presses more", name()); });
    // A gap is accurate to the force of its spring; with the dashpot the same gap error is a larger force.
    audit_law(*setup_, m, bearing_force(i), t.ft, allowed * t.k / m.kn, audit);
    const double slip = stretch_before(i) + t.moved - t.stretch;
    audit.check(t.ft * slip > 0.0 && t.status == ContactStatus::slip ? m.kt * slip : 0.0, allowed,
                [&] { return fmt::format("{}: friction drives it, {:.3g} m", name(), slip); });
  }
}

}  // namespace scree::coupling
