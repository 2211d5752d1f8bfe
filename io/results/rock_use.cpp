#include "io/results/rock_use.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/results/stored_cells.h"

namespace scree::io {
std::vector<double> cell_utilisation(const StoredFrame& frame, const std::vector<StoredMaterial>& materials) {
  std::vector<double> out(frame.cells(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t c = 0; c < out.size(); ++c) {
    const StoredMaterial& m = materials[static_cast<std::size_t>(frame.material[c])];
    if (m.strength) out[c] = utilisation(*m.strength, frame.principal[2 * c], frame.principal[2 * c + 1]);
  }
  return out;
}

std::vector<RockUse> rock_use(const RunReader& run, std::size_t frame) {
  const StoredFrame f = run.frame(frame);
  const std::vector<double> use = cell_utilisation(f, run.materials());
  std::vector<RockUse> all(run.blocks().size());
  for (std::size_t c = 0; c < use.size(); ++c) {
    const auto b = static_cast<std::size_t>(f.block[c]);
    if (run.blocks()[b].held || std::isnan(use[c])) continue;
    RockUse& r = all[b];
    if (use[c] > 1.0) r.area += std::abs(cell_area(f, c));
    if (!r.block.empty() && !(use[c] > r.utilisation)) continue;
    r = {run.blocks()[b].name,
         run.materials()[static_cast<std::size_t>(f.material[c])].name,
         use[c],
         cell_middle(f, c) + run.origin(),
         f.principal[2 * c],
         f.principal[2 * c + 1],
         r.area};
  }
  std::erase_if(all, [](const RockUse& r) { return r.block.empty(); });
  std::stable_sort(all.begin(), all.end(),
                   [](const RockUse& a, const RockUse& b) { return a.utilisation > b.utilisation; });
  return all;
}

std::string rock_use_text(const std::vector<RockUse>& use) {
  if (use.empty()) return {};
  const RockUse& worst = use.front();
  double area = 0.0;
  std::size_t above = 0;
  for (const RockUse& r : use) {
    area += r.area;
    above += r.utilisation > 1.0 ? 1 : 0;
  }
  const std::string where =
      fmt::format("{:.3g} of the strength of '{}' in block '{}' at ({:.6g}, {:.6g}) m, s1 {:.4g} Pa, s3 {:.4g} Pa",
                  worst.utilisation, worst.material, worst.block, worst.at.x(), worst.at.y(), worst.s1, worst.s3);
  if (above == 0) return "rock: stress is nowhere above the strength, at most " + where;
  return fmt::format("rock: stress is above the strength in {} of {} blocks, {:.4g} m2, at most {}", above, use.size(),
                     area, where);
}

}  // namespace scree::io
