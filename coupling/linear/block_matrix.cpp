#include "coupling/linear/block_matrix.h"

#include <algorithm>

#include "model/parallel.h"

namespace scree::coupling {
namespace {

constexpr std::int64_t kFewRows = 3000;  // not worth waking threads for

}  // namespace

void BlockMatrix::set_pattern(std::int32_t n, std::span<const Pair> pairs) {
  const auto rows = static_cast<std::size_t>(n);
  // Columns by row, counted and placed; each row is then sorted by itself and its repetitions left out.
  std::vector<std::int32_t> first(rows + 1, 0);
  for (std::size_t i = 0; i < rows; ++i) first[i + 1] = 1;
  for (const Pair& p : pairs)
    for (const std::int32_t i : p) ++first[static_cast<std::size_t>(i) + 1];
  for (std::size_t i = 0; i < rows; ++i) first[i + 1] += first[i];
  std::vector<std::int32_t> all(static_cast<std::size_t>(first[rows])), next(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < rows; ++i) all[static_cast<std::size_t>(next[i]++)] = static_cast<std::int32_t>(i);
  for (const Pair& p : pairs) {
    all[static_cast<std::size_t>(next[static_cast<std::size_t>(p[0])]++)] = p[1];
    all[static_cast<std::size_t>(next[static_cast<std::size_t>(p[1])]++)] = p[0];
  }
  start_.assign(1, 0);
  column_.clear();
  diagonal_.clear();
  for (std::size_t i = 0; i < rows; ++i) {
    const auto begin = all.begin() + first[i];
    auto end = all.begin() + first[i + 1];
    std::sort(begin, end);
    end = std::unique(begin, end);
    const auto own = std::lower_bound(begin, end, static_cast<std::int32_t>(i));
    diagonal_.push_back(start_.back() + static_cast<std::int32_t>(own - begin));
    column_.insert(column_.end(), begin, end);
    start_.push_back(static_cast<std::int32_t>(column_.size()));
  }
  value_.resize(kBlockSize * column_.size());
}

bool BlockMatrix::has_pattern(std::int32_t n, std::span<const Pair> pairs, std::span<const Pair> places) {
  if (rows() != n) return false;
  seen_.assign(blocks(), 0);
  auto found = static_cast<std::size_t>(n);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const auto [i, j] = pairs[p];
    const std::int32_t k = places[p][i < j ? 0 : 1];  // above the diagonal
    if (k < 0) return false;
    if (char& seen = seen_[static_cast<std::size_t>(k)]; seen == 0 && i != j) {
      seen = 1;
      found += 2;
    }
  }
  return found == blocks();
}

void BlockMatrix::find(std::span<const Pair> pairs, std::vector<Pair>& places) const {
  places.resize(pairs.size());
  const auto find_pair = [&](std::int64_t at) {
    const auto p = static_cast<std::size_t>(at);
    const auto [i, j] = pairs[p];
    places[p] = std::max(i, j) < rows() ? Pair{find(i, j), find(j, i)} : Pair{-1, -1};
  };
  parallel_for(std::ssize(pairs), find_pair, kFewRows);
}

std::int32_t BlockMatrix::find(std::int32_t i, std::int32_t j) const {
  const auto begin = column_.begin() + row_begin(i), end = column_.begin() + row_begin(i + 1);
  const auto at = std::lower_bound(begin, end, j);
  return at != end && *at == j ? static_cast<std::int32_t>(at - column_.begin()) : -1;
}

void BlockMatrix::clear_row(std::int32_t i) { std::fill(block(row_begin(i)), block(row_begin(i + 1)), 0.0); }

void BlockMatrix::multiply(std::span<const double> x, std::span<double> y) const {
  parallel_for(
      rows(),
      [&](std::int64_t at) {
        const auto i = static_cast<std::int32_t>(at);
        DoubleColumn sum;
        for (std::int32_t k = row_begin(i); k < row_begin(i + 1); ++k) {
          const double *of_block = block(k), *of_body = &x[kBlockSide * static_cast<std::size_t>(column(k))];
          for (int j = 0; j < kBlockSide; ++j) sum.add(of_body[j], DoubleColumn(of_block + kBlockSide * j));
        }
        sum.store(&y[kBlockSide * static_cast<std::size_t>(i)]);
      },
      kFewRows);
}

}  // namespace scree::coupling
