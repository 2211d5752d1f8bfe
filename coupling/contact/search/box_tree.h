// Boxes that move, and which of them overlap: Bullet's dynamic bounding-volume tree.
#pragma once

// Bullet's headers use old-style casts and unused parameters freely.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wpedantic"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include <BulletCollision/BroadphaseCollision/btDbvt.h>
#pragma GCC diagnostic pop

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry.h"

namespace scree::coupling {

/// Keeps boxes in btDbvt, the tree of Bullet's broadphase (double precision). What btDbvtBroadphase adds to it is left
/// out: hashing every pair in its cache costs more than to list them anew, and a proxy has 140 bytes.
class BoxTree {
 public:
  explicit BoxTree(std::span<const Box> boxes);
  BoxTree(const BoxTree&) = delete;
  BoxTree& operator=(const BoxTree&) = delete;
  ~BoxTree() = default;

  /// Takes one box out of the tree and puts it in again: its cost grows with the logarithm of their number.
  void move(std::size_t i, const Box& box);
  /// Sets a box without changing the structure of the tree; for many boxes, with one refit() after the last.
  void place(std::size_t i, const Box& box);
  /// Fits the nodes above all boxes in one pass, at a cost in proportion to the number of boxes. A tree that has grown
  /// too wide for that is built anew.
  void refit();
  /// Calls see(i, j), i != j, once for every two boxes that overlap, in no promised order.
  template <class See>
  void for_overlaps(See&& see) {
    Caller<See> caller(see);
    tree_.collideTTpersistentStack(tree_.m_root, tree_.m_root, caller);
  }
  /// Calls see(j) for every other box that overlaps one.
  template <class See>
  void for_overlaps_of(std::size_t i, See&& see) {
    const auto other = [&](std::size_t a, std::size_t b) { see(a == i ? b : a); };
    Caller<decltype(other)> caller(other);
    tree_.collideTTpersistentStack(tree_.m_root, leaves_[i], caller);
  }

 private:
  template <class See>
  struct Caller final : btDbvt::ICollide {
    explicit Caller(See& s) : see(s) {}
    void Process(const btDbvtNode* a, const btDbvtNode* b) override {
      if (a != b) see(index_of(a), index_of(b));
    }
    See& see;
  };
  static std::size_t index_of(const btDbvtNode* leaf) { return reinterpret_cast<std::uintptr_t>(leaf->data); }
  void list_nodes();
  /// Fits the nodes to their leaves.   @return the extents of all nodes, summed [m]
  double fit();
  void build();

  btDbvt tree_;
  std::vector<btDbvtNode*> leaves_;   // of the boxes
  std::vector<btDbvtNode*> nodes_;    // inner nodes, each before those below it; empty: to be listed
  std::vector<btDbvtNode*> waiting_;  // while they are listed
  double narrowest_ = 0.0;            // least of what fit() gave since the tree was built [m]
};

}  // namespace scree::coupling
