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
  std::erase_if(kinks_, [&](const Kink& k) { return k.s < low || k.s > high; });
  std::sort(kinks_.begin(), kinks_.end(),
            [](const Kink& p, const Kink& q) { return p.s != q.s ? p.s < q.s : p.vertex < q.vertex; });
  double behind = 0.0;
  for (std::size_t i = 0; i < kinks_.size(); ++i) {
    const double ahead = i + 1 < kinks_.size() ? kinks_[i + 1].s - kinks_[i].s : 0.0,
                 tributary = 0.5 * behind + 0.5 * ahead;
    if (tributary > 0.0) {
      OverlapPoint& p = points_.emplace_back();
      p.vertex = kinks_[i].vertex;
      p.edge = kinks_[i].edge;
      p.tributary = tributary;
      p.behind = behind;
      p.ahead = ahead;
    }
    behind = ahead;
  }
  return points_;
}

}  // namespace scree::coupling
