#include "io/results/results_size.h"

#include <algorithm>

#include "coupling/stages/mesh_estimate.h"

namespace scree::io {

ResultsSize results_size(const Model& model, const coupling::Plan& plan) {
  ResultsSize size;
  double ticks = 0.0, corners = 0.0;
  for (const Block& block : model.blocks) {
    corners += static_cast<double>(block.polygon.outer.size());
    for (const Ring& hole : block.polygon.holes) corners += static_cast<double>(hole.size());
  }
  const auto blocks = static_cast<double>(model.blocks.size());
  for (const coupling::Stage& stage : plan.stages) {
    ticks += static_cast<double>(stage.duration);
    // Elements are triangles, those along an outline are cut to three to five vertices. Cells share no points.
    const double elements = coupling::mesh_estimate(model, stage).elements;
    size.cells = std::max(size.cells, elements + blocks);
    size.points = std::max(size.points, 3.5 * elements + corners);
  }
  // One frame at the beginning and one at the end of each stage, in addition to those at regular times.
  const double of_stages = 2.0 * static_cast<double>(plan.stages.size());
  const auto rows = [&](Tick every) { return of_stages + (every > 0 ? ticks / static_cast<double>(every) : 0.0); };
  size.frames = rows(plan.output.every);
  size.samples = rows(plan.output.history_every);
  if (plan.output.contacts) size.contacts = 2.0 * corners;
  return size;
}

}  // namespace scree::io
