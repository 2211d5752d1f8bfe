#include <fmt/format.h>

#include <algorithm>

#include "coupling/bodies/partition.h"
#include "coupling/state.h"
#include "io/case/read_parts.h"
#include "io/case/suggest.h"
#include "model/planar.h"

namespace scree::io {
namespace {

using coupling::Integrator;
using coupling::Partition;

/// With any of these keys some block may be explicit.
constexpr const char* kRules[] = {"explicit_blocks", "explicit_region", "explicit_area", "explicit_speed",
                                  "explicit_strain_rate"};
constexpr const char* kBeside[] = {"implicit_blocks", "implicit_speed", "implicit_strain_rate", "substeps",
                                   "slow_blocks"};

void refuse_elsewhere(const Section& s) {
  const auto refuse = [&](const char* key) {
    if (s.has(key))
      throw s.error(key, "all blocks of this stage take steps of one kind", "the key in partitioned stages",
                    "remove it, or set integrator = \"partitioned\"");
  };
  for (const char* key : kRules) refuse(key);
  for (const char* key : kBeside) refuse(key);
  if (s.boolean("shared_contacts")) refuse("shared_contacts");
}

/// Blocks of a list, each once. Patterns skip blocks that are held whole: these take no steps.
std::vector<BlockId> read_side(const Section& s, const char* key, const Model& model) {
  std::vector<BlockId> blocks;
  if (!s.has(key)) return blocks;
  const std::vector<std::string> patterns = s.texts(key), known = names_of(model.blocks);
  for (std::size_t i = 0; i < patterns.size(); ++i)
    for (const std::int32_t b : find_names(s, key, i, "block", known)) {
      const BlockId block{b};
      if (!model.support_of(block))
        blocks.push_back(block);
      else if (known[block.index()] == patterns[i])
        throw s.error(key, i, fmt::format("block {} is held whole and takes no steps", in_quotes(known[block.index()])),
                      "blocks that are free", "remove the name");
    }
  if (blocks.empty())
    throw s.error(key, patterns.empty() ? "the list of blocks is empty" : "all of these blocks are held whole",
                  "names of blocks that are free", "name the blocks, or remove the key");
  std::sort(blocks.begin(), blocks.end());
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

/// The first item of the list under a key that selects the block.
std::size_t item_of(const Section& s, const char* key, BlockId block, const Model& model) {
  const std::vector<std::string> patterns = s.texts(key), known = names_of(model.blocks);
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    const std::vector<std::int32_t> found = find_names(s, key, i, "block", known);
    if (std::find(found.begin(), found.end(), block.value) != found.end()) return i;
  }
  return 0;
}

Partition::Band read_band(const Section& s, const std::string& up, const std::string& down, const char* unit) {
  Partition::Band band;
  if (!s.has(up)) {
    if (s.has(down))
      throw s.error(down, fmt::format("the limit above which a block becomes explicit is missing"),
                    fmt::format("the key beside {}", up), fmt::format("add {}, or remove the key", up));
    return band;
  }
  band.up = s.number(up);
  if (!s.has(down)) s.settle(down, 0.5 * band.up);
  band.down = s.number(down);
  if (band.down >= band.up)
    throw s.error(down, "a block would change back as soon as it has changed",
                  fmt::format("number [{}], below {} = {:g}", unit, up, band.up),
                  fmt::format("half of {} is a start: leave the key out", up));
  return band;
}

void read_region(const Section& s, const Model& model, Partition& p) {
  p.explicit_region = s.ring("explicit_region");
  Polygon region{p.explicit_region, {}};
  if (const std::string why = invalidity(region); !why.empty())
    throw s.error("explicit_region", "the region is not a polygon: " + why, "ring [m] that does not cross itself",
                  "list the corners in their order around the region");
  (void)orient(region);
  p.explicit_region = region.outer;
  Partition alone;
  alone.explicit_region = p.explicit_region;
  const std::vector<char> sides = coupling::first_sides(model, alone);
  if (std::all_of(sides.begin(), sides.end(), [](char side) { return side == 0; }))
    throw s.error("explicit_region", "no free block lies in the region, or across its border", "a region with blocks",
                  "compare it with the blocks' corners, which are in the same coordinates");
}

}  // namespace

void check_divided(const Section& s, const Model& model, std::span<const std::string> used,
                   const coupling::Stage& stage) {
  if (stage.partition.explicit_region.empty()) return;
  const std::vector<char> sides = coupling::first_sides(model, stage.partition);
  for (std::size_t b = 0; b < sides.size(); ++b) {
    const BlockId block{static_cast<std::int32_t>(b)};
    if (sides[b] != coupling::kDivided || model.support_of(block)) continue;
    if (stage.subcycled())
      throw s.error("explicit_region",
                    fmt::format("block {} lies across its border, and only a block whose other half takes implicit "
                                "steps is divided",
                                in_quotes(model.blocks[b].name)),
                    "a border between blocks where slow_blocks = \"explicit\"",
                    "move the border, or name the block in explicit_blocks or implicit_blocks");
    const bool onefold = std::any_of(stage.rules.begin(), stage.rules.end(), [&](const coupling::MethodRule& rule) {
      return rule.onefold && std::find(rule.blocks.begin(), rule.blocks.end(), block) != rule.blocks.end();
    });
    if (used[b] == "nmm" && !onefold) continue;
    throw s.error("explicit_region",
                  fmt::format("block {} lies across its border and has no mesh to be divided ({})",
                              in_quotes(model.blocks[b].name), onefold ? "a onefold cover" : used[b]),
                  "a border through blocks that use the NMM with a mesh",
                  "move the border, or name the block in explicit_blocks or implicit_blocks");
  }
}

void read_partition(const Section& s, const Model& model, coupling::Stage& stage) {
  if (stage.integrator != Integrator::partitioned) {
    refuse_elsewhere(s);
    return;
  }
  if (std::none_of(std::begin(kRules), std::end(kRules), [&](const char* key) { return s.has(key); }))
    throw s.error(
        "explicit_blocks", "no key selects the blocks that take explicit steps",
        "one or more of explicit_blocks, explicit_region, explicit_area, explicit_speed, explicit_strain_rate",
        "add explicit_blocks = [\"NAME\"], for example, or set integrator = \"implicit\"");
  Partition& p = stage.partition;
  p.explicit_blocks = read_side(s, "explicit_blocks", model);
  p.implicit_blocks = read_side(s, "implicit_blocks", model);
  for (const BlockId b : p.implicit_blocks)
    if (std::binary_search(p.explicit_blocks.begin(), p.explicit_blocks.end(), b))
      throw s.error("implicit_blocks", item_of(s, "implicit_blocks", b, model),
                    fmt::format("block {} is among explicit_blocks too", in_quotes(model.blocks[b.index()].name)),
                    "each block in one of the two lists", "remove it from one of them");
  if (s.has("explicit_region")) read_region(s, model, p);
  if (s.has("explicit_area")) p.explicit_area = s.number("explicit_area");
  p.speed = read_band(s, "explicit_speed", "implicit_speed", "m/s");
  p.strain_rate = read_band(s, "explicit_strain_rate", "implicit_strain_rate", "1/s");
  if (!s.has("slow_blocks")) s.settle("slow_blocks", "implicit");
  p.slow_explicit = s.text("slow_blocks") == "explicit";
  p.shared_contacts = s.boolean("shared_contacts");
  if (p.slow_explicit && p.shared_contacts)
    throw s.error("shared_contacts", "all contacts are explicit where slow_blocks = \"explicit\"", "false",
                  "remove the key");
  if (s.has("substeps")) p.substeps = s.integer("substeps");
}

}  // namespace scree::io
