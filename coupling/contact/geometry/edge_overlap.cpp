#include "coupling/contact/geometry/edge_overlap.h"

#include <algorithm>

namespace scree::coupling {

void EdgeOverlap::add(const Outlines& o, std::span<const Vec2> x, std::int32_t edge, std::int32_t against,
                      const Vec2& along, bool middle) {
  const Outlines::Edge& e = o.edges[static_cast<std::size_t>(edge)];
  const auto put = [&](std::int32_t vertex) {
    const auto node = static_cast<std::size_t>(o.vertices[static_cast<std::size_t>(vertex)].node);
    Kink& k = kinks_.emplace_back();
    k.s = along.dot(x[node]);
    k.vertex = vertex;
    k.edge = against;
  };
  put(e.first_segment);
  if (middle)
    for (std::int32_t k = 1; k < e.segments; ++k) put(e.first_segment + k);
  put(e.end_vertex);
}

std::span<const OverlapPoint> EdgeOverlap::divide(const Outlines& o, std::span<const Vec2> x, std::int32_t a,
                                                  std::int32_t b, const Vec2& along, bool middle) {
  kinks_.clear();
  points_.clear();
  add(o, x, a, b, along, middle);
  const std::size_t of_a = kinks_.size();
  add(o, x, b, a, along, middle);
  const double low = std::max(kinks_.front().s, kinks_.back().s), high = std::min(kinks_[of_a - 1].s, kinks_[of_a].s);
  if (!(high > low)) return points_;
  std::reverse(kinks_.begin() + static_cast<std::ptrdiff_t>(of_a), kinks_.end());
  const auto out = [&](const Kink& k) { return k.s < low || k.s > high; };
  const auto before = [](const Kink& p, const Kink& q) { return p.s != q.s ? p.s < q.s : p.vertex < q.vertex; };
  const auto begin_b = kinks_.begin() + static_cast<std::ptrdiff_t>(of_a),
             end_a = std::remove_if(kinks_.begin(), begin_b, out), end_b = std::remove_if(begin_b, kinks_.end(), out);
  merged_.resize(static_cast<std::size_t>((end_a - kinks_.begin()) + (end_b - begin_b)));
  if (std::is_sorted(kinks_.begin(), end_a, before) && std::is_sorted(begin_b, end_b, before)) {
    std::merge(kinks_.begin(), end_a, begin_b, end_b, merged_.begin(), before);
  } else {  // an edge that is bent back on itself
    std::copy(begin_b, end_b, std::copy(kinks_.begin(), end_a, merged_.begin()));
    std::sort(merged_.begin(), merged_.end(), before);
  }
  double behind = 0.0;
  for (std::size_t i = 0; i < merged_.size(); ++i) {
    const double ahead = i + 1 < merged_.size() ? merged_[i + 1].s - merged_[i].s : 0.0,
                 tributary = 0.5 * behind + 0.5 * ahead;
    if (tributary > 0.0) {
      OverlapPoint& p = points_.emplace_back();
      p.vertex = merged_[i].vertex;
      p.edge = merged_[i].edge;
      p.tributary = tributary;
      p.behind = behind;
      p.ahead = ahead;
    }
    behind = ahead;
  }
  return points_;
}

}  // namespace scree::coupling
