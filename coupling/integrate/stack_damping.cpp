#include "coupling/integrate/stack_damping.h"

#include <Eigen/LU>
#include <algorithm>

namespace scree::coupling {

namespace {

constexpr double kFactor = 2.0;  // of a block's own rate: 1 stops stacks of five, 2 those of eight

std::size_t body_of(const Outlines& o, const ContactPoint& p, std::size_t end) {
  return o.node_body[p.node[end]].index();
}

bool closed(const ContactMemory& m) { return m.status != ContactStatus::open && m.fn > 0.0; }

/// Components of a force w at x along the rigid motions about a centre.
Eigen::Vector3d row(const Vec2& w, const Vec2& x, const Vec2& centre) {
  const Vec2 d = x - centre;
  return {w.x(), w.y(), w.y() * d.x() - w.x() * d.y()};
}

double dot(const Body& b, const std::vector<double>& x, const std::vector<double>& y) {
  const auto begin = 2 * static_cast<std::size_t>(b.first_node), end = begin + 2 * static_cast<std::size_t>(b.nodes);
  double sum = 0.0;
  for (std::size_t i = begin; i < end; ++i) sum += x[i] * y[i];
  return sum;
}

}  // namespace

StackDamping::StackDamping(const Setup& setup, const SlidingDamping& sliding) : setup_(&setup) {
  for (std::size_t i = 0; i < setup.bodies().size(); ++i)
    exempt_.push_back(setup.bodies()[i].divided || !sliding.damps(i) ? 1 : 0);
  possible_ = std::count(exempt_.begin(), exempt_.end(), 0) >= 2;
}

void StackDamping::allocate() {
  const std::size_t n = exempt_.size();
  wanted_.assign(n, 0);
  rate_.assign(n, 0.0);
  all_.assign(n, 0.0);
  rigid_.assign(n, {});
  force_.assign(n, Eigen::Vector3d::Zero());
  for (auto* v : {&x_, &y_, &turn_, &work_}) v->assign(2 * static_cast<std::size_t>(setup_->nodes()), 0.0);
}

bool StackDamping::damped(const ContactMemory& m, std::size_t i, std::size_t j) const {
  return closed(m) && exempt_[i] == 0 && exempt_[j] == 0 && std::max(rate_[i], rate_[j]) > 0.0 &&
         !(setup_->laws()[static_cast<std::size_t>(m.joint)].dilation > 0.0);
}

bool StackDamping::find(const SlidingDamping& sliding, const Outlines& outlines, const ContactList& list) {
  if (!possible_ ||
      std::none_of(list.memory.begin(), list.memory.end(), [](const ContactMemory& m) { return m.slide.lost != 0; }))
    return false;
  if (x_.empty()) allocate();
  std::fill(wanted_.begin(), wanted_.end(), 0);
  std::fill(rate_.begin(), rate_.end(), 0.0);
  std::fill(all_.begin(), all_.end(), 0.0);
  for (std::size_t k = 0; k < list.points.size(); ++k) {
    const ContactMemory& m = list.memory[k];
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t b = body_of(outlines, list.points[k], end);
      if (closed(m)) all_[b] += m.fn;
      if (m.slide.lost != 0) rate_[b] = sliding.moderate_rate(b);
    }
  }
  bool any = false;
  for (std::size_t k = 0; k < list.points.size(); ++k) {
    const std::size_t i = body_of(outlines, list.points[k], 0), j = body_of(outlines, list.points[k], 1);
    if (!damped(list.memory[k], i, j)) continue;
    wanted_[i] = wanted_[j] = 1;
    any = true;
  }
  return any;
}

void StackDamping::mass_apply(const Body& body, std::span<const double> q, std::span<const double> u,
                              std::span<double> out) const {
  const auto p = static_cast<std::size_t>(body.pool);
  setup_->pool_of(body).mass_apply(body.index, setup_->part(q, p), setup_->part(u, p), setup_->part(out, p));
}

