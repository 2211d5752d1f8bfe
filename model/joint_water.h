// Water that fills joints below a piezometric line.
#pragma once

#include <vector>

#include "model/geometry.h"
#include "model/ids.h"
#include "model/loads.h"

namespace scree {

/// The pressure is hydrostatic under the line, u = unit_weight max(0, y_line(x) - y): the flow is not computed, and the
/// line does not move with the blocks.
struct JointWater {
  /// The line that applies from a stage on.
  struct Level {
    StageId stage;
    std::vector<Vec2> line;
  };
  std::vector<Vec2> line;         // at least two points [m], x increasing; level beyond its ends
  double unit_weight = 9810.0;    // [N/m3], > 0
  std::vector<JointId> joints{};  // laws of the joints that the water fills; empty: all
  std::vector<EdgeSpan> faces{};  // outlines loaded by the water from outside, where they lie below the line
  std::vector<Level> levels{};    // by stage
  /// The same water with the line of a stage, without the lines of other stages.
  [[nodiscard]] JointWater in_stage(std::int32_t stage) const;
  [[nodiscard]] bool fills(JointId joint) const;
};

/// Pressure at a point [Pa].
[[nodiscard]] double water_pressure(const JointWater& water, const Vec2& x);

/// Share of the first end in the pressure's resultant on a straight stretch: the integral of u (1 - s/L) over the
/// length L of `way`. Exact, also where the stretch leaves the water or passes below a kink of the line.
/// @param from  first end [m]   @param way  from there to the other end [m]
/// @return [N] for unit thickness
[[nodiscard]] double water_force(const JointWater& water, const Vec2& from, const Vec2& way);

}  // namespace scree
