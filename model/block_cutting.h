// A domain cut into blocks by its discontinuities.
#pragma once

#include <stdexcept>
#include <vector>

#include "model/discontinuity.h"
#include "model/domain.h"
#include "model/model.h"

namespace scree {

/// Blocks in a fixed order: by their lowest (then leftmost) corner, where their outlines also begin.
struct Cutting {
  std::vector<Block> blocks;     // named PREFIX-k, or REGION-k in a region, k counted from 1 in this order
  std::vector<Crack> cracks;     // blocks count from 0 in `blocks`
  std::vector<JointLine> lines;  // drawn
  std::vector<SetStatistics> sets;
  CuttingReport report;
};

/// The blocks do not fill the domain: a network too fine for the grid.
struct CuttingError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Nodes all lines on the snapped grid, drops dead ends (kept as cracks unless shorter than least_width), polygonises,
/// joins slivers (below least_area or least_width) to the neighbour with the longest shared edge, preferring those of
/// the same region, and straightens: a corner where two edges lie on one line and have one law is removed.
///   Law of an edge: the law of the joint on which it lies; on a region's outline the region's law; else none, so that
///   the default of the block (its region's or the domain's) or of the model applies; none on the domain's outline.
/// The result is the same bit for bit on every run, and does not depend on the order of traces, arcs and sets, unless
/// lines are coincident: then the first one determines the law.
/// @pre check_domain finds nothing     @throws CuttingError, std::runtime_error (GEOS)
/// @source docs/theory/contact-geometry.md, "Block cutting"
[[nodiscard]] Cutting cut_blocks(const Domain& domain);

}  // namespace scree
