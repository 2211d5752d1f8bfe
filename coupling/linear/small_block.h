// Kernels of 6 x 6 blocks, in vectors of fixed length.
#pragma once

#include <cstring>

namespace scree::coupling {

/// Unknowns of an affine body: side of a block.
inline constexpr int kBlockSide = 6;
/// Numbers in a block, column after column.
inline constexpr int kBlockSize = kBlockSide * kBlockSide;

/// y += B x in double precision.
class BlockSum {
 public:
  /// @param block  36 numbers, column after column   @param x  6 numbers
  void add(const double* block, const double* x) {
    for (int j = 0; j < kBlockSide; ++j) {
      Four head;
      Two tail;
      std::memcpy(&head, block + kBlockSide * j, sizeof head);
      std::memcpy(&tail, block + kBlockSide * j + 4, sizeof tail);
      head_ += head * x[j];
      tail_ += tail * x[j];
    }
  }
  /// @param y  6 numbers
  void store(double* y) const {
    std::memcpy(y, &head_, sizeof head_);
    std::memcpy(y + 4, &tail_, sizeof tail_);
  }

 private:
  using Four = double __attribute__((vector_size(32)));
  using Two = double __attribute__((vector_size(16)));
  Four head_ = {};
  Two tail_ = {};
};

/// A column of six numbers in single precision, and two zeros: a length that processors have registers for.
using FloatColumn = float __attribute__((vector_size(32)));

/// A block in single precision. Columns are passed by reference: how vectors are passed by value depends on the
/// processor.
struct FloatBlock {
  FloatColumn column[kBlockSide];

  /// y -= B x.
  void subtract_from(FloatColumn& y, const FloatColumn& x) const {
    for (int j = 0; j < kBlockSide; ++j) y -= column[j] * x[j];
  }
  /// y = B x.
  void times(const FloatColumn& x, FloatColumn& y) const {
    FloatColumn sum = column[0] * x[0];
    for (int j = 1; j < kBlockSide; ++j) sum += column[j] * x[j];
    y = sum;
  }
  /// *this = *this B.
  void multiply_by(const FloatBlock& b) {
    const FloatBlock before = *this;
    for (int j = 0; j < kBlockSide; ++j) before.times(b.column[j], column[j]);
  }
  /// *this -= B C.
  void subtract_product(const FloatBlock& b, const FloatBlock& c) {
    for (int j = 0; j < kBlockSide; ++j) b.subtract_from(column[j], c.column[j]);
  }
};

}  // namespace scree::coupling
