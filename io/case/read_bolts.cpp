#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/case/read_parts.h"

namespace scree::io {
namespace {

/// Refuses a key that requires another key, if that other key is absent.
void need(const Section& s, std::string_view key, bool there, std::string_view with) {
  if (!s.has(key) || there) return;
  throw s.error(key, fmt::format("it does nothing without {}", with), fmt::format("beside {}", with),
                fmt::format("give {}, or remove the key", with));
}

/// A strength or limit; Bolt::kNever if the key is absent.
double limit(const Section& s, std::string_view key) { return s.has(key) ? s.number(key) : Bolt::kNever; }

void read_bond(const Section& s, double spacing, Bolt& bolt) {
  const bool grouted = s.has("bond_length");
  for (const char* key : {"bond_stiffness", "bond_strength", "segment"}) need(s, key, grouted, "bond_length");
  bolt.plate = s.boolean("plate");
  if (grouted) {
    bolt.bond_length = std::min(s.number("bond_length"), bolt.length());
    if (s.number("bond_length") > (1.0 + 1e-6) * bolt.length())
      throw s.error("bond_length", fmt::format("the bolt is {:.6g} m long", bolt.length()),
                    fmt::format("at most {:.6g} m", bolt.length()), "shorten the bond, or lengthen the bolt");
    if (!s.has("bond_stiffness"))
      throw s.error("bond_stiffness", "the bond has no stiffness", "a number > 0 [N/m2]",
                    "give the force per length and slip of the grout");
    bolt.bond_stiffness = s.number("bond_stiffness") / spacing;
    bolt.bond_strength = limit(s, "bond_strength") / spacing;
    if (s.has("segment")) bolt.segment = s.number("segment");
  }
  if (!bolt.plate && bolt.bond_length < (1.0 - 1e-6) * bolt.length())
    throw s.error("plate", "the free length of the bolt is held by nothing", "true, or a bond along the whole bolt",
                  "remove plate = false, or make bond_length the length of the bolt");
}

void check_pretension(const Section& s, const Bolt& bolt, double spacing) {
  if (bolt.pretension == 0.0) return;
  if (!bolt.plate)
    throw s.error("pretension", "a bolt without a plate cannot be pulled", "beside plate = true",
                  "remove the key, or plate = false");
  if (bolt.pretension >= bolt.yield)
    throw s.error("pretension", "the bolt yields before it is reached",
                  fmt::format("less than yield, {:.6g} N", bolt.yield * spacing), "lower it, or raise yield");
}

/// Refuses a pretension above the strength of the bond, which acts in rock only.   @pre the bolt is laid out
void check_bond(const Section& s, const Bolt& bolt) {
  if (bolt.pretension == 0.0 || bolt.bond_length == 0.0) return;
  double bond = 0.0;
  for (const Bolt::Node& n : bolt.nodes) bond += bolt.bond_strength * n.length;
  if (bolt.pretension >= (1.0 - 1e-9) * bond)
    throw s.error(
        "pretension", "the bond slips before it is reached",
        fmt::format("less than bond_strength times the length of bond in rock, {:.6g} N", bond * s.number("spacing")),
        "lower it, or lengthen the bond");
}

/// Name, head and toe of the bolts of a section: one bolt, or those on a layer of the drawing.
std::vector<Bolt> drawn_bolts(const Section& s, const DrawnLayers& drawing, std::size_t number) {
  std::vector<Bolt> out;
  for (const char* key : {"head", "toe"})
    if (s.has("layer") == s.has(key))
      throw s.error(
          key, s.has(key) ? fmt::format("{} and layer are both given", key) : fmt::format("the bolt has no {}", key),
          "either head and toe, or layer", "write head = [x, y] and toe = [x, y]");
  if (!s.has("layer")) {
    Bolt& bolt = out.emplace_back();
    bolt.name = s.has("name") ? s.text("name") : fmt::format("bolt#{}", number);
    bolt.head = s.point("head");
    bolt.toe = s.point("toe");
    if (!(bolt.length() > 0.0))
      throw s.error("toe", "it is where the head is", "another point", "give the two ends of the bolt");
    return out;
  }
  for (const DrawnLine* line : drawing.lines(s, "layer", "bolts")) {
    if (line->points.size() != 2 || line->closed || !((line->points[1] - line->points[0]).norm() > 0.0))
      throw CaseError(drawing.file(), {line->row, 1},
                      {fmt::format("a {} of {} points is no bolt", line->entity, line->points.size()), "", "",
                       "a line of two points that differ, from head to toe",
                       "draw each bolt as one straight line, or take this off the layer"});
    Bolt& bolt = out.emplace_back();
    bolt.name = s.has("name") ? fmt::format("{}-{}", s.text("name"), out.size())
                              : fmt::format("bolt#{}", number + out.size() - 1);
    bolt.head = line->points[0];
    bolt.toe = line->points[1];
  }
  return out;
}

/// @param bolt  with its name, head and toe
Bolt read_bolt(const Section& s, const std::vector<std::string>& stages, Bolt bolt) {
  if (s.has("stage")) bolt.stage = StageId{find_name(s, "stage", "stage", stages)};
  const double spacing = s.number("spacing");
  bolt.stiffness = s.number("axial_stiffness") / spacing;
  bolt.yield = limit(s, "yield") / spacing;
  bolt.pretension = s.number("pretension") / spacing;
  need(s, "rupture_strain", s.has("yield"), "yield");
  bolt.rupture_strain = limit(s, "rupture_strain");
  for (const char* key : {"shear_strength", "rupture_shear"}) need(s, key, s.has("shear_stiffness"), "shear_stiffness");
  need(s, "rupture_shear", s.has("shear_strength"), "shear_strength");
  if (s.has("shear_stiffness")) bolt.shear_stiffness = s.number("shear_stiffness") / spacing;
  bolt.shear_strength = limit(s, "shear_strength") / spacing;
  bolt.rupture_shear = limit(s, "rupture_shear");
  read_bond(s, spacing, bolt);
  check_pretension(s, bolt, spacing);
  return bolt;
}

/// Refuses a bolt that holds no free block: it would have no effect.
void check_blocks(const Section& s, const char* place, const Model& model, const Bolt& bolt) {
  const auto held = [&](const Bolt::Node& n) { return model.support_of(n.block) != nullptr; };
  if (std::all_of(bolt.nodes.begin(), bolt.nodes.end(), held))
    throw s.error(place, "all blocks that the bolt holds are held whole already", "a bolt that holds a free block",
                  "move the bolt, or remove it");
}

}  // namespace

void read_bolts(const Section& root, const DrawnLayers& drawing, Model& model) {
  std::vector<std::string> stages;
  for (const Section& stage : root.list("stage")) stages.push_back(stage.text("name"));
  std::set<std::string> names;
  const auto add = [&](const Section& s, Bolt bolt) {
    const char* place = s.has("layer") ? "layer" : "head";
    if (!names.insert(bolt.name).second)
      throw s.error(s.has("name") ? "name" : place, "two bolts have the same name", "a name for each bolt",
                    "choose another name, or leave it out");
    if (const std::string wrong = lay_out(model, bolt); !wrong.empty())
      throw s.error(wrong.starts_with("its toe") && s.has("toe") ? "toe" : place,
                    fmt::format("bolt {}: {}", in_quotes(bolt.name), wrong),
                    "a line from its head to its toe, both in blocks, or on outlines from where it runs into the block",
                    "compare head and toe with the blocks");
    check_blocks(s, place, model, bolt);
    check_bond(s, bolt);
    model.bolts.push_back(std::move(bolt));
  };
  for (const Section& s : root.list("bolt"))
    for (Bolt& bolt : drawn_bolts(s, drawing, model.bolts.size() + 1)) add(s, read_bolt(s, stages, std::move(bolt)));
}

}  // namespace scree::io
