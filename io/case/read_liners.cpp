#include <fmt/format.h>

#include <algorithm>

#include "io/case/read_parts.h"

namespace scree::io {
namespace {

/// Stiffnesses and strengths of a strip of unit thickness out of the plane.
void read_section(const Section& s, Plane plane, Bolt& liner) {
  const double nu = s.number("poisson"), thickness = s.number("thickness"),
               young = s.number("young") / (plane == Plane::strain ? 1.0 - nu * nu : 1.0);
  liner.stiffness = young * thickness;
  liner.bending = young * thickness * thickness * thickness / 12.0;
  if (s.has("tensile_strength")) liner.yield = s.number("tensile_strength") * thickness;
  if (s.has("compressive_strength")) liner.crushing = s.number("compressive_strength") * thickness;
  if (!s.has("rupture_strain")) return;
  if (!s.has("tensile_strength"))
    throw s.error("rupture_strain", "it does nothing without tensile_strength", "beside tensile_strength",
                  "give tensile_strength, or remove the key");
  liner.rupture_strain = s.number("rupture_strain");
}

Bolt read_liner(const Section& s, std::size_t number, const std::vector<coupling::Stage>& stages, Plane plane) {
  Bolt liner;
  liner.name = s.has("name") ? s.text("name") : fmt::format("liner#{}", number);
  liner.plate = false;
  if (s.has("stage")) {
    std::vector<std::string> names;
    for (const coupling::Stage& stage : stages) names.push_back(stage.name);
    liner.stage = StageId{find_name(s, "stage", "stage", names)};
  }
  liner.along = s.ring("along");
  for (std::size_t k = 1; k < liner.along.size(); ++k)
    if (!((liner.along[k] - liner.along[k - 1]).norm() > 0.0))
      throw s.error("along", k, "it is where the point before it is", "points that differ",
                    "remove the repeated point");
  liner.segment = s.number("spacing");
  liner.tolerance = s.number("tolerance");
  read_section(s, plane, liner);
  return liner;
}

/// Refuses liners on blocks that are not present from the liner's stage to the end.
void check_blocks(const Section& s, const Model& model, const std::vector<coupling::Stage>& stages, const Bolt& liner) {
  for (std::size_t i = liner.stage.valid() ? liner.stage.index() : 0; i < stages.size(); ++i) {
    const std::vector<char> absent = stages[i].construction.flags(model.blocks.size());
    for (const Bolt::Node& n : liner.nodes)
      if (absent[n.block.index()] != 0)
        throw s.error("along",
                      fmt::format("block {}, which it is glued to, is not there in stage {}",
                                  in_quotes(model.blocks[n.block.index()].name), in_quotes(stages[i].name)),
                      "a line on blocks that are there from the liner's stage to the end",
                      "end the liner before that block, or install it in a stage after the block is filled");
  }
  const auto held = [&](const Bolt::Node& n) { return model.support_of(n.block) != nullptr; };
  if (std::all_of(liner.nodes.begin(), liner.nodes.end(), held))
    throw s.error("along", "all blocks that it is glued to are held whole already", "a line on a free block",
                  "move the liner, or remove it");
}

}  // namespace

void read_liners(const Section& root, const std::vector<coupling::Stage>& stages, Model& model) {
  std::size_t number = 0;
  for (const Section& s : root.list("liner")) {
    Bolt liner = read_liner(s, ++number, stages, model.plane);
    const auto same = [&](const Bolt& b) { return b.name == liner.name; };
    if (std::any_of(model.bolts.begin(), model.bolts.end(), same))
      throw s.error(s.has("name") ? "name" : "along",
                    fmt::format("another bolt or liner is named {}", in_quotes(liner.name)),
                    "a name for each bolt and liner", "choose another name, or leave it out");
    const coupling::Stage& stage = stages[liner.stage.valid() ? liner.stage.index() : 0];
    const std::vector<char> absent = stage.construction.flags(model.blocks.size());
    if (const std::string wrong = lay_out_liner(model, absent, liner); !wrong.empty())
      throw s.error("along", fmt::format("liner {}: {}", in_quotes(liner.name), wrong),
                    "a line along the outlines of blocks that are there in its stage",
                    "compare it with the outlines, or raise tolerance");
    check_blocks(s, model, stages, liner);
    model.bolts.push_back(std::move(liner));
  }
}

}  // namespace scree::io
