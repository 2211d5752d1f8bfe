// Inverses of 6 x 6 blocks that stay within what single precision tells apart.
#pragma once

#include "coupling/linear/small_block.h"

namespace scree::coupling {

/// Replaces a block by its inverse, which is computed in double precision. Rows are exchanged only where elimination
/// in the given order meets a small pivot. None of the pivots has to be positive.
/// @param unit  6 units of the unknowns: divided by those of their row and column, numbers can be compared
/// @return false: the block is singular, or not distinct from a singular one in single precision; it has no meaning
/// then
bool invert(FloatBlock& block, const double* unit);

}  // namespace scree::coupling
