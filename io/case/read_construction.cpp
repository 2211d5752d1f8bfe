// Excavation and filling by stages: names and regions become lists of the blocks that are absent in a stage.
#include <fmt/format.h>

#include <algorithm>

#include "io/case/read_parts.h"
#include "io/case/suggest.h"
#include "model/planar.h"

namespace scree::io {
namespace {

using coupling::Construction;

constexpr const char* kKeys[] = {"excavate", "excavate_in", "fill", "fill_in"};

/// A block that a key selects, and whether by its own name, not by a pattern or a region.
struct Choice {
  BlockId block;
  const char* key = "";
  std::size_t item = 0;
  bool named = false;
};

/// Appends the blocks whose centroid, in the position given in the case, lies in the region under the key.
void choose_in(const Section& s, const char* key, const Model& model, std::vector<Choice>& out) {
  if (!s.has(key)) return;
  Polygon region{s.ring(key), {}};
  if (const std::string why = invalidity(region); !why.empty())
    throw s.error(key, "the region is not a polygon: " + why, "ring [m] that does not cross itself",
                  "list the corners in their order around the region");
  (void)orient(region);
  const std::size_t before = out.size();
  for (std::size_t b = 0; b < model.blocks.size(); ++b)
    if (contains(region, moments(model.blocks[b].polygon).centroid))
      out.push_back({BlockId{static_cast<std::int32_t>(b)}, key, 0, false});
  if (out.size() == before)
    throw s.error(key, "no block has its centroid in the region", "a region with blocks",
                  "compare it with the blocks' corners, which are in the same coordinates; `scree check CASE --blocks` "
                  "lists their centroids");
}

/// Blocks that a list of names and a region select.
std::vector<Choice> chosen(const Section& s, const char* list, const char* region, const Model& model) {
  std::vector<Choice> out;
  if (s.has(list)) {
    const std::vector<std::string> patterns = s.texts(list), known = names_of(model.blocks);
    if (patterns.empty())
      throw s.error(list, "the list of blocks is empty", "names of blocks", "name the blocks, or remove the key");
    for (std::size_t i = 0; i < patterns.size(); ++i)
      for (const std::int32_t b : find_names(s, list, i, "block", known))
        out.push_back({BlockId{b}, list, i, known[static_cast<std::size_t>(b)] == patterns[i]});
  }
  choose_in(s, region, model, out);
  return out;
}

CaseError error_at(const Section& s, const Choice& at, std::string problem, std::string allowed, std::string hint) {
  return at.key == std::string_view("excavate") || at.key == std::string_view("fill")
             ? s.error(at.key, at.item, std::move(problem), std::move(allowed), std::move(hint))
             : s.error(at.key, std::move(problem), std::move(allowed), std::move(hint));
}

/// Processes the stages in order and keeps the absent blocks and the released part of each excavation.
class Reader {
 public:
  explicit Reader(const Model& model) : model_(&model), absent_(model.blocks.size(), 0), seen_(absent_) {}

  /// A block that a stage fills before any stage has excavated it is absent from the start.
  void begin(const std::vector<Section>& stages) {
    for (const Section& s : stages) {
      for (const Choice& c : chosen(s, "fill", "fill_in", *model_))
        if (seen_[c.block.index()] == 0) absent_[c.block.index()] = 1;
      for (const auto& [list, region] : {std::pair("fill", "fill_in"), std::pair("excavate", "excavate_in")})
        for (const Choice& c : chosen(s, list, region, *model_)) seen_[c.block.index()] = 1;
    }
  }

  void stage(const Section& s, bool first, coupling::Stage& stage) {
    if (first)
      for (const char* key : kKeys)
        if (s.has(key))
          throw s.error(key, "the first stage begins with the blocks as they are, without forces between them",
                        "the key in a later stage",
                        "add a stage with rest = true before it; for blocks that are never there, remove the blocks");
    const std::vector<BlockId> left = change(s, "excavate", "excavate_in", 0), came = change(s, "fill", "fill_in", 1);
    for (const BlockId b : came)
      if (std::find(left.begin(), left.end(), b) != left.end())
        throw s.error(s.has("fill") ? "fill" : "fill_in",
                      fmt::format("block {} is excavated by the same stage", in_quotes(name(b))),
                      "blocks that an earlier stage has excavated", "fill it in a later stage");
    for (const BlockId b : left) absent_[b.index()] = 1;
    for (const BlockId b : came) absent_[b.index()] = 0;
    Construction& c = stage.construction;
    for (std::size_t b = 0; b < absent_.size(); ++b)
      if (absent_[b] != 0) c.absent.emplace_back(static_cast<std::int32_t>(b));
    if (c.absent.size() == absent_.size())
      throw s.error(s.has("excavate") ? "excavate" : "excavate_in", "no block is left", "a part of the blocks",
                    "leave the rock in place");
    release(s, !left.empty(), stage);
    if (stage.newmark == coupling::NewmarkScheme::trapezoidal && !c.absent.empty())
      throw s.error("newmark", "the trapezoidal scheme needs all blocks, and some are absent in this stage",
                    "\"damped\" where blocks are excavated or filled", "use newmark = \"damped\"");
  }

