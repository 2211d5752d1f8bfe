// Contact forces summed on the nodes of outlines.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "coupling/contact_list.h"
#include "model/indexed.h"

namespace scree::coupling {

class Setup;

/// Adds the forces of contact points to the nodes of a state: of a node in the order of the points, so that sums do not
/// depend on the number of threads. Bodies at rest take no force: they may have many nodes, which steps do not visit.
/// Keeps its scratch between steps.
class NodeForces {
 public:
  /// @param setup  must outlive it   @param expected  number of points that steps need not allocate for
  NodeForces(const Setup& setup, std::size_t expected);
  /// f += forces of the points, water included.   @param f  x, y per node of the state's arrays [N]
  void add(const ContactList& list, std::span<double> f);

 private:
  /// Forces of a point on its three nodes.
  struct OfPoint {
    std::array<OutlineNode, 3> node;
    std::array<Vec2, 3> force;  // [N]
  };
  /// Nodes that the points of a chunk act on: from begin to end.
  struct Reach {
    OutlineNode begin, end;
  };
  /// take(k, force) for the three nodes of a point.   @return false: it has no force
  template <class Take>
  static bool find(const ContactPoint& p, const ContactMemory& m, Take&& take);
  void find_all(const ContactList& list);
  /// of_node(n) for the nodes of moving bodies from begin to end.
  template <class OfNode>
  void for_moving(OutlineNode begin, OutlineNode end, OfNode&& of_node) const;

  const Setup* setup_;
  IndexedVector<OutlineNode, Vec2> forces_;  // on nodes that move [N]
  IndexedVector<OutlineNode, char> rests_;   // per outline node: 1 where its body rests
  std::vector<OfPoint> of_point_;
  std::vector<Reach> reach_;  // of every chunk of points
};

}  // namespace scree::coupling
