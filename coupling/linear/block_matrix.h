// Sparse matrices of 6 x 6 blocks: the systems of affine bodies that touch.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "coupling/linear/small_block.h"

namespace scree::coupling {

/// Block rows of a square matrix with a symmetric pattern; the numbers need not be symmetric. Rows of blocks are
/// independent of one another: a caller may fill them, and multiply() computes them, on any number of threads to the
/// same bits.
class BlockMatrix {
 public:
  /// Two bodies that are coupled, in either order; the diagonal is always there.
  using Pair = std::array<std::int32_t, 2>;

  /// Makes the pattern of n block rows with the blocks of all pairs, each of which may occur repeatedly. The numbers
  /// have no meaning before they are set.   @pre 0 <= pair < n
  void set_pattern(std::int32_t n, std::span<const Pair> pairs);

  /// True if the pattern is that of n block rows and these pairs.
  /// @param places  of every pair (i, j): blocks (i, j) and (j, i), -1: there is none
  [[nodiscard]] bool has_pattern(std::int32_t n, std::span<const Pair> pairs, std::span<const Pair> places);
  /// Finds the places of pairs.
  void find(std::span<const Pair> pairs, std::vector<Pair>& places) const;

  [[nodiscard]] std::int32_t rows() const { return static_cast<std::int32_t>(diagonal_.size()); }
  /// Number of blocks in the pattern.
  [[nodiscard]] std::size_t blocks() const { return column_.size(); }
  /// The pattern: where the rows begin, with the end of the last one, and the columns of all blocks.
  [[nodiscard]] std::span<const std::int32_t> row_starts() const { return start_; }
  [[nodiscard]] std::span<const std::int32_t> columns() const { return column_; }
  /// Blocks of row i are those from row_begin(i) to row_begin(i + 1), in the order of their columns.
  [[nodiscard]] std::int32_t row_begin(std::int32_t i) const { return start_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] std::int32_t column(std::int32_t k) const { return column_[static_cast<std::size_t>(k)]; }
  [[nodiscard]] std::int32_t diagonal(std::int32_t i) const { return diagonal_[static_cast<std::size_t>(i)]; }
  /// Place of block (i, j); -1: there is none.
  [[nodiscard]] std::int32_t find(std::int32_t i, std::int32_t j) const;
  /// The 36 numbers of a block, column after column.
  [[nodiscard]] double* block(std::int32_t k) { return &value_[kBlockSize * static_cast<std::size_t>(k)]; }
  [[nodiscard]] const double* block(std::int32_t k) const { return &value_[kBlockSize * static_cast<std::size_t>(k)]; }
  /// Sets the blocks of row i to zero.
  void clear_row(std::int32_t i);
  /// y = A x.   @param x,y  6 n numbers, not the same
  void multiply(std::span<const double> x, std::span<double> y) const;

 private:
  std::vector<std::int32_t> start_{0}, column_, diagonal_;
  std::vector<double> value_;
  std::vector<char> seen_;  // per block, scratch
};

}  // namespace scree::coupling
