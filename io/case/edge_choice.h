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

}  // namespace scree::io
