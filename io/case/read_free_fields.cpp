#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "coupling/bodies/clocks.h"
#include "io/case/block_choice.h"
#include "io/case/edge_choice.h"
#include "io/case/read_parts.h"
#include "model/edge_selection.h"
#include "model/free_field.h"

namespace scree::io {
namespace {

/// Stretches that share at most this part of an edge do not overlap: their ends were rounded.
constexpr double kTouching = 1e-9;
/// Largest inclination of a side to the vertical [rad]: its ends were rounded.
constexpr double kLean = 1e-3;

/// A base that a motion drives from below.
struct Base {
  MotionId motion;
  bool rigid = false;
  double upgoing = 1.0;
  [[nodiscard]] bool operator==(const Base&) const = default;
};

/// The only base of the model, or the base that follows the motion named in the section.
Base base_of(const Section& s, const Section& root, const Model& model) {
  MotionId motion;
  if (s.has("motion")) {
    std::vector<std::string> motions;
    for (const Section::Named& named : root.named("motion")) motions.push_back(named.name);
    motion = MotionId{find_name(s, "motion", "motion", motions)};
  }
  std::vector<Base> found;
  const auto add = [&](const Base& base) {
    if (!base.motion.valid() || (motion.valid() && base.motion != motion)) return;
    if (std::find(found.begin(), found.end(), base) == found.end()) found.push_back(base);
  };
  for (const ViscousEdge& e : model.viscous_edges) add({e.motion, false, e.upgoing});
  for (const BlockSupport& b : model.block_supports) add({b.motion, true, 1.0});
  if (found.empty())
    throw s.error("motion",
                  motion.valid() ? "no base is driven by this motion" : "the model has no base that a motion drives",
                  "the motion of a viscous edge (a compliant base), or of blocks that are held whole",
                  "add [[viscous_edge]] with motion below the model, or motion to the [[support]] of its base");
  if (found.size() > 1)
    throw s.error("motion", fmt::format("the model has {} bases that motions drive, each in its own way", found.size()),
                  "the name of the motion of one of them, which drives that one only",
                  "name with motion the one that continues below the ground beside the model");
  return found.front();
}

/// The selected outline: an edge by its number, or the stretches on a line.
std::vector<EdgeSpan> sides(const Section& s, const Section& root, const Model& model) {
  std::vector<EdgeSpan> spans;
  if (s.has("edge")) {
    spans = chosen_edges(s, root, model, block_of(s, model));
  } else {
    if (!s.has("on"))
      throw s.error("on", "the outlines are not given", "on, or block and edge",
                    "write on = [[x, y], [x, y]], the ends of the side");
    spans = free_edges(s, model);
  }
  std::erase_if(spans, [&](const EdgeSpan& e) { return model.support_of(e.block) != nullptr; });
  if (spans.empty())
    throw s.error(s.has("on") ? "on" : "edge", "all blocks there are held whole: nothing else moves them",
                  "edges of blocks that are free", "remove the section, or the supports of the blocks");
  return spans;
}

/// Refuses sides that are not vertical, and sides of several materials.
void check_sides(const Section& s, const std::vector<EdgeSpan>& spans, const Model& model) {
  const char* key = s.has("on") ? "on" : "edge";
  for (const EdgeSpan& span : spans) {
    const Block& block = model.blocks[span.block.index()];
    if (const double lean = std::abs(outward_normal(block.polygon, span.edge).y()); lean > kLean)
      throw s.error(key,
                    fmt::format("an edge of block {} leans by {:.3g} degrees", in_quotes(block.name),
                                std::asin(lean) * 180.0 / std::numbers::pi),
                    "vertical edges", "end the model in a vertical side: the ground beside it is level");
    const Block& first = model.blocks[spans.front().block.index()];
    if (block.material != first.material)
      throw s.error(
          key,
          fmt::format("block {} is of another material than block {}", in_quotes(block.name), in_quotes(first.name)),
          "a side of one material", "let the model end in one material; the ground beside it has no layers");
  }
}

/// Lowest and highest point of the stretches [m].
std::pair<double, double> reach_of(const std::vector<EdgeSpan>& spans, const Model& model) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const EdgeSpan& span : spans) {
    const auto [from, to] = ends_of(model.blocks[span.block.index()].polygon, span.edge);
    for (const double at : {span.s0, span.s1}) {
      const double y = (1.0 - at) * from.y() + at * to.y();
      low = std::min(low, y);
      high = std::max(high, y);
    }
  }
  return {low, high};
}

