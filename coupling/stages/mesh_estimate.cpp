#include "coupling/stages/mesh_estimate.h"

#include <cmath>

#include "coupling/transfer/transfer.h"
#include "model/perimeter.h"

namespace scree::coupling {
namespace {

constexpr double kCellBytes = 11.0, kExplicitBytes = 800.0, kImplicitBytes = 4000.0;  // implicit: with its factor

}  // namespace

MeshEstimate mesh_estimate(const Model& model, const Stage& stage) {
  const std::vector<BodyRequest> request = body_requests(model, stage);
  MeshEstimate out;
  double most = 0.0;
  for (std::size_t b = 0; b < request.size(); ++b) {
    const Formulation& form = request[b].form;
    if (request[b].method != "nmm" || form.onefold) continue;
    const Polygon& polygon = model.blocks[b].polygon;
    const Vec2 span = bounds(polygon).hi - bounds(polygon).lo;
    const double h = form.cover_size, triangle = std::sqrt(3.0) / 4.0 * h * h,
                 elements = moments(polygon).area / triangle + 3.0 * perimeter(polygon) / h + 1.0,
                 // Rows of the lattice are oblique: a box is as long as high in it.
        cells = (span.x() / h + span.y() / h + 4.0) * (1.2 * span.y() / h + 4.0),
                 bytes = kCellBytes * cells +
                         elements * (form.mass == MassKind::consistent ? kImplicitBytes : kExplicitBytes);
    out.elements += elements;
    out.bytes += bytes;
    if (bytes <= most) continue;
    most = bytes;
    out.finest = BlockId{static_cast<std::int32_t>(b)};
    out.cover_size = h;
  }
  return out;
}

}  // namespace scree::coupling
