// Incomplete factor of a block matrix, in single precision: a preconditioner.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "coupling/linear/block_matrix.h"
#include "coupling/linear/row_parts.h"

namespace scree::coupling {

/// Block ILU(1): A is about (L + D) D^-1 (D + U), where L, D and U have blocks where A has some and where elimination
/// with the blocks of A alone fills one, and the product has the numbers of A there. For two bodies that touch, or a
/// row of them, it is the factor of A itself. Single precision is enough for a result that conjugate residuals improve,
/// and halves the memory to read; rounding is relative to every number of the factor, so that units do not matter.
/// Pivots are inverted in double precision.
///
/// Large systems are eliminated in another order (cut_rows()): parts that are independent, on any number of threads,
/// and the separator after them. How many parts there are depends on the number of rows alone.
/// @source [Saad2003] 10.3.3, blocks in place of numbers; 14.2 (parts and separator)
class BlockIlu {
 public:
  /// @param unit  of every number of a right-hand side, by which pivots are compared (ImplicitSystem::unit())
  /// @return false: a pivot block is singular or not finite; there is no factor then
  [[nodiscard]] bool factorise(const BlockMatrix& A, std::span<const double> unit);
  /// z = (D + U)^-1 D (L + D)^-1 r.   @pre factorise() returned true   @param r,z  6 numbers per block row
  void solve(std::span<const double> r, std::span<float> z);
  /// Forgets the factor.
  void clear() { made_ = false; }
  [[nodiscard]] bool made() const { return made_; }

 private:
  /// Finds the order of elimination and where the blocks of A belong in it, if its pattern is not that of the last one.
  void take_pattern(const BlockMatrix& A);
  /// Eliminates rows from begin to end of the order.   @return false: as factorise()
  [[nodiscard]] bool eliminate(const BlockMatrix& A, std::span<const double> unit, std::int32_t begin,
                               std::int32_t end);
  /// (L + D) y = D r of rows from begin to end, with y of earlier ones known.
  void forward(std::span<const double> r, std::int32_t begin, std::int32_t end);
  /// (D + U) z = D y of rows from end to begin, with z of later ones known.
  void backward(std::span<float> z, std::int32_t begin, std::int32_t end);

  /// Appends the pattern of row i of the order.
  void append_row(const BlockMatrix& A, std::int32_t i);
  [[nodiscard]] std::int32_t column(std::int32_t k) const { return blocks_[static_cast<std::size_t>(k)].column; }

  bool made_ = false;
  RowParts parts_;
  /// Where a block of the factor belongs, and comes from.
  struct Block {
    std::int32_t column = 0, source = 0;  // in the order of elimination; place in A, or kFill
  };
  std::vector<std::int32_t> start_, diagonal_;  // of every row in the order of elimination
  std::vector<Block> blocks_;
  std::vector<FloatBlock> factor_;                   // L D^-1 below the diagonal, U above it; on it D^-1
  std::vector<std::int32_t> row_begin_, of_column_;  // the pattern of A that all this belongs to
  std::vector<std::int32_t> place_;                  // of the rows of A in the order of elimination
  std::vector<std::int32_t> seen_;                   // scratch: by column, the last row that has it
  std::vector<FloatColumn> y_;                       // scratch, per row
  std::vector<char> failed_;                         // scratch, per part
};

}  // namespace scree::coupling
