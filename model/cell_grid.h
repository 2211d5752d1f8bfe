// A plane cut into square cells that know which boxes touch them: finds what is near a point or a box.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry.h"

namespace scree {

class CellGrid {
 public:
  /// @param items  about how many boxes will be put in; cells are made as many
  CellGrid(const Box& extent, std::size_t items);

  void insert(const Box& box, std::int32_t item);
  /// Puts in a segment by boxes of at most a cell, so that a long one does not fill the square around it. What lies
  /// outside the extent goes into cells of its border by one box for each side, however long it is.
  /// @param reach  points up to this far from the segment find it [m]
  void insert(const Vec2& a, const Vec2& b, double reach, std::int32_t item);

  /// Items whose boxes touch the cell of the point: those that hold the point, and some more; in order of insertion.
  [[nodiscard]] std::span<const std::int32_t> at(const Vec2& point) const;
  /// Items that share a cell with the box, each once, ascending.
  void near(const Box& box, std::vector<std::int32_t>& items) const;

 private:
  [[nodiscard]] std::int32_t column(double x) const;
  [[nodiscard]] std::int32_t row(double y) const;
  [[nodiscard]] std::size_t cell(std::int32_t c, std::int32_t r) const {
    return static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c);
  }

  void insert_pieces(const Vec2& a, const Vec2& b, std::int64_t pieces, double reach, std::int32_t item);

  Box extent_;
  double size_ = 1.0;  // of a cell [m]
  std::int32_t columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::int32_t>> cells_;
};

}  // namespace scree
