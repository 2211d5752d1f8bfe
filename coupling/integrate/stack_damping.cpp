#include "coupling/integrate/stack_damping.h"

#include <algorithm>

namespace scree::coupling {

namespace {

constexpr std::int32_t kAffine = 3;  // nodes of a body without a mesh
constexpr double kFactor = 2.0;      // of a block's own rate: 1 stops stacks of five, 2 those of eight

std::size_t body_of(const Outlines& o, const ContactPoint& p, std::size_t end) {
  return static_cast<std::size_t>(o.node_body[static_cast<std::size_t>(p.node[end])]);
}

bool closed(const ContactMemory& m) { return m.status != ContactStatus::open && m.fn > 0.0; }

}  // namespace

StackDamping::StackDamping(const Setup& setup, const SlidingDamping& sliding) : laws_(&setup.laws()) {
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
    exempt_[i] = b.divided || !sliding.damps(i) ? 1 : 0;
    if (exempt_[i] != 0) continue;
    mesh_[i] = b.nodes > kAffine ? 1 : 0;
    used_ = used_ || mesh_[i] != 0;
  }
}

bool StackDamping::damped(const ContactMemory& m, std::size_t i, std::size_t j) const {
  return closed(m) && exempt_[i] == 0 && exempt_[j] == 0 && (mesh_[i] != 0 || mesh_[j] != 0) &&
         std::max(rate_[i], rate_[j]) > 0.0 && !((*laws_)[static_cast<std::size_t>(m.joint)].dilation > 0.0);
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
    wanted_[i] = wanted_[j] = 1;
    any = true;
  }
  return any;
}

double StackDamping::act(const Outlines& outlines, const ContactList& list, std::span<const double> q, double half) {
  std::fill(force_.begin(), force_.end(), Eigen::Vector3d::Zero());
  double friction = 0.0;
  for (std::size_t k = 0; k < list.points.size(); ++k) {
    const ContactPoint& p = list.points[k];
    const ContactMemory& m = list.memory[k];
    const std::size_t i = body_of(outlines, p, 0), j = body_of(outlines, p, 1);
    if (!damped(m, i, j)) continue;
    Rigid &one = rigid_[i], &other = rigid_[j];
    const Vec2 x = position(outlines.nodes[static_cast<std::size_t>(p.node[0])], q);
    const auto row = [&x](const Vec2& w, const Rigid& r) -> Eigen::Vector3d {
      const Vec2 d = x - r.centre;
      return {w.x(), w.y(), w.y() * d.x() - w.x() * d.y()};
    };
    const double ratio = m.status == ContactStatus::slip ? m.ft / m.fn : 0.0;
    const Vec2 along = p.at.n + ratio * p.at.t;
    const Eigen::Vector3d n1 = row(p.at.n, one), n2 = row(p.at.n, other);
    const Eigen::Vector3d gain1 = one.inverse * row(along, one), gain2 = other.inverse * row(along, other);
    const double speed = n1.dot(one.velocity) - n2.dot(other.velocity);
    const double compliance = std::max(0.0, n1.dot(gain1) + n2.dot(gain2));
    const double mass = 1.0 / (1.0 / one.mass + 1.0 / other.mass);
    const double c = kFactor * std::max(rate_[i], rate_[j]) * mass * m.fn / std::min(all_[i], all_[j]);
    const double force = std::max(-m.fn, -c * speed / (1.0 + c * half * compliance));
    force_[i] += force * row(along, one);
    force_[j] -= force * row(along, other);
    one.velocity += half * force * gain1;
    other.velocity -= half * force * gain2;
    friction += force * ratio * (row(p.at.t, one).dot(one.velocity) - row(p.at.t, other).dot(other.velocity));
  }
  return friction;
}

}  // namespace scree::coupling
