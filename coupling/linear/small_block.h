// Kernels of 6 x 6 blocks, in vectors of fixed length.
#pragma once

#include <cstring>

namespace scree::coupling {

/// Unknowns of an affine body: side of a block.
inline constexpr int kBlockSide = 6;
/// Numbers in a block, column after column.
inline constexpr int kBlockSize = kBlockSide * kBlockSide;

/// A column of six numbers in single precision, and two zeros: a length that processors have registers for.
using FloatColumn = float __attribute__((vector_size(32)));

/// A column of six numbers in double precision. Columns are passed by reference: how vectors are passed by value
/// depends on the processor.
class DoubleColumn {
 public:
  DoubleColumn() = default;  // zeros
  /// @param x  6 numbers
  explicit DoubleColumn(const double* x) {
    std::memcpy(&head_, x, sizeof head_);
    std::memcpy(&tail_, x + 4, sizeof tail_);
  }
  explicit DoubleColumn(const FloatColumn& x) {
    for (int i = 0; i < 4; ++i) head_[i] = static_cast<double>(x[i]);
    for (int i = 0; i < 2; ++i) tail_[i] = static_cast<double>(x[4 + i]);
  }
  /// @param x  6 numbers
  void store(double* x) const {
    std::memcpy(x, &head_, sizeof head_);
    std::memcpy(x + 4, &tail_, sizeof tail_);
  }
  void round_to(FloatColumn& x) const {
    using FourFloats = float __attribute__((vector_size(16)));
    const auto head = __builtin_convertvector(head_, FourFloats);
    const FourFloats tail = {static_cast<float>(tail_[0]), static_cast<float>(tail_[1])};
    x = __builtin_shufflevector(head, tail, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  /// *this += a x.
  void add(double a, const DoubleColumn& x) {
    head_ += a * x.head_;
    tail_ += a * x.tail_;
  }
  /// *this += a x + b y.
  void add(double a, const DoubleColumn& x, double b, const DoubleColumn& y) {
    head_ += a * x.head_ + b * y.head_;
    tail_ += a * x.tail_ + b * y.tail_;
  }
  /// *this = a x + b y.
  void set(double a, const DoubleColumn& x, double b, const DoubleColumn& y) {
    head_ = a * x.head_ + b * y.head_;
    tail_ = a * x.tail_ + b * y.tail_;
  }
  /// Multiplies the numbers by those of x, each by its own.
  void scale(const DoubleColumn& x) {
    head_ *= x.head_;
    tail_ *= x.tail_;
  }
  void scale(double a) {
    head_ *= a;
    tail_ *= a;
  }
  /// Adds the products of the numbers of x with those of y.
  void add_products(const DoubleColumn& x, const DoubleColumn& y) {
    head_ += x.head_ * y.head_;
    tail_ += x.tail_ * y.tail_;
  }
  [[nodiscard]] double sum() const {
    const Two two = __builtin_shufflevector(head_, head_, 0, 1) + __builtin_shufflevector(head_, head_, 2, 3) + tail_;
    return two[0] + two[1];
  }

 private:
  using Four = double __attribute__((vector_size(32)));
  using Two = double __attribute__((vector_size(16)));
  Four head_ = {};
  Two tail_ = {};
};

/// A block in single precision.
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
