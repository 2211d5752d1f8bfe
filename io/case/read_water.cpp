#include <fmt/format.h>

#include <algorithm>

#include "io/case/read_parts.h"
#include "io/case/suggest.h"
#include "model/edge_selection.h"

namespace scree::io {
namespace {

std::vector<Vec2> drawn_line(const Section& s, const DrawnLayers& drawing) {
  std::vector<Chain> chains = drawing.polylines(s, "layer", "water");
  const auto fail = [&](int row, std::string problem, std::string hint) {
    return CaseError(drawing.file(), {row, 1},
                     {std::move(problem), "", "", "one line from left to right", std::move(hint)});
  };
  if (chains.size() > 1)
    throw fail(chains[1].row, "another line of water begins here",
               "put it on a layer of its own, with a [[water]] for it");
  std::vector<Vec2> points = std::move(chains[0].points);
  if (points.front().x() > points.back().x()) std::reverse(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].x() <= points[i - 1].x())
      throw fail(chains[0].row,
                 fmt::format("the line of water turns back at ({:.10g}, {:.10g}) m", points[i].x(), points[i].y()),
                 "a piezometric line has one height above each place");
  return points;
}

/// Points of a key `line`, x increasing.
std::vector<Vec2> rising(const Section& s) {
  Ring points = s.ring("line");
  for (std::size_t i = 1; i < points.size(); ++i)
    if (points[i].x() <= points[i - 1].x())
      throw s.error("line", i, fmt::format("x = {:.10g} m comes after x = {:.10g} m", points[i].x(), points[i - 1].x()),
                    fmt::format("x > {:.10g} m", points[i - 1].x()),
                    "sort the points from left to right; a piezometric line has one height above each place");
  return points;
}

std::vector<Vec2> piezometric_line(const Section& s, const DrawnLayers& drawing) {
  if (s.has("line") == s.has("layer"))
    throw s.error(s.has("line") ? "layer" : "line",
                  s.has("line") ? "line and layer are both given" : "the water has no line", "either line or layer",
                  "write line = [[x, y], [x, y]]");
  if (s.has("layer")) return drawn_line(s, drawing);
  return rising(s);
}

/// Joint laws that a section selects; refuses a law that has a piezometric line already.
std::vector<JointId> filled_joints(const Section& s, const Model& model) {
  const std::vector<std::string> known = names_of(model.joints);
  const auto take = [&](JointId joint, auto&& error) {
    if (model.water_in(joint) != nullptr)
      throw error(fmt::format("joint {} has a piezometric line already", in_quotes(known[joint.index()])));
    return joint;
  };
  const char* once = "each joint in one [[water]] section at most";
  std::vector<JointId> joints;
  if (!s.has("joints")) {
    for (std::size_t j = 0; j < known.size(); ++j)
      (void)take(JointId{static_cast<std::int32_t>(j)}, [&](std::string problem) {
        return s.error("joints", std::move(problem), once, "without the key all joints are filled: name them");
      });
    return joints;
  }
  const std::size_t count = s.texts("joints").size();
  if (count == 0)
    throw s.error("joints", "the list of joints is empty", listed(known), "name joints, or remove the key to fill all");
  for (std::size_t i = 0; i < count; ++i)
    for (const std::int32_t j : find_names(s, "joints", i, "joint", known))
      joints.push_back(take(JointId{j}, [&](std::string problem) {
        return s.error("joints", i, std::move(problem), once, "remove one of the two");
      }));
  return joints;
}

/// Piezometric lines of later stages, in the order of the stages.
std::vector<JointWater::Level> levels_of(const Section& s, const Section& root) {
  std::vector<std::string> stages;
  for (const Section& stage : root.list("stage")) stages.push_back(stage.text("name"));
  std::vector<JointWater::Level> out;
  for (const Section& l : s.list("level")) {
    const StageId stage{find_name(l, "stage", "stage", stages)};
    if (!out.empty() && stage.value <= out.back().stage.value)
      throw l.error("stage", "an earlier level begins with the same stage or a later one", "stages in their order",
                    "sort the levels by their stages");
    out.push_back({stage, rising(l)});
  }
  return out;
}

/// Stretches of outline on which a reservoir acts: those of free blocks.
std::vector<EdgeSpan> reservoir_faces(const Section& s, const Model& model) {
  Box all = bounds(model.blocks.front().polygon);
  for (const Block& b : model.blocks) {
    const Box box = bounds(b.polygon);
    all = {all.lo.cwiseMin(box.lo), all.hi.cwiseMax(box.hi)};
  }
  std::vector<EdgeSpan> out = outer_faces(model, 1e-6 * (all.hi - all.lo).maxCoeff());
  std::erase_if(out, [&](const EdgeSpan& e) { return model.support_of(e.block) != nullptr; });
  if (out.empty())
    throw s.error("reservoir", "the model has no face on which water in front of it could act",
                  "outlines of free blocks that face outside", "remove the key");
  return out;
}

}  // namespace

void read_water(const Section& root, const DrawnLayers& drawing, Model& model) {
  for (const Section& s : root.list("water")) {
    JointWater water{
        piezometric_line(s, drawing), s.number("unit_weight"), filled_joints(s, model), {}, levels_of(s, root)};
    if (s.boolean("reservoir")) water.faces = reservoir_faces(s, model);
    model.waters.push_back(std::move(water));
  }
}

}  // namespace scree::io
