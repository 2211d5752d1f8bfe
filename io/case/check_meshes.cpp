// Refuses meshes too large for the memory of the machine or for the program, before they are made.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "coupling/stages/mesh_estimate.h"
#include "io/case/read_parts.h"

namespace scree::io {
namespace {

/// Memory of the machine, or less where the shell limits it (ulimit -v) [bytes].
double memory() {
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES)), page = static_cast<double>(sysconf(_SC_PAGESIZE));
  rlimit limit{};
  const bool limited = getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return limited ? std::min(pages * page, static_cast<double>(limit.rlim_cur)) : pages * page;
}

/// The table from which a block takes its cover_size: of the block, of its region, or of the stage.
Section giver(const Section& root, const Section& stage, const Block& block) {
  if (block.cover_size == 0.0) return stage;
  for (const Section& s : root.list("block"))
    if (s.has("cover_size") && s.text("name") == block.name) return s;
  if (root.has("domain"))
    for (const Section& s : root.table("domain").list("region"))
      if (s.has("cover_size") && s.number("cover_size") == block.cover_size) return s;
  return stage;
}

}  // namespace

void check_meshes(const Section& root, const Model& model, const coupling::Plan& plan) {
  const std::vector<Section> stages = root.list("stage");
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const coupling::MeshEstimate found = coupling::mesh_estimate(model, plan.stages[i]);
    const double over = std::max(found.bytes / memory(), found.elements / coupling::kMostElements);
    if (over <= 1.0) continue;
    const Block& block = model.blocks[found.finest.index()];
    const Section at = giver(root, stages[i], block);
    throw at.error(
        "cover_size",
        fmt::format("stage {} would have about {:.2g} elements and take {:.2g} GB; there are {:.2g} GB, most "
                    "of it in block {}",
                    in_quotes(plan.stages[i].name), found.elements, 1e-9 * found.bytes, 1e-9 * memory(),
                    in_quotes(block.name)),
        fmt::format("about {:.2g} m or more", found.cover_size * std::sqrt(over)),
        "choose larger covers: a tenth of the smallest block is a start");
  }
}

}  // namespace scree::io
