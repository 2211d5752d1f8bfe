#include "coupling/integrate/point_springs.h"

#include <Eigen/LU>

namespace scree::coupling {

std::vector<PointSpring> point_springs(const Setup& setup, const State& state) {
  const Model& model = setup.model();
  std::vector<PointSpring> springs;
  for (const PointSupport& support : model.point_supports) {
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
    s.anchor = support.point;
    s.k = {support.fix_x ? k : 0.0, support.fix_y ? k : 0.0};
    springs.push_back(s);
  }
  return springs;
}

}  // namespace scree::coupling
