// Which vertices may touch which edges, and with what share of the joint.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "coupling/contact/geometry/edge_overlap.h"
#include "coupling/contact/search/search.h"
#include "coupling/contact/table/known_contacts.h"

namespace scree::coupling {

inline constexpr double kStillFaces = 0.9848;    // cosine of 10 degrees: closed edges face each other up to here
inline constexpr double kWedgeTolerance = 0.17;  // sine of 10 degrees: how far a corner's sides may lean into the edge

/// A vertex against an edge.
struct VertexEdge {
  std::int32_t vertex = -1, edge = -1;
  std::int32_t own = -1;             // the edge of the vertex that faces it
  double tributary = 0.0;            // of the overlap [m]; 0: a corner against an edge
  double behind = 0.0, ahead = 0.0;  // pieces of the overlap on either side, against and along the edge [m]
  auto operator<=>(const VertexEdge&) const = default;
};

/// Edges that face each other share their overlap among the vertices on both sides (edge-edge); where they do not,
/// every corner with an interior angle below pi is tried against every edge (angle-edge).
class ContactPairs {
 public:
  /// @param reach  distance within which no pair may be missed [m]; open ones are only listed within half of it
  ContactPairs(const Setup& setup, const JointSprings& springs, double reach);

  /// @param x      positions of the outline nodes
  /// @param known  contacts of the instant before: edges whose contact was closed face each other a little longer
  /// @param of     leave out pairs of two bodies that are not ghosts, which whoever asks does not need
  /// @return pairs in order, each once; valid until the next call
  enum class Of { all, ghosts };
  std::span<const VertexEdge> update(std::span<const Vec2> x, const KnownContacts& known, Of of = Of::all);
  /// What update() returned last.
  [[nodiscard]] std::span<const VertexEdge> pairs() const { return pairs_; }
  /// How far every outline node may move before update() can return a pair [m]; 0 if it could now.
  [[nodiscard]] double clearance(std::span<const Vec2> x) { return search_.clearance(x); }
  /// Unit vector of an edge from its first to its last vertex.
  [[nodiscard]] const Vec2& direction(std::int32_t edge) const { return direction_[static_cast<std::size_t>(edge)]; }
  /// True if one edge goes on, in the same direction, about where the other ends: a joint may run on from one to the
  /// other. Sides of thin blocks next to each other are as parallel, and do not.
  [[nodiscard]] bool in_line(std::int32_t a, std::int32_t b) const;
  /// Of the two edges that meet at a vertex, the one that turns towards an edge.
  [[nodiscard]] std::int32_t opposing_edge(std::int32_t vertex, std::int32_t edge) const;

 private:
  [[nodiscard]] bool edge_edge(std::int32_t a, std::int32_t b, const KnownContacts& known) const;
  /// Ends, direction and box of edges as they lie now.
  void place_edges(std::span<const Vec2> x, Outlines::Range range);
  void try_edges(std::span<const Vec2> x, std::int32_t a, std::int32_t b, const KnownContacts& known);
  void try_corner(std::int32_t vertex, std::int32_t edge, const KnownContacts& known);
  /// True if what is in the boxes is farther apart than half the reach.
  [[nodiscard]] bool too_far(const Box& a, const Box& b) const;
  /// True if a side of the corner leans into the edge: it cannot touch it first. Left open for bent sides.
  [[nodiscard]] bool leans_in(const Outlines::Vertex& v, std::int32_t edge) const;
  /// Lists a pair.
  void list(std::int32_t vertex, std::int32_t edge, std::int32_t own, double tributary, double behind, double ahead);
  /// Brings the pairs into order: by vertex in one pass, then the few of each vertex, with those of one edge made one.
  void sort();
  /// The same vertices against the same edges were listed as last time, in the same order: no order is to be found.
  void refresh();

  const Setup* setup_;
  const JointSprings* springs_;
  double reach_ = 0.0;
  Search search_;
  EdgeOverlap overlap_;
  std::vector<char> ghost_;  // an edge: 1 if its body is a ghost
  std::vector<Vec2> direction_;
  std::vector<std::array<Vec2, 2>> ends_;  // of an edge, where its first and its last vertex are
  std::vector<Box> box_;                   // of an edge
  bool placed_ = false;                    // those of bodies that rest
  std::vector<VertexEdge> pairs_, unsorted_;
  std::size_t listed_ = 0;  // of unsorted_, so far
  bool same_ = false;       // they are those of the last time
  struct Place {
    std::int32_t pair;
    bool adds;
  };
  std::vector<Place> place_;         // of unsorted_, in pairs_
  std::vector<char> seen_;           // scratch of sort()
  std::vector<std::int32_t> first_;  // per vertex: its pairs, counted one further on; then its first pair
  std::vector<EdgePair> deep_;       // of closed contacts deeper than the search looks
};

}  // namespace scree::coupling
