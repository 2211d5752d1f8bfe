// Which vertices may touch which edges, and with what share of the joint.
#pragma once

#include <array>
#include <initializer_list>
#include <span>
#include <vector>

#include "coupling/contact/geometry/edge_overlap.h"
#include "coupling/contact/law/joint_springs.h"
#include "coupling/contact/search/search.h"
#include "coupling/contact/table/known_contacts.h"
#include "coupling/contact/table/quiet_pairs.h"
#include "model/buckets.h"

namespace scree::coupling {

inline constexpr double kStillFaces = 0.9848;    // cosine of 10 degrees: closed edges face each other up to here
inline constexpr double kWedgeTolerance = 0.17;  // sine of 10 degrees: how far a corner's sides may lean into the edge

inline constexpr std::int64_t kContactChunk = 128;  // pairs of edges, vertices or points that one thread takes at once

/// A vertex against an edge.
struct VertexEdge {
  VertexIndex vertex;
  EdgeIndex edge;
  EdgeIndex own;                     // the edge of the vertex that faces it
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
  /// @param of     ghosts: leave out pairs of two bodies that are not ghosts, which the caller does not need;
  ///               all_in_turn: the call before was for the instant before, from which `known` follows: edges that
  ///               cannot have approached each other since are not examined again
  /// @return pairs in order, each once; valid until the next call
  enum class Of { all, all_in_turn, ghosts };
  std::span<const VertexEdge> update(OutlinePositions x, const KnownContacts& known, Of of = Of::all);
  /// Declares that `known` of the next update() does not follow from the one before.
  void forget() { quiet_.forget(); }
  /// The result of the last update().
  [[nodiscard]] std::span<const VertexEdge> pairs() const { return lists_.pairs; }
  /// Index of a vertex's first pair in pairs(); its pairs end where those of the next vertex begin.
  /// @param vertex  any, or one beyond the last
  [[nodiscard]] std::size_t first_pair(VertexIndex vertex) const {
    return static_cast<std::size_t>(lists_.first[vertex]);
  }
  /// Of calls in turn: largest displacement of any node, summed over them since epoch() changed [m].
  [[nodiscard]] double travel() const { return quiet_.travel(); }
  [[nodiscard]] std::int64_t epoch() const { return quiet_.epoch(); }
  /// Another number whenever pairs() lists other vertices against other edges.
  [[nodiscard]] std::int64_t list_number() const { return lists_.number; }
  /// How far every outline node may move before update() can return a pair [m]; 0 if it could now.
  [[nodiscard]] double clearance(OutlinePositions x) { return search_.clearance(x); }
  /// Unit vector of an edge from its first to its last vertex.
  [[nodiscard]] const Vec2& direction(EdgeIndex edge) const { return direction_[edge]; }
  /// True if one edge continues in the same direction about where the other ends, so that a joint may run on from one
  /// to the other. Sides of thin blocks next to each other are as parallel, but do not continue each other.
  [[nodiscard]] bool in_line(EdgeIndex a, EdgeIndex b) const;
  /// Of the two edges that meet at a vertex, the one that turns towards an edge.
  [[nodiscard]] EdgeIndex opposing_edge(VertexIndex vertex, EdgeIndex edge) const;

 private:
  /// Vertices against edges that one chunk of edge pairs yields, in order. Kept from one update to the next.
  struct Found {
    std::vector<VertexEdge> pairs;
    std::size_t count = 0;   // number of pairs so far
    std::int32_t first = 0;  // number of the first one among all
    bool same = false;       // they equal those of the last update
    Reach reach;             // their vertices, where several threads sort them
    EdgeOverlap overlap;     // scratch

    void begin() { count = 0, same = true; }
    void list(const VertexEdge& pair);
    void end();
  };
  [[nodiscard]] bool edge_edge(EdgeIndex a, EdgeIndex b, const KnownContacts& known) const;
  /// Ends, direction and box of edges as they lie now.
  void place_edges(OutlinePositions x, IndexRange<EdgeIndex> range);
  void try_edges(OutlinePositions x, EdgeIndex a, EdgeIndex b, const KnownContacts& known, Found& out) const;
  void try_corner(VertexIndex vertex, EdgeIndex edge, const KnownContacts& known, Found& out) const;
  /// Lists the edges of closed contacts that are deeper than the search reaches.
  void find_deep(const KnownContacts& known);
  /// True if the contents of the boxes are farther apart than half the reach.
  [[nodiscard]] bool too_far(const Box& a, const Box& b) const;
  /// Distance from which on open edges are not listed [m].
  [[nodiscard]] double far() const;
  /// How far every node may move, at least, before two edges without any pair now can yield a vertex [m].
  [[nodiscard]] double room(EdgeIndex a, EdgeIndex b) const;
  /// By how much the product of the directions of two of the edges changes, at most, per displacement of nodes [1/m].
  [[nodiscard]] double turn_by(std::initializer_list<EdgeIndex> edges) const;
  /// The same as room(), for a corner against an edge that it does not touch.
  [[nodiscard]] double corner_room(VertexIndex vertex, EdgeIndex edge) const;
  /// True if a side of the corner leans into the edge, so that it cannot touch it first. Not decided for bent sides.
  [[nodiscard]] bool leans_in(const Outlines::Vertex& v, EdgeIndex edge) const;
  /// Sorts the pairs: by vertex in one pass, then the few of each vertex, and merges those of one edge.
  void sort();
  /// @return true: some are of one edge
  bool sort_of_vertex(VertexIndex vertex);
  void merge();
  /// Updates the pairs without sorting, if the same vertices against the same edges were listed as last time, in the
  /// same order.
  void refresh();

  const Setup* setup_;
  const JointSprings* springs_;
  double reach_ = 0.0;
  Search search_;
  QuietPairs quiet_;
  std::size_t times_listed_ = 0;          // of the pairs in quiet_
  IndexedVector<EdgeIndex, char> ghost_;  // 1 if its body is a ghost
  IndexedVector<EdgeIndex, Vec2> direction_;
  IndexedVector<EdgeIndex, std::array<Vec2, 2>> ends_;  // positions of its first and its last vertex
  IndexedVector<EdgeIndex, Box> box_;
  bool placed_ = false;  // those of bodies at rest are placed
  struct Place {
    std::int32_t pair;
    bool adds;
  };
  /// What an update leaves.
  struct Lists {
    std::vector<VertexEdge> pairs;
    std::vector<Found> found;                        // per chunk of pairs of edges; last those of deep_
    std::vector<Place> place;                        // of what was found, in pairs
    IndexedVector<VertexIndex, std::int32_t> first;  // its first pair, and the end
    std::int64_t number = 0;                         // of list_number()
    bool merged = false;                             // some of what was found were merged
  };
  Lists lists_, other_;  // of the last update, and of the other kind (ghosts, or all): most updates of a kind are alike
  bool ghosts_ = false;  // lists_ is that of ghosts
  std::int64_t numbers_ = 0;          // the last list_number()
  std::vector<std::int32_t> origin_;  // scratch of sort()
  Buckets by_vertex_;
  std::vector<EdgePair> deep_;  // of closed contacts deeper than the search reaches
};

}  // namespace scree::coupling
