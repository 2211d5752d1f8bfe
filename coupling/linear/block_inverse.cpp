#include "coupling/linear/block_inverse.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace scree::coupling {
namespace {

using Rows = double[kBlockSide][kBlockSide];

/// Sum and largest of the absolute values; the sum is finite if all numbers are.
std::pair<double, double> size_of(const Rows& m) {
  double sum = 0.0, largest = 0.0;
  for (const auto& row : m)
    for (const double x : row) {
      sum += std::abs(x);
      largest = std::max(largest, std::abs(x));
    }
  return {sum, largest};
}

/// Gauss-Jordan elimination with exchanges of rows, in place.
/// @return the smallest absolute pivot; if it is zero the matrix is singular, and m has no meaning
double eliminate_with_exchanges(Rows& m) {
  double smallest = std::numeric_limits<double>::infinity();
  int from[kBlockSide];
  for (int k = 0; k < kBlockSide; ++k) {
    int p = k;
    for (int i = k + 1; i < kBlockSide; ++i)
      if (std::abs(m[i][k]) > std::abs(m[p][k])) p = i;
    from[k] = p;
    if (p != k) std::swap(m[p], m[k]);
    const double pivot = m[k][k];
    smallest = std::min(smallest, std::abs(pivot));
    if (smallest == 0.0) return 0.0;
    m[k][k] = 1.0;
    DoubleColumn row(m[k]);
    row.scale(1.0 / pivot);
    row.store(m[k]);
    for (int i = 0; i < kBlockSide; ++i) {
      if (i == k) continue;
      const double factor = std::exchange(m[i][k], 0.0);
      DoubleColumn other(m[i]);
      other.add(-factor, row);
      other.store(m[i]);
    }
  }
  for (int k = kBlockSide; k-- > 0;)
    if (from[k] != k)
      for (auto& row : m) std::swap(row[k], row[from[k]]);
  return smallest;
}

/// Six numbers and two zeros: where registers have eight numbers, a block stays in six of them.
using WideRow = double __attribute__((vector_size(64)));

/// One step of Gauss-Jordan elimination without exchanges.   @param smallest  becomes the smallest pivot so far
template <int Step>
[[gnu::always_inline]] inline void eliminate(WideRow (&m)[kBlockSide], double& smallest) {
  // Number `Step` of a row is replaced by that of another.
  constexpr auto from = [](int i) { return i == Step ? 8 + i : i; };
  constexpr WideRow zeros = {};
  const double pivot = m[Step][Step];
  smallest = std::min(smallest, std::abs(pivot));
  const WideRow row =
      __builtin_shufflevector(m[Step], zeros + 1.0, from(0), from(1), from(2), from(3), from(4), from(5), 6, 7) *
      (1.0 / pivot);
  m[Step] = row;
#pragma GCC unroll 6
  for (int i = 0; i < kBlockSide; ++i) {
    if (i == Step) continue;
    const double factor = m[i][Step];
    m[i] =
        __builtin_shufflevector(m[i], zeros, from(0), from(1), from(2), from(3), from(4), from(5), 6, 7) - factor * row;
  }
}

/// Inverts without exchanges.   @return false: a pivot is small, or a number not finite, and the block is unchanged
bool invert_in_order(FloatBlock& block, const double* unit) {
  constexpr double kSmall = 1e-3;  // of the largest number; where a pivot is smaller, rows are exchanged
  WideRow scale = {}, m[kBlockSide], largest = {};
  for (int i = 0; i < kBlockSide; ++i) scale[i] = 1.0 / unit[i];
    // The transpose, whose rows are the columns: its inverse is the transpose of the inverse.
#pragma GCC unroll 6
  for (int j = 0; j < kBlockSide; ++j) {
    m[j] = __builtin_convertvector(block.column[j], WideRow) * scale * scale[j];
    const WideRow size = m[j] < 0.0 ? -m[j] : m[j];
    largest = size > largest ? size : largest;
  }
  double smallest = std::numeric_limits<double>::infinity(), most = 0.0;
  eliminate<0>(m, smallest);
  eliminate<1>(m, smallest);
  eliminate<2>(m, smallest);
  eliminate<3>(m, smallest);
  eliminate<4>(m, smallest);
  eliminate<5>(m, smallest);
  for (int i = 0; i < kBlockSide; ++i) most = std::max(most, largest[i]);
  if (!(smallest > kSmall * most)) return false;
  WideRow sum = {};
#pragma GCC unroll 6
  for (int j = 0; j < kBlockSide; ++j) {
    m[j] *= scale * scale[j];
    sum += m[j] < 0.0 ? -m[j] : m[j];
  }
  double total = 0.0;
  for (int i = 0; i < kBlockSide; ++i) total += sum[i];
  if (!std::isfinite(total)) return false;
#pragma GCC unroll 6
  for (int j = 0; j < kBlockSide; ++j) block.column[j] = __builtin_convertvector(m[j], FloatColumn);
  return true;
}

bool invert_with_exchanges(FloatBlock& block, const double* unit) {
  constexpr double kSingular = 1e-7;
  double scale[kBlockSide];
  for (int i = 0; i < kBlockSide; ++i) scale[i] = 1.0 / unit[i];
  const DoubleColumn all(scale);
  Rows m;  // of the transpose, too
  for (int j = 0; j < kBlockSide; ++j) {
    DoubleColumn column(block.column[j]);
    column.scale(all);
    column.scale(scale[j]);
    column.store(m[j]);
  }
  const auto [sum, largest] = size_of(m);
  if (!std::isfinite(sum) || !(eliminate_with_exchanges(m) > kSingular * largest)) return false;
  for (int j = 0; j < kBlockSide; ++j) {
    DoubleColumn column(m[j]);
    column.scale(all);
    column.scale(scale[j]);
    column.store(m[j]);
    column.round_to(block.column[j]);
  }
  return std::isfinite(size_of(m).first);
}

}  // namespace

bool invert(FloatBlock& block, const double* unit) {
  return invert_in_order(block, unit) || invert_with_exchanges(block, unit);
}

}  // namespace scree::coupling
