// Marks drawn on the blocks of a snapshot: arrows, and names.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/pictures/frame_field.h"
#include "io/pictures/plot_area.h"

namespace scree::io {

/// Arrows of a vector field, their middles on the blocks, the longest about as long as a block is wide.
class ArrowMarks {
 public:
  ArrowMarks() = default;
  /// @param value  two per cell   @param skip  per cell   @param block  usual width of a block on the page [pt]
  /// @param noise  none are drawn when no vector is longer   @param si  unit of the value
  ArrowMarks(const StoredFrame& frame, const std::vector<double>& value, const std::vector<char>& skip,
             const PlotArea& area, double block, double noise, const std::string& name, const std::string& si);

  void draw(const Canvas& canvas, const PlotArea& area) const;
  /// An arrow of a round length and its value, to the right of x about the height y; nothing if there are no arrows.
  void draw_key(const Canvas& canvas, double x, double y) const;

 private:
  std::vector<Arrow> arrows_;
  double points_ = 0.0;  // length on the page per unit of the value [pt]
  double key_length_ = 0.0;
  std::string key_;
};

/// Writes the name of each block in its middle, in black or white depending on the colour behind it; smaller where it
/// would not fit, and in the smallest letters on a background of its own where it does not fit at all.
/// @param colour  of a cell
void draw_names(const Canvas& canvas, const PlotArea& area, const StoredFrame& frame,
                const std::vector<std::string>& names, const std::function<Colour(std::size_t)>& colour);

/// The largest of 1, 2, 5 times a power of ten that is not above x.   @pre x > 0, finite
[[nodiscard]] double round_below(double x);

/// True when a cell holds the point.
[[nodiscard]] bool cell_holds(const StoredFrame& frame, std::size_t cell, const Vec2& point);

}  // namespace scree::io
