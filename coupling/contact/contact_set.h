// All contact points of an instant: found, matched with what they remember, ready for a law.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coupling/contact/contact_point.h"
#include "coupling/contact/edge_overlap.h"
#include "coupling/contact/joint_springs.h"
#include "coupling/contact/search.h"

namespace scree::coupling {

/// Points and memories in the order of their keys, one memory a point.
struct ContactList {
  std::vector<ContactPoint> points;
  std::vector<ContactMemory> memory;
};

/// Finds contact points. Edges that face each other share their overlap among the vertices on both sides (edge-edge);
/// where they do not, every corner with an interior angle below pi is tried against every edge (angle-edge). The
/// nearest segment of an edge carries the point. Decisions rest on exact geometry and on the memory alone.
/// @source contact.md "Contact points"; thesis 3.2.2, 2.4.3
class ContactFinder {
 public:
  /// @param detection  pairs nearer than this are listed, open or closed [m]
  ContactFinder(const Setup& setup, double detection);

  [[nodiscard]] double detection() const { return detection_; }
  /// Points of a state without geometry, for find() to start from.
  void restore(std::span<const ContactMemory> memory, ContactList& out) const;
  /// Lists the points at q. A point that was known before takes its memory over (with the anchor carried to a new
  /// segment so that the stretch does not jump) and says so in `from`; where a vertex leaves an overlap and one of the
  /// other side takes its place, or passes to the next edge in line, the memory passes as well. New points start open.
  /// A share that changes while a contact stays of its kind keeps gap and stretch, and with them the traction.
  /// @param at_start  t = 0: touching pairs are closed without stress, their gap becomes gap0
  void find(std::span<const double> q, const ContactList& known, bool at_start, ContactList& out);
  /// Gives closed points that changed between edge-edge and angle-edge the stiffness of their new kind; force and state
  /// stay, gap0 and anchor move.
  /// @return f^2 (1/k' - 1/k)/2 summed, normal and tangential: the change of the springs' energy [J]
  [[nodiscard]] double adopt_kinds(ContactList& list) const;

 private:
  struct Pair {  // a vertex against an edge
    std::int32_t vertex, edge;
    std::int32_t own;  // the edge of the vertex that faces it
    double share;      // 0: angle-edge
    auto operator<=>(const Pair&) const = default;
  };
  void collect(const ContactList& known);
  [[nodiscard]] bool facing(std::int32_t a, std::int32_t b, const ContactList& known) const;
  /// Calls see(i) for the known points between two edges.
  template <class See>
  void for_pair(std::int32_t a, std::int32_t b, const ContactList& known, See&& see) const;
  /// Calls see(i) for the known points that vertices of either edge have on edges in line with the other, of any body.
  template <class See>
  void for_next_pairs(std::int32_t a, std::int32_t b, const ContactList& known, See&& see) const;
  /// Calls see(i) for the known points of an edge's vertices on the edges that take() accepts.
  template <class Take, class See>
  void for_vertices(std::int32_t edge, const ContactList& known, Take&& take, See&& see) const;
  /// The nearest other point of the same edge-edge contact, else of one in line where the joint goes on from another
  /// block; -1 if there is none. Only a new point may begin like an open one.
  /// @param next_only  leave out the point's own contact
  [[nodiscard]] std::int32_t neighbour(const ContactPoint& p, const ContactList& known, bool next_only) const;
  /// How much deeper a point is than the joint in line beside it; its depth where there is none, whatever gap0 [m].
  [[nodiscard]] double entry_depth(const ContactPoint& p, const ContactList& known) const;
  void try_corner(std::int32_t vertex, std::int32_t edge, const ContactList& known);
  [[nodiscard]] std::int32_t segment_under(const Vec2& x, std::int32_t edge) const;
  [[nodiscard]] ContactGeometry geometry(std::int32_t vertex, std::int32_t segment) const;
  [[nodiscard]] ContactKey key_of(std::int32_t vertex, std::int32_t edge) const;
  [[nodiscard]] bool admissible(const ContactPoint& p) const;
  void set_range(ContactPoint& p, bool closed) const;
  void set_damping(ContactPoint& p, const ContactMemory& m) const;
  void inherit(const ContactList& known, ContactList& out);
  void fill(const ContactMemory* old, const ContactPoint* before, bool at_start, ContactPoint& p,
            ContactMemory& m) const;
  /// Where a body was meshed anew its new vertices on a closed joint take gap0 and stretch, and with them the traction,
  /// from the remembered points on either side.
  void interpolate(const ContactList& known, ContactList& out) const;
  void pair_edges(ContactList& list) const;
  void suppress_second_edges(const ContactList& known, ContactList& list) const;

  const Setup* setup_;
  double detection_, touching_;
  Search search_;
  JointSprings springs_;
  EdgeOverlap overlap_;
  std::vector<Vec2> x_;          // outline nodes
  std::vector<Vec2> direction_;  // of every edge, from its first to its last vertex
  std::vector<Pair> pairs_;
  std::vector<std::int32_t> known_first_;   // a vertex: its first point in the list known, and the end
  std::vector<std::int32_t> fresh_, gone_;  // points without memory, and closed memory without a point
};

}  // namespace scree::coupling
