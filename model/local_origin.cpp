#include "model/local_origin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {
namespace {

/// Box of all blocks; lo > hi if there are no corners.
Box box_of(const Model& model) {
  Box box{Vec2::Constant(std::numeric_limits<double>::infinity()),
          Vec2::Constant(-std::numeric_limits<double>::infinity())};
  for (const Block& block : model.blocks)
    for (const Vec2& p : block.polygon.outer) {
      box.lo = box.lo.cwiseMin(p);
      box.hi = box.hi.cwiseMax(p);
    }
  return box;
}

/// Origin of one axis.
double origin_of(double lo, double hi, double extent) {
  const double distance = std::max(lo, -hi);  // negative where zero lies between them
  if (!(distance > kFarExtents * extent)) return 0.0;
  const double unit = std::exp2(std::ceil(std::log2(extent)));
  return unit * std::round((lo + 0.5 * (hi - lo)) / unit);
}

void move(Polygon& polygon, const Vec2& by) {
  for (std::size_t r = 0; r < polygon.rings(); ++r)
    for (Vec2& p : polygon.ring(r)) p += by;
}

}  // namespace

void move_to_local_origin(Model& model) {
  const Box box = box_of(model);
  const double extent = (box.hi - box.lo).maxCoeff();
  if (!(extent > 0.0) || !std::isfinite(extent)) return;
  const Vec2 origin(origin_of(box.lo.x(), box.hi.x(), extent), origin_of(box.lo.y(), box.hi.y(), extent));
  if (origin == Vec2(0.0, 0.0)) return;

  model.origin += origin;
  for (Material& m : model.materials)
    if (m.initial_stress) m.initial_stress->level -= origin.y();
  for (Block& b : model.blocks) move(b.polygon, -origin);
  // Spans of edges are fractions: edge supports, tractions and viscous edges stay.
  for (PointSupport& s : model.point_supports) s.point -= origin;
  for (Monitor& m : model.monitors) m.point -= origin;
  for (PointLoad& l : model.point_loads) l.point -= origin;
  for (Bolt& b : model.bolts) {
    b.head -= origin;
    b.toe -= origin;
    for (Vec2& p : b.along) p -= origin;
    for (Bolt::Node& n : b.nodes) n.place -= origin;
  }
  for (JointWater& w : model.waters) {
    for (Vec2& p : w.line) p -= origin;
    for (JointWater::Level& l : w.levels)
      for (Vec2& p : l.line) p -= origin;
  }
  for (JointLine& l : model.joint_lines) {
    l.from -= origin;
    l.to -= origin;
  }
  for (Crack& c : model.cracks) {
    c.from -= origin;
    c.to -= origin;
  }
}

std::string place_text(const Vec2& x, const Vec2& origin) {
  // Four digits are enough to find a place in a model, but not for survey coordinates.
  const auto text = [](double value, double from) {
    return from == 0.0 ? fmt::format("{:.4g}", value) : fmt::format("{:.10g}", value + from);
  };
  return fmt::format("({}, {})", text(x.x(), origin.x()), text(x.y(), origin.y()));
}

}  // namespace scree
