// Pairs of edges that cannot touch before nodes have moved farther.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coupling/contact/search/search.h"

namespace scree::coupling {

/// Keeps, per pair of edges, how far nodes may travel before the pair has to be examined again. The caller that
/// examines a pair gives a bound that holds for any motion of its nodes, so results are those of examining every pair
/// each time.
class QuietPairs {
 public:
  /// Every pair is to be examined.
  void forget() { known_ = false; }
  /// Nodes are at x now; the pairs are those that may touch.
  /// @param x       positions of the outline nodes [m]
  /// @param moving  nodes of bodies that do not rest
  /// @param near    pairs in order   @param listed_anew  they are not those of the last call
  void begin(OutlinePositions x, std::span<const IndexRange<OutlineNode>> moving, std::span<const EdgePair> near,
             bool listed_anew);
  /// Largest displacement of any node, summed over the calls since epoch() changed [m].
  [[nodiscard]] double travel() const { return travel_; }
  /// Another number whenever travel() does not go on from what it was.
  [[nodiscard]] std::int64_t epoch() const { return epoch_; }
  /// True if pair k yields nothing, however its nodes have moved since.
  [[nodiscard]] bool quiet(std::size_t k) const { return until_[k] > travel_; }
  /// Pair k yields nothing while no node is farther than `room` from where it is now [m].
  void set(std::size_t k, double room) { until_[k] = travel_ + kSafe * room; }
  static constexpr double kSafe = 0.99;  // for round-off

 private:
  bool known_ = false;
  double travel_ = 0.0;
  std::int64_t epoch_ = 0;
  std::vector<double> until_;  // per pair: the travel up to which it is quiet [m]
  std::vector<EdgePair> pairs_, before_;
  std::vector<double> until_before_;
  IndexedVector<OutlineNode, Vec2> x_;
};

}  // namespace scree::coupling
