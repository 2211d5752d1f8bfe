#include "coupling/integrate/load_vectors.h"

#include <algorithm>

#include "model/parallel.h"

namespace scree::coupling {
namespace {

/// Adds a traction on the part of each boundary segment that lies within the span.
void add_traction(const Setup& setup, const BodyRecord& record, const Body& body, const EdgeTraction& load,
                  std::span<double> f) {
  const OutlineEdge edge = load.span.edge;
  const Ring& ring = record.shape.origin.ring(static_cast<std::size_t>(edge.ring));
  const auto v = static_cast<std::size_t>(edge.edge);
  const double length = (ring[(v + 1) % ring.size()] - ring[v]).norm();
  const Boundary& boundary = setup.pool_of(body).boundary(body.index);
  for (const Boundary::Segment& s : boundary.segments) {
    if (s.edge != edge) continue;
    const double low = std::max(s.s0, load.span.s0), high = std::min(s.s1, load.span.s1);
    if (!(low < high)) continue;
    // At the fraction u of the segment the ends weigh 1 - u and u.
    const double u0 = (low - s.s0) / (s.s1 - s.s0), u1 = (high - s.s0) / (s.s1 - s.s0);
    const double of_b = 0.5 * (u0 + u1);
    const Vec2 force = (high - low) * length * load.traction;
    add_force(setup.global(body, boundary.nodes[static_cast<std::size_t>(s.a)]), (1.0 - of_b) * force, f);
    add_force(setup.global(body, boundary.nodes[static_cast<std::size_t>(s.b)]), of_b * force, f);
  }
}

/// Adds a uniform acceleration of some bodies.
void add_acceleration(const Setup& setup, const BodyAcceleration& load, std::span<double> f) {
  std::vector<double> all(f.size(), 0.0);
  for (std::size_t p = 0; p < setup.pools(); ++p)
    setup.pool(p).body_force(load.acceleration, setup.part(std::span<double>(all), p));
  for (const Body& b : setup.bodies()) {
    const bool named =
        load.blocks.empty() || std::find(load.blocks.begin(), load.blocks.end(), b.block) != load.blocks.end();
    if (!named || b.driven) continue;
    for (auto i = 2 * static_cast<std::size_t>(b.first_node); i < 2 * static_cast<std::size_t>(b.first_node + b.nodes);
         ++i)
      f[i] += all[i];
  }
}

}  // namespace

std::vector<LoadVector> load_vectors(const Setup& setup, std::span<const BodyRecord> bodies) {
  std::vector<LoadVector> out;
  const auto vector_of = [&](FunctionId function) -> std::span<double> {
    const auto at =
        std::find_if(out.begin(), out.end(), [&](const LoadVector& v) { return v.function.value == function.value; });
    if (at != out.end()) return at->f;
    out.push_back({std::vector<double>(2 * static_cast<std::size_t>(setup.nodes()), 0.0), function});
    return out.back().f;
  };
  const Model& model = setup.model();
  for (const PointLoad& load : model.point_loads) {
    const Body& b = setup.bodies()[load.block.index()];
    if (b.driven) continue;
    // Material point: from where the model first had it to the present reference shape.
    const ReferenceShape& shape = bodies[load.block.index()].shape;
    const AffineMotion map = affine_fit(shape.origin, shape.outline);
    const Row row = setup.pool_of(b).row_at(b.index, map.c + map.F * load.point);
    add_force(setup.global(b, row), load.force, vector_of(load.function));
  }
  for (const EdgeTraction& load : model.tractions) {
    const Body& b = setup.bodies()[load.span.block.index()];
    if (!b.driven) add_traction(setup, bodies[load.span.block.index()], b, load, vector_of(load.function));
  }
  for (const BodyAcceleration& load : model.body_accelerations) add_acceleration(setup, load, vector_of(load.function));
  return out;
}

void add_loads(const Model& model, std::span<const LoadVector> loads, double time, std::span<double> f) {
  for (const LoadVector& load : loads) {
    const double factor = model.factor(load.function, time);
    if (factor == 0.0) continue;
    parallel_for(static_cast<std::int64_t>(f.size()), [&](std::int64_t i) {
      f[static_cast<std::size_t>(i)] += factor * load.f[static_cast<std::size_t>(i)];
    });
  }
}

}  // namespace scree::coupling
