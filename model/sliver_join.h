// Faces that are too small or too narrow to be blocks are joined to a neighbour.
#pragma once

#include <cstdint>
#include <vector>

#include "model/line_graph.h"

namespace scree {

struct SliverLimits {
  double least_area = 0.0;   // [m2]
  double least_width = 0.0;  // area over half the perimeter: the width of a long strip [m]
};

struct SliverJoin {
  std::vector<std::int32_t> group;  // per face: the face that it is now part of (usually itself)
  std::int64_t joined = 0;
  std::int64_t left = 0;  // below a limit, without a neighbour
};

/// Joins slivers, the smallest first, to the neighbour with the longest shared edge; neighbours of the same region are
/// preferred. For equal lengths the neighbour of lower number is taken.
/// @param region  per face
[[nodiscard]] SliverJoin join_slivers(const LineGraph& graph, const std::vector<Face>& faces,
                                      const std::vector<std::int32_t>& region, const SliverLimits& limits);

/// Area of a face [m2], with the vertices of the graph.
[[nodiscard]] double area_of(const LineGraph& graph, const Face& face);

}  // namespace scree