void StackDamping::find_motion(std::size_t body, std::span<const double> q, std::span<const double> v) {
  const Body& b = setup_->bodies()[body];
  rigid_motions(*setup_, b, q, x_, y_, turn_);
  mass_apply(b, q, x_, work_);
  const double mass = dot(b, x_, work_);
  mass_apply(b, q, turn_, work_);
  const double lx = dot(b, x_, work_), ly = dot(b, y_, work_), turn = dot(b, turn_, work_);
  mass_apply(b, q, v, work_);
  const Eigen::Matrix3d inverse =
      (Eigen::Matrix3d() << mass, 0.0, lx, 0.0, mass, ly, lx, ly, turn).finished().inverse();
  rigid_[body] = {centre_of_turn(*setup_, b, q),
                  inverse * Eigen::Vector3d(dot(b, x_, work_), dot(b, y_, work_), dot(b, turn_, work_)), inverse, mass};
}

void StackDamping::act(const Outlines& outlines, const ContactList& list, std::span<const double> q,
                       std::span<const double> v, double time) {
  for (std::size_t i = 0; i < wanted_.size(); ++i)
    if (wanted_[i] != 0) find_motion(i, q, v);
  std::fill(force_.begin(), force_.end(), Eigen::Vector3d::Zero());
  power_ = friction_ = 0.0;
  for (std::size_t k = 0; k < list.points.size(); ++k) {
    const ContactPoint& p = list.points[k];
    const ContactMemory& m = list.memory[k];
    const std::size_t i = body_of(outlines, p, 0), j = body_of(outlines, p, 1);
    if (!damped(m, i, j)) continue;
    Rigid &one = rigid_[i], &other = rigid_[j];
    const Vec2 x = position(outlines.nodes[p.node[0]], q);
    const double ratio = m.status == ContactStatus::slip ? m.ft / m.fn : 0.0;
    const Vec2 along = p.at.n + ratio * p.at.t;
    const Eigen::Vector3d n1 = row(p.at.n, x, one.centre), n2 = row(p.at.n, x, other.centre),
                          t1 = row(p.at.t, x, one.centre), t2 = row(p.at.t, x, other.centre),
                          f1 = row(along, x, one.centre), f2 = row(along, x, other.centre), gain1 = one.inverse * f1,
                          gain2 = other.inverse * f2;
    const double speed = n1.dot(one.velocity) - n2.dot(other.velocity),
                 slip = t1.dot(one.velocity) - t2.dot(other.velocity), compliance = n1.dot(gain1) + n2.dot(gain2),
                 mass = 1.0 / (1.0 / one.mass + 1.0 / other.mass),
                 c = kFactor * std::max(rate_[i], rate_[j]) * mass * m.fn / std::min(all_[i], all_[j]);
    const double force = std::max(-m.fn, -c * speed / (1.0 + c * time * std::max(0.0, compliance))),
                 half = 0.5 * time * force;
    force_[i] += force * f1;
    force_[j] -= force * f2;
    one.velocity += time * force * gain1;
    other.velocity -= time * force * gain2;
    const double friction = ratio * force * (slip + half * (t1.dot(gain1) + t2.dot(gain2)));
    friction_ += friction;
    power_ += friction + force * (speed + half * compliance);
  }
}

void StackDamping::add_acceleration(double factor, std::span<double> out) const {
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (wanted_[i] == 0) continue;
    const Body& b = setup_->bodies()[i];
    const Eigen::Vector3d a = factor * (rigid_[i].inverse * force_[i]);
    const auto begin = 2 * static_cast<std::size_t>(b.first_node), end = begin + 2 * static_cast<std::size_t>(b.nodes);
    for (std::size_t k = begin; k < end; ++k) out[k] += a.x() * x_[k] + a.y() * y_[k] + a.z() * turn_[k];
  }
}

void StackDamping::add_force(std::span<const double> q, std::span<double> out) {
  for (std::size_t i = 0; i < wanted_.size(); ++i) {
    if (wanted_[i] == 0) continue;
    const Body& b = setup_->bodies()[i];
    const Eigen::Vector3d a = rigid_[i].inverse * force_[i];
    const auto begin = 2 * static_cast<std::size_t>(b.first_node), end = begin + 2 * static_cast<std::size_t>(b.nodes);
    for (const auto& [motion, by] : {std::pair(&x_, a.x()), std::pair(&y_, a.y()), std::pair(&turn_, a.z())}) {
      mass_apply(b, q, *motion, work_);
      for (std::size_t k = begin; k < end; ++k) out[k] += by * work_[k];
    }
  }
}

}  // namespace scree::coupling
