// Indices of the parts of outlines: a vector of one kind does not accept an index of another kind.
#pragma once

#include "model/indexed.h"

namespace scree::coupling {

using OutlineNode = Id<struct OutlineNodeTag>;  // into Outlines::nodes
using SegmentIndex = Id<struct SegmentTag>;     // into Outlines::segments
using VertexIndex = Id<struct VertexTag>;       // into Outlines::vertices
using EdgeIndex = Id<struct EdgeTag>;           // into Outlines::edges

}  // namespace scree::coupling
