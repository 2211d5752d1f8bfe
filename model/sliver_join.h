// Faces that are too small or too narrow to be blocks go to a neighbour.
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
  std::vector<std::int32_t> group;  // of each face: the face that it has become part of (itself mostly)
  std::int64_t joined = 0;
  std::int64_t left = 0;  // below a limit, without a neighbour
};

/// Joins slivers, the smallest first, to the neighbour with the longest shared edge; neighbours of the same region come
/// first. Ties go to the neighbour of lower number.
/// @param region  of each face
[[nodiscard]] SliverJoin join_slivers(const LineGraph& graph, const std::vector<Face>& faces,
                                      const std::vector<std::int32_t>& region, const SliverLimits& limits);

/// Area of a face [m2], with the vertices of the graph.
[[nodiscard]] double area_of(const LineGraph& graph, const Face& face);

}  // namespace scree
