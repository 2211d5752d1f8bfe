// Planar geometry by GEOS: intersections of polygons, validity, triangulation.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/geometry.h"

namespace scree {

/// Clips one polygon by many convex cells; prepared once.
class Clipper {
 public:
  explicit Clipper(const Polygon& polygon);
  Clipper(const Clipper&) = delete;
  Clipper& operator=(const Clipper&) = delete;
  ~Clipper();

  enum class Relation { outside, inside, across };
  [[nodiscard]] Relation relation(const Ring& cell) const;
  /// Connected pieces of polygon and cell, oriented; pieces without area are dropped.
  [[nodiscard]] std::vector<Polygon> intersection(const Ring& cell) const;

 private:
  struct Impl;
  Impl* impl_;
};

/// A straight line between two points [m].
struct CutLine {
  Vec2 from{0.0, 0.0}, to{0.0, 0.0};
};
/// The parts into which lines cut a polygon, oriented: one if no line runs through it. Line ends inside cut nothing.
[[nodiscard]] std::vector<Polygon> cut_by_lines(const Polygon& polygon, std::span<const CutLine> lines);

/// Reason why a polygon is not simple and valid, with the place; empty if it is.
[[nodiscard]] std::string invalidity(const Polygon& polygon);
/// Connected pieces that two valid polygons have in common, oriented; pieces without area are dropped.
[[nodiscard]] std::vector<Polygon> intersection(const Polygon& a, const Polygon& b);
/// Area common to two valid polygons [m2].
[[nodiscard]] double overlap_area(const Polygon& a, const Polygon& b);
/// Cells for drawing a polygon: itself, or triangles where it has holes (a polygon cell of VTK has none).
[[nodiscard]] std::vector<Ring> drawing_cells(const Polygon& polygon);
/// Triangles that fill a polygon with holes, without new points (constrained Delaunay).
[[nodiscard]] std::vector<Ring> triangulate(const Polygon& polygon);

}  // namespace scree
