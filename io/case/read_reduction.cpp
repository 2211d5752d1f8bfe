// [reduction]: replaces stages of a case by stages in which the strength of its joints is reduced.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "coupling/bodies/joint_laws.h"
#include "io/case/read_parts.h"
#include "io/case/suggest.h"
#include "model/elasticity.h"
#include "model/free_field.h"

namespace scree::io {
namespace {

using coupling::Integrator;
using coupling::Stage;

constexpr double kStepRatio = 0.01;     // largest relative change of the factor per static step
constexpr double kLeastSteps = 20.0;    // least number of steps of the stage that reduces
constexpr double kSettleSteps = 400.0;  // most static steps to find balance
constexpr double kBalanced = 1e-6;      // unbalanced force at rest over the largest force
constexpr double kLimit = 5e-3;         // displacement that ends a stage, over the root area of the smallest free block
constexpr double kSettleWay = 4.0;      // displacement allowed until balance is found, in limits: joints take up slip
constexpr double kTraverses = 2.0;      // traverses of a wave of sqrt(E/rho) through the free blocks per static step

/// Quantities from which the defaults of absent settings follow.
struct Scale {
  double block = INFINITY;  // root area of the smallest free block [m]
  double extent = 0.0;      // of the free blocks [m]
  double speed = INFINITY;  // smallest sqrt(E/rho) in them [m/s]
};

Scale scale_of(const Section& r, const Model& model, const std::vector<char>& absent) {
  Scale out;
  Box box;
  bool first = true;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const BlockId id{static_cast<std::int32_t>(b)};
    if (model.support_of(id) != nullptr || absent[b] != 0) continue;
    const Box own = bounds(model.blocks[b].polygon);
    box.lo = first ? own.lo : Vec2(box.lo.cwiseMin(own.lo));
    box.hi = first ? own.hi : Vec2(box.hi.cwiseMax(own.hi));
    first = false;
    out.block = std::min(out.block, std::sqrt(moments(model.blocks[b].polygon).area));
    const Material& m = model.material_of(id);
    out.speed = std::min(out.speed, std::sqrt(m.young / m.density));
  }
  if (first)
    throw r.error("joints", "no block is free: nothing can fail", "a model with free blocks",
                  "leave a block unsupported");
  out.extent = (box.hi - box.lo).maxCoeff();
  return out;
}

/// Changes the integrator of a stage to rest: to explicit steps of the step bound, or implicit static steps of dt.
void integrate(Stage& s, Integrator integrator, double dt) {
  if (s.integrator == integrator) return;
  s.integrator = integrator;
  s.rest_steps = 0;
  s.mass.reset();
  if (integrator == Integrator::implicit)
    s.dt = dt;
  else
    s.dt.reset();
}

/// The leading stages to rest; if there are none, one that is made here.
std::vector<Stage> rest_stages(const Section& r, const Section& root, const coupling::Plan& plan, double dt) {
  std::vector<Stage> out;
  for (const Stage& s : plan.stages) {
    if (!s.rest) break;
    out.push_back(s);
  }
  if (out.empty()) {
    Stage s = plan.stages.front();
    s.name = "rest";
    s.rest = true;
    s.dynamics = 1.0;
    s.rest_steps = 5000;
    s.end = {};
    s.change = {};
    s.partition = {};
    if (s.integrator == Integrator::partitioned) s.integrator = Integrator::implicit;
    s.dt = s.integrator == Integrator::implicit ? std::optional(dt) : std::nullopt;
    s.duration = ticks(s.integrator == Integrator::implicit ? 5000.0 * dt : 1e3 * dt);
    out.push_back(std::move(s));
  }
  Stage& last = out.back();
  if (last.integrator == Integrator::partitioned)
    throw root.list("stage").front().error("rest", "a stage to rest cannot be partitioned", "explicit or implicit", "");
  if (r.has("rest_integrator"))
    for (Stage& s : out)
      integrate(s, r.text("rest_integrator") == "implicit" ? Integrator::implicit : Integrator::explicit_, dt);
  if (!(last.rest_force > 0.0)) last.rest_force = r.number("rest_force");
  return out;
}

/// What the stages after the rest have in common.
Stage stage_of(const Section& r, const Section& root, const Stage& rest, const std::vector<std::string>& methods,
               const Model& model, double dt) {
  Stage s = rest;
  s.end = {};
  s.rest_steps = 0;
  s.rest_force = 0.0;
  s.construction.release.reset();  // it is complete
  s.construction.release_time = 0;
  if (r.has("method")) {
    (void)find_name(r, "method", "method", methods);
    s.method = r.text("method");
    s.rules.clear();
    if (s.method == "nmm" && !(s.cover_size > 0.0)) {
      const Section m = root.table("model");
      if (m.has("cover_size")) s.cover_size = m.number("cover_size");
      const bool all =
          std::all_of(model.blocks.begin(), model.blocks.end(), [](const Block& b) { return b.cover_size > 0.0; });
      if (!(s.cover_size > 0.0) && !all)
        throw r.error("method", "the NMM needs the size of its covers, and no cover_size is given",
                      "cover_size in [model] or in the stage to rest", "--set model.cover_size=1, for example");
    }
  }
  if (r.has("integrator"))
    s.integrator = r.text("integrator") == "implicit" ? Integrator::implicit : Integrator::explicit_;
  if (s.integrator == Integrator::implicit)
    s.dt = dt;
  else
    s.dt.reset();
  if (s.mass && ((s.integrator == Integrator::implicit) == (*s.mass == MassKind::affine_exact))) s.mass.reset();
  return s;
}

/// Removes what depends on later stages: motions, loads that have not begun, bolts that are not installed yet.
void drop_later(Model& model, std::size_t kept) {
  for (BlockSupport& s : model.block_supports) s.motion = {};
  for (ViscousEdge& e : model.viscous_edges) e.motion = {};
  model.motions.clear();
  const auto later = [&](FunctionId f) {
    if (!f.valid()) return false;
    if (of_free_field(model, f)) return true;  // removed like the motions
    const StageId stage = model.functions[f.index()].stage;
    return stage.valid() && stage.index() >= kept;
  };
  const auto drop = [&](auto& loads) { std::erase_if(loads, [&](const auto& load) { return later(load.function); }); };
  drop(model.point_loads);
  drop(model.tractions);
  drop(model.body_accelerations);
  std::erase_if(model.bolts, [kept](const Bolt& b) { return b.stage.valid() && b.stage.index() >= kept; });
  for (TimeFunction& f : model.functions)
    if (f.stage.valid() && f.stage.index() >= kept) {
      f = TimeFunction{};  // nothing uses it any more
      f.stage = {};
    }
}

std::vector<JointId> joints_of(const Section& r, const Model& model) {
  std::vector<JointId> out;
  const std::vector<std::string> known = names_of(model.joints);
  if (!r.has("joints")) {
    for (std::size_t j = 0; j < known.size(); ++j) out.emplace_back(static_cast<std::int32_t>(j));
    return out;
  }
  std::set<std::int32_t> chosen;
  for (std::size_t i = 0; i < r.texts("joints").size(); ++i)
    for (const std::int32_t j : find_names(r, "joints", i, "joint", known)) chosen.insert(j);
  for (const std::int32_t j : chosen) out.emplace_back(j);
  if (out.empty())
    throw r.error("joints", "the list of joint laws is empty", "names of joint laws", "name one, or leave it out");
  return out;
}

}  // namespace

