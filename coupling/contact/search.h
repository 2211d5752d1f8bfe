// Contact search: which corners may touch which edges. Bullet's dynamic bounding-volume tree keeps the boxes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "coupling/stages/setup.h"

namespace scree::coupling {

/// A corner near a segment of another body.
struct Candidate {
  std::int32_t corner, edge, segment;  // indices into Outlines
  auto operator<=>(const Candidate&) const = default;
};

/// Keeps a fattened box a boundary segment in btDbvtBroadphase (double precision) and moves it only when the segment
/// leaves it. The candidates are a superset of all pairs nearer than `reach`; what depends on a box's history is
/// sorted out by the exact distance afterwards, so results never depend on the tree.
class Search {
 public:
  /// @param reach  distance within which no pair may be missed [m]
  Search(const Setup& setup, double reach);
  Search(const Search&) = delete;
  Search& operator=(const Search&) = delete;
  ~Search();

  /// @param x  positions of the outline nodes, in their order
  /// @return candidates sorted by corner, edge, segment; valid until the next call
  std::span<const Candidate> update(std::span<const Vec2> x);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::coupling
