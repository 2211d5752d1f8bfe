// A domain that is cut into blocks: outline, holes, regions, discontinuities.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/geometry.h"
#include "model/ids.h"
#include "model/joint_network.h"

namespace scree {

/// A part of the domain with a material of its own; its outline separates blocks.
struct Region {
  std::string name;
  Ring outline;  // [m]; parts outside the domain are ignored
  MaterialId material;
  JointId joint;            // law of its outline and of block edges that lie on no joint; invalid: the domain's
  bool cut = true;          // false: discontinuities end at it
  double cover_size = 0.0;  // of the NMM in its blocks; 0: the stage's value [m]
};

/// Treatment of lines that end inside rock, at a rock bridge.
enum class DeadEnds {
  keep,   // cracks in their blocks: the NMM cuts its covers along them, the DDA ignores them
  drop,   // no method uses them
  extend  // they are extended, straight, to the next line: rock bridges are cut through
};

struct Domain {
  Polygon outline;  // [m] oriented; the holes are openings such as tunnels
  std::string prefix = "block";
  MaterialId material;
  JointId joint;  // law of edges that lie on no joint; invalid: the model's default
  std::vector<Region> regions;
  JointNetwork network;
  std::optional<double> snap;         // grid that lines are noded on [m]; empty: auto_snap
  std::optional<double> least_width;  // area over half the perimeter of a block, and length of a crack [m]; empty: auto
  double least_area = 0.0;            // [m2]
  DeadEnds dead_ends = DeadEnds::keep;
};

/// Smallest power of ten that is at least 1e-9 of the extent and at least 64 units in the last place of the farthest
/// coordinate (for survey coordinates): coordinates with few decimals lie on the grid [m].
[[nodiscard]] double auto_snap(const Domain& domain);
/// 1e-6 of the extent, and at least ten grid widths [m].
[[nodiscard]] double auto_least_width(const Domain& domain);

/// One error in a domain; io locates it in the case file.
struct DomainFault {
  enum class Part { outline, hole, region, set_spacing, set_region, trace, arc, snap };
  Part part = Part::outline;
  std::size_t index = 0;  // which hole, region, joint set, trace or arc
  std::string what, allowed, hint;
};

/// The first fault of a domain: rings of fewer than three corners, not finite, with repeated corners, nearly closed
/// (open), self-crossing or without area; holes outside the outline, crossing it or each other; regions outside the
/// domain, overlapping or coincident; lines without length; more than a million lines; a snap that is not small
/// against the extent.
[[nodiscard]] std::optional<DomainFault> check_domain(const Domain& domain);

}  // namespace scree
