// Rows of a block matrix in independent parts and a separator: what threads may eliminate side by side.
#pragma once

#include <cstdint>
#include <vector>

#include "coupling/linear/block_matrix.h"

namespace scree::coupling {

/// Order of elimination: the rows of one part after another, then the separator. No block of the matrix couples rows of
/// two parts; rows that would are in the separator.
struct RowParts {
  std::vector<std::int32_t> order;  // rows of the matrix, in the order of elimination
  std::vector<std::int32_t> begin;  // in `order`: of every part, then of the separator

  [[nodiscard]] std::int32_t parts() const { return static_cast<std::int32_t>(begin.size()) - 1; }
  [[nodiscard]] std::int32_t separator() const { return begin.back(); }
};

/// Cuts the graph of the blocks into parts of about equal size: levels of distance from a row at its rim, in succession
/// (breadth first), whose fronts are the separator. One part has the rows in their own order and no separator. The
/// result depends on the pattern alone.
/// @param parts  at least 1
/// @source [Saad2003] 3.3.3 (level sets), 14.2 (parts and separator)
[[nodiscard]] RowParts cut_rows(const BlockMatrix& A, std::int32_t parts);

}  // namespace scree::coupling
