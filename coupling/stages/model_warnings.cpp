#include "coupling/stages/model_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "model/edge_selection.h"

namespace scree::coupling {
namespace {

struct Thing {
  std::string name;
  double size = 0.0;
};

/// The least and the largest of several; false where there are none.
bool ends_of_list(const std::vector<Thing>& things, Thing& least, Thing& largest) {
  if (things.empty()) return false;
  const auto [low, high] =
      std::minmax_element(things.begin(), things.end(), [](const Thing& a, const Thing& b) { return a.size < b.size; });
  least = *low;
  largest = *high;
  return true;
}

std::vector<double> sizes_of(const Model& model) {
  std::vector<double> sizes;
  for (const Block& b : model.blocks) sizes.push_back(std::sqrt(std::max(moments(b.polygon).area, 0.0)));
  return sizes;
}

}  // namespace

std::vector<std::string> stiffness_warnings(const Model& model) {
  std::vector<Thing> things;
  std::set<std::size_t> used;
  for (const Block& b : model.blocks) used.insert(b.material.index());
  things.reserve(used.size() + 3 * model.joints.size());
  for (const std::size_t m : used)
    things.push_back({fmt::format("Young's modulus of '{}'", model.materials[m].name), model.materials[m].young});
  const std::vector<double> sizes = sizes_of(model);
  double mean = 0.0;
  for (const double s : sizes) mean += s / static_cast<double>(sizes.size());
  for (const JointLaw& j : model.joints) {
    if (j.normal_stiffness)
      things.push_back(
          {fmt::format("normal_stiffness of joint '{}' on a block's width", j.name), *j.normal_stiffness * mean});
    if (j.penalty) things.push_back({fmt::format("penalty of joint '{}'", j.name), *j.penalty});
  }
  for (const PointSupport& s : model.point_supports)
    if (s.stiffness)
      things.push_back({fmt::format("stiffness of a supported point of block '{}'", model.blocks[s.block.index()].name),
                        *s.stiffness});
  for (const EdgeSupport& s : model.edge_supports)
    if (s.bedding)
      things.push_back({fmt::format("bedding of an edge of block '{}'", model.blocks[s.span.block.index()].name),
                        *s.bedding * length_of(model, s.span)});
  Thing least, largest;
  if (!ends_of_list(things, least, largest) || !(largest.size > kFarStiffness * least.size)) return {};
  return {fmt::format(
      "stiffness ratio {:.2g}: the {} is {:.3g} Pa, the {} is {:.3g} Pa; implicit steps lose accuracy and explicit "
      "ones become short",
      largest.size / least.size, largest.name, largest.size, least.name, least.size)};
}

std::vector<std::string> size_warnings(const Model& model) {
  std::vector<Thing> things;
  const std::vector<double> sizes = sizes_of(model);
  for (std::size_t i = 0; i < sizes.size(); ++i) things.push_back({model.blocks[i].name, sizes[i]});
  Thing least, largest;
  if (!ends_of_list(things, least, largest) || !(largest.size > kFarSizes * least.size)) return {};
  return {fmt::format(
      "blocks are of very different sizes: '{}' is {:.3g} m wide, '{}' {:.3g} m (roots of areas); contact search "
      "and springs assume blocks of similar size; least_width and least_area of a domain join small ones to their "
      "neighbours",
      largest.name, largest.size, least.name, least.size)};
}

std::vector<std::string> unit_warnings(const Model& model) {
  std::vector<std::string> out;
  std::set<std::size_t> used;
  for (const Block& b : model.blocks) used.insert(b.material.index());
  for (const std::size_t i : used) {
    const Material& m = model.materials[i];
    if (m.density < kLightest || m.density > kHeaviest)
      out.push_back(fmt::format(
          "the density of '{}' is {:.4g} kg/m3, and that of rock is 1500 to 4500; a number in another unit is written "
          "with it, as \"2.6 t/m3\"",
          m.name, m.density));
    if (m.young < kSoftest)
      out.push_back(fmt::format(
          "Young's modulus of '{}' is {:.4g} Pa, and that of rock is 1e8 to 1e11; a number in another unit is written "
          "with it, as \"25 GPa\"",
          m.name, m.young));
  }
  return out;
}

std::vector<std::string> weight_warnings(const Model& model) {
  constexpr double kSame = 0.02;  // of gravity: 9.81 and 9.8 m/s2 are meant as the same
  const Vec2 g = model.gravity;
  std::vector<std::string> out;
  for (const BodyAcceleration& b : model.body_accelerations) {
    using Shape = TimeFunction::Shape;
    const Shape shape = b.function.valid() ? model.functions[b.function.index()].shape : Shape::constant;
    const bool lasts = shape == Shape::constant || shape == Shape::ramp;
    if (!lasts || g.norm() == 0.0 || (b.acceleration - g).norm() > kSame * g.norm()) continue;
    out.push_back(
        fmt::format("a body acceleration of ({:g}, {:g}) m/s2 acts in addition to gravity, which is about the same: {} "
                    "weigh twice as much; with [model] gravity = [0, 0] it takes gravity's place",
                    b.acceleration.x(), b.acceleration.y(), b.blocks.empty() ? "all blocks" : "its blocks"));
  }
  return out;
}

std::vector<std::string> lawless_warnings(const Model& model, const std::vector<Touch>& touches) {
  const bool smooth = model.joints.size() == 1 && model.joints.front().name == "smooth" &&
                      model.joints.front().friction == 0.0 && model.joints.front().cohesion == 0.0;
  double length = 0.0;
  for (const Touch& t : touches)
    for (const Stretch& s : t.facing) length += s.length;
  if (!smooth || length == 0.0) return {};
  return {
      fmt::format("the case names no joint law: {:.4g} m of faces between blocks are smooth, without friction; add "
                  "[joint.NAME] with friction_deg",
                  length)};
}

}  // namespace scree::coupling
