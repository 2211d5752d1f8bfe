// Positions of the nodes of a liner.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/bolt.h"
#include "model/model.h"

namespace scree {
namespace {

constexpr std::size_t kMostNodes = 2000;  // of a liner
constexpr double kSame = 1e-9;            // of the tolerance: outlines that touch count as equally near

/// The nearest point of the outlines.
struct Spot {
  BlockId block;
  Vec2 at{0.0, 0.0};
  double distance = std::numeric_limits<double>::infinity();
};

void look_at(const Ring& ring, BlockId block, const Vec2& x, double better, Spot& best) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 &a = ring[k], &b = ring[(k + 1) % ring.size()];
    const Vec2 d = b - a;
    const double s = std::clamp(d.dot(x - a) / d.squaredNorm(), 0.0, 1.0);
    const Vec2 at = s == 1.0 ? b : Vec2(a + s * d);
    const double distance = (x - at).norm();
    if (distance < best.distance - better) best = {block, at, distance};
  }
}

Spot nearest(const Model& model, std::span<const char> absent, const Vec2& x, double tolerance) {
  Spot best;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    if (!absent.empty() && absent[i] != 0) continue;
    const Polygon& polygon = model.blocks[i].polygon;
    for (std::size_t r = 0; r < polygon.rings(); ++r)
      look_at(polygon.ring(r), BlockId{static_cast<std::int32_t>(i)}, x, kSame * tolerance, best);
  }
  return best;
}

}  // namespace

std::string lay_out_liner(const Model& model, std::span<const char> absent, Bolt& liner) {
  liner.nodes.clear();
  liner.crossings.clear();
  liner.head = liner.along.front();
  liner.toe = liner.along.back();
  double length = 0.0;
  for (std::size_t k = 0; k + 1 < liner.along.size(); ++k) length += (liner.along[k + 1] - liner.along[k]).norm();
  if (length / liner.segment > static_cast<double>(kMostNodes))
    return fmt::format("{:.4g} m of it would have more than {} nodes {:.4g} m apart", length, kMostNodes,
                       liner.segment);
  for (std::size_t k = 0; k + 1 < liner.along.size(); ++k) {
    const Vec2 a = liner.along[k], d = liner.along[k + 1] - a;
    const double pieces = std::max(1.0, std::ceil(d.norm() / liner.segment * (1.0 - 1e-9)));
    const bool last = k + 2 == liner.along.size();
    for (double i = 0.0; i < pieces + (last ? 1.0 : 0.0); ++i) {
      const Vec2 x = i == pieces ? liner.along[k + 1] : Vec2(a + i / pieces * d);
      const Spot spot = nearest(model, absent, x, liner.tolerance);
      if (!(spot.distance <= liner.tolerance))
        return fmt::format("at ({:.6g}, {:.6g}) the nearest outline is {:.3g} m away, the tolerance is {:.3g} m",
                           x.x() + model.origin.x(), x.y() + model.origin.y(), spot.distance, liner.tolerance);
      const double at = liner.nodes.empty() ? 0.0 : liner.nodes.back().at + (spot.at - liner.nodes.back().place).norm();
      if (!liner.nodes.empty() && at - liner.nodes.back().at <= 1e-6 * liner.segment)
        return fmt::format("two of its nodes meet at ({:.6g}, {:.6g})", x.x() + model.origin.x(),
                           x.y() + model.origin.y());
      liner.nodes.push_back({spot.block, at, 0.0, spot.at});
    }
  }
  return {};
}

}  // namespace scree
