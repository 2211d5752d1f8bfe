#include "io/live/live_data.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

namespace scree::io {
namespace {

/// Middle of the range of the coordinate `axis` of points x, y.
double middle(std::span<const double> xy, std::size_t axis) {
  if (xy.empty()) return 0.0;
  double low = xy[axis], high = xy[axis];
  for (std::size_t i = axis; i < xy.size(); i += 2) low = std::min(low, xy[i]), high = std::max(high, xy[i]);
  return 0.5 * low + 0.5 * high;
}

std::vector<std::int32_t> copied(std::span<const std::int32_t> values) { return {values.begin(), values.end()}; }

}  // namespace

LiveMesh LiveMesh::copy(const coupling::MeshView& view, std::span<const double> position) {
  LiveMesh mesh;
  mesh.id = view.id;
  mesh.base = {middle(view.origin, 0), middle(view.origin, 1)};
  for (std::size_t i = 0; i + 1 < view.origin.size(); i += 2) {
    mesh.origin_x.push_back(static_cast<float>(view.origin[i] - mesh.base[0]));
    mesh.origin_y.push_back(static_cast<float>(view.origin[i + 1] - mesh.base[1]));
  }
  for (std::size_t i = 0; i + 1 < view.origin.size(); i += 2) {
    const bool known = position.size() == view.origin.size() && std::isfinite(position[i] + position[i + 1]);
    mesh.start_x.push_back(known ? position[i] : view.origin[i]);
    mesh.start_y.push_back(known ? position[i + 1] : view.origin[i + 1]);
  }
  if (!view.offsets.empty()) mesh.offsets = copied(view.offsets);
  mesh.connectivity = copied(view.connectivity);
  mesh.block = copied(view.cell_block);
  mesh.material = copied(view.cell_material);
  mesh.method = copied(view.cell_method);
  mesh.methods = view.methods;
  mesh.find_bodies();
  return mesh;
}

void LiveMesh::find_bodies() {
  std::unordered_map<std::int32_t, std::int32_t> body_of_block;
  std::vector<std::int32_t> body_of_point(points(), -1);
  for (std::size_t c = 0; c < cells(); ++c) {
    const std::int32_t body =
        body_of_block.emplace(block[c], static_cast<std::int32_t>(body_of_block.size())).first->second;
    for (std::int32_t k = offsets[c]; k < offsets[c + 1]; ++k) {
      std::int32_t& owner = body_of_point[static_cast<std::size_t>(connectivity[static_cast<std::size_t>(k)])];
      if (owner < 0) owner = body;
    }
  }
  // Counting sort: the points of a body keep their order.
  body_first.assign(body_of_block.size() + 1, 0);
  for (const std::int32_t body : body_of_point)
    if (body >= 0) ++body_first[static_cast<std::size_t>(body) + 1];
  std::partial_sum(body_first.begin(), body_first.end(), body_first.begin());
  body_points.resize(static_cast<std::size_t>(body_first.back()));
  std::vector<std::int32_t> next(body_first.begin(), body_first.end() - 1);
  for (std::size_t p = 0; p < points(); ++p)
    if (const std::int32_t body = body_of_point[p]; body >= 0)
      body_points[static_cast<std::size_t>(next[static_cast<std::size_t>(body)]++)] = static_cast<std::int32_t>(p);
}

}  // namespace scree::io
