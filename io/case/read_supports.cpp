#include <fmt/format.h>

#include <map>
#include <set>

#include "io/case/block_choice.h"
#include "io/case/read_parts.h"

namespace scree::io {
namespace {

/// Blocks that a support names, with the place of each name.
struct Held {
  BlockId block;
  std::size_t item;
};
std::vector<Held> held_blocks(const Section& s, const Model& model) {
  if (!s.has("blocks")) return {{block_of(s, model), 0}};
  std::vector<Held> held;
  const std::vector<std::string> known = names_of(model.blocks);
  for (std::size_t i = 0; i < s.texts("blocks").size(); ++i)
    for (const std::int32_t b : find_names(s, "blocks", i, "block", known)) held.push_back({BlockId{b}, i});
  if (held.empty())
    throw s.error("blocks", "the list of blocks is empty", "names of blocks", "name the blocks that are held");
  return held;
}

/// One of block, blocks and at.
void check_naming(const Section& s) {
  std::vector<std::string> given;
  for (const char* key : {"block", "blocks", "at"})
    if (s.has(key)) given.emplace_back(key);
  const char *allowed = "one of block, blocks and at",
             *hint = "write block = \"NAME\", blocks = [\"NAME\", ...] or at = [x, y]";
  if (given.empty()) throw s.error("block", "the support names no block", allowed, hint);
  if (given.size() > 1)
    throw s.error(given[1], fmt::format("{} and {} are both given", given[0], given[1]), allowed, hint);
}

void hold_point(const Section& s, Model& model) {
  if (s.has("blocks"))
    throw s.error("point", "a point belongs to one block", "block = \"NAME\" beside point",
                  "write one support a block");
  if (s.has("motion"))
    throw s.error("motion", "a point cannot follow a motion", "a motion for a whole block", "remove point, or motion");
  const std::string& fix = s.text("fix");
  const PointSupport support{block_of(s, model), s.point("point"), fix != "y", fix != "x",
                             s.number_or_auto("stiffness")};
  check_point(s, model, support.block, support.point);
  model.point_supports.push_back(support);
}

void hold_whole(const Section& s, const std::vector<std::string>& motions, Model& model) {
  if (s.text("fix") != "all")
    throw s.error("fix", "a whole block is held in all directions", "\"all\"",
                  "add point = [x, y] to hold a point in one direction");
  if (s.number_or_auto("stiffness"))
    throw s.error("stiffness", "a block that is held whole has no spring", "a stiffness beside point",
                  "remove stiffness, or add point");
  BlockSupport support;
  if (s.has("motion")) support.motion = MotionId{find_name(s, "motion", "motion", motions)};
  for (const Held& held : held_blocks(s, model)) {
    support.block = held.block;
    if (model.support_of(held.block)) {
      const std::string problem =
          fmt::format("block {} is held twice", in_quotes(model.blocks[held.block.index()].name));
      const char *allowed = "one support for a whole block", *hint = "remove one of the two supports";
      throw s.has("blocks") ? s.error("blocks", held.item, problem, allowed, hint)
                            : s.error(s.has("block") ? "block" : "at", problem, allowed, hint);
    }
    model.block_supports.push_back(support);
  }
}

}  // namespace

void read_supports(const Section& root, Model& model) {
  std::vector<std::string> motions;
  for (const Section::Named& named : root.named("motion")) motions.push_back(named.name);
  for (const Section& s : root.list("support")) {
    check_naming(s);
    s.has("point") ? hold_point(s, model) : hold_whole(s, motions, model);
  }
}

void read_monitors(const Section& root, Model& model) {
  std::map<std::int32_t, int> count;  // monitors of a block so far
  std::set<std::string> names;
  for (const Section& s : root.list("monitor")) {
    Monitor monitor{"", s.has("block") ? block_of(s, model) : block_at(s, "point", model), s.point("point")};
    check_point(s, model, monitor.block, monitor.point);
    const int number = ++count[monitor.block.value];
    monitor.name =
        s.has("name") ? s.text("name") : fmt::format("{}#{}", model.blocks[monitor.block.index()].name, number);
    if (!names.insert(monitor.name).second)
      throw s.error("name", "two monitors have the same name", "a name for each monitor",
                    "choose another name, or leave it out");
    model.monitors.push_back(std::move(monitor));
  }
}

}  // namespace scree::io
