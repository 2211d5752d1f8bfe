#include "io/results/worst_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scree::io {

WorstContact worst_contact(const coupling::State& state, std::span<const std::string> blocks) {
  const coupling::ContactMemory *deepest = nullptr, *strongest = nullptr;
  // Squares are sufficient for comparison, and a frame may have 100,000 contacts.
  const auto force_squared = [](const coupling::ContactMemory& c) { return c.fn * c.fn + c.ft * c.ft; };
  double largest = 0.0;
  for (const coupling::ContactMemory& c : state.contacts) {
    if (c.status == coupling::ContactStatus::open) continue;
    if (deepest == nullptr || c.gap < deepest->gap) deepest = &c;
    const double f = force_squared(c);
    if (strongest != nullptr && !(f > largest)) continue;
    strongest = &c;
    largest = f;
  }
  const auto who_is = [&](std::int32_t block) {
    const auto b = static_cast<std::size_t>(block);
    return block >= 0 && b < blocks.size() && !blocks[b].empty() ? blocks[b] : fmt::format("block {}", block);
  };
  const auto where = [&](const coupling::ContactKey& k) {
    const std::string vertex =
        k.part == 0 ? fmt::format("corner {}", k.vertex) : fmt::format("edge {} node {}", k.vertex, k.part);
    return fmt::format("{} {} on {} edge {}", who_is(k.block_p), vertex, who_is(k.block_e), k.edge);
  };
  WorstContact worst;
  worst.time = seconds(state.time);
  if (deepest == nullptr) return worst;
  worst.depth = std::max(0.0, -deepest->gap);
  worst.depth_at = where(deepest->key);
  worst.force = std::hypot(strongest->fn, strongest->ft);
  worst.force_at = where(strongest->key);
  return worst;
}

}  // namespace scree::io
