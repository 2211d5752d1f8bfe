#include "coupling/integrate/step_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::coupling {
namespace {

constexpr std::int64_t kFewBodies = 1024;  // fewer are not worth waking threads

/// The largest root of h^2 lambda + 2 h gamma = 4.
double largest_step(double lambda, double gamma) {
  // 4/(sqrt(gamma^2 + 4 lambda) + gamma) is the same root, also for lambda = 0.
  const double rate = std::sqrt(gamma * gamma + 4.0 * lambda) + gamma;
  return rate > 0.0 ? 4.0 / rate : std::numeric_limits<double>::infinity();
}

void take_groups(std::span<const std::int32_t> groups, Reach& reach) {
  if (groups.empty()) return;
  reach.take(groups.front());
  reach.take(groups.back());
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

void StepBound::find_sizes(const ContactList& list) {
  const auto points = std::ssize(list.points);
  sizes_.resize(list.points.size());
  reach_.resize(static_cast<std::size_t>((points + kChunk - 1) / kChunk));
  const bool on_threads = omp_get_max_threads() > 1;
  parallel_for_chunks(points, [&](std::int64_t begin, std::int64_t end) {
    Reach reach;
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
      const ContactPoint& p = list.points[i];
      const auto mu_of = [&](std::size_t n) { return node_compliance_[p.node[n]]; };
      // The foot lies between the ends, or a little beyond: its compliance is at most that of their combination.
      const double ends = std::max({1.0, std::abs(p.at.xi), std::abs(1.0 - p.at.xi)});
      const double mu = mu_of(0) + ends * ends * std::max(mu_of(1), mu_of(2));
      const ContactMemory& m = list.memory[i];
      const double k = (std::max(m.kn, m.kt) + p.margin) / shortens_[static_cast<std::size_t>(m.joint)];
      sizes_[i] = {k * mu, p.node[0], p.segment};
      if (on_threads) take_groups(of_node_[p.node[0]], reach), take_groups(of_segment_[p.segment], reach);
    }
    reach_[static_cast<std::size_t>(begin / kChunk)] = reach;
  });
}

void StepBound::collect_contacts(const StepParts& in) {
  const Outlines& o = setup_->outlines();
  const auto& points = in.contacts.points;
  find_sizes(in.contacts);
  if (listed_) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      add(Kind::contact, o.node_body[points[i].node[1]], sizes_[i].size, of_node_[sizes_[i].corner]);
      add(Kind::contact, o.node_body[points[i].node[0]], sizes_[i].size, of_segment_[sizes_[i].foot]);
    }
    return;
  }
  const auto groups = static_cast<std::int32_t>(stiff_.size());
  const auto of_part = [&](std::int64_t, std::int32_t begin, std::int32_t end) {
    const auto add_to = [&](std::span<const std::int32_t> list, double size) {
      for (const std::int32_t g : list)
        if (g >= begin && g < end) stiff_[static_cast<std::size_t>(g)] += size;
    };
    for (std::size_t c = 0; c < reach_.size(); ++c) {
      if (end - begin < groups && !reach_[c].meets(begin, end)) continue;
      const auto chunk = static_cast<std::size_t>(kChunk);
      for (const Size& s : std::span(sizes_).subspan(chunk * c, std::min(chunk, sizes_.size() - chunk * c))) {
        add_to(of_node_[s.corner], s.size);
        add_to(of_segment_[s.foot], s.size);
      }
    }
  };
  parallel_parts(groups, std::ssize(points) >= kSerialBelow, of_part);
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

double StepBound::of_body(const Body& b, const ExplicitDamping& damping) const {
  const Pool& pool = setup_->pool_of(b);
  const double own = pool.frequency_bound(b.index), theta = pool.mass_ratio(b.index);
  const double lambda = theta * (1.0 + damping.local) * (own + sum(worst(b, false), false)),
               gamma = theta * (damping.stiffness * own + sum(worst(b, true), true));
  return largest_step(lambda, gamma);
}

double StepBound::certified_step(const StepParts& parts, std::string* binding) {
  listed_ = binding != nullptr;
  collect(parts);
  const std::span<const Body> bodies = setup_->bodies();
  const auto count = std::ssize(bodies);
  least_.assign(static_cast<std::size_t>(count / kChunk + 1), {});
  const auto of_bodies = [&](std::int64_t begin, std::int64_t end) {
    Least least;
    for (std::int64_t i = begin; i < end; ++i) {
      const Body& b = bodies[static_cast<std::size_t>(i)];
      if (b.driven) continue;
      if (const double h = of_body(b, parts.damping); h < least.h) least = {h, &b};
    }
    least_[static_cast<std::size_t>(begin / kChunk)] = least;
  };
  parallel_for_chunks(count, of_bodies, kFewBodies);
  const Least least =
      *std::min_element(least_.begin(), least_.end(), [](const Least& a, const Least& b) { return a.h < b.h; });
  if (binding != nullptr && least.body != nullptr)
    *binding = fmt::format("block '{}' ({})", setup_->model().blocks[least.body->block.index()].name,
                           shares(*least.body, parts.damping, least.h));
  return least.h;
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
