#include "coupling/stages/rest_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::coupling {
namespace {

constexpr double kSlowing = 0.9;  // slows: displacement below this fraction of the one in the part before
constexpr double kStill = 1e-4;   // stands still: displacement below this fraction of that in the whole stage
constexpr double kBeside = 0.1;   // fraction of the largest displacement from which other blocks are listed too

/// "'a', 'b' and 3 more"
std::string listed_blocks(const Model& model, const std::vector<BlockId>& blocks) {
  constexpr std::size_t kNamed = 3;
  std::string out;
  for (std::size_t i = 0; i < std::min(kNamed, blocks.size()); ++i)
    out += fmt::format("{}'{}'", i == 0 ? "" : ", ", model.blocks[blocks[i].index()].name);
  return blocks.size() > kNamed ? out + fmt::format(" and {} more", blocks.size() - kNamed) : out;
}

std::string ways(const RestTrace& trace, const Setup& setup, std::span<const Vec2> centres) {
  const std::size_t bodies = setup.bodies().size();
  const auto at = [&](std::size_t part, std::size_t body) {
    const std::size_t k = 2 * (part * bodies + body);
    return Vec2(trace.centre[k], trace.centre[k + 1]);
  };
  struct Way {
    BlockId block;
    double last, before, all;
  };
  std::vector<Way> list;
  for (std::size_t i = 0; i < bodies; ++i) {
    if (setup.bodies()[i].driven) continue;
    list.push_back({setup.bodies()[i].block, (centres[i] - at(3, i)).norm(), (at(3, i) - at(2, i)).norm(),
                    (centres[i] - at(0, i)).norm()});
  }
  if (list.empty()) return {};
  std::stable_sort(list.begin(), list.end(), [](const Way& a, const Way& b) { return a.last > b.last; });
  const Way& first = list.front();
  if (!(first.last > kStill * first.all))
    return fmt::format("; no block moves any more (the farthest {:.2g} m in the last quarter of the stage)",
                       first.last);
  std::vector<BlockId> moving;
  for (const Way& w : list)
    if (w.last >= kBeside * first.last) moving.push_back(w.block);
  const bool slides = first.last >= kSlowing * first.before;
  return fmt::format("; {} {}: {:.3g} m in the last quarter of the stage, {:.3g} m in the one before",
                     listed_blocks(setup.model(), moving),
                     slides ? (moving.size() > 1 ? "slide, and do not slow down" : "slides, and does not slow down")
                            : (moving.size() > 1 ? "creep, and slow down" : "creeps, and slows down"),
                     first.last, first.before);
}

std::string rate(const RestTrace& trace, double length) {
  if (trace.least.size() < RestTrace::kParts) return {};
  std::string out = fmt::format(
      "; the least unbalanced force was {:.2g}, {:.2g}, {:.2g} and {:.2g} of the largest in the quarters of the stage",
      trace.least[0], trace.least[1], trace.least[2], trace.least[3]);
  constexpr double kFalls = 0.95;
  if (!(trace.least[3] < kFalls * trace.least[2])) return out + ": it does not fall any more";
  const double tenfold = 0.25 * length / std::log10(trace.least[2] / trace.least[3]);
  return out + fmt::format(": it falls tenfold in {:.2g} s", tenfold);
}

}  // namespace

bool RestTrace::begins_part(double progress) const {
  const auto begun = static_cast<double>(least.size());
  return begun < kParts && progress * kParts >= begun;
}

void RestTrace::begin_part(std::span<const Vec2> centres) {
  least.push_back(std::numeric_limits<double>::infinity());
  for (const Vec2& c : centres) centre.insert(centre.end(), {c.x(), c.y()});
}

void RestTrace::follow(double ratio) {
  if (!least.empty()) least.back() = std::min(least.back(), ratio);
}

std::string rest_text(const RestTrace& trace, const Setup& setup, std::span<const Vec2> centres, double length) {
  if (trace.centre.size() != 2 * RestTrace::kParts * setup.bodies().size()) return {};
  return ways(trace, setup, centres) + (std::isfinite(trace.least.back()) ? rate(trace, length) : std::string());
}

}  // namespace scree::coupling
