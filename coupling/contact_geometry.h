// Gap and stretch of a corner over a segment, with their gradients.
#pragma once

#include <array>

#include "model/geometry.h"

namespace scree::coupling {

/// Geometry of a contact at given positions.
///   d = x_2 - x_1, t = d/L, n = (d.y, -d.x)/L (outward of a counter-clockwise body)
///   gap g = n.(x_P - x_1), negative when penetrating; xi = t.(x_P - x_1)/L
struct ContactGeometry {
  Vec2 n, t;
  double length = 0.0, gap = 0.0, xi = 0.0;
};
/// The part of the geometry that depends on the segment alone.
struct SegmentFrame {
  Vec2 begin, t;
  double length = 0.0;
};
/// @pre x1 != x2
[[nodiscard]] inline SegmentFrame segment_frame(const Vec2& x1, const Vec2& x2) {
  const Vec2 d = x2 - x1;
  const double length = d.norm();
  return {x1, d / length, length};
}
[[nodiscard]] inline ContactGeometry contact_geometry(const Vec2& xP, const SegmentFrame& segment) {
  ContactGeometry c;
  c.length = segment.length;
  c.t = segment.t;
  c.n = Vec2(c.t.y(), -c.t.x());
  c.gap = c.n.dot(xP - segment.begin);
  c.xi = c.t.dot(xP - segment.begin) / c.length;
  return c;
}
/// @pre x1 != x2
[[nodiscard]] inline ContactGeometry contact_geometry(const Vec2& xP, const Vec2& x1, const Vec2& x2) {
  return contact_geometry(xP, segment_frame(x1, x2));
}

/// A vector c_i for each of P, 1, 2: the gradient of a scalar of the contact. The scalar changes by sum c_i.u_i, and a
/// force f conjugate to it applies f c_i to each point: these forces add to zero and make no torque.
using ContactRow = std::array<Vec2, 3>;

/// Gradient of g: exactly n on P; -n is shared between 1 and 2 by the position of the foot.
/// @source [Qu2013] eq. 3.11-3.12; deviation: exact current normal instead of the linearised one
[[nodiscard]] inline ContactRow gap_row(const ContactGeometry& c) { return {c.n, -(1.0 - c.xi) * c.n, -c.xi * c.n}; }
/// Gradient of the stretch e = t.(x_P - x_a), x_a at the fraction `anchor` of the segment:
///   t.(u_P - u_a) + (g/L) n.(u_2 - u_1)
/// A plain pair of forces at corner and foot would make a torque g f_t.
[[nodiscard]] inline ContactRow stretch_row(const ContactGeometry& c, double anchor) {
  const Vec2 turn = c.gap / c.length * c.n;
  return {c.t, -(1.0 - anchor) * c.t - turn, -anchor * c.t + turn};
}

}  // namespace scree::coupling
