#include "coupling/bodies/partition.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "coupling/bodies/setup.h"
#include "model/planar.h"

namespace scree::coupling {
namespace {

/// Where a block lies: 1 in the region, kDivided across its border, -1 outside. Slivers of less than a millionth of the
/// block do not count.
char side_of_region(const Clipper& block, double area, const Ring& region) {
  double inside = 0.0;
  for (const Polygon& piece : block.intersection(region)) inside += moments(piece).area;
  if (inside <= 1e-6 * area) return -1;
  return inside >= (1.0 - 1e-6) * area ? 1 : kDivided;
}

/// The largest principal strain rate of a body's affine motion [1/s].
double strain_rate(const Setup& setup, const Body& b, const State& state) {
  const auto p = static_cast<std::size_t>(b.pool);
  const AffineMotion m = setup.pool_of(b)
                             .release(b.index, setup.part(std::span<const double>(state.q), p),
                                      setup.part(std::span<const double>(state.v), p))
                             .motion;
  const Mat2 rate = m.Fdot * m.F.inverse(), d = 0.5 * (rate + rate.transpose());
  return 0.5 * std::abs(d.trace()) + std::hypot(0.5 * (d(0, 0) - d(1, 1)), d(0, 1));
}

char next(char side, double measure, const Partition::Band& band) {
  if (side == 0) return measure > band.up ? 1 : 0;
  return measure < band.down ? 0 : 1;
}

}  // namespace

std::vector<char> settled_sides(const Model& model, const Partition& partition, const Construction& construction) {
  std::vector<char> side(model.blocks.size(), -1);
  if (partition.explicit_area > 0.0)
    for (std::size_t i = 0; i < side.size(); ++i)
      if (moments(model.blocks[i].polygon).area < partition.explicit_area) side[i] = 1;
  if (!partition.explicit_region.empty())
    for (std::size_t i = 0; i < side.size(); ++i)
      if (const char of = side_of_region(Clipper(model.blocks[i].polygon), moments(model.blocks[i].polygon).area,
                                         partition.explicit_region);
          of != -1)
        side[i] = of;
  for (const BlockId b : partition.explicit_blocks) side[b.index()] = 1;
  for (const BlockId b : partition.implicit_blocks) side[b.index()] = 0;
  // Held and driven blocks take no steps: they are on neither side, and a border through one divides nothing.
  for (std::size_t i = 0; i < side.size(); ++i)
    if (model.support_of(BlockId{static_cast<std::int32_t>(i)}) != nullptr) side[i] = 0;
  for (const BlockId b : construction.absent) side[b.index()] = 0;
  return side;
}

std::vector<char> first_sides(const Model& model, const Partition& partition, const Construction& construction) {
  std::vector<char> side = settled_sides(model, partition, construction);
  std::replace(side.begin(), side.end(), static_cast<char>(-1), static_cast<char>(0));
  return side;
}

Ghosts slow_bodies(const Model& model, const Stage& stage, std::span<const char> sides) {
  Ghosts out;
  if (!stage.subcycled()) return out;
  std::vector<char> first;
  if (sides.empty()) sides = first = first_sides(model, stage.partition, stage.construction);
  for (const char side : sides) out.slow.push_back(side == 0 ? 1 : 0);
  return out;
}

bool change_sides(const Setup& setup, const State& state, const Partition& partition, std::span<const char> fixed,
                  std::vector<char>& sides) {
  std::vector<double> fastest(sides.size(), 0.0);
  if (partition.speed.used()) {
    const Outlines& o = setup.outlines();
    for (const OutlineNode k : o.nodes.indices()) {
      double& speed = fastest[o.node_body[k].index()];
      speed = std::max(speed, position(o.nodes[k], state.v).norm());
    }
  }
  bool changed = false;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Body& b = setup.bodies()[i];
    if (fixed[i] >= 0 || b.driven) continue;
    // Either measure makes a block explicit; both must have fallen below their bands before it is implicit again.
    char wanted = 0;
    if (partition.speed.used()) wanted = next(sides[i], fastest[i], partition.speed);
    if (wanted == 0 && partition.strain_rate.used())
      wanted = next(sides[i], strain_rate(setup, b, state), partition.strain_rate);
    changed = changed || wanted != sides[i];
    sides[i] = wanted;
  }
  return changed;
}

}  // namespace scree::coupling
