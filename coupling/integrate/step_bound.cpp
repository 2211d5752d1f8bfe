#include "coupling/integrate/step_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::coupling {
namespace {

enum class Kind { contact, support, viscous };

/// One spring or dashpot of a body.
struct Part {
  Kind kind;
  std::int32_t body;
  std::int32_t other;  // the body on the other side of a contact
  double size;         // k mu [1/s2], c mu of a dashpot [1/s]
  std::vector<std::int32_t> groups;
};

/// Springs and dashpots of all free bodies, and their sums a group.
class Parts {
 public:
  explicit Parts(const Setup& setup)
      : setup_(&setup),
        stiff_(static_cast<std::size_t>(setup.nodes()), 0.0),
        viscous_(static_cast<std::size_t>(setup.nodes()), 0.0) {}

  /// What another integrator moves (a ghost, or the other half of a divided body) is on a given path, and does not
  /// count.
  void add(Kind kind, std::int32_t body, std::int32_t other, std::span<const Row> rows, double size) {
    const Body& b = setup_->bodies()[static_cast<std::size_t>(body)];
    if (b.driven) return;
    Part part{kind, body, other, size, {}};
    std::vector<std::int32_t> groups;
    for (const Row& row : rows) {
      if (setup_->on_ghost(row)) continue;
      setup_->pool_of(b).bound_groups(b.index, setup_->local(b, row), groups);
      part.groups.insert(part.groups.end(), groups.begin(), groups.end());
    }
    if (part.groups.empty()) return;
    std::sort(part.groups.begin(), part.groups.end());
    part.groups.erase(std::unique(part.groups.begin(), part.groups.end()), part.groups.end());
    const std::int32_t first = setup_->pool_first(static_cast<std::size_t>(b.pool));
    for (std::int32_t& g : part.groups) {
      g += first;
      (kind == Kind::viscous ? viscous_ : stiff_)[static_cast<std::size_t>(g)] += size;
    }
    list_.push_back(std::move(part));
  }
  [[nodiscard]] double compliance(std::int32_t body, const Row& row) const {
    const Body& b = setup_->bodies()[static_cast<std::size_t>(body)];
    return b.driven || setup_->on_ghost(row) ? 0.0 : setup_->pool_of(b).compliance(b.index, setup_->local(b, row));
  }
  [[nodiscard]] std::int32_t worst(const Body& b, bool viscous) const {
    const std::vector<double>& sum = viscous ? viscous_ : stiff_;
    const auto first = sum.begin() + b.first_node;
    return static_cast<std::int32_t>(std::max_element(first, first + b.nodes) - sum.begin());
  }
  [[nodiscard]] double sum(std::int32_t group, bool viscous) const {
    return (viscous ? viscous_ : stiff_)[static_cast<std::size_t>(group)];
  }
  [[nodiscard]] const std::vector<Part>& list() const { return list_; }

