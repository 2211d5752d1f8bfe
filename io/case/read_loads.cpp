#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/case/block_choice.h"
#include "io/case/edge_choice.h"
#include "io/case/read_parts.h"
#include "model/edge_selection.h"

namespace scree::io {
namespace {

/// The function named in a load; if the load has a start, a function of its own that begins with the load.
FunctionId function_of(const Section& s, const Section& root, std::string_view list, std::size_t index, Model& model) {
  FunctionId named;
  if (s.has("function")) {
    std::vector<std::string> names;
    for (const TimeFunction& f : model.functions)
      if (!f.of_load) names.push_back(f.name);
    named = FunctionId{find_name(s, "function", "function", names)};
  }
  if (!s.has("start")) {
    if (s.has("offset"))
      throw s.error("offset", "it is counted from the beginning of a stage, and there is no start",
                    "beside start = \"STAGE\"", "name the stage in start, or remove the key");
    return named;
  }
  TimeFunction f = named.valid() ? model.functions[named.index()] : TimeFunction();
  if (f.stage.valid() || f.start != 0.0)
    throw s.error("start", fmt::format("the function {} has a start too", in_quotes(f.name)),
                  "the start of the load, or that of its function", "remove one of the two");
  const Start start = read_start(s, root);
  f.name = fmt::format("{}.{}", list, index);
  f.start = start.time;
  f.stage = start.stage;
  f.of_load = true;
  model.functions.push_back(std::move(f));
  return FunctionId{static_cast<std::int32_t>(model.functions.size()) - 1};
}

std::string held_text(const Model& model, BlockId block) {
  return fmt::format("block {} is held whole: nothing else moves it", in_quotes(model.blocks[block.index()].name));
}

/// The block of a load, which must be free to move.
/// @param what  acts on it: "a load"
BlockId free_block(const Section& s, const Model& model, std::string_view what) {
  const BlockId block = block_of(s, model, "point");
  if (model.support_of(block))
    throw s.error(s.has("block") ? "block" : "point", held_text(model, block), "a block that is free",
                  fmt::format("remove {}, or the support of the block", what));
  return block;
}

void read_point_load(const Section& s, const Section& root, std::size_t index, Model& model) {
  const PointLoad load{free_block(s, model, "the load"), s.point("point"), s.point("force"),
                       function_of(s, root, "point_load", index, model)};
  check_point(s, model, load.block, load.point);
  model.point_loads.push_back(load);
}

/// Edges that a traction acts on: of the block named in it, or of all free blocks with edges on its line.
std::vector<EdgeSpan> loaded_edges(const Section& s, const Section& root, const Model& model) {
  if (s.has("block")) return chosen_edges(s, root, model, free_block(s, model, "the traction"));
  if (s.has("edge") || !s.has("on"))
    throw s.error(s.has("edge") ? "block" : "on", "the outlines are not given", "block and edge, or on",
                  "write on = [[x, y], [x, y]], the ends of a straight line");
  std::vector<EdgeSpan> spans = free_edges(s, model);
  std::erase_if(spans, [&](const EdgeSpan& e) { return model.support_of(e.block) != nullptr; });
  if (spans.empty())
    throw s.error("on", "all blocks there are held whole: nothing else moves them", "edges of blocks that are free",
                  "remove the traction, or the supports of the blocks");
  return spans;
}

void read_traction(const Section& s, const Section& root, std::size_t index, Model& model) {
  std::vector<std::string> given;
  for (const char* key : {"traction", "pressure", "surcharge"})
    if (s.has(key)) given.emplace_back(key);
  if (given.size() != 1)
    throw s.error(given.empty() ? "traction" : given[1],
                  given.empty() ? std::string("the load has no size")
                                : fmt::format("{} and {} are both given", given[0], given[1]),
                  "one of traction, pressure and surcharge",
                  "write traction = [x, y], pressure = p, which pushes if positive, or surcharge = q, a weight");
  const std::vector<EdgeSpan> spans = loaded_edges(s, root, model);
  const FunctionId function = function_of(s, root, "traction", index, model);
  for (const EdgeSpan& span : spans) {
    const Vec2 normal = outward_normal(model.blocks[span.block.index()].polygon, span.edge);
    const Vec2 traction = s.has("traction")   ? s.point("traction")
                          : s.has("pressure") ? Vec2(-s.number("pressure") * normal)
                                              : Vec2(0.0, -s.number("surcharge") * std::abs(normal.y()));
    model.tractions.push_back({span, traction, function});
  }
}

/// Blocks of a body acceleration, each once, in the order of the model.
std::vector<BlockId> accelerated(const Section& s, const Model& model) {
  const std::vector<std::string> patterns = s.texts("blocks"), known = names_of(model.blocks);
  std::vector<BlockId> blocks;
  for (std::size_t i = 0; i < patterns.size(); ++i)
    for (const std::int32_t b : find_names(s, "blocks", i, "block", known)) {
      const BlockId block{b};
      if (!model.support_of(block)) {
        blocks.push_back(block);
      } else if (known[block.index()] == patterns[i]) {
        throw s.error("blocks", i, held_text(model, block), "blocks that are free", "remove the name");
      }
    }
  if (blocks.empty())
    throw s.error("blocks", patterns.empty() ? "the list of blocks is empty" : "all of these blocks are held whole",
                  "names of blocks that are free", "name the blocks, or remove the key to use all");
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

void read_body_acceleration(const Section& s, const Section& root, std::size_t index, Model& model) {
  BodyAcceleration load;
  load.acceleration = s.point("acceleration");
  load.function = function_of(s, root, "body_acceleration", index, model);
  if (s.has("blocks")) load.blocks = accelerated(s, model);
  model.body_accelerations.push_back(std::move(load));
}

void read_viscous_edge(const Section& s, const Section& root, Model& model) {
  const BlockId block = free_block(s, model, "the viscous edge");
  MotionId motion;
  if (s.has("motion")) {
    std::vector<std::string> motions;
    for (const Section::Named& named : root.named("motion")) motions.push_back(named.name);
    motion = MotionId{find_name(s, "motion", "motion", motions)};
  }
  const double upgoing = s.text("motion_is") == "outcrop" ? 0.5 : 1.0;
  for (const EdgeSpan& span : chosen_edges(s, root, model, block)) {
    check_absorbs_once(s, span, model);
    model.viscous_edges.push_back({span, motion, upgoing});
  }
}

}  // namespace

void read_loads(const Section& root, Model& model) {
  std::size_t index = 0;
  for (const Section& s : root.list("point_load")) read_point_load(s, root, index++, model);
  index = 0;
  for (const Section& s : root.list("traction")) read_traction(s, root, index++, model);
  index = 0;
  for (const Section& s : root.list("body_acceleration")) read_body_acceleration(s, root, index++, model);
  for (const Section& s : root.list("viscous_edge")) read_viscous_edge(s, root, model);
}

}  // namespace scree::io
