#include "coupling/contact/geometry/edge_overlap.h"

#include <algorithm>
#include <array>

namespace scree::coupling {

namespace {

/// Coordinates of the vertices of an edge along a direction, rising or falling from its start to its end. Vertices
/// between the ends lie in that order except where an edge is bent back on itself.
class Places {
 public:
  Places(const Outlines& o, OutlinePositions x, EdgeIndex edge, const Vec2& along, bool falls)
      : outlines_(&o), x_(x), edge_(&o.edges[edge]), along_(along), falls_(falls) {
    start_ = at(0);
    end_ = at(edge_->segments);
  }
  [[nodiscard]] VertexIndex vertex(std::int32_t k) const { return edge_->vertex(k); }
  [[nodiscard]] double at(std::int32_t k) const { return along_.dot(x_[outlines_->vertices[vertex(k)].node]); }
  [[nodiscard]] double start() const { return start_; }
  [[nodiscard]] double end() const { return end_; }
  [[nodiscard]] bool straight() const { return edge_->segments == 1; }
  /// Calls see(vertex, s) for the two ends, where they lie within [low, high].
  template <class See>
  void ends_within(double low, double high, See&& see) const {
    if (start_ >= low && start_ <= high) see(edge_->first_vertex(), start_);
    if (end_ >= low && end_ <= high) see(edge_->end_vertex, end_);
  }
  /// Calls see(k, s) for the vertices within [low, high]; a bisection finds the first one.
  template <class See>
  void within(double low, double high, bool middle, See&& see) const {
    const auto inside = [&](double s) { return s >= low && s <= high; };
    if (inside(start_)) see(0, start_);
    if (middle) {
      std::int32_t k = 1, after = edge_->segments;
      while (k < after) {  // the first vertex that is not before the overlap
        const std::int32_t half = k + (after - k) / 2;
        (falls_ ? at(half) > high : at(half) < low) ? k = half + 1 : after = half;
      }
      for (; k < edge_->segments; ++k) {
        const double s = at(k);
        if (!inside(s)) break;
        see(k, s);
      }
    }
    if (inside(end_)) see(edge_->segments, end_);
  }

 private:
  const Outlines* outlines_;
  OutlinePositions x_;
  const Outlines::Edge* edge_;
  Vec2 along_;
  bool falls_;
  double start_ = 0.0, end_ = 0.0;
};

}  // namespace

std::span<const OverlapPoint> EdgeOverlap::divide(const Outlines& o, OutlinePositions x, EdgeIndex a, EdgeIndex b,
                                                  const Vec2& along, bool middle) {
  points_.clear();
  const Places of_a(o, x, a, along, false), of_b(o, x, b, along, true);
  const double low = std::max(of_a.start(), of_b.end()), high = std::min(of_a.end(), of_b.start());
  if (!(high > low)) return points_;
  const auto before = [](const Kink& p, const Kink& q) { return p.s != q.s ? p.s < q.s : p.vertex < q.vertex; };
  if (of_a.straight() && of_b.straight()) {
    const bool a_begins = of_a.start() > of_b.end(), a_ends = of_a.end() < of_b.start();
    if (of_a.start() != of_b.end() && of_a.end() != of_b.start()) {
      const double whole = high - low, half = 0.5 * whole;
      points_.push_back({a_begins ? of_a.vertex(0) : of_b.vertex(1), a_begins ? b : a, half, 0.0, whole});
      points_.push_back({a_ends ? of_a.vertex(1) : of_b.vertex(0), a_ends ? b : a, half, whole, 0.0});
      return points_;
    }
    std::array<Kink, 4> ends;  // vertices meet exactly
    std::size_t count = 0;
    const auto put = [&](EdgeIndex against) {
      return [&, against](VertexIndex vertex, double s) { ends[count++] = {s, vertex, against}; };
    };
    of_a.ends_within(low, high, put(b));
    of_b.ends_within(low, high, put(a));
    std::sort(ends.begin(), ends.begin() + count, before);
    share(std::span(ends).first(count));
    return points_;
  }
  of_a_.clear();
  of_b_.clear();
  of_a.within(low, high, middle, [&](std::int32_t k, double s) { of_a_.push_back({s, of_a.vertex(k), b}); });
  of_b.within(low, high, middle, [&](std::int32_t k, double s) { of_b_.push_back({s, of_b.vertex(k), a}); });
  // Where an edge is bent back on itself its vertices are not in the order of their places.
  const auto after = [&](const Kink& p, const Kink& q) { return before(q, p); };
  if (!std::is_sorted(of_a_.begin(), of_a_.end(), before)) std::sort(of_a_.begin(), of_a_.end(), before);
  if (!std::is_sorted(of_b_.begin(), of_b_.end(), after)) std::sort(of_b_.begin(), of_b_.end(), after);
  kinks_.resize(of_a_.size() + of_b_.size());
  std::merge(of_a_.begin(), of_a_.end(), of_b_.rbegin(), of_b_.rend(), kinks_.begin(), before);
  share(kinks_);
  return points_;
}

void EdgeOverlap::share(std::span<const Kink> kinks) {
  double behind = 0.0;
  for (std::size_t i = 0; i < kinks.size(); ++i) {
    const double ahead = i + 1 < kinks.size() ? kinks[i + 1].s - kinks[i].s : 0.0,
                 tributary = 0.5 * behind + 0.5 * ahead;
    if (tributary > 0.0) {
      OverlapPoint& p = points_.emplace_back();
      p.vertex = kinks[i].vertex;
      p.edge = kinks[i].edge;
      p.tributary = tributary;
      p.behind = behind;
      p.ahead = ahead;
    }
    behind = ahead;
  }
}

}  // namespace scree::coupling
