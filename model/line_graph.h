// Lines as a planar graph: nodes where they meet, edges with the lines on which they lie.
#pragma once

#include <cstdint>
#include <vector>

#include "model/geometry.h"
#include "model/ids.h"

namespace scree {

/// An input line of the graph.
struct SourceLine {
  enum class Role { outline, region, discontinuity };  // the outline and its holes; the edge of a region; a joint
  Vec2 a{0.0, 0.0}, b{0.0, 0.0};
  Role role = Role::discontinuity;
  JointId law;
  double beyond_a = 0.0, beyond_b = 0.0;  // extension of the line for noding [m]
  std::int32_t priority = 0;              // of coincident lines, the law of the lowest applies
};

struct GraphEdge {
  std::int32_t a = 0, b = 0;        // vertices, a < b
  std::int32_t boundary = -1;       // the source with role outline or region that the edge lies on; -1: none
  std::int32_t discontinuity = -1;  // the source that is a joint; -1: none
};

struct LineGraph {
  double grid = 0.0;             // [m]
  Mat2 axes = Mat2::Identity();  // rows: axes of the grid. Those of the model, or turned along very many parallel lines
  std::vector<Vec2> snapped;   // vertices on the grid, in its axes, sorted by y, then x: the graph is planar with these
  std::vector<Vec2> vertices;  // the same, where their lines meet in full precision, at most a grid width away
  std::vector<GraphEdge> edges;  // sorted

  /// A vertex on the grid, in the axes of the model.
  [[nodiscard]] Vec2 node(std::int32_t vertex) const {
    return axes.transpose() * snapped[static_cast<std::size_t>(vertex)];
  }
  /// The vertex at a point of the grid, in its axes.   @pre there is one
  [[nodiscard]] std::int32_t vertex_at(const Vec2& point) const;
};

constexpr std::size_t kManyLines = 500;

/// Nodes the lines on a grid (snap rounding by GEOS), so that edges meet in vertices only.
///   `vertices` are on the grid until place_vertices. Coordinates depend on the order of the lines in the last bit only
///   where three or more meet; the caller sorts them.
///   GEOS tests all pairs of lines whose boxes overlap. Oblique parallel lines overlap all others, so the axes of
///   the grid are turned along them where there are kManyLines or more.
/// @param grid  [m]     @source [Hobby1999], snap rounding
[[nodiscard]] LineGraph node_lines(const std::vector<SourceLine>& drawn, double grid);

/// Moves every vertex from the grid to where its lines meet: a corner of the outline or a region, else the intersection
/// of the two lines that cross nearest to a right angle, else the end of a line. Blocks then tile the domain to
/// rounding, and cut edges are straight; on the grid each would bend by half a grid width at every node. A vertex stays
/// on the grid if it would move further than a grid width, or if one of its edges is shorter than eight grid widths:
/// the topology cannot change.
void place_vertices(LineGraph& graph, const std::vector<SourceLine>& sources);

/// A face of the graph: rings of vertices, the outer one first and counter-clockwise, holes clockwise.
struct Face {
  std::vector<std::vector<std::int32_t>> rings;
  Vec2 inside{0.0, 0.0};  // a point in it
};

/// Bounded faces of the graph, and the edges that bound none or the same one on both sides (dead ends and bridges).
struct Faces {
  std::vector<Face> faces;
  std::vector<GraphEdge> dead;
};
[[nodiscard]] Faces faces_of(const LineGraph& graph);

}  // namespace scree
