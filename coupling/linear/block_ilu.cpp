#include "coupling/linear/block_ilu.h"

#include <algorithm>
#include <utility>

#include "coupling/linear/block_inverse.h"

namespace scree::coupling {
namespace {

constexpr std::int32_t kFill = -1;      // source of a block that A does not have
constexpr std::int32_t kWhole = 3000;   // rows that stay one part
constexpr std::int32_t kPair = 4096;    // rows of two parts, above that
constexpr std::int32_t kMostParts = 8;  // the more there are, the more rows are in the separator

std::int32_t count_parts(std::int32_t rows) { return rows < kWhole ? 1 : std::min(kMostParts, 2 * (1 + rows / kPair)); }

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

void round_to(const double* block, FloatBlock& out) {
  for (int j = 0; j < kBlockSide; ++j) DoubleColumn(block + kBlockSide * j).round_to(out.column[j]);
}

/// of(part) for every part, on threads if there are several.
template <class Of>
void for_parts(std::int32_t count, Of&& of) {
  if (count == 1) return of(0);
#pragma omp parallel for schedule(static)
  for (std::int32_t p = 0; p < count; ++p) of(p);
}

}  // namespace

void BlockIlu::take_pattern(const BlockMatrix& A) {
  if (std::ranges::equal(row_begin_, A.row_starts()) && std::ranges::equal(of_column_, A.columns())) return;
  row_begin_.assign(A.row_starts().begin(), A.row_starts().end());
  of_column_.assign(A.columns().begin(), A.columns().end());
  parts_ = cut_rows(A, count_parts(A.rows()));
  failed_.assign(index(parts_.parts()), 0);
  const std::size_t rows = index(A.rows());
  place_.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) place_[index(parts_.order[i])] = static_cast<std::int32_t>(i);
  start_.assign(1, 0);
  blocks_.clear();
  diagonal_.resize(rows);
  seen_.assign(rows, -1);
  for (std::int32_t i = 0; i < A.rows(); ++i) append_row(A, i);
  if (blocks_.size() > factor_.capacity()) {  // resize() would double it
    factor_.clear();
    factor_.reserve(blocks_.size() + blocks_.size() / 16);
  }
  factor_.resize(blocks_.size());
  y_.resize(rows);
}

void BlockIlu::append_row(const BlockMatrix& A, std::int32_t i) {
  const auto add = [&](std::int32_t column, std::int32_t source) {
    if (std::exchange(seen_[index(column)], i) != i) blocks_.push_back({column, source});
  };
  const auto each = [&](std::int32_t at, auto&& of) {
    const std::int32_t row = parts_.order[index(at)];
    for (std::int32_t k = A.row_begin(row); k < A.row_begin(row + 1); ++k) of(place_[index(A.column(k))], k);
  };
  const auto first = static_cast<std::ptrdiff_t>(blocks_.size());
  each(i, add);
  each(i, [&](std::int32_t pivot, std::int32_t) {
    if (pivot >= i) return;
    each(pivot, [&](std::int32_t column, std::int32_t) {
      if (column > pivot) add(column, kFill);
    });
  });
  std::sort(blocks_.begin() + first, blocks_.end(), [](const Block& p, const Block& q) { return p.column < q.column; });
  const auto own = std::find_if(blocks_.begin() + first, blocks_.end(), [i](const Block& b) { return b.column == i; });
  diagonal_[index(i)] = static_cast<std::int32_t>(own - blocks_.begin());
  start_.push_back(static_cast<std::int32_t>(blocks_.size()));
}

bool BlockIlu::eliminate(const BlockMatrix& A, std::span<const double> unit, std::int32_t begin, std::int32_t end) {
  for (std::size_t i = index(begin); i < index(end); ++i) {
    for (std::int32_t k = start_[i]; k < start_[i + 1]; ++k) {
      if (const std::int32_t source = blocks_[index(k)].source; source == kFill)
        factor_[index(k)] = {};
      else
        round_to(A.block(source), factor_[index(k)]);
    }
    for (std::int32_t k = start_[i]; k < diagonal_[i]; ++k) {
      const std::size_t pivot = index(column(k));
      FloatBlock& left = factor_[index(k)];
      left.multiply_by(factor_[index(diagonal_[pivot])]);
      std::int32_t at = k + 1;
      for (std::int32_t m = diagonal_[pivot] + 1; m < start_[pivot + 1]; ++m) {
        while (at < start_[i + 1] && column(at) < column(m)) ++at;
        if (at == start_[i + 1]) break;
        if (column(at) == column(m)) factor_[index(at)].subtract_product(left, factor_[index(m)]);
      }
    }
    if (!invert(factor_[index(diagonal_[i])], &unit[kBlockSide * index(parts_.order[i])])) return false;
  }
  return true;
}

bool BlockIlu::factorise(const BlockMatrix& A, std::span<const double> unit) {
  take_pattern(A);
  for_parts(parts_.parts(), [&](std::int32_t p) {
    failed_[index(p)] = eliminate(A, unit, parts_.begin[index(p)], parts_.begin[index(p + 1)]) ? 0 : 1;
  });
  made_ =
      std::find(failed_.begin(), failed_.end(), 1) == failed_.end() && eliminate(A, unit, parts_.separator(), A.rows());
  return made_;
}

void BlockIlu::forward(std::span<const double> r, std::int32_t begin, std::int32_t end) {
  for (std::size_t i = index(begin); i < index(end); ++i) {
    FloatColumn sum;
    DoubleColumn(&r[kBlockSide * index(parts_.order[i])]).round_to(sum);
    for (std::int32_t k = start_[i]; k < diagonal_[i]; ++k) factor_[index(k)].subtract_from(sum, y_[index(column(k))]);
    y_[i] = sum;
  }
}

void BlockIlu::backward(std::span<float> z, std::int32_t begin, std::int32_t end) {
  for (std::size_t i = index(end); i-- > index(begin);) {
    FloatColumn sum = y_[i];
    for (std::int32_t k = diagonal_[i] + 1; k < start_[i + 1]; ++k)
      factor_[index(k)].subtract_from(sum, y_[index(column(k))]);
    factor_[index(diagonal_[i])].times(sum, y_[i]);
    float* out = &z[kBlockSide * index(parts_.order[i])];
    for (int j = 0; j < kBlockSide; ++j) out[j] = y_[i][j];
  }
}

void BlockIlu::solve(std::span<const double> r, std::span<float> z) {
  const std::int32_t parts = parts_.parts(), separator = parts_.separator();
  const auto rows = static_cast<std::int32_t>(y_.size());
  const auto& begin = parts_.begin;
  for_parts(parts, [&](std::int32_t p) { forward(r, begin[index(p)], begin[index(p + 1)]); });
  forward(r, separator, rows);
  backward(z, separator, rows);
  for_parts(parts, [&](std::int32_t p) { backward(z, begin[index(p)], begin[index(p + 1)]); });
}

}  // namespace scree::coupling
