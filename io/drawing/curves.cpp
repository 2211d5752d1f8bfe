#include "io/drawing/curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/edge_selection.h"

namespace scree::io {
namespace {

constexpr int kMostChords = 20000, kMostHalvings = 14;

}  // namespace

std::vector<Vec2> arc_points(const Vec2& c, const Vec2& a, const Vec2& b, double from, double to, double tolerance) {
  const double radius = std::max(a.norm(), b.norm()), sweep = to - from;
  const double step = 2.0 * std::acos(std::clamp(1.0 - tolerance / radius, 0.5, 1.0));  // at most a third of a turn
  const double chords = std::ceil(std::abs(sweep) / std::max(step, 1e-12));
  const int n = static_cast<int>(std::clamp(chords, 1.0, static_cast<double>(kMostChords)));
  std::vector<Vec2> out;
  for (int i = 0; i <= n; ++i) {
    const double t = from + sweep * i / n;
    out.emplace_back(c + std::cos(t) * a + std::sin(t) * b);
  }
  return out;
}

std::vector<Vec2> bulge_points(const Vec2& p, const Vec2& q, double bulge, double tolerance) {
  const Vec2 d = q - p;
  if (std::abs(bulge) < 1e-9 || d.norm() == 0.0) return {q};
  // The centre lies beside the middle of the chord: sagitta L |b|/2, radius L (1 + b^2)/(4 |b|).
  const Vec2 left(-d.y(), d.x());
  const Vec2 centre = p + 0.5 * d + (1.0 - bulge * bulge) / (4.0 * bulge) * left;
  const Vec2 arm = p - centre;
  std::vector<Vec2> points = arc_points(centre, arm, {-arm.y(), arm.x()}, 0.0, 4.0 * std::atan(bulge), tolerance);
  points.erase(points.begin());
  points.back() = q;
  return points;
}

std::string spline_fault(const Spline& s) {
  const std::size_t n = s.control.size();
  if (s.degree < 1 || s.degree > 20) return fmt::format("its degree is {}", s.degree);
  const auto p = static_cast<std::size_t>(s.degree);
  if (n < p + 1) return fmt::format("it has {} control points for the degree {}", n, s.degree);
  if (s.knots.size() != n + p + 1)
    return fmt::format("it has {} knots for {} control points and the degree {}", s.knots.size(), n, s.degree);
  for (std::size_t i = 1; i < s.knots.size(); ++i)
    if (s.knots[i] < s.knots[i - 1]) return "its knots decrease";
  if (!(s.knots[n] > s.knots[p])) return "its knots are all the same";
  if (!s.weights.empty() && s.weights.size() != n)
    return fmt::format("it has {} weights for {} control points", s.weights.size(), n);
  for (const double w : s.weights)
    if (!(w > 0.0)) return "a weight is not positive";
  return {};
}

Vec2 spline_at(const Spline& s, double t) {
  const auto p = static_cast<std::size_t>(s.degree), n = s.control.size();
  // De Boor's algorithm on (w x, w y, w), in the span that holds t.
  auto k = static_cast<std::size_t>(
               std::upper_bound(s.knots.begin() + s.degree, s.knots.begin() + static_cast<std::ptrdiff_t>(n), t) -
               s.knots.begin()) -
           1;
  k = std::clamp(k, p, n - 1);
  while (k > p && s.knots[k] == s.knots[k + 1]) --k;
  std::vector<Eigen::Vector3d> d;
  for (std::size_t j = 0; j <= p; ++j) {
    const std::size_t i = j + k - p;
    const double w = s.weights.empty() ? 1.0 : s.weights[i];
    d.emplace_back(w * s.control[i].x(), w * s.control[i].y(), w);
  }
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t j = p; j >= r; --j) {
      const std::size_t i = j + k - p;
      const double width = s.knots[i + p - r + 1] - s.knots[i], alpha = width > 0.0 ? (t - s.knots[i]) / width : 0.0;
      d[j] = (1.0 - alpha) * d[j - 1] + alpha * d[j];
    }
  return d[p].head<2>() / d[p].z();
}

std::vector<Vec2> spline_points(const Spline& s, double tolerance) {
  const auto p = static_cast<std::size_t>(s.degree), n = s.control.size();
  std::vector<Vec2> out{spline_at(s, s.knots[p])};
  const auto add = [&](const auto& self, double from, const Vec2& a, double to, const Vec2& b, int depth) -> void {
    double off = 0.0;
    for (const double part : {0.25, 0.5, 0.75})
      off = std::max(off, distance_to_segment(spline_at(s, from + part * (to - from)), a, b));
    if ((off <= tolerance && depth > 0) || depth >= kMostHalvings || out.size() > kMostChords) {
      out.push_back(b);
      return;
    }
    const double middle = 0.5 * (from + to);
    const Vec2 x = spline_at(s, middle);
    self(self, from, a, middle, x, depth + 1);
    self(self, middle, x, to, b, depth + 1);
  };
  for (std::size_t i = p; i < n; ++i)
    if (s.knots[i + 1] > s.knots[i])
      add(add, s.knots[i], spline_at(s, s.knots[i]), s.knots[i + 1], spline_at(s, s.knots[i + 1]),
          s.degree > 1 ? 0 : 1);
  return out;
}

}  // namespace scree::io
