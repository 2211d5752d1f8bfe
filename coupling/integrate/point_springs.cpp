#include "coupling/integrate/point_springs.h"

#include <Eigen/LU>

namespace scree::coupling {

std::vector<PointSpring> point_springs(const Setup& setup, const State& state) {
  const Model& model = setup.model();
  std::vector<PointSpring> springs;
  for (std::size_t i = 0; i < model.point_supports.size(); ++i) {
    const PointSupport& support = model.point_supports[i];
    const auto index = support.block.index();
    const Body& b = setup.bodies()[index];
    if (b.driven) continue;  // held whole already
    const Elasticity law = model.elasticity_of(support.block);
    const double k = support.stiffness ? *support.stiffness : 10.0 * law.p_modulus();
    // Material point: from where the model first had it to the present reference shape.
    const ReferenceShape& shape = state.bodies[index].shape;
    const AffineMotion map = affine_fit(shape.origin, shape.outline);
    PointSpring s;
    s.body = static_cast<std::int32_t>(index);
    s.row = setup.global(b, setup.pool_of(b).row_at(b.index, map.c + map.F * support.point));
    if (!setup.applies({&s.row, 1})) continue;
    s.support = static_cast<std::int32_t>(i);
    s.anchor = support.point;
    if (!state.anchors.empty()) s.anchor += Vec2(state.anchors[2 * i], state.anchors[2 * i + 1]);
    s.k = {support.fix_x ? k : 0.0, support.fix_y ? k : 0.0};
    springs.push_back(s);
  }
  return springs;
}

void keep_elongations(const std::vector<PointSpring>& before, std::span<const double> q_before, const Setup& to,
                      const std::vector<char>& changed, State& state) {
  const std::vector<PointSpring> now = point_springs(to, state);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (changed[static_cast<std::size_t>(now[i].body)] == 0) continue;
    state.anchors.resize(2 * to.model().point_supports.size(), 0.0);
    const Vec2 shift =
        position(now[i].row, state.q) - now[i].anchor - position(before[i].row, q_before) + before[i].anchor;
    const auto at = 2 * static_cast<std::size_t>(now[i].support);
    state.anchors[at] += shift.x();
    state.anchors[at + 1] += shift.y();
  }
}

}  // namespace scree::coupling
