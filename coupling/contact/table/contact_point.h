// One contact point: a vertex P of one body against a segment 1 -> 2 of another, with the rows of gap and stretch.
#pragma once

#include <array>
#include <span>

#include "coupling/contact/law/joint_springs.h"

namespace scree::coupling {

/// Geometry of a contact at given positions.
///   d = x_2 - x_1, t = d/L, n = (d.y, -d.x)/L (outward of a counter-clockwise body)
///   gap g = n.(x_P - x_1), negative when penetrating; xi = t.(x_P - x_1)/L
struct ContactGeometry {
  Vec2 n, t;
  double length = 0.0, gap = 0.0, xi = 0.0;
};
/// What it has of the segment alone.
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

/// A vector for each of P, 1, 2: the gradient of a scalar of the contact. Its change is sum c_i.u_i, and a force f
/// that works on it puts f c_i on each point: forces add to zero and make no torque.
using ContactRow = std::array<Vec2, 3>;

/// Gradient of g: exactly n on P and -n shared by the foot.
/// @source [Qu2013] eq. 3.11-3.12; deviation: exact current normal instead of the linearised one
[[nodiscard]] inline ContactRow gap_row(const ContactGeometry& c) { return {c.n, -(1.0 - c.xi) * c.n, -c.xi * c.n}; }
/// Gradient of the stretch e = t.(x_P - x_a), x_a at the fraction `anchor` of the segment:
///   t.(u_P - u_a) + (g/L) n.(u_2 - u_1)
/// A plain pair of forces at corner and foot would make a torque g f_t.
[[nodiscard]] inline ContactRow stretch_row(const ContactGeometry& c, double anchor) {
  const Vec2 turn = c.gap / c.length * c.n;
  return {c.t, -(1.0 - anchor) * c.t - turn, -anchor * c.t + turn};
}

/// A contact that the law may see, at one instant.
struct ContactPoint {
  ContactKey key;
  VertexIndex vertex;
  EdgeIndex edge;
  SegmentIndex segment;
  std::int32_t joint = -1;            // law between the edges
  std::int32_t from = -1;             // its point in the list it was found from; -1: new
  std::int32_t beside = -1;           // of a new point: the one in that list that it begins like
  std::array<OutlineNode, 3> node{};  // of P, 1, 2
  ContactGeometry at;
  bool edge_edge = false;              // part of an edge-edge contact
  double behind = 0.0, ahead = 0.0;    // of it: pieces of the overlap on either side, against and along the edge [m]
  double first_gap0 = 0.0;             // of a point that is new, or was in too deep to close [m]
  bool suppressed = false;             // another edge, or another corner, holds what there is here
  bool beyond = false;                 // open, and its foot lies beyond a convex end of the edge: cannot close here
  double s_low = 0.0, s_high = 0.0;    // range of the foot within which it may close [m along the segment]
  std::int32_t partner[2] = {-1, -1};  // the same corner on the edges before and after, where they meet convexly
  Springs springs;                     // what the geometry asks for; a closed contact of another kind has its own yet
  double largest_tributary = 0.0;      // that the vertex could have in an overlap per area [m]
  double full_tributary = 0.0;         // that it has where the segments of both sides lie on each other [m]
  double margin = 0.0;                 // stiffness to add in a step bound that is to outlive small changes [N/m]
  double cn = 0.0, ct = 0.0;           // damping of explicit steps, normal and (while sticking) tangential [N s/m]

  /// Shows every field, in a fixed order, to see(name, value), as State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const;
};

/// Which of two edges that meet at a convex corner another corner inside leaves by: true for the edge that it is
/// `depth` deep in, the nearer one. Two tips that meet exactly are as deep in both: then the edge that ends at the
/// corner, for both tips, which faces the other's. Left to round-off, each might choose the way that the other stands
/// in.
/// @param depth,other  [m], > 0    @param ends  the edge of `depth` is the one that ends at the corner
/// @source [Qu2013] 2.4.3 (shortest path); the rule for equal depths is not from there
[[nodiscard]] bool leaves_by(double depth, double other, bool ends);

/// Rate of a contact scalar at outline node velocities taken from v.
[[nodiscard]] double row_rate(const Outlines& o, const ContactPoint& p, const ContactRow& row,
                              std::span<const double> v);
/// The same at velocities of the outline nodes.
[[nodiscard]] inline double row_rate(const ContactPoint& p, const ContactRow& row, OutlineVelocities v) {
  double rate = 0.0;
  for (std::size_t i = 0; i < 3; ++i) rate += row[i].dot(v[p.node[i]]);
  return rate;
}
/// f += force times the row.
void add_row_force(const Outlines& o, const ContactPoint& p, const ContactRow& row, double force, std::span<double> f);

// ---------------------------------------------------------------------------------------------------------------

template <class Visitor>
void ContactPoint::visit(Visitor&& see) const {
  static_assert(sizeof(ContactPoint) == 256, "a field that is new here belongs in the list below");
  key.visit(see);
  see("point.vertex", vertex.value);
  see("point.edge", edge.value);
  see("point.segment", segment.value);
  see("point.joint", joint);
  see("point.from", from);
  see("point.beside", beside);
  for (const OutlineNode& n : node) see("point.node", n.value);
  see("point.n", at.n);
  see("point.t", at.t);
  see("point.length", at.length);
  see("point.gap", at.gap);
  see("point.xi", at.xi);
  see("point.edge_edge", edge_edge);
  see("point.behind", behind);
  see("point.ahead", ahead);
  see("point.first_gap0", first_gap0);
  see("point.suppressed", suppressed);
  see("point.beyond", beyond);
  see("point.s_low", s_low);
  see("point.s_high", s_high);
  for (const std::int32_t& p : partner) see("point.partner", p);
  see("point.tributary", springs.tributary);
  see("point.kn", springs.kn);
  see("point.kt", springs.kt);
  see("point.largest_tributary", largest_tributary);
  see("point.full_tributary", full_tributary);
  see("point.margin", margin);
  see("point.cn", cn);
  see("point.ct", ct);
}

}  // namespace scree::coupling
