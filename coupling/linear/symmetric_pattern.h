// Places of the lower triangle of a sparse symmetric matrix, column after column.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace scree::coupling {

/// Compressed columns, rows in order; where many small matrices are summed, the place of each of their numbers is
/// known, so that assembling is one pass without a search.
struct SymmetricPattern {
  std::int32_t n = 0;
  std::vector<std::int32_t> column_start{0}, row;

  [[nodiscard]] std::size_t size() const { return row.size(); }

  /// Makes the pattern of entries (i, j), any of them repeated; (i, j) and (j, i) are the same.
  /// @return the place of each entry
  std::vector<std::int32_t> make(std::int32_t unknowns, std::span<const std::int32_t> i,
                                 std::span<const std::int32_t> j);
  /// y = A x, or y += factor A x; on threads where ranges of unknowns are independent of each other.
  void multiply(std::span<const double> values, std::span<const double> x, std::span<double> y) const;
  void multiply_add(double factor, std::span<const double> values, std::span<const double> x,
                    std::span<double> y) const;

 private:
  void multiply_add(double factor, std::span<const double> values, std::span<const double> x, std::span<double> y,
                    std::int32_t first, std::int32_t last) const;

  std::vector<std::int32_t> ranges_;  // of columns that no entry couples: where each begins, and the end of the last
};

/// A matrix with its pattern, as a state contains it.
struct SymmetricMatrix {
  SymmetricPattern pattern;
  std::vector<double> value;
};

}  // namespace scree::coupling
