#include "coupling/integrate/sliding_damping.h"

#include <algorithm>
#include <cmath>

#include "coupling/integrate/point_springs.h"
#include "model/dense_algebra.h"
#include "model/parallel.h"

namespace scree::coupling {

constexpr double kSteep = 2.0;  // of the cube of friction: twice what stops the flutter, or more

double lowest_deformation_frequency(const ReferenceShape& shape, const Elasticity& law) {
  // On D = (D11, D12, D21, D22): translations do not couple with D about the centre of mass.
  Eigen::Matrix4d K = Eigen::Matrix4d::Zero(), M = Eigen::Matrix4d::Zero();
  K(0, 0) = K(3, 3) = shape.area * law.p_modulus();
  K(0, 3) = K(3, 0) = shape.area * law.lambda;
  K(1, 1) = K(2, 2) = K(1, 2) = K(2, 1) = shape.area * law.mu;
  M.topLeftCorner<2, 2>() = M.bottomRightCorner<2, 2>() = shape.second;
  // The rotation is the only motion without energy.
  return std::sqrt(generalized_eigenvalues(K, M)(1));
}

SlidingDamping::SlidingDamping(const Setup& setup, double fraction) {
  const std::size_t n = setup.bodies().size();
  most_.assign(n, 0.0);
  slipping_.assign(n, 0.0);
  all_.assign(n, 0.0);
  steep_.assign(n, 0.0);
  rate_.assign(n, 0.0);
  const Model& model = setup.model();
  laws_ = &setup.laws();
  if (fraction == 0.0) return;
  std::vector<char> exempt(model.blocks.size(), 0);
  for (const PointSupport& s : model.point_supports) exempt[s.block.index()] = 1;
  for (const EdgeSupport& s : model.edge_supports) exempt[s.span.block.index()] = 1;
  for (const ViscousEdge& e : model.viscous_edges) exempt[e.span.block.index()] = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Body& b = setup.bodies()[i];
    if (b.driven || exempt[b.block.index()] != 0 || !setup.pool_of(b).strains()) continue;
    const ReferenceShape shape = reference_shape(model, b.block);
    most_[i] = 2.0 * fraction * lowest_deformation_frequency(shape, model.elasticity_of(b.block));
    used_ = true;
  }
}

void SlidingDamping::begin() {
  std::fill(slipping_.begin(), slipping_.end(), 0.0);
  std::fill(all_.begin(), all_.end(), 0.0);
  std::fill(steep_.begin(), steep_.end(), 0.0);
}

void SlidingDamping::count(const Outlines& outlines, const ContactList& list) {
  const auto carries = [](const ContactMemory& m) { return m.status != ContactStatus::open && m.fn > 0.0; };
  const auto slides = [&](std::int64_t at) {
    const ContactMemory& m = list.memory[static_cast<std::size_t>(at)];
    return m.slide.last.slip != 0.0F && carries(m) ? 1.0 : 0.0;
  };
  if (!slid_ && parallel_largest(std::ssize(list.points), slides) == 0.0) return;
  slid_ = false;
  const auto take = [&](std::int64_t at, std::vector<Carrier>& out) {
    const auto i = static_cast<std::size_t>(at);
    const ContactMemory& m = list.memory[i];
    if (!carries(m)) return;
    const auto& node = list.points[i].node;
    Carrier& c = out.emplace_back();
    for (std::size_t end = 0; end < 2; ++end) c.body[end] = outlines.node_body[node[end]].index();
    c.force = m.fn;
    if (m.slide.last.slip == 0.0F) return;
    const auto joint = static_cast<std::size_t>(m.joint);
    const Strength now = strength((*laws_)[joint], laws_->tan_friction(joint), m);
    c.slides = m.fn * sliding_part(now, m);
    c.steep = c.slides * now.coefficient * now.coefficient * now.coefficient;
  };
  parallel_list(std::ssize(list.points), by_chunk_, carriers_, take);
  for (const Carrier& c : carriers_) {
    slid_ = slid_ || c.slides > 0.0;
    for (const std::size_t body : c.body) {
      all_[body] += c.force;
      slipping_[body] += c.slides;
      steep_[body] += c.steep;
    }
  }
}

double SlidingDamping::sliding_part(const Strength& now, const ContactMemory& m) {
  const double friction = now.coefficient * m.fn, limit = now.cohesion + friction;
  const bool back = m.slide.slip * static_cast<double>(m.slide.last.slip) < 0.0;
  if (back && std::abs(m.slide.slip) * m.kt > limit) return 0.0;
  return limit > 0.0 ? friction / limit : 1.0;  // without any strength: limit of small friction
}

bool SlidingDamping::find() {
  bool any = false;
  for (std::size_t b = 0; b < rate_.size(); ++b) {
    const double s = slipping_[b] > 0.0 ? slipping_[b] / all_[b] : 0.0;
    const double part = std::min(1.0, 3.0 * s);
    const double steep = slipping_[b] > 0.0 ? std::max(1.0, kSteep * steep_[b] / slipping_[b]) : 1.0;
    rate_[b] = most_[b] * part * std::sqrt(part) * steep;
    any = any || rate_[b] > 0.0;
  }
  return any;
}

Vec2 centre_of_turn(const Setup& setup, const Body& body, std::span<const double> q) {
  const std::span<const double> t = setup.pool_of(body).translation(body.index);
  Vec2 c(0.0, 0.0);
  double sum = 0.0;
  const auto first = 2 * static_cast<std::size_t>(body.first_node);
  for (std::size_t k = 0; k < t.size(); ++k) {
    c += t[k] * Vec2(q[first + 2 * k], q[first + 2 * k + 1]);
    sum += t[k];
  }
  return c / sum;
}

void rigid_turn(const Setup& setup, const Body& body, std::span<const double> q, std::span<double> turn) {
  const std::span<const double> t = setup.pool_of(body).translation(body.index);
  const Vec2 c = centre_of_turn(setup, body, q);
  const auto first = 2 * static_cast<std::size_t>(body.first_node);
  for (std::size_t k = 0; k < t.size(); ++k) {
    const std::size_t i = first + 2 * k;
    turn[i] = -(q[i + 1] - t[k] * c.y());
    turn[i + 1] = q[i] - t[k] * c.x();
  }
}

void rigid_motions(const Setup& setup, const Body& body, std::span<const double> q, std::span<double> x,
                   std::span<double> y, std::span<double> turn) {
  const std::span<const double> t = setup.pool_of(body).translation(body.index);
  const auto first = 2 * static_cast<std::size_t>(body.first_node);
  for (std::size_t k = 0; k < t.size(); ++k) {
    const std::size_t i = first + 2 * k;
    x[i] = y[i + 1] = t[k];
    x[i + 1] = y[i] = 0.0;
  }
  rigid_turn(setup, body, q, turn);
}

}  // namespace scree::coupling
