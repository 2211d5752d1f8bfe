// Selection of blocks in sections of a case: by name, or by a point.
#pragma once

#include <string_view>
#include <vector>

#include "io/case/section.h"
#include "model/model.h"

namespace scree::io {

/// Distance within which a point of a case file counts as lying on an outline: 1e-6 of the outline's extent [m].
[[nodiscard]] double near_outline(const Polygon& polygon);
/// True if the point lies inside the polygon or within near_outline of its outline.
[[nodiscard]] bool on_block(const Polygon& polygon, const Vec2& point);

/// @throws CaseError at the key `point` if the point is neither inside the block nor on its outline
void check_point(const Section& s, const Model& model, BlockId block, const Vec2& point);
/// All blocks that contain a point, inside or on their outline, in the order of the model.
[[nodiscard]] std::vector<BlockId> blocks_at(const Model& model, const Vec2& point);
/// The one block that contains the point under a key.   @throws CaseError: no block or several blocks contain it
[[nodiscard]] BlockId block_at(const Section& s, std::string_view key, const Model& model);
/// The block named under `block`; without that key the block that contains the point under `at`.
[[nodiscard]] BlockId block_of(const Section& s, const Model& model, std::string_view at = "at");

}  // namespace scree::io
