// Role of a method: cells and stresses for output.
#pragma once

#include <span>
#include <vector>

#include "model/body.h"

namespace scree {

/// Cells for output: polygons of points, each point a Row.
struct MeshPart {
  std::vector<Row> points;            // nodes counted within the pool
  std::vector<Vec2> origin;           // initial position of each point in the model [m]
  std::vector<std::int32_t> offsets;  // cells + 1
  std::vector<std::int32_t> connectivity;
  std::vector<std::int32_t> body;   // per cell: body index in the pool
  std::vector<char> explicit_half;  // per cell: 1 in the explicit half of a divided body; empty: no body is divided
};

/// Cells and stresses of the bodies for results, pictures and streams.
class BodyOutput {
 public:
  BodyOutput() = default;
  BodyOutput(const BodyOutput&) = delete;
  BodyOutput& operator=(const BodyOutput&) = delete;
  virtual ~BodyOutput() = default;

  virtual void topology(MeshPart& mesh) const = 0;
  /// Cauchy stress (xx, yy, xy) per cell, in the order of topology().
  virtual void stress(std::span<const double> q, std::span<double> cells) const = 0;
  /// Recovered Cauchy stress: three numbers (xx, yy, xy) per node, so that sum_k w_k s[node_k] of a row is the stress
  /// at that point, smoothed over the cells around it [Pa].
  /// @param wanted  per node: not 0 where it is required; the numbers of other nodes have no meaning
  virtual void recovered_stress(std::span<const double> q, std::span<const char> wanted, std::span<double> nodes) const;
};

}  // namespace scree
