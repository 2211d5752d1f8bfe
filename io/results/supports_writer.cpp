#include "io/results/supports_writer.h"

#include <vector>

#include "io/results/h5_series.h"

namespace scree::io {

void write_supports(const h5::File& file, const Model& model) {
  std::vector<double> point;
  std::vector<std::int32_t> block, fix_x, fix_y;
  for (const PointSupport& s : model.point_supports) {
    point.insert(point.end(), {s.point.x(), s.point.y()});
    block.push_back(s.block.value);
    fix_x.push_back(s.fix_x ? 1 : 0), fix_y.push_back(s.fix_y ? 1 : 0);
  }
  h5::write<double>(file, "/supports/point", 2, point, {"m", "x, y of a supported point in the model"});
  h5::write<std::int32_t>(file, "/supports/block", 1, block, {"1", "its block, counted from 0 in /blocks"});
  h5::write<std::int32_t>(file, "/supports/fix_x", 1, fix_x, {"1", "1 where it is held along x"});
  h5::write<std::int32_t>(file, "/supports/fix_y", 1, fix_y, {"1", "1 where it is held along y"});
}

}  // namespace scree::io
