#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "coupling/contact/law/friction_laws.h"
#include "io/case/read_parts.h"
#include "io/case/suggest.h"

namespace scree::io {
namespace {

void read_strength(const Section& s, JointLaw& law) {
  const auto radians = [&s](std::string_view key) { return s.number(key) * std::numbers::pi / 180.0; };
  law.friction = radians("friction_deg");
  law.cohesion = s.number("cohesion");
  law.residual_cohesion = s.number("residual_cohesion");
  law.tensile_strength = s.number_or_unlimited("tensile_strength");
  law.weakening_slip = s.number("weakening_slip");
  if (s.has("residual_friction_deg")) {
    if (s.number("residual_friction_deg") > s.number("friction_deg"))
      throw s.error("residual_friction_deg", "the friction would grow with failure",
                    fmt::format("0 <= value <= {:g}, the friction_deg of the joint", s.number("friction_deg")),
                    "friction_deg is the angle before failure, residual_friction_deg the one after it");
    law.residual_friction = radians("residual_friction_deg");
  } else if (law.weakening_slip > 0.0) {
    throw s.error("weakening_slip", "a weakening_slip without a residual_friction_deg to fall to",
                  "weakening_slip [m] beside residual_friction_deg", "add residual_friction_deg = ...");
  }
  if (law.residual_cohesion > law.cohesion)
    throw s.error("residual_cohesion", "the cohesion would grow with failure",
                  fmt::format("0 <= value <= {:g}, the cohesion of the joint [Pa]", law.cohesion),
                  "cohesion is the one before failure, residual_cohesion the one after it");
  // At f_n = -c / tan(phi) any shear force causes slip: a higher tensile strength would never be reached.
  const double pull = law.tensile_strength, shear = pull * std::tan(law.friction);
  if (std::isfinite(pull) && pull > 0.0 && (law.cohesion == 0.0 || shear > law.cohesion * (1.0 + 1e-12)))
    throw s.error("tensile_strength", "Coulomb's line ends before the tensile strength: the joint would slip first",
                  law.cohesion == 0.0 ? "\"unlimited\" or 0, without a cohesion"
                                      : fmt::format("\"unlimited\" or number [Pa], >= 0, <= cohesion / "
                                                    "tan(friction_deg) = {:g}",
                                                    law.cohesion / std::tan(law.friction)),
                  fmt::format("give the joint a cohesion of at least {:g} Pa, or a smaller tensile_strength; "
                              "\"unlimited\" never fails",
                              shear));
}

void read_dilation(const Section& s, JointLaw& law) {
  law.dilation = s.number("dilation_deg") * std::numbers::pi / 180.0;
  if (s.has("dilation_slip")) law.dilation_slip = s.number("dilation_slip");
  if (law.dilation == 0.0) {
    if (law.dilation_slip)
      throw s.error("dilation_slip", "a dilation_slip without a dilation_deg", "dilation_slip [m] beside dilation_deg",
                    "add dilation_deg = ...");
    return;
  }
  // Lifting takes its work from friction: with dilation above friction, sliding would create energy.
  double least = law.friction;
  if (law.residual_friction) {
    const double lost =
        !law.dilation_slip || law.weakening_slip == 0.0 ? 1.0 : std::min(1.0, *law.dilation_slip / law.weakening_slip);
    least = std::atan(std::tan(law.friction) + lost * (std::tan(*law.residual_friction) - std::tan(law.friction)));
  }
  if (law.friction_law != nullptr)
    least = std::atan(law.friction_law->least(std::tan(law.friction), law.friction_constants));
  constexpr double kRounding = 1e-12;
  if (law.dilation > least * (1.0 + kRounding))
    throw s.error("dilation_deg", "the joint would open by more than its friction can lift",
                  fmt::format("0 <= value <= {:.4g}, the least friction angle while it dilates",
                              least * 180.0 / std::numbers::pi),
                  law.residual_friction || law.friction_law != nullptr
                      ? "give a smaller dilation_deg, or a dilation_slip that ends dilation before the friction has "
                        "fallen that far"
                      : "dilation angles of rock joints are below their friction angle: give a "
                        "smaller one");
}

void read_friction_law(const Section& s, JointLaw& law) {
  for (const FrictionLaw& known : coupling::friction_laws()) {
    if (!s.has(known.name)) continue;
    if (law.friction_law != nullptr)
      throw s.error(known.name, "the joint has two laws of friction", "one of them",
                    fmt::format("remove this table or {}", law.friction_law->name));
    if (law.residual_friction)
      throw s.error(known.name, "the joint has a law of friction and a residual_friction_deg", "one of them",
                    fmt::format("remove residual_friction_deg: {} changes the friction", known.name));
    const Section table = s.table(known.name);
    law.friction_law = &known;
    for (const NumberKey& key : known.keys) law.friction_constants.push_back(table.number(key.name));
    if (const std::string wrong = known.fault(std::tan(law.friction), law.friction_constants); !wrong.empty())
      throw s.error(known.name, wrong, known.meaning, "`scree schema` explains each key");
  }
}

JointLaw joint_law(const Section::Named& named) {
  const Section& s = named.section;
  JointLaw law;
  law.name = named.name;
  read_strength(s, law);
  read_friction_law(s, law);
  read_dilation(s, law);
  if (s.has("contact_length")) law.contact_length = s.number("contact_length");
  law.normal_stiffness = s.number_or_auto("normal_stiffness");
  law.shear_stiffness = s.number_or_auto("shear_stiffness");
  if (s.has("penalty")) law.penalty = s.number("penalty");
  if (s.has("shear_penalty")) law.shear_penalty = s.number("shear_penalty");
  if (law.penalty && (law.normal_stiffness || law.shear_stiffness))
    throw s.error("penalty", "the joint has a stiffness per area and a penalty per contact",
                  "normal_stiffness and shear_stiffness [Pa/m], or penalty and shear_penalty [N/m]",
                  "keep one of the two: joints that share their overlap take a stiffness per area");
  if (law.shear_penalty && !law.penalty)
    throw s.error("shear_penalty", "a shear_penalty without a penalty", "penalty and shear_penalty [N/m] together",
                  "give the penalty as well, or use shear_stiffness [Pa/m]");
  law.damping = s.number("damping");
  return law;
}

InitialStress initial_stress(const Section& s) {
  const auto tensor = [&s](const std::string& prefix) {
    const double xy = s.number(prefix + "xy");
    return (Mat2() << s.number(prefix + "xx"), xy, xy, s.number(prefix + "yy")).finished();
  };
  InitialStress stress{tensor(""), tensor("gradient_"), 0.0};
  const bool grows = stress.gradient != Mat2::Zero();
  if (grows && !s.has("level"))
    throw s.error("level", "the stress grows with depth, but the level of zero depth is missing", "number [m]",
                  "add level = ..., the y at which the stress is xx, yy, xy");
  if (!grows && s.has("level"))
    throw s.error("level", "the stress is constant: it has no level", "a level beside a gradient",
                  "remove level, or add gradient_xx and gradient_yy");
  if (grows) stress.level = s.number("level");
  return stress;
}

MohrCoulombStrength mohr_coulomb(const Section& s) {
  for (const char* key : {"cohesion", "friction_deg"})
    if (!s.has(key))
      throw s.error(key, "a Mohr-Coulomb strength needs cohesion and friction_deg", "both [Pa], [deg]",
                    fmt::format("add {} = ...", key));
  const double cohesion = s.number("cohesion"),
               tan_friction = std::tan(s.number("friction_deg") * std::numbers::pi / 180.0);
  const double apex = tan_friction > 0.0 ? cohesion / tan_friction : std::numeric_limits<double>::infinity();
  const double tension = s.has("tension") ? s.number("tension") : apex;
  if (tension > apex * (1.0 + 1e-12))
    throw s.error("tension", "the envelope of cohesion and friction_deg ends before the tension",
                  fmt::format("0 <= value <= {:g}, cohesion / tan(friction_deg) [Pa]", apex),
                  "leave it out to use that value");
  return {cohesion, std::atan(tan_friction), std::min(tension, apex)};
}

RockStrength rock_strength(const Section& s) {
  const auto any = [&s](std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (s.has(key)) return key;
    return static_cast<const char*>(nullptr);
  };
  const char *mohr = any({"cohesion", "friction_deg", "tension"}), *hoek = any({"ucs", "gsi", "mi"});
  if (mohr != nullptr && hoek != nullptr)
    throw s.error(hoek, "the rock has a strength of Mohr-Coulomb and one of Hoek and Brown", "one of the two",
                  "keep cohesion, friction_deg and tension, or ucs, gsi, mi and d");
  if (mohr == nullptr && hoek == nullptr)
    throw s.error("cohesion", "the rock_strength is empty", "cohesion and friction_deg, or ucs, gsi and mi",
                  "add cohesion = ... and friction_deg = ...");
  if (mohr != nullptr) return mohr_coulomb(s);
  for (const char* key : {"ucs", "gsi", "mi"})
    if (!s.has(key))
      throw s.error(key, "a strength of Hoek and Brown needs ucs, gsi and mi", "all three; d is 0 where it is left out",
                    fmt::format("add {} = ...", key));
  return HoekBrownStrength::of_rock_mass(s.number("ucs"), s.number("gsi"), s.number("mi"), s.number("d"));
}

Material material(const Section::Named& named) {
  const Section& s = named.section;
  Material m{named.name, s.number("density"), s.number("young"), s.number("poisson")};
  if (s.has("initial_stress")) m.initial_stress = initial_stress(s.table("initial_stress"));
  if (s.has("rock_strength")) m.rock_strength = rock_strength(s.table("rock_strength"));
  return m;
}

}  // namespace

void read_laws(const Section& root, Model& model) {
  const Section m = root.table("model");
  model.title = root.text("title");
  model.plane = m.text("plane") == "strain" ? Plane::strain : Plane::stress;
  model.gravity = m.point("gravity");
  for (const Section::Named& named : root.named("material")) model.materials.push_back(material(named));
  for (const Section::Named& named : root.named("joint")) model.joints.push_back(joint_law(named));

  if (m.has("default_joint")) {
    model.default_joint = JointId{find_name(m, "default_joint", "joint", names_of(model.joints))};
  } else if (model.joints.size() > 1) {
    throw m.error("default_joint", "several joints are defined and none is the default", listed(names_of(model.joints)),
                  "add default_joint = " + in_quotes(model.joints.front().name) + " (or another) to [model]");
  } else {
    if (model.joints.empty()) {
      JointLaw smooth;
      smooth.name = "smooth";
      model.joints.push_back(smooth);
    } else {
      m.settle("default_joint", model.joints.front().name);
    }
    model.default_joint = JointId{0};
  }
}

}  // namespace scree::io
