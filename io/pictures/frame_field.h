// Data of a frame for a snapshot: one number per cell, their range, and the outlines of the blocks.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "io/pictures/snapshot.h"
#include "io/results/run_reader.h"
#include "io/results/stored_cells.h"

namespace scree::io {

/// How a field is drawn.
struct FieldInfo {
  const char* label = "";
  const char* unit = "";   // SI; empty: names, not numbers
  bool is_signed = false;  // diverging colours about zero
};
[[nodiscard]] const FieldInfo& info(Field field);

/// One number per cell, in SI units (block, method, material: their number). Point fields: mean magnitude over the
/// cell's points.
[[nodiscard]] std::vector<double> cell_values(const StoredFrame& frame, Field field);

/// A field of stress from its components xx, yy, xy.   @pre the field is one of stress
[[nodiscard]] double stress_value(const std::array<double, 3>& stress, Field field);

/// Range of colours: [0, largest] of magnitudes, [-s, s] of signed fields with |value| <= s on 99 % of the area.
/// Cells with `skip` are left out. Never empty.
/// @param rounding  values not above it are noise: if all values are noise, the largest is replaced by 1
[[nodiscard]] std::pair<double, double> colour_range(const StoredFrame& frame, Field field,
                                                     const std::vector<double>& values, const std::vector<char>& skip,
                                                     double rounding);

/// Values of a field due to rounding alone: 1e-12 of the model's extent (displacement), of the stiffest material's
/// modulus (stress); zero for the others.
[[nodiscard]] double rounding_of(Field field, const StoredFrame& frame, const std::vector<StoredMaterial>& materials);

/// A vector at a place [m].
struct Arrow {
  Vec2 at, vector;
};
/// The mean of a vector over each block that is not skipped; a block larger than `spacing` is divided evenly.
/// @param value  two per cell   @param skip  per cell   @param spacing [m], positive
[[nodiscard]] std::vector<Arrow> arrows_of(const StoredFrame& frame, const std::vector<double>& value,
                                           const std::vector<char>& skip, double spacing);

/// Edges (two points each) that only one cell of a block has: its outline. Edges are matched by the positions of
/// their points in the model, so cells need not share points.
[[nodiscard]] std::vector<std::pair<std::int64_t, std::int64_t>> outline_edges(const StoredFrame& frame);

}  // namespace scree::io
