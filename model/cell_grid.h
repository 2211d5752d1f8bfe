// A plane divided into square cells, each with a list of the boxes that touch it: finds items near a point or a box.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry.h"

namespace scree {

class CellGrid {
 public:
  /// @param items  approximate number of boxes to insert, and of cells
  CellGrid(const Box& extent, std::size_t items);

  void insert(const Box& box, std::int32_t item);
  /// Inserts a segment as boxes of at most one cell, so that a long segment does not fill its bounding box. Parts
  /// outside the extent are inserted into cells of its border as one box for each side, whatever their length.
  /// @param reach  largest distance at which a point finds the segment [m]
  void insert(const Vec2& a, const Vec2& b, double reach, std::int32_t item);

  /// Items whose boxes touch the cell of the point: those that contain it, and some others; in order of insertion.
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
