#include "io/results/joints_writer.h"

#include <numbers>
#include <string>
#include <vector>

#include "io/results/h5_series.h"

namespace scree::io {
namespace {

/// Columns of straight pieces: their ends and laws.
struct Pieces {
  std::vector<double> from, to;
  std::vector<std::int32_t> joint;

  template <class Piece>
  explicit Pieces(const std::vector<Piece>& pieces) {
    for (const Piece& p : pieces) {
      from.insert(from.end(), {p.from.x(), p.from.y()});
      to.insert(to.end(), {p.to.x(), p.to.y()});
      joint.push_back(p.joint.value);
    }
  }
  void write(const h5::File& file, const std::string& group, const std::string& what) const {
    h5::write<double>(file, group + "/from", 2, from, {"m", "x, y of one end of " + what});
    h5::write<double>(file, group + "/to", 2, to, {"m", "x, y of the other end of " + what});
    h5::write<std::int32_t>(file, group + "/joint", 1, joint, {"1", "law, counted from 0 in /joints/name"});
  }
};

}  // namespace

void write_joints(const h5::File& file, const Model& model) {
  std::vector<std::string> names;
  std::vector<double> friction, cohesion, tension, residual_friction, residual_cohesion, slip, dilation, dilating_slip;
  for (const JointLaw& law : model.joints) {
    names.push_back(law.name);
    friction.push_back(law.friction * 180.0 / std::numbers::pi);
    cohesion.push_back(law.cohesion);
    tension.push_back(law.tensile_strength);
    residual_friction.push_back(law.residual_friction.value_or(law.friction) * 180.0 / std::numbers::pi);
    residual_cohesion.push_back(law.residual_cohesion);
    slip.push_back(law.weakening_slip);
    dilation.push_back(law.dilation * 180.0 / std::numbers::pi);
    dilating_slip.push_back(law.dilation_slip.value_or(0.0));
  }
  h5::write(file, "/joints/name", names, {"none", "names of the joint laws"});
  h5::write<double>(file, "/joints/friction_deg", 1, friction, {"deg", "friction angle"});
  h5::write<double>(file, "/joints/cohesion", 1, cohesion, {"Pa", "cohesion before the first failure"});

  h5::write<double>(file, "/joints/tensile_strength", 1, tension,
                    {"Pa", "of contacts closed at the start, before the first failure; infinite: they never fail"});
  h5::write<double>(file, "/joints/residual_friction_deg", 1, residual_friction,
                    {"deg", "friction angle after failure"});
  h5::write<double>(file, "/joints/residual_cohesion", 1, residual_cohesion,
                    {"Pa", "cohesion after the first failure"});
  h5::write<double>(file, "/joints/weakening_slip", 1, slip,
                    {"m", "slip over which friction falls; 0: at the first failure"});
  h5::write<double>(file, "/joints/dilation_deg", 1, dilation, {"deg", "dilation angle"});
  h5::write<double>(file, "/joints/dilation_slip", 1, dilating_slip,
                    {"m", "slip after which the joint opens no further; 0: it always does"});

  Pieces(model.joint_lines).write(file, "/joints/lines", "a straight piece of a discontinuity");
  std::vector<std::int32_t> kind, source, block;
  for (const JointLine& line : model.joint_lines) {
    kind.push_back(static_cast<std::int32_t>(line.kind));
    source.push_back(line.source);
  }
  h5::write<std::int32_t>(file, "/joints/lines/kind", 1, kind, {"1", "0 trace, 1 arc, 2 joint set"});
  h5::write<std::int32_t>(file, "/joints/lines/source", 1, source, {"1", "which trace, arc or joint set, from 0"});

  Pieces(model.cracks).write(file, "/joints/cracks", "a straight piece that ends inside a block");
  for (const Crack& crack : model.cracks) block.push_back(crack.block.value);
  h5::write<std::int32_t>(file, "/joints/cracks/block", 1, block, {"1", "block, counted from 0 in /blocks"});
}

}  // namespace scree::io
