#include "coupling/integrate/stack_damping.h"

#include <algorithm>
#include <array>
#include <limits>

namespace scree::coupling {

namespace {

constexpr std::int32_t kAffine = 3;  // nodes of a body without a mesh
constexpr double kFactor = 2.0;      // of a block's own rate: 1 stops stacks of five, 2 those of eight

std::size_t body_of(const Outlines& o, const ContactPoint& p, std::size_t end) {
  return static_cast<std::size_t>(o.node_body[static_cast<std::size_t>(p.node[end])]);
}

bool closed(const ContactMemory& m) { return m.status != ContactStatus::open && m.fn > 0.0; }

}  // namespace

StackDamping::StackDamping(const Setup& setup, const SlidingDamping& sliding) : setup_(&setup) {
  const std::size_t n = setup.bodies().size();
  mesh_.assign(n, 0);
  exempt_.assign(n, 0);
  wanted_.assign(n, 0);
  rate_.assign(n, 0.0);
  all_.assign(n, 0.0);
  rigid_.assign(n, {});
  force_.assign(n, Eigen::Vector3d::Zero());
  for (std::size_t i = 0; i < n; ++i) {
    const Body& b = setup.bodies()[i];
    exempt_[i] = b.ghost || b.divided || b.absent || !(b.driven || sliding.damps(i)) ? 1 : 0;
    if (exempt_[i] != 0 || b.driven) continue;
    mesh_[i] = b.nodes > kAffine ? 1 : 0;
    used_ = used_ || mesh_[i] != 0;
  }
}

bool StackDamping::damped(const ContactMemory& m, std::size_t i, std::size_t j) const {
  return closed(m) && exempt_[i] == 0 && exempt_[j] == 0 && (mesh_[i] != 0 || mesh_[j] != 0) &&
         std::max(rate_[i], rate_[j]) > 0.0;
}

bool StackDamping::find(const SlidingDamping& sliding, const Outlines& outlines, const ContactList& list) {
  std::fill(wanted_.begin(), wanted_.end(), 0);
  std::fill(all_.begin(), all_.end(), 0.0);
  for (std::size_t b = 0; b < rate_.size(); ++b) rate_[b] = sliding.moderate_rate(b);
  bool any = false;
  for (std::size_t k = 0; k < list.points.size(); ++k) {
    const ContactMemory& m = list.memory[k];
    if (!closed(m)) continue;
    const std::size_t i = body_of(outlines, list.points[k], 0), j = body_of(outlines, list.points[k], 1);
    all_[i] += m.fn;
    all_[j] += m.fn;
    if (!damped(m, i, j)) continue;
    for (const std::size_t b : {i, j}) wanted_[b] = setup_->bodies()[b].driven ? 0 : 1;
    any = true;
  }
  return any;
}

double StackDamping::act(const Outlines& outlines, const ContactList& list, std::span<const double> q,
                         std::span<const double> v, double half, std::span<double> driven_force) {
  constexpr std::array<std::size_t, 2> first{0, 1}, last{1, 3};  // nodes of a contact's row on its two bodies
  const auto node = [&](const ContactPoint& p, std::size_t i) -> const Row& {
    return outlines.nodes[static_cast<std::size_t>(p.node[i])];
  };
  std::fill(force_.begin(), force_.end(), Eigen::Vector3d::Zero());
  double friction = 0.0;
  for (std::size_t k = 0; k < list.points.size(); ++k) {
    const ContactPoint& p = list.points[k];
    const ContactMemory& m = list.memory[k];
    const std::array body{body_of(outlines, p, 0), body_of(outlines, p, 1)};
    if (!damped(m, body[0], body[1])) continue;
    const double ratio = m.status == ContactStatus::slip ? m.ft / m.fn : 0.0;
    const Vec2 n = p.at.n, t = p.at.t, along = n + ratio * t, x = position(node(p, 0), q);
    // Of the rigid motion of the first body less that of the second: the normal velocity, the slip rate, the force.
    std::array<Eigen::Vector3d, 2> normal, tangent, push;
    double compliance = 0.0, inverse_mass = 0.0, speed = 0.0, slip = 0.0, sum = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < 2; ++e) {
      const std::size_t b = body[e];
      const double sign = e == 0 ? 1.0 : -1.0;
      if (wanted_[b] == 0) {  // driven
        const ContactRow weights = gap_row(p.at);
        for (std::size_t i = first[e]; i < last[e]; ++i) {
          const Vec2 velocity = position(node(p, i), v);
          speed += weights[i].dot(velocity);
          slip += weights[i].dot(n) * t.dot(velocity);
        }
        continue;
      }
      const Rigid& r = rigid_[b];
      const Vec2 d = x - r.centre;
      const auto row = [&](const Vec2& w) -> Eigen::Vector3d {
        return sign * Eigen::Vector3d(w.x(), w.y(), w.y() * d.x() - w.x() * d.y());
      };
      normal[e] = row(n);
      tangent[e] = row(t);
      push[e] = row(along);
      compliance += normal[e].dot(r.inverse * push[e]);
      inverse_mass += 1.0 / r.mass;
      speed += normal[e].dot(r.velocity);
      sum = std::min(sum, all_[b]);
    }
    const double c = kFactor * std::max(rate_[body[0]], rate_[body[1]]) * m.fn / (sum * inverse_mass);
    const double force = std::max(-m.fn, -c * speed / (1.0 + c * half * std::max(0.0, compliance)));
    for (std::size_t e = 0; e < 2; ++e) {
      const std::size_t b = body[e];
      if (wanted_[b] == 0) {
        const ContactRow weights = gap_row(p.at);
        for (std::size_t i = first[e]; i < last[e]; ++i)
          add_force(node(p, i), force * weights[i].dot(n) * along, driven_force);
        continue;
      }
      force_[b] += force * push[e];
      rigid_[b].velocity += half * force * (rigid_[b].inverse * push[e]);
      slip += tangent[e].dot(rigid_[b].velocity);
    }
    friction += force * ratio * slip;
  }
  return friction;
}

}  // namespace scree::coupling
