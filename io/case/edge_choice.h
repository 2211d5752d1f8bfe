// Parts of outlines as sections of a case choose them: by a line, or by the number of an edge.
#pragma once

#include <vector>

#include "io/case/section.h"
#include "model/model.h"

namespace scree::io {

/// The stretches of the block's outline that the keys `on` or `edge` of a section mean; at least one.
/// @param root  the case, for the order in which the corners of listed blocks were written
/// @throws CaseError: neither key or both, no straight line, nothing on the line (with the distance of the nearest
///         edge), no such edge, an edge of a block that a domain was cut into
[[nodiscard]] std::vector<EdgeSpan> chosen_edges(const Section& s, const Section& root, const Model& model,
                                                 BlockId block);

/// The stretches of outlines that `on` (a line of any number of points) or `box` mean; at least one. Of all blocks
/// those that face no other block; with block, blocks or at in the section those of these blocks, whatever faces them.
/// @throws CaseError: a line or box without extent, nothing on it
[[nodiscard]] std::vector<EdgeSpan> free_edges(const Section& s, const Model& model);

}  // namespace scree::io
