// Contact points, and pairs that are none, that stay as they are until nodes have moved farther.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "coupling/contact/table/contact_pairs.h"

namespace scree::coupling {

/// Keeps, per pair of a vertex and an edge, how far nodes may travel before it has to be examined again whether the
/// pair is a contact point and over which segment. As in QuietPairs the bound holds for any motion of the nodes. Only
/// of edges with several segments: others are examined as fast.
class QuietPoints {
 public:
  /// No point, as it is far, or as a side of the corner leans into the edge; an open point; a closed one.
  enum class Kind : std::int32_t { far, averted, open, closed };
  /// What a pair is, over which segment, and how far nodes may move before that can change [m]; 0: not known.
  struct Quiet {
    Kind kind = Kind::far;
    SegmentIndex segment = {};
    double room = 0.0;
  };

  explicit QuietPoints(const Outlines& outlines)
      : acts_(std::any_of(outlines.edges.begin(), outlines.edges.end(), [](const auto& e) { return e.segments > 1; })) {
  }

  /// After an update() of the pairs in turn.
  void begin(const ContactPairs& pairs) {
    if (!acts_) return;
    travel_ = pairs.travel();
    const bool goes_on = std::exchange(epoch_, pairs.epoch()) == pairs.epoch();
    if (std::exchange(number_, pairs.list_number()) == pairs.list_number() && goes_on) return;
    const std::size_t size = pairs.pairs().size();
    if (size > bounds_.capacity() || size >= before_.capacity())  // so that later steps need not allocate
      for (auto* bounds : {&bounds_, &before_}) bounds->reserve(size + size / 4 + 1);
    before_.swap(bounds_);
    bounds_.resize(size);
    if (!goes_on) before_.clear();
    before_.push_back({std::numeric_limits<std::int64_t>::max()});
    std::size_t old = 0;
    for (std::size_t k = 0; k < bounds_.size(); ++k) {
      const Bound here{key(pairs.pairs()[k])};
      while (before_[old].key < here.key) ++old;
      bounds_[k] = before_[old].key == here.key ? before_[old] : here;
    }
  }
  /// True if pair k, which was of this kind at the instant before, still is and lies over segment(k).
  [[nodiscard]] bool quiet(std::size_t k, Kind kind) const {
    return acts_ && bounds_[k].until > travel_ && bounds_[k].kind == kind;
  }
  [[nodiscard]] SegmentIndex segment(std::size_t k) const { return bounds_[k].segment; }
  /// Pair k stays what it is while no node is farther than the room from where it is now.
  void set(std::size_t k, const Quiet& quiet) {
    Bound& b = bounds_[k];
    b.kind = quiet.kind;
    b.segment = quiet.segment;
    b.until = travel_ + QuietPairs::kSafe * quiet.room;
  }

 private:
  struct Bound {
    std::int64_t key = 0;
    double until = 0.0;  // travel [m]
    SegmentIndex segment = {};
    Kind kind = Kind::far;
  };
  /// In the order of the pairs.
  static std::int64_t key(const VertexEdge& pair) { return (std::int64_t{pair.vertex.value} << 32) + pair.edge.value; }
  bool acts_;
  double travel_ = 0.0;
  std::int64_t epoch_ = 0, number_ = 0;  // of the pairs
  std::vector<Bound> bounds_, before_;   // per pair
};

}  // namespace scree::coupling
