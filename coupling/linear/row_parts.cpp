#include "coupling/linear/row_parts.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace scree::coupling {
namespace {

/// Appends the rows that can be reached from `root` to `order`, the nearer ones first, and marks them with `mark`,
/// which those that were reached before have.
void append_levels(const BlockMatrix& A, std::int32_t root, std::vector<std::int32_t>& marks, std::int32_t mark,
                   std::vector<std::int32_t>& order) {
  std::size_t next = order.size();
  const auto reach = [&](std::int32_t row) {
    if (std::exchange(marks[static_cast<std::size_t>(row)], mark) != mark) order.push_back(row);
  };
  for (reach(root); next < order.size(); ++next)
    for (std::int32_t k = A.row_begin(order[next]); k < A.row_begin(order[next] + 1); ++k) reach(A.column(k));
}

/// Rows by their distance from a row at the rim of the graph, one connected piece after another.
std::vector<std::int32_t> levels_of(const BlockMatrix& A) {
  std::vector<std::int32_t> order, marks(static_cast<std::size_t>(A.rows()), 0);
  order.reserve(marks.size());
  for (std::int32_t row = 0; row < A.rows(); ++row) {
    if (marks[static_cast<std::size_t>(row)] != 0) continue;
    const std::size_t first = order.size();
    append_levels(A, row, marks, 1, order);
    const std::int32_t farthest = order.back();
    order.resize(first);
    append_levels(A, farthest, marks, 2, order);
  }
  return order;
}

}  // namespace

RowParts cut_rows(const BlockMatrix& A, std::int32_t parts) {
  const std::int32_t n = A.rows();
  RowParts out;
  if (parts == 1) {
    out.order.resize(static_cast<std::size_t>(n));
    std::iota(out.order.begin(), out.order.end(), 0);
    out.begin = {0, n};
    return out;
  }
  const std::vector<std::int32_t> levels = levels_of(A);
  const auto end_of = [&](std::int32_t part) { return static_cast<std::size_t>(std::int64_t{n} * (part + 1) / parts); };
  std::vector<std::int32_t> part_of(static_cast<std::size_t>(n));
  std::size_t at = 0;
  for (std::int32_t p = 0; p < parts; ++p)
    for (; at < end_of(p); ++at) part_of[static_cast<std::size_t>(levels[at])] = p;
  std::vector<std::int32_t> separator;
  out.order.reserve(static_cast<std::size_t>(n));
  at = 0;
  for (std::int32_t p = 0; p < parts; ++p) {
    out.begin.push_back(static_cast<std::int32_t>(out.order.size()));
    for (; at < end_of(p); ++at) {
      const std::int32_t row = levels[at];
      bool front = false;
      for (std::int32_t k = A.row_begin(row); k < A.row_begin(row + 1); ++k)
        front = front || part_of[static_cast<std::size_t>(A.column(k))] > p;
      (front ? separator : out.order).push_back(row);
    }
  }
  out.begin.push_back(static_cast<std::int32_t>(out.order.size()));
  out.order.insert(out.order.end(), separator.begin(), separator.end());
  return out;
}

}  // namespace scree::coupling
