// Selection of parts of outlines in sections of a case: by a line, or by the number of an edge.
#pragma once

#include <vector>

#include "io/case/section.h"
#include "model/model.h"

namespace scree::io {

/// The stretches of the block's outline that the key `on` or `edge` of a section selects; at least one.
/// @param root  the case, which contains the corners of listed blocks in the order in which they were written
/// @throws CaseError: neither key or both, no straight line, nothing on the line (with the distance of the nearest
///         edge), no such edge, an edge of a block that a domain was cut into
[[nodiscard]] std::vector<EdgeSpan> chosen_edges(const Section& s, const Section& root, const Model& model,
                                                 BlockId block);

/// The stretches of outlines that `on` (a line of any number of points) or `box` selects; at least one. Without block,
/// blocks and at in the section: of all blocks, where the outline faces no other block. With one of these keys: of the
/// blocks that it selects, whether or not the outline faces another block.
/// @throws CaseError: a line or box without extent, nothing on it
[[nodiscard]] std::vector<EdgeSpan> free_edges(const Section& s, const Model& model);

}  // namespace scree::io
