// The regular triangular lattice that carries the mathematical covers.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstdint>

#include "model/geometry.h"

namespace scree::nmm {

struct LatticeNode {
  std::int32_t i = 0, j = 0;
  auto operator<=>(const LatticeNode&) const = default;
};

/// One of the two triangles of the cell (i, j): up has its base below, down above.
struct LatticeTriangle {
  std::int32_t j = 0, i = 0, down = 0;
  auto operator<=>(const LatticeTriangle&) const = default;
};

/// Nodes at origin + h (i + j/2, sqrt(3)/2 j).
class Lattice {
 public:
  Lattice(double h, const Vec2& origin) : h_(h), origin_(origin) {}

  [[nodiscard]] double size() const { return h_; }
  [[nodiscard]] double triangle_area() const { return std::sqrt(3.0) / 4.0 * h_ * h_; }
  [[nodiscard]] Vec2 position(const LatticeNode& n) const { return origin_ + h_ * Vec2(n.i + 0.5 * n.j, kRow * n.j); }
  /// Oblique coordinates (i, j) of a point; the third line family is i + j = const.
  [[nodiscard]] Vec2 oblique(const Vec2& x) const {
    const double j = (x.y() - origin_.y()) / (kRow * h_);
    return {(x.x() - origin_.x()) / h_ - 0.5 * j, j};
  }
  [[nodiscard]] LatticeTriangle triangle_at(const Vec2& x) const {
    const Vec2 o = oblique(x);
    const double i = std::floor(o.x()), j = std::floor(o.y());
    return {static_cast<std::int32_t>(j), static_cast<std::int32_t>(i), (o.x() - i) + (o.y() - j) < 1.0 ? 0 : 1};
  }
  /// Corners, counter-clockwise.
  [[nodiscard]] static std::array<LatticeNode, 3> corners(const LatticeTriangle& t) {
    if (t.down == 0) return {{{t.i, t.j}, {t.i + 1, t.j}, {t.i, t.j + 1}}};
    return {{{t.i + 1, t.j}, {t.i + 1, t.j + 1}, {t.i, t.j + 1}}};
  }

 private:
  static constexpr double kRow = 0.86602540378443864676;  // sqrt(3)/2
  double h_;
  Vec2 origin_;
};

}  // namespace scree::nmm
