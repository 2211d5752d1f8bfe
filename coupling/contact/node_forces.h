// Contact forces summed on the nodes of outlines.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "coupling/contact/table/contact_pairs.h"
#include "coupling/contact_geometry.h"
#include "model/indexed.h"
#include "model/parallel.h"

namespace scree::coupling {

class Setup;

/// Adds the forces of contact points to the nodes of a state: of a node in the order of the points, so that sums do not
/// depend on the number of threads. Bodies at rest take no force: they may have many nodes, which steps do not visit.
/// A point is large, and its forces are few: they are taken while it is in the cache, and kept in one place.
class NodeForces {
 public:
  /// @param setup  must outlive it   @param expected  number of points that steps need not allocate for
  NodeForces(const Setup& setup, std::size_t expected);
  /// Before take() for every point of a list.
  void begin(std::size_t points);
  /// Before take() for the points of a chunk of kContactChunk.   @param first  the first of them
  void begin_chunk(std::size_t first) { reach_[first / kContactChunk] = {}; }
  /// Takes the forces of a point, water included. Chunks may be taken on several threads.
  void take(std::size_t i, const ContactPoint& p, const ContactMemory& m);
  /// take() for all points of a list.
  void take_all(const ContactList& list);
  /// f += forces of the points taken last.   @param f  x, y per node of the state's arrays [N]
  void add(std::span<double> f);

 private:
  /// Forces of a point on its three nodes. No node is valid if it has none.
  struct OfPoint {
    std::array<OutlineNode, 3> node;
    std::array<Vec2, 3> force;  // [N]
  };
  /// of_node(n) for the nodes of moving bodies from begin to end.
  template <class OfNode>
  void for_moving(OutlineNode begin, OutlineNode end, OfNode&& of_node) const;

  const Setup* setup_;
  IndexedVector<OutlineNode, Vec2> forces_;  // on nodes that move [N]
  IndexedVector<OutlineNode, char> rests_;   // per outline node: 1 where its body rests
  std::vector<OfPoint> of_point_;
  std::vector<Reach> reach_;  // of every chunk of points, on nodes
};

inline void NodeForces::take(std::size_t i, const ContactPoint& p, const ContactMemory& m) {
  OfPoint& of = of_point_[i];
  const double normal = m.fn + m.water;
  if (normal == 0.0 && m.ft == 0.0) {
    of.node.fill(OutlineNode{});
    return;
  }
  const ContactRow gap = gap_row(p.at), stretch = stretch_row(p.at, m.anchor);
  Reach& reach = reach_[i / kContactChunk];
  for (std::size_t k = 0; k < 3; ++k) {
    of.node[k] = p.node[k];
    of.force[k] = normal * gap[k] + m.ft * stretch[k];
    reach.take(p.node[k].value);
  }
}

}  // namespace scree::coupling