void read_reduction(const Section& root, std::span<const std::string> methods, Model& model, coupling::Plan& plan) {
  if (!root.has("reduction")) return;
  const Section r = root.table("reduction");
  const auto first = plan.stages.begin();
  const auto after = std::find_if(first, plan.stages.end(), [](const Stage& s) { return !s.rest; });
  const Scale scale = scale_of(r, model, (after == first ? first : after - 1)->construction.flags(model.blocks.size()));
  const double dt = r.has("dt") ? r.number("dt") : kTraverses * scale.extent / scale.speed;
  const double limit = r.has("limit") ? r.number("limit") : kLimit * scale.block;
  r.settle("dt", dt);
  r.settle("limit", limit);
  const double start = r.number("start"), tilt = r.number("k_h");
  const std::vector<JointId> joints = joints_of(r, model);
  if (r.text("strength") == "peak")
    for (const JointId j : joints) model.joints[j.index()] = coupling::without_weakening(model.joints[j.index()]);
  const coupling::StrengthPlan::Part part = r.text("what") == "friction"   ? coupling::StrengthPlan::Part::friction
                                            : r.text("what") == "cohesion" ? coupling::StrengthPlan::Part::cohesion
                                                                           : coupling::StrengthPlan::Part::all;
  model.gravity.x() += tilt * std::abs(model.gravity.y());

  std::vector<Stage> stages = rest_stages(r, root, plan, dt);
  drop_later(model, stages.size());
  for (Stage& s : stages) s.strength = {joints, part, start, start};
  if (r.has("factor")) {
    const double factor = r.number("factor");
    const Stage common = stage_of(r, root, stages.back(), {methods.begin(), methods.end()}, model, dt);
    const bool implicit = common.integrator == Integrator::implicit;
    const double steps = std::max(kLeastSteps, std::ceil(std::abs(std::log(factor / start)) / kStepRatio));
    const auto add = [&](const char* name, double duration, double from) -> Stage& {
      Stage& s = stages.emplace_back(common);
      s.name = name;
      s.duration = ticks(duration);
      s.strength = {joints, part, from, factor};
      s.end.displacement = limit;
      return s;
    };
    add("reduction", steps * dt * (implicit ? 1.0 : 4.0), start);
    Stage& settling = add("settling", kSettleSteps * dt, factor);
    settling.end.force_below = kBalanced;
    settling.end.displacement = kSettleWay * limit;
    Stage& hold = add("hold", r.number("hold"), factor);
    hold.rest = false;
    if (implicit) hold.dt = std::min(dt, r.number("hold") / 200.0);
    hold.end.force_below = implicit ? kBalanced : 100.0 * kBalanced;
    hold.end.hold = ticks(r.number("hold") / 50.0);
  }
  plan.stages = std::move(stages);
  const Tick every = r.has("factor") ? ticks(r.number("hold") / 25.0) : plan.stages.back().duration / 200;
  plan.output.every = plan.output.history_every = std::max<Tick>(every, 1);
  plan.output.contacts = true;
}

}  // namespace scree::io
