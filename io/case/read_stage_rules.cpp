#include <fmt/format.h>

#include <algorithm>

#include "io/case/read_parts.h"
#include "io/case/suggest.h"

namespace scree::io {
namespace {

using coupling::EndRules;
using coupling::SwitchRules;

void read_end(const Section& s, coupling::Stage& stage) {
  if (!s.has("end")) return;
  const Section e = s.table("end");
  EndRules& end = stage.end;
  const auto number = [&](const char* key) { return e.has(key) ? e.number(key) : 0.0; };
  end.kinetic_below = number("kinetic_below");
  end.force_below = number("force_below");
  end.slip = number("slip");
  end.displacement = number("displacement");
  if (!end.used())
    throw e.error("slip", "no rule to end the stage before its duration is given",
                  "one or more of kinetic_below, force_below, slip, displacement",
                  "add slip = 0.05, for example, or remove end");
  if (e.has("hold")) {
    if (end.kinetic_below == 0.0 && end.force_below == 0.0)
      throw e.error("hold", "slip and displacement end a stage as they are reached",
                    "hold beside kinetic_below or force_below", "remove it");
    end.hold = ticks(e.number("hold"));
  }
  for (const char* key : {"kinetic_below", "force_below"})
    if (stage.rest && e.has(key))
      throw e.error(key, "a stage with rest = true removes the motion", "slip or displacement in stages with rest",
                    "give rest_force = 1e-4 to the stage, for example, or remove rest");
  if (stage.dynamics == 0.0 && e.has("kinetic_below"))
    throw e.error("kinetic_below", "dynamics = 0 leaves no kinetic energy", "the key beside dynamics above 0",
                  "use force_below");
}

void read_strength(const Section& s, const Model& model, coupling::Stage& stage) {
  if (!s.has("strength")) return;
  if (stage.integrator == coupling::Integrator::partitioned)
    throw s.error("strength", "partitioned stages cannot change the strengths of the model",
                  "strength in explicit and implicit stages", "remove it, or set another integrator");
  const Section r = s.table("strength");
  stage.strength.to = r.number("factor");
  if (!r.has("from")) r.settle("from", stage.strength.to);
  stage.strength.from = r.number("from");
  const std::vector<std::string> known = names_of(model.joints);
  std::vector<char> chosen(known.size(), r.has("joints") ? 0 : 1);
  if (r.has("joints"))
    for (std::size_t i = 0; i < r.texts("joints").size(); ++i)
      for (const std::int32_t j : find_names(r, "joints", i, "joint", known)) chosen[static_cast<std::size_t>(j)] = 1;
  for (std::size_t j = 0; j < chosen.size(); ++j)
    if (chosen[j] != 0) stage.strength.joints.emplace_back(static_cast<std::int32_t>(j));
}

/// Why a block can have one method only; empty: it can have both.
std::string obstacle(const coupling::Stage& stage, const Model& model, BlockId block) {
  if (model.support_of(block) != nullptr) return "is held whole";
  std::string method = stage.method;
  for (const coupling::MethodRule& rule : stage.rules) {
    if (std::find(rule.blocks.begin(), rule.blocks.end(), block) == rule.blocks.end()) continue;
    if (rule.onefold) return "has a onefold cover";
    method = rule.method;
  }
  if (method != "nmm" && method != "dda") return fmt::format("uses the method {}", in_quotes(method));
  const bool cracked =
      std::any_of(model.cracks.begin(), model.cracks.end(), [&](const Crack& crack) { return crack.block == block; });
  return stage.cracks && cracked ? "has a crack, which the DDA would close" : "";
}

/// Blocks of the list that can change method, each once; blocks that match a pattern but cannot change are skipped.
std::vector<BlockId> read_blocks_of(const Section& r, const coupling::Stage& stage, const Model& model) {
  std::vector<BlockId> blocks;
  const std::vector<std::string> known = names_of(model.blocks);
  if (!r.has("blocks")) {
    for (std::size_t b = 0; b < known.size(); ++b)
      if (const BlockId block{static_cast<std::int32_t>(b)}; obstacle(stage, model, block).empty())
        blocks.push_back(block);
  } else {
    const std::vector<std::string> patterns = r.texts("blocks");
    for (std::size_t i = 0; i < patterns.size(); ++i)
      for (const std::int32_t b : find_names(r, "blocks", i, "block", known)) {
        const BlockId block{b};
        const std::string why = obstacle(stage, model, block);
        if (why.empty())
          blocks.push_back(block);
        else if (known[block.index()] == patterns[i])
          throw r.error("blocks", i, fmt::format("block {} {}", in_quotes(known[block.index()]), why),
                        "free blocks of the NMM with a mesh, or of the DDA", "remove the name");
      }
  }
  if (blocks.empty())
    throw r.error("blocks", "no block can change between the NMM and the DDA in this stage",
                  "free blocks of the NMM with a mesh, or of the DDA", "remove switch, or name other blocks");
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

void read_switch(const Section& s, const Model& model, coupling::Stage& stage) {
  if (!s.has("switch")) return;
  const auto refuse = [&](bool wrong, const char* problem, const char* allowed, const char* hint) {
    if (wrong) throw s.error("switch", problem, allowed, hint);
  };
  refuse(stage.rest, "a stage with rest = true removes the motion that the rules measure",
         "switch in stages without rest", "remove one of the two");
  refuse(stage.kinematics == Kinematics::linear, "linear kinematics cannot return a rotated block to the NMM",
         "switch beside kinematics = \"corotational\"", "remove one of the two");
  refuse(stage.newmark == coupling::NewmarkScheme::trapezoidal,
         "the trapezoidal scheme does not support blocks of the DDA, which turn", "switch beside newmark = \"damped\"",
         "remove one of the two");
  const Section r = s.table("switch");
  SwitchRules& rules = stage.change;
  rules.used = true;
  rules.blocks = read_blocks_of(r, stage, model);
  rules.kinetic = r.number("kinetic");
  rules.elastic = r.number("elastic");
  if (r.has("inhomogeneity")) rules.inhomogeneity = r.number("inhomogeneity");
  rules.hold = ticks(r.number("hold"));
  if (!r.has("back")) return;
  const Section b = r.table("back");
  const auto number = [&](const char* key) { return b.has(key) ? b.number(key) : 0.0; };
  rules.back = {number("strain_rate"), number("stress"), number("acceleration")};
  if (!rules.back.used())
    throw b.error("strain_rate", "no rule for a block of the DDA to change to the NMM is given",
                  "one or more of strain_rate, stress, acceleration",
                  "add strain_rate = 0.1, for example, or remove back");
}

}  // namespace

void read_stage_rules(const Section& s, const Model& model, coupling::Stage& stage) {
  read_end(s, stage);
  read_strength(s, model, stage);
  read_switch(s, model, stage);
}

}  // namespace scree::io
