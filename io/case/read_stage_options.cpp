#include <fmt/format.h>

#include <algorithm>

#include "io/case/read_parts.h"

namespace scree::io {
namespace {

using coupling::Integrator;

/// Refuses a choice that would have no effect in this stage, which the user would not notice.
void refuse(const Section& s, std::string_view key, bool wrong, std::string problem, std::string allowed,
            std::string hint) {
  if (wrong) throw s.error(key, std::move(problem), std::move(allowed), std::move(hint));
}

void read_formulation(const Section& s, bool nmm, coupling::Stage& stage) {
  const bool implicit = stage.integrator == Integrator::implicit,
             partitioned = stage.integrator == Integrator::partitioned;
  const std::string &kinematics = s.text("kinematics"), &mass = s.text("mass");
  stage.kinematics = kinematics == "linear" ? Kinematics::linear : Kinematics::corotational;
  const bool wants_none = s.has("cracks") && !s.boolean("cracks");
  stage.cracks = !wants_none;
  refuse(s, "mass", partitioned && !stage.subcycled() && (mass == "consistent" || mass == "affine-exact"),
         fmt::format("the {} mass is one of {} steps only, and this stage has both kinds", mass,
                     mass == "consistent" ? "implicit" : "explicit"),
         "\"auto\" or \"lumped\"",
         "leave mass out: explicit blocks then use affine-exact, implicit ones consistent, which agree in mass, "
         "momenta and inertia");
  refuse(s, "mass", implicit && mass == "affine-exact",
         "the affine-exact mass is full in each block, and an implicit step needs a sparse one",
         "\"auto\", \"consistent\" or \"lumped\"", "the consistent mass is exact as well: leave mass out");
  refuse(s, "mass", !stage.has_implicit_steps() && mass == "consistent",
         "explicit steps do not solve with the consistent mass", "\"auto\", \"affine-exact\" or \"lumped\"",
         "affine-exact has the same mass, momenta and inertia: leave mass out, or set integrator = \"implicit\"");
  if (mass != "auto")
    stage.mass = mass == "consistent" ? MassKind::consistent
                 : mass == "lumped"   ? MassKind::lumped
                                      : MassKind::affine_exact;
  if (nmm) return;
  const char *problem = "no block uses the NMM in this stage", *hint = "remove the key, or set method = \"nmm\"";
  refuse(s, "kinematics", stage.kinematics != Kinematics::corotational, problem, "\"corotational\"", hint);
  refuse(s, "mass", stage.mass.has_value(), problem, "\"auto\"", hint);
  refuse(s, "cracks", s.has("cracks") && !wants_none, problem, "false", hint);
}

void read_rotation(const Section& s, bool dda, coupling::Stage& stage) {
  if (!s.has("rotation")) {
    if (dda && stage.integrator == Integrator::implicit) s.settle("rotation", "exact");
    return;
  }
  refuse(s, "rotation", !stage.has_implicit_steps(), "explicit steps of the DDA move position and gradient themselves",
         "the key in implicit stages", "remove it, or set integrator = \"implicit\"");
  refuse(s, "rotation", !dda, "no block uses the DDA in this stage", "the key in stages with the DDA",
         "remove it, or set method = \"dda\"");
  const std::string& rotation = s.text("rotation");
  refuse(s, "rotation", rotation == "first-order" && stage.integrator == Integrator::partitioned,
         "explicit blocks have no first-order rotation, and this stage has both kinds", "\"exact\" or \"affine\"",
         "set integrator = \"implicit\"");
  stage.rotation = rotation == "affine"        ? BlockRotation::affine
                   : rotation == "first-order" ? BlockRotation::first_order
                                               : BlockRotation::exact;
}

void read_damping(const Section& s, coupling::Stage& stage) {
  stage.damping = s.number("damping");
  stage.damp_rigid_motion = s.boolean("damp_rigid_motion");
  stage.stiffness_damping = s.number("stiffness_damping");
  stage.local_damping = s.number("local_damping");
  stage.sliding_damping = s.number("sliding_damping");
  refuse(s, "damp_rigid_motion", stage.damp_rigid_motion && stage.damping == 0.0, "there is no damping to apply to it",
         "true beside damping", "give damping = ... [1/s], or remove the key");
  refuse(s, "local_damping", stage.local_damping > 0.0 && stage.subcycled(),
         "local damping acts on the unbalanced force, which slow_blocks = \"explicit\" does not compute in every step",
         "0", "use damping, or slow_blocks = \"implicit\"");
  refuse(s, "local_damping", stage.local_damping > 0.0 && stage.integrator == Integrator::implicit,
         "local damping is for explicit steps only", "0 in implicit stages",
         "for a static solution by implicit steps set rest = true, or dynamics below 1");
}

void read_newmark(const Section& s, coupling::Stage& stage) {
  for (const char* key : {"newmark", "dynamics"})
    refuse(s, key, s.has(key) && !stage.has_implicit_steps(), fmt::format("{} is a setting of implicit steps", key),
           "the key in implicit stages", "remove it, or set integrator = \"implicit\"");
  if (!stage.has_implicit_steps()) return;
  if (!s.has("newmark")) s.settle("newmark", "damped");
  stage.newmark =
      s.text("newmark") == "trapezoidal" ? coupling::NewmarkScheme::trapezoidal : coupling::NewmarkScheme::damped;
  if (stage.rest) {
    refuse(s, "dynamics", s.has("dynamics") && s.number("dynamics") > 0.0,
           "rest = true sets all velocities to zero after every step", "0, or no dynamics, in stages with rest",
           "remove one of the two");
  } else if (!s.has("dynamics")) {
    s.settle("dynamics", 1.0);
  }
  if (s.has("dynamics")) stage.dynamics = s.number("dynamics");
  if (stage.integrator != Integrator::partitioned) return;
  refuse(s, "newmark", stage.newmark != coupling::NewmarkScheme::damped,
         "the trapezoidal scheme has no contacts, which connect the two kinds of blocks", "\"damped\"",
         "remove the key, or set integrator = \"implicit\"");
  refuse(s, "dynamics", stage.dynamics < 1.0, "explicit blocks keep all of their velocity", "1, or no dynamics",
         "remove the key, or set integrator = \"implicit\"");
}

void read_step(const Section& s, coupling::Stage& stage) {
  stage.force_dt = s.boolean("force_dt");
  refuse(s, "force_dt",
         stage.force_dt && stage.integrator == Integrator::partitioned && !stage.subcycled() &&
             stage.partition.substeps == 0,
         "substeps are as many as the certified bound requires, and there is nothing to force", "true beside substeps",
         "remove the key, or give substeps");
  refuse(s, "force_dt", stage.force_dt && (stage.integrator == Integrator::implicit || !stage.dt),
         "there is no explicit dt to force", "true beside a number for dt in explicit stages",
         "remove the key, or give dt");
}

void read_transfer(const Section& s, bool first, coupling::Stage& stage) {
  const double usual = stage.transfer_cap;
  const std::string& mode = s.text("transfer");
  stage.transfer = mode == "strain-rate"  ? coupling::TransferMode::strain_rate
                   : mode == "rotational" ? coupling::TransferMode::rotational
                                          : coupling::TransferMode::reservoir;
  stage.transfer_cap = s.number("transfer_cap");
  refuse(s, "transfer", stage.transfer != coupling::TransferMode::reservoir && first && !s.has("switch"),
         "no block changes method as the first stage begins", "the key in later stages", "remove it");
  refuse(s, "transfer_cap", stage.transfer_cap != usual && stage.transfer != coupling::TransferMode::strain_rate,
         "no strain rates are raised", "transfer_cap beside transfer = \"strain-rate\"",
         "add transfer = \"strain-rate\", or remove transfer_cap");
}

void read_sleep(const Section& s, coupling::Stage& stage) {
  stage.sleep = s.number("sleep");
  const bool sleeps = stage.sleep > 0.0;
  refuse(s, "sleep", sleeps && stage.integrator == Integrator::partitioned,
         "blocks on two sides of a partitioned stage do not fall asleep", "0 in partitioned stages",
         "remove the key, or set integrator = \"implicit\" or \"explicit\"");
  refuse(s, "sleep", sleeps && stage.rest, "a stage that runs to rest ends where its blocks would fall asleep",
         "0 in stages with rest", "remove one of the two");
  refuse(s, "sleep", sleeps && stage.newmark == coupling::NewmarkScheme::trapezoidal,
         "the trapezoidal scheme keeps accelerations and does not damp: nothing comes to rest", "0",
         "remove the key, or newmark = \"trapezoidal\"");
  refuse(s, "sleep", sleeps && s.has("switch"), "rules that change methods measure blocks that take steps", "0",
         "remove sleep, or the stage's table switch");
}

void read_rest(const Section& s, coupling::Stage& stage) {
  stage.rest = s.boolean("rest");
  refuse(s, "rest", stage.rest && stage.integrator == Integrator::partitioned,
         "explicit and implicit steps are brought to rest in different ways", "false in partitioned stages",
         "bring the model to rest in a stage before, with integrator = \"implicit\" or \"explicit\"");
  refuse(s, "rest_force", s.has("rest_force") && !stage.rest, "the stage is not brought to rest",
         "rest_force beside rest = true", "add rest = true, or remove rest_force");
  refuse(s, "rest_steps", s.has("rest_steps") && !s.has("rest_force"),
         "rest_force, which defines when the model is at rest, is missing", "rest_steps beside rest_force",
         "add rest_force = 1e-4, for example");
  if (s.has("rest_force")) stage.rest_force = s.number("rest_force");
  if (s.has("rest_steps")) stage.rest_steps = s.integer("rest_steps");
}

}  // namespace

void read_stage_options(const Section& s, std::span<const std::string> used, bool first, coupling::Stage& stage) {
  const auto uses = [&](const char* method) { return std::find(used.begin(), used.end(), method) != used.end(); };
  read_formulation(s, uses("nmm"), stage);
  read_rotation(s, uses("dda"), stage);
  read_step(s, stage);
  read_damping(s, stage);
  read_rest(s, stage);
  read_newmark(s, stage);
  read_sleep(s, stage);
  read_transfer(s, first, stage);
}

}  // namespace scree::io
