// Comparison of the stress in the blocks of a stored frame with the strength of their rock.
#pragma once

#include <string>
#include <vector>

#include "io/results/run_reader.h"

namespace scree::io {

/// Ratio of stress to strength of each cell (scree::utilisation); NaN where the material of the cell has no strength.
[[nodiscard]] std::vector<double> cell_utilisation(const StoredFrame& frame,
                                                   const std::vector<StoredMaterial>& materials);

/// A block, and its cell with the largest utilisation.
struct RockUse {
  std::string block, material;
  double utilisation = 0.0;
  Vec2 at{0.0, 0.0};          // current middle of the cell, in the axes of the case [m]
  double s1 = 0.0, s3 = 0.0;  // principal stresses there, tension positive [Pa]
  double area = 0.0;          // of the block's cells above the strength [m2]
};

/// Blocks that are not held and whose material has a strength, by decreasing utilisation.
/// @param frame  its number in the run   @throws FileError
[[nodiscard]] std::vector<RockUse> rock_use(const RunReader& run, std::size_t frame);

/// "rock: stress is above the strength in 2 of 9 blocks, 14.5 m2, at most 1.37 of the strength of 'rock' in block 'b-3'
/// at (12.1, 30.2) m, s1 .. Pa, s3 .. Pa"; empty: no material has a strength.
[[nodiscard]] std::string rock_use_text(const std::vector<RockUse>& use);

}  // namespace scree::io