 private:
  const Setup* setup_;
  std::vector<double> stiff_, viscous_;  // by the first node of the group
  std::vector<Part> list_;
};

Parts collect(const Setup& setup, const StepParts& in) {
  const Outlines& o = setup.outlines();
  Parts parts(setup);
  for (std::size_t i = 0; i < in.contacts.points.size(); ++i) {
    const ContactPoint& p = in.contacts.points[i];
    const std::array<Row, 3> row{o.nodes[static_cast<std::size_t>(p.node[0])],
                                 o.nodes[static_cast<std::size_t>(p.node[1])],
                                 o.nodes[static_cast<std::size_t>(p.node[2])]};
    const std::int32_t body_p = o.node_body[static_cast<std::size_t>(p.node[0])],
                       body_e = o.node_body[static_cast<std::size_t>(p.node[1])];
    // The foot lies between the ends (or a little beyond): its compliance is at most that of a combination of the two.
    const double reach = std::max({1.0, std::abs(p.at.xi), std::abs(1.0 - p.at.xi)});
    const double mu = parts.compliance(body_p, row[0]) +
                      reach * reach * std::max(parts.compliance(body_e, row[1]), parts.compliance(body_e, row[2]));
    // A damped spring has h = (2/w)(sqrt(1 + xi^2) - xi) ([Qu2013] 5.3.2): as if it were stiffer.
    const double xi = setup.model().joints[static_cast<std::size_t>(in.contacts.memory[i].joint)].damping;
    const double shrink = std::sqrt(1.0 + xi * xi) - xi;
    const double k = (std::max(in.contacts.memory[i].kn, in.contacts.memory[i].kt) + p.margin) / (shrink * shrink);
    parts.add(Kind::contact, body_p, body_e, std::span(row).first(1), k * mu);
    parts.add(Kind::contact, body_e, body_p, std::span(row).last(2), k * mu);
  }
  for (const PointSpring& s : in.springs)
    parts.add(Kind::support, s.body, -1, {&s.row, 1}, s.k.maxCoeff() * parts.compliance(s.body, s.row));
  for (const Dashpot& d : in.dashpots) {
    const std::array<Row, 2> row{d.stretch.a, d.stretch.b};
    const double mu_a = parts.compliance(d.stretch.body, row[0]), mu_b = parts.compliance(d.stretch.body, row[1]);
    for (const double s : {d.stretch.from, d.stretch.to}) {
      // The compliance of a point between the rows is convex in s. At a row only that one is touched.
      const auto touched = s == 0.0 ? std::span(row).first(1) : (s == 1.0 ? std::span(row).last(1) : std::span(row));
      parts.add(Kind::viscous, d.stretch.body, -1, touched,
                std::max(d.normal, d.shear) * ((1.0 - s) * mu_a + s * mu_b));
    }
  }
  return parts;
}

/// The largest root of h^2 lambda + 2 h gamma = 4.
double largest_step(double lambda, double gamma) {
  // 4/(sqrt(gamma^2 + 4 lambda) + gamma) is the same root, also for lambda = 0.
  const double rate = std::sqrt(gamma * gamma + 4.0 * lambda) + gamma;
  return rate > 0.0 ? 4.0 / rate : std::numeric_limits<double>::infinity();
}

/// "62 % its own stiffness, 38 % contacts, the stiffest with block 'x'": shares of h^2 lambda + 2 h gamma = 4.
std::string shares(const Setup& setup, const Parts& parts, const Body& b, const ExplicitDamping& damping, double h) {
  const Pool& pool = setup.pool_of(b);
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
  const std::int32_t worst = parts.worst(b, false), damped = parts.worst(b, true);
  double contacts = 0.0, supports = 0.0, stiffest = 0.0;
  std::int32_t with = -1;
  for (const Part& p : parts.list()) {
    if (!std::binary_search(p.groups.begin(), p.groups.end(), worst)) continue;
    if (p.kind == Kind::support) supports += p.size;
    if (p.kind != Kind::contact) continue;
    contacts += p.size;
    if (p.size <= stiffest) continue;
    stiffest = p.size;
    with = p.other;
  }
  if (with >= 0)
    list.push_back(
        {stiff * contacts,
         fmt::format("contacts, the stiffest with block '{}'",
                     setup.model().blocks[setup.bodies()[static_cast<std::size_t>(with)].block.index()].name)});
  list.push_back({stiff * supports, "point supports"});
  list.push_back({viscous * parts.sum(damped, true), "viscous edges"});
  std::stable_sort(list.begin(), list.end(), [](const Share& x, const Share& y) { return x.part > y.part; });
  std::string text;
  for (const Share& s : list)
    if (s.part >= 0.005) text += fmt::format("{}{:.0f} % {}", text.empty() ? "" : ", ", 100.0 * s.part, s.of);
  return text;
}

}  // namespace

double certified_step(const Setup& setup, const StepParts& parts, std::string* binding) {
  const Parts all = collect(setup, parts);
  double least = std::numeric_limits<double>::infinity();
  const Body* binds = nullptr;
  for (const Body& b : setup.bodies()) {
    if (b.driven) continue;
    const Pool& pool = setup.pool_of(b);
    const double own = pool.frequency_bound(b.index), theta = pool.mass_ratio(b.index);
    const double lambda = theta * (1.0 + parts.damping.local) * (own + all.sum(all.worst(b, false), false)),
                 gamma = theta * (parts.damping.stiffness * own + all.sum(all.worst(b, true), true));
    const double h = largest_step(lambda, gamma);
    if (!(h < least)) continue;
    least = h;
    binds = &b;
  }
  if (binding != nullptr && binds != nullptr)
    *binding = fmt::format("block '{}' ({})", setup.model().blocks[binds->block.index()].name,
                           shares(setup, all, *binds, parts.damping, least));
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
