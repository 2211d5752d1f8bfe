// The contact points at one instant, with their memories.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "coupling/contact_geometry.h"
#include "coupling/contact_memory.h"
#include "coupling/outline_index.h"

namespace scree::coupling {

/// The springs of a contact point under a law.
struct Springs {
  double tributary = 0.0;     // length of joint that the point stands for [m]
  double kn = 0.0, kt = 0.0;  // [N/m]
  [[nodiscard]] bool operator==(const Springs&) const = default;
};

/// A contact point to which the contact law may apply, at one instant.
struct ContactPoint {
  ContactKey key;
  VertexIndex vertex;
  EdgeIndex edge;
  SegmentIndex segment;
  std::int32_t joint = -1;            // joint law between the edges
  std::int32_t from = -1;             // index of the same point in the list that the search began with; -1: new
  std::int32_t beside = -1;           // of a new point: the one in that list whose state it copies
  std::array<OutlineNode, 3> node{};  // of P, 1, 2
  ContactGeometry at;
  bool edge_edge = false;              // part of an edge-edge contact
  double behind = 0.0, ahead = 0.0;    // edge-edge contact: overlap on either side, against and along the edge [m]
  double first_gap0 = 0.0;             // gap0 of a point that is new, or had penetrated too far to close [m]
  bool suppressed = false;             // another edge, or another corner, carries the load at this point
  bool beyond = false;                 // open, and its foot lies beyond a convex end of the edge: cannot close here
  double s_low = 0.0, s_high = 0.0;    // range of the foot within which it may close [m along the segment]
  std::int32_t partner[2] = {-1, -1};  // the same corner on the edges before and after, where they meet convexly
  Springs springs;                     // as the geometry requires; a closed contact of another kind still has its own
  double largest_tributary = 0.0;      // largest possible one in an overlap; springs per area [m]
  double full_tributary = 0.0;         // where the segments of both sides lie on each other [m]
  double margin = 0.0;                 // stiffness added in a step bound that must stay valid for small changes [N/m]
  double cn = 0.0, ct = 0.0;           // damping of explicit steps, normal and (while sticking) tangential [N s/m]

  /// Calls see(name, value) for every field, in a fixed order, as State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const;
};

/// The contact points at one instant in the order of their keys, and as many memories. As a range it is the range of
/// the memories: the points can be found again from the memories and the positions, except for the last bits.
struct ContactList {
  /// The fields of a point that the next search reads, stored separately: in `points` each read is a cache miss.
  struct Brief {
    VertexIndex vertex;
    EdgeIndex edge;
  };
  std::vector<ContactPoint> points;
  std::vector<ContactMemory> memory;
  std::vector<Brief> briefs;

  [[nodiscard]] std::size_t size() const { return memory.size(); }
  [[nodiscard]] bool empty() const { return memory.empty(); }
  [[nodiscard]] auto begin() const { return memory.begin(); }
  [[nodiscard]] auto end() const { return memory.end(); }
  [[nodiscard]] auto begin() { return memory.begin(); }
  [[nodiscard]] auto end() { return memory.end(); }
  [[nodiscard]] const ContactMemory& operator[](std::size_t i) const { return memory[i]; }
  [[nodiscard]] ContactMemory& operator[](std::size_t i) { return memory[i]; }
  void clear() {
    points.clear();
    memory.clear();
    briefs.clear();
  }
  void reserve(std::size_t size) {
    points.reserve(size);
    memory.reserve(size);
    briefs.reserve(size);
  }
  void shrink_to_fit() {
    points.shrink_to_fit();
    memory.shrink_to_fit();
    briefs.shrink_to_fit();
  }
  /// Drops the points, which refer to the outlines of a stage; the memories do not, and stay.
  void forget_points() {
    points = {};
    briefs = {};
  }
  /// Fills `briefs` after points have been inserted directly.
  void find_briefs() {
    briefs.clear();
    for (const ContactPoint& p : points) briefs.push_back({p.vertex, p.edge});
  }
};

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
