// Contact search: which edges may touch. Bullet's dynamic bounding-volume tree keeps the boxes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

/// Two edges of different bodies, or the two faces of a crack, that have segments near each other.
struct EdgePair {
  EdgeIndex a, b;  // a < b
  auto operator<=>(const EdgePair&) const = default;
};

/// Keeps a fattened box per boundary segment in BoxTree and moves it only when the segment
/// leaves it. The pairs are a superset of all nearer than `reach`; those that depend on a box's history are excluded by
/// the exact distance afterwards, so results never depend on the tree.
class Search {
 public:
  /// @param reach  distance within which no pair may be missed [m]
  Search(const Setup& setup, double reach);
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;
  ~Search();

  /// @param x  positions of the outline nodes
  /// @return pairs in order, each once; valid until the next call
  std::span<const EdgePair> update(OutlinePositions x);
  /// How often pairs have been listed so far.
  [[nodiscard]] std::size_t times_listed() const { return times_listed_; }
  /// How far every outline node may move before update() can find a pair [m]; 0 if there are pairs already. Fattens all
  /// boxes anew, which pays where the result saves many updates.   @pre update() was called with x
  double clearance(OutlinePositions x);

 private:
  bool refit(OutlinePositions x, bool all);
  void collect();
  /// How far every outline node may move while the bounding boxes of bodies stay out of each other's reach; <= 0: they
  /// are within it now.
  [[nodiscard]] double room_between_bodies(OutlinePositions x) const;

  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::size_t times_listed_ = 0;
};

}  // namespace scree::coupling
