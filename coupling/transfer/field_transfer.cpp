#include "coupling/transfer/field_transfer.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "model/elasticity.h"
#include "model/field_carrier.h"

namespace scree::coupling {

bool carries_fields(const Pool& pool) { return dynamic_cast<const FieldCarrier*>(&pool) != nullptr; }

bool has_fields(const Pool& pool, int body) {
  const auto* carrier = dynamic_cast<const FieldCarrier*>(&pool);
  return carrier != nullptr && carrier->has_fields(body);
}

void keep_momenta(const Pool& pool, int body, const BodyTotals& was, std::span<const double> q, std::span<double> v) {
  const BodyTotals is = pool.totals(body, q, v);
  const auto begin = 2 * static_cast<std::size_t>(pool.first_node(body)),
             end = 2 * static_cast<std::size_t>(pool.first_node(body + 1));
  std::vector<double> spin(q.size(), 0.0);
  for (std::size_t i = begin; i < end; i += 2) {
    spin[i] = is.centre.y() - q[i + 1];
    spin[i + 1] = q[i] - is.centre.x();
  }
  const double inertia = pool.totals(body, q, spin).angular_momentum;
  const Vec2 push = (was.momentum - is.momentum) / is.mass;
  const double turn = (was.angular_momentum - is.angular_momentum - is.mass * cross(is.centre, push)) / inertia;
  for (std::size_t i = begin; i < end; ++i) v[i] += push[static_cast<Eigen::Index>(i % 2)] + turn * spin[i];
}

namespace {

/// Scales the non-affine velocities, which are orthogonal to the affine ones in the mass, so that the kinetic energy is
/// at most `most`.
void keep_below(double most, const Pool& pool, int body, std::span<const double> q, std::span<double> v) {
  const double kinetic = pool.totals(body, q, v).kinetic;
  if (kinetic <= most) return;
  const Release split = pool.release(body, q, v);
  if (!(split.kinetic_rest > 0.0)) return;
  const double left = std::max(0.0, split.kinetic_rest - (kinetic - most)),
               less = 1.0 - std::sqrt(left / split.kinetic_rest);
  const Mat2 R = polar_rotation(split.motion.F);
  const auto begin = 2 * static_cast<std::size_t>(pool.first_node(body));
  for (std::size_t i = 0; i < split.velocity_rest.size(); i += 2) {
    const Vec2 w = less * (R * Vec2(split.velocity_rest[i], split.velocity_rest[i + 1]));
    v[begin + i] -= w.x();
    v[begin + i + 1] -= w.y();
  }
}

}  // namespace

void project_fields(const Pool& from, int other, std::span<const double> q_from, std::span<const double> v_from,
                    const Pool& pool, int body, const BodyTotals& was, std::span<double> q, std::span<double> v) {
  dynamic_cast<const FieldCarrier&>(pool).project(body, dynamic_cast<const FieldCarrier&>(from), other, q_from, v_from,
                                                  q, v);
  const Vec2 shift = was.centre - pool.totals(body, q, v).centre;
  const auto begin = 2 * static_cast<std::size_t>(pool.first_node(body)),
             end = 2 * static_cast<std::size_t>(pool.first_node(body + 1));
  for (std::size_t i = begin; i < end; ++i) q[i] += shift[static_cast<Eigen::Index>(i % 2)];
  // Each of the two masses counts a different small part of the short waves as affine: that of the old mass is kept.
  const AffineMotion old = from.release(other, q_from, v_from).motion, now = pool.release(body, q, v).motion;
  const Mat2 G = old.Fdot * old.F.inverse() - now.Fdot * now.F.inverse();
  for (std::size_t i = begin; i < end; i += 2) {
    const Vec2 u = old.vc - now.vc + G * (Vec2(q[i], q[i + 1]) - now.c);
    v[i] += u.x();
    v[i + 1] += u.y();
  }
  keep_momenta(pool, body, was, q, v);
  keep_below(was.kinetic, pool, body, q, v);
}

}  // namespace scree::coupling
