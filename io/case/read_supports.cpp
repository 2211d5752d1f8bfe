#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "io/case/block_choice.h"
#include "io/case/edge_choice.h"
#include "io/case/read_parts.h"
#include "model/edge_selection.h"

namespace scree::io {
namespace {

/// Blocks named in a support, with the item of the list that names each.
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

/// Checks that one of block, blocks and at is given; none is needed beside a line or a box.
void check_naming(const Section& s) {
  std::vector<std::string> given;
  for (const char* key : {"block", "blocks", "at"})
    if (s.has(key)) given.emplace_back(key);
  const char *allowed = "one of block, blocks and at; or on, or box",
             *hint = "write block = \"NAME\", blocks = [\"NAME\", ...], at = [x, y] or on = [[x, y], [x, y]]";
  const bool edges = s.has("on") || s.has("box");
  if (given.empty() && !edges) throw s.error("block", "the support names no block", allowed, hint);
  if (given.size() > 1)
    throw s.error(given[1], fmt::format("{} and {} are both given", given[0], given[1]), allowed, hint);
  if (s.has("on") && s.has("box"))
    throw s.error("box", "on and box are both given", "either on or box", "write two supports");
  if (edges && s.has("point"))
    throw s.error("point", "a point and a line are both given", "either point, or on or box", "write two supports");
  if (!edges && s.has("bedding"))
    throw s.error("bedding", "only edges have a bedding", "beside on or box", "a point has stiffness");
  if (!edges && s.text("fix") == "normal")
    throw s.error("fix", "only an edge has a normal", "\"all\", \"x\" or \"y\"", "give the edge by on or box");
}

void hold_point(const Section& s, Model& model) {
  if (s.has("blocks"))
    throw s.error("point", "a point belongs to one block", "block = \"NAME\" beside point",
                  "write one support per block");
  if (s.has("motion"))
    throw s.error("motion", "a point cannot follow a motion", "a motion for a whole block", "remove point, or motion");
  const std::string& fix = s.text("fix");
  const PointSupport support{block_of(s, model), s.point("point"), fix != "y", fix != "x",
                             s.number_or_auto("stiffness")};
  check_point(s, model, support.block, support.point);
  model.point_supports.push_back(support);
}

/// Stretches of outline that a support holds, without those of blocks that are held whole.
std::vector<EdgeSpan> held_edges(const Section& s, const Model& model) {
  std::vector<EdgeSpan> spans = free_edges(s, model);
  const char* key = s.has("on") ? "on" : "box";
  const std::size_t all = spans.size();
  std::erase_if(spans, [&](const EdgeSpan& e) { return model.support_of(e.block) != nullptr; });
  if (spans.empty() && all > 0)
    throw s.error(key, "all blocks there are held whole", "edges of blocks that are free",
                  "remove one of the supports");
  return spans;
}

void hold_edges(const Section& s, Model& model) {
  if (s.has("motion"))
    throw s.error("motion", "an edge cannot follow a motion", "a motion for a whole block",
                  "let a block that is held whole follow it, and place the others on it");
  if (s.number_or_auto("stiffness"))
    throw s.error("stiffness", "an edge has no single spring", "a bedding, in Pa/m", "write bedding = \"1 GPa/m\"");
  const std::string& fix = s.text("fix");
  for (const EdgeSpan& span : held_edges(s, model)) {
    EdgeSupport support{span, Mat2::Identity(), {}};
    if (fix == "x") support.held << 1.0, 0.0, 0.0, 0.0;
    if (fix == "y") support.held << 0.0, 0.0, 0.0, 1.0;
    if (fix == "normal") {
      const Vec2 n = outward_normal(model.blocks[span.block.index()].polygon, span.edge);
      support.held = n * n.transpose();
    }
    if (s.has("bedding")) support.bedding = s.number("bedding");
    for (const EdgeSupport& other : model.edge_supports) {
      if (other.span.block != span.block || other.span.edge != span.edge) continue;
      if (std::min(other.span.s1, span.s1) - std::max(other.span.s0, span.s0) <= 1e-9) continue;
      if ((other.held * support.held).norm() < 1e-12) continue;
      throw s.error(s.has("on") ? "on" : "box",
                    fmt::format("an edge of block {} is held twice along one direction",
                                in_quotes(model.blocks[span.block.index()].name)),
                    "edges that are held once along each direction", "shorten the line or box, or fix less");
    }
    model.edge_supports.push_back(support);
  }
}

void hold_whole(const Section& s, const std::vector<std::string>& motions, Model& model) {
  if (s.text("fix") != "all" && s.text("fix") != "both")
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
    if (s.has("on") || s.has("box")) continue;
    s.has("point") ? hold_point(s, model) : hold_whole(s, motions, model);
  }
  for (const Section& s : root.list("support"))  // after all supports that hold whole blocks
    if (s.has("on") || s.has("box")) hold_edges(s, model);
}

void read_monitors(const Section& root, const DrawnLayers& drawing, Model& model) {
  std::map<std::int32_t, int> count;  // monitors of a block so far
  std::set<std::string> names;
  const auto add = [&](const Section& s, Monitor monitor, const char* key) {
    const int number = ++count[monitor.block.value];
    if (monitor.name.empty()) monitor.name = fmt::format("{}#{}", model.blocks[monitor.block.index()].name, number);
    if (!names.insert(monitor.name).second)
      throw s.error(key, "two monitors have the same name", "a name for each monitor",
                    "choose another name, or leave it out");
    model.monitors.push_back(std::move(monitor));
  };
  for (const Section& s : root.list("monitor")) {
    if (s.has("point") == s.has("layer"))
      throw s.error(s.has("point") ? "layer" : "point",
                    s.has("point") ? "point and layer are both given" : "the monitor has no point",
                    "either point or layer", "write point = [x, y]");
    if (s.has("layer")) {
      std::size_t number = 0;
      for (const DrawnPoint& p : drawing.points(s, "layer", "monitors")) {
        const std::vector<BlockId> holding = blocks_at(model, p.at);
        if (holding.empty())
          throw CaseError(
              drawing.file(), {p.row, 1},
              {fmt::format("the point ({:.10g}, {:.10g}) m of a monitor is in no block", p.at.x(), p.at.y()), "", "",
               "a point inside a block", "move it, or take it off the layer"});
        ++number;
        add(s, {s.has("name") ? fmt::format("{}-{}", s.text("name"), number) : "", holding.front(), p.at}, "name");
      }
      continue;
    }
    const Monitor monitor{s.has("name") ? s.text("name") : "",
                          s.has("block") ? block_of(s, model) : block_at(s, "point", model), s.point("point")};
    check_point(s, model, monitor.block, monitor.point);
    add(s, monitor, "name");
  }
}

}  // namespace scree::io
