#include "io/results/supports_writer.h"

#include <vector>

#include "io/results/h5_series.h"
#include "model/edge_selection.h"

namespace scree::io {

void write_supports(const h5::File& file, const Model& model) {
  std::vector<double> point;
  std::vector<std::int32_t> block, fix_x, fix_y;
  for (const PointSupport& s : model.point_supports) {
    point.insert(point.end(), {s.point.x(), s.point.y()});
    block.push_back(s.block.value);
    fix_x.push_back(s.fix_x ? 1 : 0), fix_y.push_back(s.fix_y ? 1 : 0);
  }
  std::vector<double> line, held;
  std::vector<std::int32_t> edge_block;
  for (const EdgeSupport& s : model.edge_supports) {
    const auto [from, to] = ends_of(model.blocks[s.span.block.index()].polygon, s.span.edge);
    const Vec2 a = from + s.span.s0 * (to - from), b = from + s.span.s1 * (to - from);
    line.insert(line.end(), {a.x(), a.y(), b.x(), b.y()});
    held.insert(held.end(), {s.held(0, 0), s.held(1, 1), s.held(0, 1)});
    edge_block.push_back(s.span.block.value);
  }
  h5::write<double>(file, "/supports/line", 4, line, {"m", "x, y of either end of a held stretch of an outline"});
  h5::write<std::int32_t>(file, "/supports/line_block", 1, edge_block, {"1", "its block, counted from 0 in /blocks"});
  h5::write<double>(file, "/supports/line_held", 3, held, {"1", "xx, yy, xy of the projector on the held directions"});
  h5::write<double>(file, "/supports/point", 2, point, {"m", "x, y of a supported point in the model"});
  h5::write<std::int32_t>(file, "/supports/block", 1, block, {"1", "its block, counted from 0 in /blocks"});
  h5::write<std::int32_t>(file, "/supports/fix_x", 1, fix_x, {"1", "1 where it is held along x"});
  h5::write<std::int32_t>(file, "/supports/fix_y", 1, fix_y, {"1", "1 where it is held along y"});
}

}  // namespace scree::io
