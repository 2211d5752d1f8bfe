#include "coupling/stages/bolt_watch.h"

#include <fmt/format.h>

#include <cmath>

namespace scree::coupling {
namespace {

std::string break_text(const Model& model, const Bolt& bolt, const BoltMemory& memory, std::size_t segment) {
  const Bolt::Node &a = bolt.nodes[segment], &b = bolt.nodes[segment + 1];
  const auto name = [&](BlockId block) { return model.blocks[block.index()].name; };
  std::string text =
      fmt::format("{} '{}' breaks between {:.3g} m and {:.3g} m from its {}, in ", bolt.liner() ? "liner" : "bolt",
                  bolt.name, a.at, b.at, bolt.liner() ? "beginning" : "head");
  text += a.block == b.block ? fmt::format("block '{}'", name(a.block))
                             : fmt::format("blocks '{}' and '{}'", name(a.block), name(b.block));
  text += fmt::format(": plastic strain {:.3g}", memory.plastic[segment] / (b.at - a.at));
  for (std::size_t c = 0; c < bolt.crossings.size(); ++c)
    if (static_cast<std::size_t>(bolt.crossings[c].segment) == segment && memory.sheared[c] != 0.0)
      text += fmt::format(", plastic shear {:.3g} m", std::abs(memory.sheared[c]));
  return text;
}

}  // namespace

std::vector<std::string> BoltWatch::new_breaks(const Model* model, const State& state) {
  std::vector<std::string> out;
  broken_.resize(state.bolts.size());
  for (std::size_t i = 0; i < broken_.size(); ++i) {
    const std::vector<std::int8_t>& now = state.bolts[i].broken;
    if (now == broken_[i]) continue;
    broken_[i].resize(now.size(), 0);
    for (std::size_t s = 0; s < now.size(); ++s) {
      if (now[s] != 0 && broken_[i][s] == 0 && model != nullptr)
        out.push_back(break_text(*model, model->bolts[i], state.bolts[i], s));
      broken_[i][s] = now[s];
    }
  }
  return out;
}

}  // namespace scree::coupling
