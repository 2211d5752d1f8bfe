#include "coupling/integrate/edge_stretch.h"

#include <algorithm>
#include <array>

namespace scree::coupling {

std::vector<EdgeStretch> edge_stretches(const Setup& setup, const State& state, const EdgeSpan& span) {
  std::vector<EdgeStretch> out;
  const auto index = span.block.index();
  const Body& body = setup.bodies()[index];
  if (body.driven) return out;
  const Ring& ring = state.bodies[index].shape.origin.ring(static_cast<std::size_t>(span.edge.ring));
  const auto corner = static_cast<std::size_t>(span.edge.edge);
  const double edge = (ring[(corner + 1) % ring.size()] - ring[corner]).norm();
  const Boundary& boundary = setup.pool_of(body).boundary(body.index);
  for (const Boundary::Segment& s : boundary.segments) {
    if (s.edge != span.edge) continue;
    const double begin = std::max(s.s0, span.s0), end = std::min(s.s1, span.s1);
    if (!(end > begin)) continue;
    const auto row = [&](std::int32_t node) {
      return setup.global(body, boundary.nodes[static_cast<std::size_t>(node)]);
    };
    if (!setup.applies(std::array{row(s.a), row(s.b)})) continue;
    const double whole = s.s1 - s.s0;
    out.push_back({BodyIndex::of(index), row(s.a), row(s.b), (begin - s.s0) / whole, (end - s.s0) / whole,
                   (end - begin) * edge, begin, end});
  }
  return out;
}

}  // namespace scree::coupling
