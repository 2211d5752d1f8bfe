#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "io/case/read_parts.h"

namespace scree::io {
namespace {

/// Laws of the outer edges in the order in which they were written. Edge i runs from corner i to i + 1.
std::vector<JointId> edge_laws(const Section& s, std::size_t corners, const std::vector<std::string>& joints) {
  const std::vector<std::string> names = s.texts("edge_joints");
  std::vector<JointId> laws(corners);
  if (names.empty()) return laws;
  if (names.size() != corners)
    throw s.error("edge_joints", fmt::format("{} joints for {} edges", names.size(), corners),
                  fmt::format("a list of {} names, or none", corners),
                  "give one name per edge, \"\" where the joint of the block applies");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!names[i].empty()) laws[i] = JointId{find_name(s, "edge_joints", i, "joint", joints)};
  return laws;
}

Block read_block(const Section& s, const Model& model) {
  const std::vector<std::string> joints = names_of(model.joints);
  Block block;
  block.name = s.text("name");
  block.material = MaterialId{find_name(s, "material", "material", names_of(model.materials))};
  if (s.has("joint")) block.joint = JointId{find_name(s, "joint", "joint", joints)};
  if (s.has("cover_size")) block.cover_size = s.number("cover_size");
  block.polygon.outer = s.ring("polygon");
  block.polygon.holes = s.rings("holes");
  for (std::size_t k = 0; k < block.polygon.rings(); ++k) block.edges.emplace_back(block.polygon.ring(k).size());
  block.edges[0] = edge_laws(s, block.polygon.outer.size(), joints);
  for (const std::size_t k : orient(block.polygon)) {
    // In a reversed ring the corners run n-1, ..., 0. Edge j as written, from corner j to j + 1, is now edge n - 2 - j;
    // the last edge, from corner n - 1 to 0, stays last.
    std::vector<JointId>& laws = block.edges[k];
    std::reverse(laws.begin(), laws.end() - 1);
  }
  return block;
}

}  // namespace

void read_blocks(const Section& root, const std::filesystem::path& folder, const DrawnLayers& drawing, Model& model,
                 const Notice& notice) {
  const std::vector<Section> sections = root.list("block");
  if (sections.empty() && !root.has("domain"))
    throw root.error("block", "the case has no block", "at least one [[block]], or a [domain]",
                     "add [[block]] with a polygon, or [domain] with an outline that joints cut into blocks");
  std::set<std::string> names;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const Section& s = sections[i];
    if (!names.insert(s.text("name")).second)
      throw s.error("name", "two blocks have the same name", "a name for each block", "number the blocks");
    model.blocks.push_back(read_block(s, model));
    const InitialVelocity start{BlockId{static_cast<std::int32_t>(i)}, s.point("velocity"), s.number("spin")};
    if (start.velocity != Vec2::Zero() || start.spin != 0.0) model.initial_velocities.push_back(start);
  }
  if (root.has("domain")) read_domain(root.table("domain"), folder, drawing, model, notice);
  for (std::size_t i = sections.size(); i < model.blocks.size(); ++i)
    if (names.count(model.blocks[i].name) > 0)
      for (const Section& s : sections)
        if (s.text("name") == model.blocks[i].name)
          throw s.error("name", "a block that the domain is cut into has the same name", "a name for each block",
                        "rename this block, or give domain.prefix");

  const std::vector<GeometryFault> faults = check_geometry(model);
  if (faults.empty()) return;
  const GeometryFault& f = faults.front();
  // The text of an overlap contains the names of both blocks already.
  const std::string what =
      f.other.valid() ? f.what : fmt::format("block {}: {}", in_quotes(model.blocks[f.block.index()].name), f.what);
  const char* allowed = "a simple polygon that encloses an area and overlaps no other block";
  for (const BlockId b : {f.block, f.other})
    if (b.valid() && b.index() < sections.size()) throw sections[b.index()].error("polygon", what, allowed, f.hint);
  throw root.table("domain").error("least_width", "a block of the domain is too small or too narrow: " + what,
                                   "a width above the narrowest blocks to be kept",
                                   "raise least_width or snap; `scree check` prints those in use");
}

}  // namespace scree::io
