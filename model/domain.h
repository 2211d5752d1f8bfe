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
  Ring outline;  // [m]; what lies outside the domain does not count
  MaterialId material;
  JointId joint;            // law of its outline, and of its blocks' edges on no joint; invalid: the domain's
  bool cut = true;          // false: discontinuities end at it
  double cover_size = 0.0;  // of the NMM in its blocks; 0: as the stage says [m]
};

/// What becomes of lines that end inside rock, at a rock bridge.
enum class DeadEnds {
  keep,   // cracks in their blocks: the NMM cuts its covers along them, the DDA leaves them out
  drop,   // no method has them
  extend  // they run on, straight, to the next line: rock bridges are cut through
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

/// Smallest power of ten that is at least 1e-9 of the extent, and 64 last places of the farthest coordinate (survey
/// coordinates): coordinates with few decimals lie on the grid [m].
[[nodiscard]] double auto_snap(const Domain& domain);
/// 1e-6 of the extent, and at least ten grid widths [m].
[[nodiscard]] double auto_least_width(const Domain& domain);

/// One thing that is wrong with a domain, for io to place in the case file.
struct DomainFault {
  enum class Part { outline, hole, region, set_spacing, set_region, trace, arc, snap };
  Part part = Part::outline;
  std::size_t index = 0;  // which hole, region, joint set, trace or arc
  std::string what, allowed, hint;
};

/// The first fault of a domain: rings of fewer than three corners, not finite, with repeated corners, nearly closed
/// (open), self-crossing or without area; holes outside the outline, crossing it or each other; regions outside the
/// domain, overlapping or coincident; lines without length; more than a million lines; a snap that is no small part of
/// the extent.
[[nodiscard]] std::optional<DomainFault> check_domain(const Domain& domain);

}  // namespace scree
