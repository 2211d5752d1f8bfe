#include "coupling/linear/symmetric_pattern.h"

#include <algorithm>

#include "model/parallel.h"

namespace scree::coupling {

std::vector<std::int32_t> SymmetricPattern::make(std::int32_t unknowns, std::span<const std::int32_t> i,
                                                 std::span<const std::int32_t> j) {
  n = unknowns;
  // Entries by column, then by row within each: (row, entry) pairs.
  struct Entry {
    std::int32_t row, index;
  };
  std::vector<std::int32_t> start(static_cast<std::size_t>(n) + 1, 0);
  for (std::size_t k = 0; k < i.size(); ++k) ++start[static_cast<std::size_t>(std::min(i[k], j[k])) + 1];
  for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
  std::vector<Entry> entries(i.size());
  std::vector<std::int32_t> next(start.begin(), start.end() - 1);
  for (std::size_t k = 0; k < i.size(); ++k)
    entries[static_cast<std::size_t>(next[static_cast<std::size_t>(std::min(i[k], j[k]))]++)] = {
        std::max(i[k], j[k]), static_cast<std::int32_t>(k)};

  std::vector<std::int32_t> place(i.size());
  column_start.assign(1, 0);
  row.clear();
  for (std::size_t c = 0; c + 1 < start.size(); ++c) {
    const auto begin = entries.begin() + start[c], end = entries.begin() + start[c + 1];
    std::sort(begin, end, [](const Entry& a, const Entry& b) { return a.row < b.row; });
    for (auto e = begin; e != end; ++e) {
      if (e == begin || e->row != (e - 1)->row) row.push_back(e->row);
      place[static_cast<std::size_t>(e->index)] = static_cast<std::int32_t>(row.size()) - 1;
    }
    column_start.push_back(static_cast<std::int32_t>(row.size()));
  }
  constexpr std::int32_t kShort = 1024;  // unknowns: as much as a thread should have to do
  ranges_.assign(1, 0);
  std::int32_t last = -1;  // row of the columns so far
  for (std::int32_t c = 0; c < n; ++c) {
    if (c > last && c - ranges_.back() >= kShort) ranges_.push_back(c);
    const auto begin = static_cast<std::size_t>(column_start[static_cast<std::size_t>(c)]),
               end = static_cast<std::size_t>(column_start[static_cast<std::size_t>(c) + 1]);
    if (begin < end) last = std::max(last, row[end - 1]);
  }
  ranges_.push_back(n);
  return place;
}

void SymmetricPattern::multiply(std::span<const double> values, std::span<const double> x, std::span<double> y) const {
  std::fill(y.begin(), y.end(), 0.0);
  multiply_add(1.0, values, x, y);
}

void SymmetricPattern::multiply_add(double factor, std::span<const double> values, std::span<const double> x,
                                    std::span<double> y) const {
  if (ranges_.size() < 2) return multiply_add(factor, values, x, y, 0, n);  // not by make()
  constexpr std::int64_t kFew = 6;                                          // ranges
  parallel_for(
      std::ssize(ranges_) - 1,
      [&](std::int64_t i) {
        const auto range = static_cast<std::size_t>(i);
        multiply_add(factor, values, x, y, ranges_[range], ranges_[range + 1]);
      },
      kFew);
}

void SymmetricPattern::multiply_add(double factor, std::span<const double> values, std::span<const double> x,
                                    std::span<double> y, std::int32_t first, std::int32_t last) const {
  for (auto c = static_cast<std::size_t>(first); c < static_cast<std::size_t>(last); ++c) {
    const double of_column = factor * x[c];
    double sum = 0.0;
    auto k = static_cast<std::size_t>(column_start[c]);
    const auto end = static_cast<std::size_t>(column_start[c + 1]);
    if (k < end && static_cast<std::size_t>(row[k]) == c) sum += values[k++] * x[c];  // rows are in order from c on
    for (; k < end; ++k) {
      const auto r = static_cast<std::size_t>(row[k]);
      sum += values[k] * x[r];
      y[r] += values[k] * of_column;
    }
    y[c] += factor * sum;
  }
}

}  // namespace scree::coupling
