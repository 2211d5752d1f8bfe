#include "coupling/contact/law/joint_springs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::coupling {
namespace {

constexpr double kCornerLength = 0.1;  // of the smaller block's root area

/// Extent of a block along a direction [m].
double width_of(const Polygon& block, const Vec2& direction) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec2& x : block.outer) {
    low = std::min(low, direction.dot(x));
    high = std::max(high, direction.dot(x));
  }
  return high - low;
}

}  // namespace

JointSprings::JointSprings(const Setup& setup) : setup_(&setup) {
  const Model& model = setup.model();
  std::vector<double> root_area;  // of the bodies: an outline may have many edges
  for (const Body& b : setup.bodies())
    root_area.push_back(std::sqrt(moments(model.blocks[b.block.index()].polygon).area));
  for (const Outlines::Edge& e : setup.outlines().edges) {
    const BlockId id = setup.body(e.body).block;
    const Polygon& block = model.blocks[id.index()].polygon;
    width_.push_back(width_of(block, Vec2(e.along.y(), -e.along.x())));
    modulus_over_width_.push_back(model.elasticity_of(id).p_modulus() / width_.back());
    root_area_.push_back(root_area[e.body.index()]);
    joint_.push_back(e.joint);
  }
}

double JointSprings::corner_length(JointId id, EdgeIndex edge_a, EdgeIndex edge_b) const {
  if (law(id).contact_length > 0.0) return law(id).contact_length;
  return kCornerLength * std::min(root_area_[edge_a], root_area_[edge_b]);
}

}  // namespace scree::coupling
