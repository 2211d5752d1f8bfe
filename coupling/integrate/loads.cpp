#include "coupling/integrate/loads.h"

#include <algorithm>

#include "coupling/integrate/edge_stretch.h"
#include "model/edge_selection.h"

namespace scree::coupling {
namespace {

/// Nodal forces of a uniform acceleration of the free bodies of some blocks; empty: of all.
std::vector<double> forces_of(const Setup& setup, const Vec2& acceleration, const std::vector<BlockId>& blocks) {
  std::vector<double> force(2 * static_cast<std::size_t>(setup.nodes()), 0.0);
  for (std::size_t p = 0; p < setup.pools(); ++p)
    setup.pool(p).body_force(acceleration, setup.part(std::span<double>(force), p));
  for (const Body& b : setup.bodies()) {
    const bool meant = blocks.empty() || std::find(blocks.begin(), blocks.end(), b.block) != blocks.end();
    if (meant && !b.driven) continue;
    const auto first = force.begin() + 2 * static_cast<std::ptrdiff_t>(b.first_node);
    std::fill(first, first + 2 * static_cast<std::ptrdiff_t>(b.nodes), 0.0);
  }
  return force;
}

/// Pressure of water on the faces that it presses on from outside, as consistent forces at the ends of their pieces.
void add_water(const Setup& setup, const State& state, const JointWater& water, std::vector<PointForce>& out) {
  const Model& model = setup.model();
  for (const EdgeSpan& span : water.faces) {
    const Polygon& polygon = model.blocks[span.block.index()].polygon;
    const auto [first, last] = ends_of(polygon, span.edge);
    const Vec2 n = outward_normal(polygon, span.edge);
    for (const EdgeStretch& s : edge_stretches(setup, state, span)) {
      const Vec2 from = first + s.begin * (last - first), to = first + s.end * (last - first), way = to - from;
      // Each end of the piece carries the pressure nearer to it; a force at s is shared linearly by the segment's ends.
      const double at_from = water_force(water, from, way), at_to = water_force(water, to, -way);
      const Vec2 a = -((1.0 - s.from) * at_from + (1.0 - s.to) * at_to) * n, b = -(s.from * at_from + s.to * at_to) * n;
      if (a != Vec2::Zero()) out.push_back({s.a, a, PointForce::kWater});
      if (b != Vec2::Zero()) out.push_back({s.b, b, PointForce::kWater});
    }
  }
}

}  // namespace

std::vector<BodyLoad> body_loads(const Setup& setup) {
  const Model& model = setup.model();
  std::vector<BodyLoad> out;
  if (model.gravity != Vec2(0.0, 0.0))
    out.push_back({forces_of(setup, model.gravity, {}), FunctionId{}, Column::gravity});
  for (const BodyAcceleration& b : model.body_accelerations) {
    if (b.acceleration == Vec2(0.0, 0.0)) continue;
    std::vector<double> force = forces_of(setup, b.acceleration, b.blocks);
    const auto same = std::find_if(out.begin(), out.end(), [&](const BodyLoad& l) {
      return l.column == Column::loads && l.function == b.function;
    });
    if (same == out.end())
      out.push_back({std::move(force), b.function, Column::loads});
    else
      std::transform(force.begin(), force.end(), same->force.begin(), same->force.begin(), std::plus<>());
  }
  return out;
}

std::vector<PointForce> point_forces(const Setup& setup, const State& state) {
  const Model& model = setup.model();
  std::vector<PointForce> out;
  std::int32_t load = 0;
  for (const PointLoad& p : model.point_loads) {
    const Body& b = setup.bodies()[p.block.index()];
    if (!b.driven) {
      // Material point, mapped from the initial model to the present reference shape.
      const ReferenceShape& shape = state.bodies[p.block.index()].shape;
      const AffineMotion map = affine_fit(shape.origin, shape.outline);
      const Row row = setup.global(b, setup.pool_of(b).row_at(b.index, map.c + map.F * p.point));
      if (setup.applies({&row, 1})) out.push_back({row, p.force, load});
    }
    ++load;
  }
  for (const EdgeTraction& t : model.tractions) {
    for (const EdgeStretch& s : edge_stretches(setup, state, t.span)) {
      const double middle = 0.5 * (s.from + s.to);
      out.push_back({s.a, (1.0 - middle) * s.length * t.traction, load});
      out.push_back({s.b, middle * s.length * t.traction, load});
    }
    ++load;
  }
  for (const JointWater& w : setup.waters()) add_water(setup, state, w, out);
  return out;
}

FunctionId load_function(const Model& model, std::int32_t load) {
  if (load == PointForce::kWater) return {};
  const auto i = static_cast<std::size_t>(load), points = model.point_loads.size();
  return i < points ? model.point_loads[i].function : model.tractions[i - points].function;
}

PointLoads::PointLoads(const Setup& setup, std::vector<PointForce> forces)
    : setup_(&setup),
      forces_(std::move(forces)),
      factor_(setup.model().point_loads.size() + setup.model().tractions.size(), 0.0) {}

void PointLoads::add(const Instant& at, std::span<double> f) {
  for (std::size_t i = 0; i < factor_.size(); ++i)
    factor_[i] = setup_->factor(load_function(setup_->model(), static_cast<std::int32_t>(i)), at.t);
  for (const PointForce& p : forces_) add_force(p.row, factor_of(p) * p.force, f);
}

double PointLoads::half_work(double h, std::span<const double> v) const {
  double power = 0.0;
  for (const PointForce& p : forces_) power += factor_of(p) * p.force.dot(position(p.row, v));
  return 0.5 * h * power;
}

}  // namespace scree::coupling
