// What remains of the discontinuities once blocks are cut: lines drawn, dead ends, and a report.
#pragma once

#include <cstdint>

#include "model/geometry.h"
#include "model/ids.h"
#include "model/joint_network.h"

namespace scree {

/// A straight piece of a discontinuity that ends inside a block. DDA cannot use it; NMM can.
struct Crack {
  Vec2 from{0.0, 0.0}, to{0.0, 0.0};  // [m]
  JointId joint;
  BlockId block;
};

/// Statistics of cutting a domain into blocks.
struct CuttingReport {
  std::int64_t blocks = 0;
  std::int64_t lines = 0;                // straight pieces drawn
  std::int64_t cracks_kept = 0;          // connected dead ends inside blocks
  double crack_length = 0.0;             // of these [m]
  std::int64_t cracks_trimmed = 0;       // dead ends shorter than least_width, removed
  double trimmed_length = 0.0;           // of these [m]
  std::int64_t ends_extended = 0;        // dead ends extended to the next line
  double extended_length = 0.0;          // [m]
  std::int64_t slivers_joined = 0;       // with a neighbour
  std::int64_t slivers_left = 0;         // without a neighbour to join
  double area = 0.0;                     // of all blocks [m2]
  double least_area = 0.0;               // of a block [m2]
  double least_edge = 0.0;               // [m]
  double least_angle = 0.0;              // between two edges [rad]
  double snap = 0.0, least_width = 0.0;  // as used [m]
};

}  // namespace scree
