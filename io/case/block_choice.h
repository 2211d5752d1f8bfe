// Blocks as sections of a case name them: by name, or by a point.
#pragma once

#include <string_view>
#include <vector>

#include "io/case/section.h"
#include "model/model.h"

namespace scree::io {

/// Coordinates as people write them are on an outline if they are this near to it: 1e-6 of its extent [m].
[[nodiscard]] double near_outline(const Polygon& polygon);
/// True inside the polygon and on its outline, within near_outline.
[[nodiscard]] bool on_block(const Polygon& polygon, const Vec2& point);

/// @throws CaseError at the key `point` where the point is not on the block
void check_point(const Section& s, const Model& model, BlockId block, const Vec2& point);
/// All blocks that hold a point, inside or on their outline, in their order.
[[nodiscard]] std::vector<BlockId> blocks_at(const Model& model, const Vec2& point);
/// The one block that holds the point under a key.   @throws CaseError: none, or several on their boundary
[[nodiscard]] BlockId block_at(const Section& s, std::string_view key, const Model& model);
/// The block named under `block`; without that key the one that holds the point under `at`.
[[nodiscard]] BlockId block_of(const Section& s, const Model& model, std::string_view at = "at");

}  // namespace scree::io
