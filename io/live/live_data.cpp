#include "io/live/live_data.h"

#include <algorithm>

namespace scree::io {
namespace {

/// Middle of the range of every second number.
double middle(std::span<const double> xy, std::size_t axis) {
  if (xy.empty()) return 0.0;
  double low = xy[axis], high = xy[axis];
  for (std::size_t i = axis; i < xy.size(); i += 2) low = std::min(low, xy[i]), high = std::max(high, xy[i]);
  return 0.5 * low + 0.5 * high;
}

std::vector<std::int32_t> copied(std::span<const std::int32_t> values) { return {values.begin(), values.end()}; }

}  // namespace

std::string_view name(LiveField field) { return field == LiveField::speed ? "speed" : "mean stress"; }

LiveMesh LiveMesh::copy(const coupling::MeshView& view) {
  LiveMesh mesh;
  mesh.id = view.id;
  mesh.base = {middle(view.origin, 0), middle(view.origin, 1)};
  for (std::size_t i = 0; i + 1 < view.origin.size(); i += 2) {
    mesh.origin_x.push_back(static_cast<float>(view.origin[i] - mesh.base[0]));
    mesh.origin_y.push_back(static_cast<float>(view.origin[i + 1] - mesh.base[1]));
  }
  if (!view.offsets.empty()) mesh.offsets = copied(view.offsets);
  mesh.connectivity = copied(view.connectivity);
  mesh.block = copied(view.cell_block);
  mesh.material = copied(view.cell_material);
  mesh.method = copied(view.cell_method);
  mesh.methods = view.methods;
  return mesh;
}

}  // namespace scree::io
