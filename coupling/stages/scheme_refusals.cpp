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
    refuse("local damping acts on the unbalanced force, which is not computed in every step");
  for (const Body& b : setup.bodies())
    if (!b.driven && sides[b.block.index()] == kDivided)
      refuse(fmt::format("block '{}' lies across the border of explicit_region, and cannot be divided",
                         setup.model().blocks[b.block.index()].name));
}

namespace {

[[noreturn]] void refuse_implicit(const Stage& stage, const std::string& why) {
  throw PlanError(fmt::format("stage '{}' is {}: {}", stage.name,
                              stage.integrator == Integrator::partitioned ? "partitioned" : "implicit", why));
}

void check_trapezoidal(const Stage& stage, const Model& model) {
  const auto refuse = [&](const std::string& why) { refuse_implicit(stage, "the trapezoidal scheme " + why); };
  if (stage.rest || stage.dynamics != 1.0)
    refuse("keeps accelerations from step to step and cannot set velocities to zero; use newmark = \"damped\"");
  if (stage.kinematics == Kinematics::corotational && (stage.stiffness_damping > 0.0 || !model.viscous_edges.empty()))
    refuse("supports stiffness damping and viscous edges with kinematics = \"linear\" only");
  if (!model.bolts.empty()) refuse("does not support bolts and liners; use newmark = \"damped\"");
  if (!stage.construction.absent.empty()) refuse("does not support excavation; use newmark = \"damped\"");
  if (!model.waters.empty()) refuse("has no contacts, and so no water in joints; use newmark = \"damped\"");
}

}  // namespace

void check_implicit(const Stage& stage, const Setup& setup, std::span<const char> explicit_side) {
  const bool partitioned = stage.integrator == Integrator::partitioned;
  const auto refuse = [&](const std::string& why) { refuse_implicit(stage, why); };
  const bool trapezoidal = stage.newmark == NewmarkScheme::trapezoidal;
  if (partitioned && stage.rotation == BlockRotation::first_order)
    refuse("explicit blocks have no rotation of first order");
  if (partitioned && (trapezoidal || stage.rest))
    refuse("its implicit blocks take newmark = \"damped\", and it cannot run to rest");
  if (trapezoidal) check_trapezoidal(stage, setup.model());
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
