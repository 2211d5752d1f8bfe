#include "coupling/integrate/step_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/parallel.h"

namespace scree::coupling {
namespace {

/// The largest root of h^2 lambda + 2 h gamma = 4.
double largest_step(double lambda, double gamma) {
  // 4/(sqrt(gamma^2 + 4 lambda) + gamma) is the same root, also for lambda = 0.
  const double rate = std::sqrt(gamma * gamma + 4.0 * lambda) + gamma;
  return rate > 0.0 ? 4.0 / rate : std::numeric_limits<double>::infinity();
}

}  // namespace

StepBound::StepBound(const Setup& setup)
    : setup_(&setup),
      stiff_(static_cast<std::size_t>(setup.nodes()), 0.0),
      viscous_(static_cast<std::size_t>(setup.nodes()), 0.0) {
  // A damped spring has h = (2/w)(sqrt(1 + xi^2) - xi) ([Qu2013] 5.3.2): as if it were stiffer.
  for (const JointLaw& law : setup.model().joints) {
    const double shrink = std::sqrt(1.0 + law.damping * law.damping) - law.damping;
    shortens_.push_back(shrink * shrink);
  }
  const Outlines& o = setup.outlines();
  node_compliance_.reserve(o.nodes.size());
  const auto list_touched = [this](auto& lists) {
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
    lists.push_back(touched_);
    touched_.clear();
  };
  for (const OutlineNode i : o.nodes.indices()) {
    node_compliance_.push_back(compliance(o.node_body[i], o.nodes[i]));
    touch_row(o.node_body[i], o.nodes[i]);
    list_touched(of_node_);
  }
  for (const Outlines::Segment& s : o.segments) {
    for (const OutlineNode end : {s.a, s.b})
      touched_.insert(touched_.end(), of_node_[end].begin(), of_node_[end].end());
    list_touched(of_segment_);
  }
}

double StepBound::compliance(BodyIndex body, const Row& row) const {
  const Body& b = setup_->body(body);
  return b.driven || setup_->on_ghost(row) ? 0.0 : setup_->pool_of(b).compliance(b.index, setup_->local(b, row));
}

void StepBound::touch_row(BodyIndex body, const Row& row) {
  // A row that another integrator moves (a ghost, or the other half of a divided body) is on a given path, and does
  // not count.
  const Body& b = setup_->body(body);
  if (b.driven || setup_->on_ghost(row)) return;
  setup_->pool_of(b).bound_groups(b.index, setup_->local(b, row), found_);
  const std::int32_t first = setup_->pool_first(static_cast<std::size_t>(b.pool));
  for (const std::int32_t g : found_) touched_.push_back(first + g);
}

void StepBound::add(Kind kind, BodyIndex other, double size, std::span<const std::int32_t> groups) {
  std::vector<double>& sums = kind == Kind::viscous ? viscous_ : stiff_;
  for (const std::int32_t g : groups) sums[static_cast<std::size_t>(g)] += size;
  if (!listed_ || groups.empty()) return;
  list_.push_back(
      {kind, other, size, static_cast<std::int32_t>(groups_.size()), static_cast<std::int32_t>(groups.size())});
  groups_.insert(groups_.end(), groups.begin(), groups.end());
}

void StepBound::add_touched(Kind kind, double size) {
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  add(kind, {}, size, touched_);
  touched_.clear();
}

std::int32_t StepBound::worst(const Body& b, bool viscous) const {
  const std::vector<double>& sums = viscous ? viscous_ : stiff_;
  const auto first = sums.begin() + b.first_node;
  return static_cast<std::int32_t>(std::max_element(first, first + b.nodes) - sums.begin());
}

double StepBound::sum(std::int32_t group, bool viscous) const {
  return (viscous ? viscous_ : stiff_)[static_cast<std::size_t>(group)];
}

void StepBound::collect_contacts(const StepParts& in) {
  const Outlines& o = setup_->outlines();
  const auto& points = in.contacts.points;
  sizes_.resize(points.size());
  parallel_for(std::ssize(points), [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    const ContactPoint& p = points[i];
    const auto mu_of = [&](std::size_t n) { return node_compliance_[p.node[n]]; };
    // The foot lies between the ends (or a little beyond): its compliance is at most that of a combination of the two.
    const double reach = std::max({1.0, std::abs(p.at.xi), std::abs(1.0 - p.at.xi)});
    const double mu = mu_of(0) + reach * reach * std::max(mu_of(1), mu_of(2));
    const ContactMemory& m = in.contacts.memory[i];
    const double k = (std::max(m.kn, m.kt) + p.margin) / shortens_[static_cast<std::size_t>(m.joint)];
    sizes_[i] = {k * mu, p.node[0], p.segment};
  });
  if (listed_)
    for (std::size_t i = 0; i < points.size(); ++i) {
      add(Kind::contact, o.node_body[points[i].node[1]], sizes_[i].size, of_node_[sizes_[i].corner]);
      add(Kind::contact, o.node_body[points[i].node[0]], sizes_[i].size, of_segment_[sizes_[i].foot]);
    }
  else
    for (const Size& s : sizes_) {
      for (const std::int32_t g : of_node_[s.corner]) stiff_[static_cast<std::size_t>(g)] += s.size;
      for (const std::int32_t g : of_segment_[s.foot]) stiff_[static_cast<std::size_t>(g)] += s.size;
    }
}

void StepBound::collect(const StepParts& in) {
  std::fill(stiff_.begin(), stiff_.end(), 0.0);
  std::fill(viscous_.begin(), viscous_.end(), 0.0);
  list_.clear();
  groups_.clear();
  collect_contacts(in);
  for (const PointSpring& s : in.springs) {
    touch_row(s.body, s.row);
    add_touched(Kind::support, s.k.maxCoeff() * compliance(s.body, s.row));
  }
  for (const BoltSpring& s : in.bolts) {
    double mu = 0.0;
    for (std::size_t k = 0; k < s.rows.size(); ++k) mu += compliance(s.body[k], s.rows[k]);
    for (std::size_t k = 0; k < s.rows.size(); ++k) {
      touch_row(s.body[k], s.rows[k]);
      add_touched(Kind::bolt, s.k * mu);
    }
  }
  for (const Dashpot& d : in.dashpots) {
    const double mu_a = compliance(d.stretch.body, d.stretch.a), mu_b = compliance(d.stretch.body, d.stretch.b);
    for (const double s : {d.stretch.from, d.stretch.to}) {
      // The compliance of a point between the rows is convex in s. At a row only that one is touched.
      if (s != 1.0) touch_row(d.stretch.body, d.stretch.a);
      if (s != 0.0) touch_row(d.stretch.body, d.stretch.b);
      add_touched(Kind::viscous, std::max(d.normal, d.shear) * ((1.0 - s) * mu_a + s * mu_b));
    }
  }
}

std::string StepBound::shares(const Body& b, const ExplicitDamping& damping, double h) const {
  // "62 % its own stiffness, 38 % contacts, the stiffest with block 'x'": shares of h^2 lambda + 2 h gamma = 4.
  const Pool& pool = setup_->pool_of(b);
  const double theta = pool.mass_ratio(b.index), own = pool.frequency_bound(b.index),
               stiff = 0.25 * h * h * theta * (1.0 + damping.local), viscous = 0.5 * h * theta;
  struct Share {
    double part;
    std::string of;
  };
  std::vector<Share> list;
  const std::string element = pool.binding(b.index);
  list.push_back({stiff * own, element.empty() ? "its own stiffness" : element});
  list.push_back({viscous * damping.stiffness * own, "its stiffness-proportional damping"});
  const std::int32_t stiffest_group = worst(b, false), damped = worst(b, true);
  double contacts = 0.0, supports = 0.0, bolts = 0.0, stiffest = 0.0;
  BodyIndex with;
  for (const Part& p : list_) {
    const auto first = groups_.begin() + p.first;
    if (!std::binary_search(first, first + p.groups, stiffest_group)) continue;
    if (p.kind == Kind::support) supports += p.size;
    if (p.kind == Kind::bolt) bolts += p.size;
    if (p.kind != Kind::contact) continue;
    contacts += p.size;
    if (p.size <= stiffest) continue;
    stiffest = p.size;
    with = p.other;
  }
  if (with.valid())
    list.push_back({stiff * contacts, fmt::format("contacts, the stiffest with block '{}'",
                                                  setup_->model().blocks[setup_->body(with).block.index()].name)});
  list.push_back({stiff * supports, "point supports"});
  list.push_back({stiff * bolts, "bolts"});
  list.push_back({viscous * sum(damped, true), "viscous edges"});
  std::stable_sort(list.begin(), list.end(), [](const Share& x, const Share& y) { return x.part > y.part; });
  std::string text;
  for (const Share& s : list)
    if (s.part >= 0.005) text += fmt::format("{}{:.0f} % {}", text.empty() ? "" : ", ", 100.0 * s.part, s.of);
  return text;
}

double StepBound::certified_step(const StepParts& parts, std::string* binding) {
  listed_ = binding != nullptr;
  collect(parts);
  double least = std::numeric_limits<double>::infinity();
  const Body* binds = nullptr;
  for (const Body& b : setup_->bodies()) {
    if (b.driven) continue;
    const Pool& pool = setup_->pool_of(b);
    const double own = pool.frequency_bound(b.index), theta = pool.mass_ratio(b.index);
    const double lambda = theta * (1.0 + parts.damping.local) * (own + sum(worst(b, false), false)),
                 gamma = theta * (parts.damping.stiffness * own + sum(worst(b, true), true));
    const double h = largest_step(lambda, gamma);
    if (!(h < least)) continue;
    least = h;
    binds = &b;
  }
  if (binding != nullptr && binds != nullptr)
    *binding = fmt::format("block '{}' ({})", setup_->model().blocks[binds->block.index()].name,
                           shares(*binds, parts.damping, least));
  return least;
}

double slow_step(const Setup& setup, std::string* binding) {
  double least = std::numeric_limits<double>::infinity();
  for (const Body& b : setup.bodies()) {
    if (b.driven || !b.slow) continue;
    const Pool& pool = setup.pool_of(b);
    const double step = 0.5 / std::sqrt(pool.mass_ratio(b.index) * pool.frequency_bound(b.index));
    if (!(step < least)) continue;
    least = step;
    if (binding == nullptr) continue;
    const std::string element = pool.binding(b.index);
    *binding = fmt::format("block '{}'{}", setup.model().blocks[b.block.index()].name,
                           element.empty() ? std::string() : ", " + element);
  }
  return least;
}

}  // namespace scree::coupling
