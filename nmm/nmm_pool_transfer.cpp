// Transfer of manifold blocks: placement, fields, totals, release.
#include <Eigen/Dense>
#include <cmath>

#include "model/planar.h"
#include "nmm/field_projection.h"
#include "nmm/nmm_pool.h"

namespace scree::nmm {

void NmmPool::place(int body, const AffineMotion& m, std::span<double> q, std::span<double> v) const {
  const Body& b = of(body);
  for (std::size_t k = 0; k < b.mesh.star.size(); ++k) {
    const std::size_t i = 2 * (static_cast<std::size_t>(first_node(body)) + k);
    const Vec2 x = m.c + m.F * b.mesh.star[k], u = m.vc + m.Fdot * b.mesh.star[k];
    q[i] = x.x();
    q[i + 1] = x.y();
    v[i] = u.x();
    v[i + 1] = u.y();
  }
}

void NmmPool::settle(int body, std::span<double> q, std::span<double> v) const {
  const std::size_t first = 2 * static_cast<std::size_t>(first_node(body));
  for (const Tie& t : of(body).mesh.ties) {
    CoverChart::follow(t, q.subspan(first));
    CoverChart::follow(t, v.subspan(first));
  }
}

void NmmPool::project(int body, const FieldCarrier& from, int other, std::span<const double> q_from,
                      std::span<const double> v_from, std::span<double> q, std::span<double> v) const {
  const auto& was = dynamic_cast<const NmmPool&>(from);
  const auto part = [](auto all, const NmmPool& pool, int b) {
    const auto first = static_cast<std::size_t>(pool.first_node(b)),
               last = static_cast<std::size_t>(pool.first_node(b + 1));
    return all.subspan(2 * first, 2 * (last - first));
  };
  // For a divided block the whole mesh, whose interface constraints are still counted from its first cover.
  const auto mesh = [](const Body& b) -> const CoverMesh& { return b.whole ? *b.whole : b.mesh; };
  project_motion({&mesh(was.of(other)), part(q_from, was, other), part(v_from, was, other)}, mesh(of(body)),
                 of(body).law, of(body).form.kinematics, part(q, *this, body), part(v, *this, body));
  settle(body, q, v);
}

BodyTotals NmmPool::totals(int body, std::span<const double> q, std::span<const double> v) const {
  const Body& b = of(body);
  std::vector<double> p(q.size(), 0.0), weight(q.size(), 0.0);
  apply_mass(body, v, p);
  add_weight(body, {1.0, 1.0}, weight);
  BodyTotals t;
  for (std::int32_t k = first_node(body); k < first_node(body + 1); ++k) {
    const double m = weight[2 * static_cast<std::size_t>(k)];
    t.mass += m;
    t.centre += m * node(q, k);
    t.momentum += node(p, k);
    t.angular_momentum += cross(node(q, k), node(p, k));
  }
  t.centre /= t.mass;
  t.kinetic = kinetic_of(body, v);
  const auto first = static_cast<std::size_t>(b.first_element);
  for (std::size_t e = first; e < first + b.mesh.elements(); ++e)
    t.elastic += elements_.area(e) * elements_.response(e, q).energy;
  t.elastic += edge_energy(body, q);
  return t;
}

Release NmmPool::release(int body, std::span<const double> q, std::span<const double> v) const {
  const Body& b = of(body);
  Release out;
  const std::int32_t begin = first_node(body), end = first_node(body + 1);
  const auto local = [&](std::int32_t k) { return static_cast<std::size_t>(k - begin); };

  // Affine part in the operator actually used: c, S, v_c, B, and the fit of x to X.
  std::vector<double> weight(q.size(), 0.0), p(q.size(), 0.0), r(q.size(), 0.0), Mr(q.size(), 0.0);
  add_weight(body, {1.0, 1.0}, weight);
  apply_mass(body, v, p);
  Vec2 c = Vec2::Zero(), momentum = Vec2::Zero();
  double mass = 0.0;
  for (std::int32_t k = begin; k < end; ++k) {
    mass += weight[2 * static_cast<std::size_t>(k)];
    c += weight[2 * static_cast<std::size_t>(k)] * node(q, k);
    momentum += node(p, k);
  }
  c /= mass;
  const Vec2 vc = momentum / mass;
  for (std::int32_t k = begin; k < end; ++k)
    for (int d = 0; d < 2; ++d) r[2 * static_cast<std::size_t>(k) + static_cast<std::size_t>(d)] = node(q, k)[d] - c[d];
  apply_mass(body, r, Mr);
  Mat2 S = Mat2::Zero(), B = Mat2::Zero(), fit = Mat2::Zero();
  for (std::int32_t k = begin; k < end; ++k) {
    S += node(Mr, k) * node(r, k).transpose();
    B += node(p, k) * node(r, k).transpose();
    fit += node(Mr, k) * b.mesh.star[local(k)].transpose();
  }
  S = 0.5 * (S + S.transpose()).eval();
  const Mat2 G = B * S.inverse();

  // The stress that keeps the affine part of the internal force, and the stretch that carries it.
  const Mat2 R = polar_rotation(fit * b.shape.second.inverse());  // of the best F, for any shape of the block
  const auto first = static_cast<std::size_t>(b.first_element);
  const std::size_t last = first + b.mesh.elements();
  Mat2 virial = Mat2::Zero(), initial = Mat2::Zero();
  double area = 0.0;
  for (std::size_t e = first; e < last; ++e) {
    virial += elements_.area(e) * elements_.response(e, q).P * elements_.gradient(e, q).transpose();
    initial += elements_.area(e) * elements_.initial_stress(e);
    area += elements_.area(e);
  }
  initial /= area;
  const Mat2 local_virial = R.transpose() * virial * R;
  const Mat2 strain = strain_of_kirchhoff(b.law, 0.5 * (local_virial + local_virial.transpose()) / area, initial);
  const Mat2 F = R * (Mat2::Identity() + strain), F_inverse = F.inverse();
  out.motion = {c, F, vc, G * F};
  out.initial = initial;

  out.shape.mass = b.shape.mass;
  out.shape.area = area;
  out.shape.second = F_inverse * S * F_inverse.transpose();
  out.shape.origin = b.shape.origin;
  out.shape.outline = b.shape.outline;
  for (const Boundary::Corner& corner : b.mesh.boundary.corners) {
    const Row& row = b.mesh.boundary.nodes[static_cast<std::size_t>(corner.node)];
    Vec2 x = Vec2::Zero();
    for (std::size_t k = 0; k < 3; ++k) x += row.w[k] * node(q, row.node[k]);
    out.shape.outline.ring(static_cast<std::size_t>(corner.ring))[static_cast<std::size_t>(corner.vertex)] =
        F_inverse * (x - c);
  }

  // The rest: velocities M-orthogonal to affine fields, stresses about their mean.
  std::vector<double> w(q.size(), 0.0);
  for (std::int32_t k = begin; k < end; ++k) {
    const Vec2 rest = node(v, k) - vc - G * node(r, k), turned = R.transpose() * rest;
    w[2 * static_cast<std::size_t>(k)] = rest.x();
    w[2 * static_cast<std::size_t>(k) + 1] = rest.y();
    const Vec2 y = F_inverse * node(r, k);
    if (b.onefold) continue;  // its motion is affine
    out.velocity_rest.insert(out.velocity_rest.end(), {turned.x(), turned.y()});
    out.position.insert(out.position.end(), {y.x(), y.y()});
  }
  out.kinetic_rest = b.onefold ? 0.0 : kinetic_of(body, w);
  const Mat2 mean = b.law.stress(strain) + initial;
  double inertia = 0.0;
  for (std::size_t e = first; e < last; ++e) {
    const Mat2 F_e = elements_.gradient(e, q), U = polar_rotation(F_e).transpose() * F_e;
    const Mat2 own = 0.5 * (U + U.transpose()) - Mat2::Identity(), difference = own - strain;
    const Mat2 ds = b.law.stress(difference), extra = elements_.initial_stress(e) - initial;
    const double A = elements_.area(e);
    const Mat2 G_e = elements_.gradient(e, v) * F_e.inverse();
    const Moments own_moments = moments(b.mesh.material(e - first));
    const std::int32_t cover = elements_.cover(e)[0];
    const Vec2 arm = node(q, cover) + F_e * (own_moments.centroid - b.mesh.star[local(cover)]) - c;
    const double J_e = (F_e * own_moments.second * F_e.transpose()).trace() + A * arm.squaredNorm();
    out.spin_squared += J_e * std::pow(0.5 * (G_e(1, 0) - G_e(0, 1)), 2);
    inertia += J_e;
    out.elastic_rest += 0.5 * A * ds.cwiseProduct(difference).sum();
    out.elastic_cross += A * (mean.cwiseProduct(difference).sum() + extra.cwiseProduct(own).sum());
  }
  out.spin_squared /= inertia;
  return out;
}

}  // namespace scree::nmm
