#include "io/results/water_writer.h"

#include <vector>

#include "io/results/h5_series.h"

namespace scree::io {

void write_water(const h5::File& file, const Model& model) {
  std::vector<double> unit_weight, point;
  std::vector<std::int32_t> point_line, joint, joint_line;
  for (const JointWater& water : model.waters) {
    const auto line = static_cast<std::int32_t>(unit_weight.size());
    unit_weight.push_back(water.unit_weight);
    for (const Vec2& p : water.line) {
      point.insert(point.end(), {p.x(), p.y()});
      point_line.push_back(line);
    }
    for (const JointId id : water.joints) {
      joint.push_back(id.value);
      joint_line.push_back(line);
    }
  }
  h5::write<double>(file, "/water/unit_weight", 1, unit_weight, {"N/m3", "of the water below a piezometric line"});
  h5::write<double>(file, "/water/point", 2, point, {"m", "x, y of a point of a piezometric line, from left to right"});
  h5::write<std::int32_t>(file, "/water/point_line", 1, point_line,
                          {"1", "its line, counted from 0 in /water/unit_weight"});
  h5::write<std::int32_t>(file, "/water/joint", 1, joint,
                          {"1", "joint law that a line fills, counted from 0 in /joints/name"});
  h5::write<std::int32_t>(file, "/water/joint_line", 1, joint_line,
                          {"1", "that line; one that has no row here fills all joints"});
}

}  // namespace scree::io
