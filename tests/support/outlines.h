// Current outlines of a run's blocks, and the depth of their overlap.
#pragma once

#include <algorithm>
#include <limits>

#include "coupling/contact/table/contact_point.h"
#include "tests/support/scene.h"

namespace scree::test {

/// Current outline of a block.
inline Ring outline_of(const coupling::Driver& run, BlockId id) {
  const coupling::Setup& setup = run.setup();
  const coupling::Outlines& o = setup.outlines();
  Ring ring;
  for (const coupling::Outlines::Edge& e : o.edges)
    if (setup.body(e.body).block == id)
      ring.push_back(coupling::position(o.nodes[o.vertices[e.first_vertex()].node], run.state().q));
  return ring;
}

/// Largest depth of a corner of one convex ring in another; 0 if no corner lies in it.
inline double depth_in(const Ring& of, const Ring& in) {
  double deepest = 0.0;
  for (const Vec2& x : of) {
    double inside = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < in.size(); ++i)
      inside = std::min(inside, -coupling::contact_geometry(x, in[i], in[(i + 1) % in.size()]).gap);
    deepest = std::max(deepest, inside);
  }
  return deepest;
}

}  // namespace scree::test
