// Small models built in code, and their runs.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "coupling/stages/driver.h"

namespace scree::test {

inline constexpr double kDegree = std::numbers::pi / 180.0;

inline Polygon rectangle(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

/// A model of one material and one joint law, blocks added one by one.
struct Scene {
  Model model;
  coupling::Plan plan;

  explicit Scene(double young = 1e9, double poisson = 0.2, double density = 2600.0, double friction_deg = 30.0) {
    model.materials.push_back({"rock", density, young, poisson});
    JointLaw law;
    law.name = "joint";
    law.friction = friction_deg * kDegree;
    model.joints.push_back(law);
    model.default_joint = JointId{0};
  }
  BlockId add(std::string name, Polygon polygon, bool fixed = false) {
    Block b;
    b.name = std::move(name);
    b.polygon = std::move(polygon);
    orient(b.polygon);
    b.material = MaterialId{0};
    b.joint = JointId{0};
    model.blocks.push_back(b);
    const BlockId id{static_cast<std::int32_t>(model.blocks.size()) - 1};
    if (fixed) model.block_supports.push_back({id, MotionId{}});
    return id;
  }
  coupling::Stage& stage(const std::string& method, coupling::Integrator integrator, double duration,
                         std::optional<double> dt, double cover_size = 0.5) {
    coupling::Stage s;
    s.name = method + std::to_string(plan.stages.size());
    s.method = method;
    s.integrator = integrator;
    s.duration = ticks(duration);
    s.dt = dt;
    s.cover_size = cover_size;
    plan.stages.push_back(s);
    if (plan.output.every == 0) plan.output.every = plan.output.history_every = ticks(duration / 10);
    return plan.stages.back();
  }
};

/// Momenta and energies of a body in a state.
inline BodyTotals totals_of(const coupling::Setup& setup, const coupling::State& state, const coupling::Body& b) {
  const auto p = static_cast<std::size_t>(b.pool);
  return setup.pool_of(b).totals(b.index, setup.part(std::span<const double>(state.q), p),
                                 setup.part(std::span<const double>(state.v), p));
}
inline BodyTotals totals_of(const coupling::Driver& run, BlockId id) {
  return totals_of(run.setup(), run.state(), run.setup().bodies()[id.index()]);
}

/// Centroid of a block in the current state of a run.
inline Vec2 centre_of(const coupling::Driver& run, BlockId id) { return totals_of(run, id).centre; }

}  // namespace scree::test