/// The ground from its base to its surface, which must include the height of the side.
FreeField ground_of(const Section& s, const std::vector<EdgeSpan>& spans, const Model& model, const Base& base) {
  const auto [low, high] = reach_of(spans, model);
  const FreeField ground{s.has("bottom") ? s.number("bottom") : low, s.has("top") ? s.number("top") : high, base.motion,
                         base.rigid, base.upgoing};
  if (!(ground.bottom < ground.top))
    throw s.error(s.has("top") ? "top" : "bottom", "the ground beside the model has no height",
                  fmt::format("bottom below top: the side reaches from {:.10g} to {:.10g} m", low, high),
                  "leave both keys out: the ground is then as high as the side");
  const double near = 1e-6 * (ground.top - ground.bottom);
  if (ground.bottom > low + near)
    throw s.error("bottom", "the side reaches below the base of the ground beside it",
                  fmt::format("at most {:.10g} m, where the side begins", low), "shorten the side, or lower the base");
  if (ground.top < high - near)
    throw s.error("top", "the side reaches above the surface of the ground beside it",
                  fmt::format("at least {:.10g} m, where the side ends", high),
                  "shorten the side, or raise the surface");
  return ground;
}

/// True if a block has no mesh in a stage.
bool without_mesh(const coupling::Stage& stage, BlockId block) {
  std::string method = stage.method;
  bool onefold = false;
  for (const coupling::MethodRule& rule : stage.rules)
    if (std::find(rule.blocks.begin(), rule.blocks.end(), block) != rule.blocks.end()) {
      method = rule.method;
      onefold = rule.onefold;
    }
  const std::vector<BlockId>& absent = stage.construction.absent;
  return (method != "nmm" || onefold) && std::find(absent.begin(), absent.end(), block) == absent.end();
}

/// Refuses sides of blocks that have no mesh in a stage in which the motion acts.
void check_meshed(const Section& s, const std::vector<EdgeSpan>& spans, MotionId motion, const Model& model,
                  const coupling::Plan& plan) {
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    if (coupling::acts_in(model, plan, i)[motion.index()] == 0) continue;
    for (const EdgeSpan& span : spans)
      if (without_mesh(plan.stages[i], span.block))
        throw s.error(s.has("on") ? "on" : "edge",
                      fmt::format("block {} has no mesh in stage {}: waves cannot run through it",
                                  in_quotes(model.blocks[span.block.index()].name), in_quotes(plan.stages[i].name)),
                      "blocks with the NMM and covers of some size, in every stage that the motion shakes",
                      "name the blocks at the sides in method_of, with method = \"nmm\"");
  }
}

/// Remaining time of the run when a motion begins, if the stages last as planned [s].
double rest_of_run(const GroundMotion& motion, const coupling::Plan& plan) {
  Tick left = 0;
  const StageId stage = motion.setting().stage;
  for (std::size_t i = stage.valid() ? stage.index() : 0; i < plan.stages.size(); ++i) left += plan.stages[i].duration;
  return seconds(left) - motion.setting().start;
}

void read_free_field(const Section& s, const Section& root, const coupling::Plan& plan, Model& model) {
  const std::vector<EdgeSpan> spans = sides(s, root, model);
  check_sides(s, spans, model);
  const Base base = base_of(s, root, model);
  const FreeField ground = ground_of(s, spans, model, base);
  for (const EdgeSpan& span : spans) check_absorbs_once(s, span, model);
  check_meshed(s, spans, base.motion, model, plan);
  add_free_field(model, spans, ground, rest_of_run(model.motions[base.motion.index()], plan));
}

}  // namespace

void check_absorbs_once(const Section& s, const EdgeSpan& span, const Model& model) {
  for (const ViscousEdge& other : model.viscous_edges) {
    const EdgeSpan& o = other.span;
    const double common = std::min(o.s1, span.s1) - std::max(o.s0, span.s0);
    if (o.block != span.block || o.edge != span.edge || common <= kTouching) continue;
    throw s.error(s.has("on") ? "on" : "edge", "a part of this stretch is viscous already",
                  "stretches that do not overlap", "waves would be absorbed twice: remove one, or shorten it");
  }
}

void read_free_fields(const Section& root, const coupling::Plan& plan, Model& model) {
  for (const Section& s : root.list("free_field")) read_free_field(s, root, plan, model);
}

}  // namespace scree::io
