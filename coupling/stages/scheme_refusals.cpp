#include "coupling/stages/scheme_refusals.h"

#include <fmt/format.h>

#include <string>

#include "coupling/stages/driver.h"

namespace scree::coupling {

void check_subcycled(const Stage& stage, const Setup& setup, std::span<const char> sides) {
  const auto refuse = [&](const std::string& why) {
    throw PlanError(fmt::format("stage '{}' has explicit steps of two sizes: {}", stage.name, why));
  };
  if (stage.rest) refuse("it cannot run to rest");
  if (stage.local_damping > 0.0)
    refuse("local damping acts on the unbalanced force, which it does not have at every instant");
  for (const Body& b : setup.bodies())
    if (!b.driven && sides[b.block.index()] == kDivided)
      refuse(fmt::format("block '{}' lies across the border of explicit_region, and cannot be divided",
                         setup.model().blocks[b.block.index()].name));
}

void check_implicit(const Stage& stage, const Setup& setup, std::span<const char> explicit_side) {
  const bool partitioned = stage.integrator == Integrator::partitioned;
  const auto refuse = [&](const std::string& why) {
    throw PlanError(fmt::format("stage '{}' is {}: {}", stage.name, partitioned ? "partitioned" : "implicit", why));
  };
  const bool trapezoidal = stage.newmark == NewmarkScheme::trapezoidal;
  if (partitioned && stage.rotation == BlockRotation::first_order)
    refuse("explicit blocks have no rotation of first order");
  if (partitioned && (trapezoidal || stage.rest))
    refuse("its implicit blocks take newmark = \"damped\", and it cannot run to rest");
  if (trapezoidal && (stage.rest || stage.dynamics != 1.0))
    refuse("the trapezoidal scheme carries accelerations along and cannot drop velocities; use newmark = \"damped\"");
  if (trapezoidal && stage.kinematics == Kinematics::corotational &&
      (stage.stiffness_damping > 0.0 || !setup.model().viscous_edges.empty()))
    refuse("the trapezoidal scheme takes stiffness damping and viscous edges with kinematics = \"linear\" only");
  if (trapezoidal && !setup.model().bolts.empty())
    refuse("the trapezoidal scheme has no bolts and no liners; use newmark = \"damped\"");
  if (trapezoidal && !stage.construction.absent.empty())
    refuse("the trapezoidal scheme has no excavation; use newmark = \"damped\"");
  if (trapezoidal && !setup.model().waters.empty())
    refuse("the trapezoidal scheme has no contacts, and so no water in joints; use newmark = \"damped\"");
  for (const Body& b : setup.bodies()) {
    if (b.driven || (partitioned && explicit_side[b.block.index()] != 0)) continue;
    const Pool& pool = setup.pool_of(b);
    const std::string block = setup.model().blocks[b.block.index()].name;
    if (const std::string obstacle = pool.implicit_obstacle(b.index); !obstacle.empty())
      refuse(fmt::format("block '{}': {}", block, obstacle));
    if (pool.dofs(b.index) == 0)
      refuse(fmt::format("block '{}' uses the method {}, which is explicit only", block, pool.method()));
    if (trapezoidal && !pool.constant_chart(b.index))
      refuse(
          fmt::format("block '{}' uses the method {}, whose unknowns turn with the block from step to step; the "
                      "trapezoidal scheme needs rotation = \"affine\", or the NMM",
                      block, pool.method()));
  }
}

}  // namespace scree::coupling
