// What acts on the blocks of a model picture, as marks.
#pragma once

#include <set>
#include <string>

#include "io/pictures/plot_area.h"
#include "model/model.h"

namespace scree::io {

/// Kinds of marks that a picture holds, for its legend.
enum class Mark {
  held_block,
  fixed_edge,
  roller,
  point_support,
  traction,
  point_load,
  viscous,
  water,
  monitor,
  crack,
  bolt,
  liner
};
/// What a mark means: "held edge".
[[nodiscard]] std::string meaning_of(Mark mark);
/// Draws a mark at the left of a line of a legend, 16 pt wide, its middle at (x + 8, y).
void draw_sample(const Canvas& canvas, Mark mark, double x, double y);

/// Hatching or rollers along the held edges, triangles at supported points.
void draw_supports(const Canvas& canvas, const PlotArea& area, const Model& model, std::set<Mark>& marks);
/// Arrows of tractions and point loads, the largest of either about 26 pt long; viscous edges.
void draw_loads(const Canvas& canvas, const PlotArea& area, const Model& model, std::set<Mark>& marks);
/// Bolts from head to toe, the bonded length wide, a plate as a stroke across the head.
void draw_bolts(const Canvas& canvas, const PlotArea& area, const Model& model, std::set<Mark>& marks);
/// Lines of water with their sign, and monitors with their names.
void draw_water(const Canvas& canvas, const PlotArea& area, const Model& model, std::set<Mark>& marks);
void draw_monitors(const Canvas& canvas, const PlotArea& area, const Model& model, bool names, std::set<Mark>& marks);

}  // namespace scree::io
