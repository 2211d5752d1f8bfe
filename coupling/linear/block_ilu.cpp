#include "coupling/linear/block_ilu.h"

#include <algorithm>

#include "coupling/linear/block_inverse.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

void round_to(const double* block, FloatBlock& out) {
  for (int j = 0; j < kBlockSide; ++j) DoubleColumn(block + kBlockSide * j).round_to(out.column[j]);
}

constexpr std::int32_t kWhole = 3000;   // rows that stay one part
constexpr std::int32_t kPair = 4096;    // rows of two parts, above that
constexpr std::int32_t kMostParts = 8;  // the more there are, the more iterations it takes

/// The part that row i of n is in.
std::int32_t part_of(std::int32_t i, std::int32_t n, std::int32_t parts) {
  auto p = static_cast<std::int32_t>(std::int64_t{i} * parts / n);
  if (i >= std::int64_t{n} * (p + 1) / parts) ++p;
  return p;
}

template <class Of>
void for_parts(std::size_t count, Of&& of) {
  if (count == 1) return of(std::size_t{0});
#pragma omp parallel for schedule(static)
  for (std::int64_t p = 0; p < static_cast<std::int64_t>(count); ++p) of(static_cast<std::size_t>(p));
}

}  // namespace

void BlockIlu::take(const BlockMatrix& A) {
  const std::int32_t n = A.rows();
  const auto rows = static_cast<std::size_t>(n);
  parts_.clear();
  const std::int32_t parts = n < kWhole ? 1 : std::min(kMostParts, 2 * (1 + n / kPair));
  for (std::int32_t p = 0; p < parts; ++p)
    parts_.push_back({static_cast<std::int32_t>(std::int64_t{n} * p / parts),
                      static_cast<std::int32_t>(std::int64_t{n} * (p + 1) / parts)});
  for (auto* v : {&first_, &diagonal_, &end_, &place_}) v->resize(rows);
  if (A.blocks() > factor_.capacity()) {  // resize() would double it
    column_.clear();
    factor_.clear();
    column_.reserve(A.blocks() + A.blocks() / 16);
    factor_.reserve(A.blocks() + A.blocks() / 16);
  }
  column_.resize(A.blocks());
  factor_.resize(A.blocks());
  y_.resize(rows);
  failed_.assign(parts_.size(), 0);
  parallel_for(n, [&](std::int64_t at) {
    const auto i = static_cast<std::int32_t>(at);
    const auto row = static_cast<std::size_t>(at);
    const Part part = parts_[static_cast<std::size_t>(part_of(i, n, parts))];
    diagonal_[row] = A.diagonal(i);
    first_[row] = A.row_begin(i + 1);
    end_[row] = A.row_begin(i);
    for (std::int32_t k = A.row_begin(i); k < A.row_begin(i + 1); ++k) {
      const std::int32_t c = column_[static_cast<std::size_t>(k)] = A.column(k);
      if (c < part.begin || c >= part.end) continue;
      first_[row] = std::min(first_[row], k);
      end_[row] = k + 1;
      round_to(A.block(k), factor_[static_cast<std::size_t>(k)]);
    }
    place_[row] = -1;
  });
}

bool BlockIlu::eliminate(const Part& part, std::span<const double> unit) {
  const auto column = [this](std::int32_t k) { return static_cast<std::size_t>(column_[static_cast<std::size_t>(k)]); };
  for (auto row = static_cast<std::size_t>(part.begin); row < static_cast<std::size_t>(part.end); ++row) {
    for (std::int32_t k = first_[row]; k < end_[row]; ++k) place_[column(k)] = k;
    for (std::int32_t k = first_[row]; k < diagonal_[row]; ++k) {
      const std::size_t c = column(k);
      FloatBlock& left = factor_[static_cast<std::size_t>(k)];
      left.multiply_by(factor_[static_cast<std::size_t>(diagonal_[c])]);
      for (std::int32_t m = diagonal_[c] + 1; m < end_[c]; ++m)
        if (const std::int32_t at = place_[column(m)]; at >= 0)
          factor_[static_cast<std::size_t>(at)].subtract_product(left, factor_[static_cast<std::size_t>(m)]);
    }
    for (std::int32_t k = first_[row]; k < end_[row]; ++k) place_[column(k)] = -1;
    if (!invert(factor_[static_cast<std::size_t>(diagonal_[row])], &unit[kBlockSide * row])) return false;
  }
  return true;
}

bool BlockIlu::factorise(const BlockMatrix& A, std::span<const double> unit) {
  take(A);
  for_parts(parts_.size(), [&](std::size_t p) { failed_[p] = eliminate(parts_[p], unit) ? 0 : 1; });
  return made_ = std::find(failed_.begin(), failed_.end(), 1) == failed_.end();
}

void BlockIlu::solve(const Part& part, std::span<const double> r, std::span<float> z) {
  const auto begin = static_cast<std::size_t>(part.begin), end = static_cast<std::size_t>(part.end);
  for (std::size_t i = begin; i < end; ++i) {
    FloatColumn sum;
    DoubleColumn(&r[kBlockSide * i]).round_to(sum);
    for (auto k = static_cast<std::size_t>(first_[i]); k < static_cast<std::size_t>(diagonal_[i]); ++k)
      factor_[k].subtract_from(sum, y_[static_cast<std::size_t>(column_[k])]);
    y_[i] = sum;
  }
  for (std::size_t i = end; i-- > begin;) {
    FloatColumn sum = y_[i];
    for (auto k = static_cast<std::size_t>(diagonal_[i]) + 1; k < static_cast<std::size_t>(end_[i]); ++k)
      factor_[k].subtract_from(sum, y_[static_cast<std::size_t>(column_[k])]);
    factor_[static_cast<std::size_t>(diagonal_[i])].times(sum, y_[i]);
    for (std::size_t j = 0; j < kBlockSide; ++j) z[kBlockSide * i + j] = y_[i][j];
  }
}

void BlockIlu::solve(std::span<const double> r, std::span<float> z) {
  for_parts(parts_.size(), [&](std::size_t p) { solve(parts_[p], r, z); });
}

}  // namespace scree::coupling
