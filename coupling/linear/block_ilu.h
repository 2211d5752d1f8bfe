// Incomplete factor of a block matrix, in single precision: a preconditioner.
#pragma once

#include <span>
#include <vector>

#include "coupling/linear/block_matrix.h"

namespace scree::coupling {

/// Block ILU(0) of fixed parts of the rows: A is about (L + D) D^-1 (D + U) where L, D, U have the pattern of A and the
/// product has the numbers of A on that pattern. For two bodies that touch, or a row of them, it is the factor of A
/// itself. Single precision is enough for a result that conjugate residuals improve, and halves the memory to read;
/// rounding is relative to every number of the factor, so that units do not matter. Pivots are inverted in double
/// precision.
///
/// Large systems are cut into parts that depend on the number of rows alone; the coupling between parts is left out
/// (block Jacobi). Parts are independent, on any number of threads.
/// @source [Saad2003] 10.3, blocks in place of numbers; 12.4.1 (parts)
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
  /// Rows from begin to end.
  struct Part {
    std::int32_t begin = 0, end = 0;
  };
  void take(const BlockMatrix& A);
  /// The factor of a part from the numbers of A.   @return false: as factorise()
  [[nodiscard]] bool eliminate(const Part& part, std::span<const double> unit);
  void solve(const Part& part, std::span<const double> r, std::span<float> z);

  bool made_ = false;
  std::vector<Part> parts_;
  // Per row: its blocks within its part, and the diagonal one.
  std::vector<std::int32_t> first_, diagonal_, end_;
  std::vector<std::int32_t> column_;
  std::vector<FloatBlock> factor_;   // L D^-1 below the diagonal, U above it; on it D^-1
  std::vector<FloatColumn> y_;       // scratch, per row
  std::vector<std::int32_t> place_;  // scratch: of the blocks of the present row by their columns; -1: none
  std::vector<char> failed_;         // scratch, per part
};

}  // namespace scree::coupling
