// Curves of drawings as chords that deviate from them by at most a tolerance.
#pragma once

#include <span>
#include <vector>

#include "model/geometry.h"

namespace scree::io {

/// Points of an ellipse arc c + cos(t) a + sin(t) b, t from `from` to `to` [rad], both ends included.
/// A chord over dt of a circle of radius r deviates from the circle by r (1 - cos(dt/2)); a chord of an ellipse by at
/// most this value with r = max(|a|, |b|).
/// @param tolerance > 0
[[nodiscard]] std::vector<Vec2> arc_points(const Vec2& c, const Vec2& a, const Vec2& b, double from, double to,
                                           double tolerance);

/// Points of the arc from p to q, without p. The bulge is tan of a quarter of the arc's angle, positive for a
/// counter-clockwise arc.
[[nodiscard]] std::vector<Vec2> bulge_points(const Vec2& p, const Vec2& q, double bulge, double tolerance);

/// A non-uniform rational B-spline. Knots do not decrease, control points + degree + 1 of them; weights > 0.
struct Spline {
  int degree = 3;
  std::vector<double> knots, weights;  // no weights: all are 1
  std::vector<Vec2> control;
};
/// What is wrong with a spline; empty if it is valid.
[[nodiscard]] std::string spline_fault(const Spline& s);
/// Position at a parameter t from knots[degree] to knots[control.size()].   @pre no fault
[[nodiscard]] Vec2 spline_at(const Spline& s, double t);
/// Points along the whole spline: knot spans are halved until the points at their quarters lie within the tolerance of
/// the chord.   @pre no fault
[[nodiscard]] std::vector<Vec2> spline_points(const Spline& s, double tolerance);

}  // namespace scree::io
