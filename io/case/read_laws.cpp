#include <numbers>

#include "io/case/read_parts.h"
#include "io/case/suggest.h"

namespace scree::io {
namespace {

JointLaw joint_law(const Section::Named& named) {
  const Section& s = named.section;
  JointLaw law;
  law.name = named.name;
  law.friction = s.number("friction_deg") * std::numbers::pi / 180.0;
  law.cohesion = s.number("cohesion");
  if (s.has("contact_length")) law.contact_length = s.number("contact_length");
  if (law.cohesion > 0.0 && !s.has("contact_length"))
    throw s.error("contact_length", "the joint has cohesion but no contact_length", "number [m], > 0",
                  "give the length of joint that one contact point stands for, such as half the length of an edge");
  law.penalty = s.number_or_auto("penalty");
  law.shear_penalty = s.number_or_auto("shear_penalty");
  law.damping = s.number("damping");
  return law;
}

}  // namespace

void read_laws(const Section& root, Model& model) {
  const Section m = root.table("model");
  model.title = root.text("title");
  model.plane = m.text("plane") == "strain" ? Plane::strain : Plane::stress;
  model.gravity = m.point("gravity");
  for (const Section::Named& named : root.named("material"))
    model.materials.push_back(
        {named.name, named.section.number("density"), named.section.number("young"), named.section.number("poisson")});
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
