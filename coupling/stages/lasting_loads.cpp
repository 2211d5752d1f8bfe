#include "coupling/stages/lasting_loads.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {
namespace {

constexpr double kCancels = 1e-6;  // fraction of the sum of absolute values

double span_length(const Model& model, const EdgeSpan& span) {
  const Ring& ring = model.blocks[span.block.index()].polygon.ring(static_cast<std::size_t>(span.edge.ring));
  const auto i = static_cast<std::size_t>(span.edge.edge);
  return (ring[(i + 1) % ring.size()] - ring[i]).norm() * (span.s1 - span.s0);
}

}  // namespace

bool lasts(const Model& model, FunctionId function) {
  if (!function.valid()) return true;
  const TimeFunction& f = model.functions[function.index()];
  if (f.amplitude == 0.0) return false;
  using Shape = TimeFunction::Shape;
  if (f.shape == Shape::table) return !f.table.empty() && f.table.back() != 0.0;
  return f.shape == Shape::constant || f.shape == Shape::ramp;
}

namespace {

Vec2 last_value(const Model& model, const BodyAcceleration& a) {
  return a.acceleration * model.factor(a.function, 1e9);
}

}  // namespace

Vec2 weight_direction(const Model& model) {
  Vec2 sum = model.gravity;
  for (const BodyAcceleration& a : model.body_accelerations)
    if (a.blocks.empty() && lasts(model, a.function)) sum += last_value(model, a);
  return sum;
}

Vec2 lasting_acceleration(const Model& model, BlockId block) {
  Vec2 sum = model.gravity;
  for (const BodyAcceleration& a : model.body_accelerations) {
    if (!lasts(model, a.function)) continue;
    if (!a.blocks.empty() && std::find(a.blocks.begin(), a.blocks.end(), block) == a.blocks.end()) continue;
    sum += last_value(model, a);
  }
  return sum;
}

bool LastingForce::acts(int axis) const {
  return std::abs(sum[axis]) > kCancels * std::max(absolute.x(), absolute.y());
}

void add_lasting_loads(const Model& model, const std::vector<std::int32_t>& group_of,
                       std::vector<LastingForce>& groups) {
  const auto add = [&](BlockId block, const Vec2& force) {
    LastingForce& g = groups[static_cast<std::size_t>(group_of[block.index()])];
    g.sum += force;
    g.absolute += force.cwiseAbs();
  };
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const BlockId block(static_cast<std::int32_t>(b));
    const double mass = model.material_of(block).density * moments(model.blocks[b].polygon).area;
    add(block, mass * lasting_acceleration(model, block));
  }
  for (const PointLoad& l : model.point_loads)
    if (lasts(model, l.function)) add(l.block, l.force * model.factor(l.function, 1e9));
  for (const EdgeTraction& l : model.tractions)
    if (lasts(model, l.function))
      add(l.span.block, l.traction * span_length(model, l.span) * model.factor(l.function, 1e9));
}

}  // namespace scree::coupling
