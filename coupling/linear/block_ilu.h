// Incomplete factor of a block matrix, in single precision: a preconditioner.
#pragma once

#include <span>
#include <vector>

#include "coupling/linear/block_matrix.h"

namespace scree::coupling {

/// Block ILU(0): A is about (L + D) D^-1 (D + U) where L, D, U have the pattern of A and the product has the numbers of
/// A on that pattern. Of two bodies that touch, or of a row of them, it is the factor of A itself. Single precision is
/// enough for what conjugate residuals improve, and halves the numbers to read; rounding is relative to every number
/// of the factor, so that units do not matter. Pivots are inverted in double precision.
/// @source [Saad2003] 10.3, blocks in place of numbers
class BlockIlu {
 public:
  /// @return false: a pivot block is singular or not finite; there is no factor then
  [[nodiscard]] bool factorise(const BlockMatrix& A);
  /// z = (D + U)^-1 D (L + D)^-1 r.   @pre factorise() returned true   @param r,z  6 numbers per block row
  void solve(std::span<const double> r, std::span<double> z);
  /// Forgets the factor.
  void clear() { made_ = false; }
  [[nodiscard]] bool made() const { return made_; }

 private:
  /// Row i of the factor from that of A and from the rows before.   @return false: as factorise()
  [[nodiscard]] bool eliminate(std::int32_t i);

  bool made_ = false;
  std::vector<std::int32_t> start_, column_, diagonal_;
  std::vector<FloatBlock> factor_;   // L D^-1 below the diagonal, U above it; on it D
  std::vector<FloatBlock> inverse_;  // D^-1
  std::vector<FloatColumn> y_;       // scratch, per block row
  std::vector<std::int32_t> place_;  // scratch of a row: of its blocks by column; -1: none
};

}  // namespace scree::coupling