 private:
  [[nodiscard]] const std::string& name(BlockId b) const { return model_->blocks[b.index()].name; }

  /// Blocks that a stage excavates (there: 0) or fills (there: 1), each once. Patterns and regions skip blocks that are
  /// absent or present already.
  std::vector<BlockId> change(const Section& s, const char* list, const char* region, char there) const {
    std::vector<BlockId> out;
    const std::vector<Choice> all = chosen(s, list, region, *model_);
    for (const Choice& c : all) {
      if (absent_[c.block.index()] == there) {
        out.push_back(c.block);
      } else if (c.named) {
        throw error_at(
            s, c, fmt::format("block {} is {}", in_quotes(name(c.block)), there == 0 ? "not there" : "there already"),
            there == 0 ? "blocks that are there as the stage begins" : "blocks that are not there yet",
            there == 0 ? "remove the name; an earlier stage has excavated it, or a later one fills it first"
                       : "remove the name, or excavate the block in an earlier stage");
      }
    }
    if (!all.empty() && out.empty())
      throw error_at(s, all.front(),
                     there == 0 ? "all of these blocks are excavated already" : "all of these blocks are there already",
                     there == 0 ? "blocks that are there as the stage begins" : "blocks that are not there yet",
                     "choose other blocks, or remove the key");
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  void release(const Section& s, bool excavates, coupling::Stage& stage) {
    Construction& c = stage.construction;
    if (!excavates && !s.has("release")) {
      if (s.has("release_time"))
        throw s.error("release_time", "the stage releases nothing", "beside excavate, excavate_in or release",
                      "remove the key, or say with release how much of earlier excavations it releases");
      return;
    }
    if (!s.has("release")) s.settle("release", 1.0);
    const double part = s.number("release");
    if (excavates) released_.push_back(0.0);
    if (std::all_of(released_.begin(), released_.end(), [&](double r) { return r >= part; }) && !excavates)
      throw s.error("release",
                    released_.empty() ? std::string("nothing has been excavated")
                                      : fmt::format("{:g} and more of it is released already",
                                                    *std::min_element(released_.begin(), released_.end())),
                    released_.empty() ? "beside excavate or excavate_in, or after a stage with them"
                                      : "more than what is released already, at most 1",
                    "remove the key, or raise it");
    for (double& r : released_) r = std::max(r, part);
    c.release = part;
    if (!s.has("release_time")) return;
    c.release_time = ticks(s.number("release_time"));
    if (c.release_time > stage.duration)
      throw s.error("release_time", "the stage ends before",
                    fmt::format("at most duration, {:g} s", seconds(stage.duration)),
                    "shorten it, or make the stage longer");
    if (part == 0.0)
      throw s.error("release_time", "release = 0 releases nothing", "beside release above 0", "remove the key");
  }

  const Model* model_;
  std::vector<char> absent_, seen_;
  std::vector<double> released_;  // of each excavation so far
};

/// Refuses bolts in absent blocks: those that a bolt holds must be present from its installation to the end.
void check_bolts(const Section& s, std::size_t index, const Model& model, const Construction& construction) {
  const std::vector<char> absent = construction.flags(model.blocks.size());
  for (const Bolt& bolt : model.bolts) {
    if (bolt.stage.valid() && bolt.stage.index() > index) continue;
    const auto refuse = [&](BlockId b) {
      if (absent[b.index()] == 0) return;
      throw s.error(s.has("excavate") ? "excavate" : (s.has("excavate_in") ? "excavate_in" : "name"),
                    fmt::format("bolt {} holds block {}, which is not there in this stage", in_quotes(bolt.name),
                                in_quotes(model.blocks[b.index()].name)),
                    "bolts in blocks that are there from the bolt's stage to the end",
                    "end the bolt in rock that stays, or install it in a stage after the block is filled");
    };
    for (const Bolt::Node& n : bolt.nodes) refuse(n.block);
    for (const Bolt::Crossing& c : bolt.crossings) {
      refuse(c.before);
      refuse(c.after);
    }
  }
}

}  // namespace

void read_construction(const Section& root, const Model& model, coupling::Plan& plan) {
  const std::vector<Section> stages = root.list("stage");
  const auto builds = [](const Section& s) {
    return s.has("release") || s.has("release_time") ||
           std::any_of(std::begin(kKeys), std::end(kKeys), [&](const char* key) { return s.has(key); });
  };
  if (std::none_of(stages.begin(), stages.end(), builds)) return;
  Reader reader(model);
  reader.begin(stages);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    reader.stage(stages[i], i == 0, plan.stages[i]);
    check_bolts(stages[i], i, model, plan.stages[i].construction);
  }
}

}  // namespace scree::io
