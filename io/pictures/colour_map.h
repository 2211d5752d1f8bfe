// Colours for numbers and for names.
#pragma once

#include <cstddef>

#include "io/pictures/canvas.h"

namespace scree::io {

/// Viridis for magnitudes, t from 0 to 1 (clamped).
[[nodiscard]] Colour sequential_colour(double t);
/// Blue, white, red for signed values, 0.5 is zero (clamped).
[[nodiscard]] Colour diverging_colour(double t);
/// Colours that are easily distinguished, counted from 0: 14, then paler and darker ones of them; repeating after 42.
[[nodiscard]] Colour distinct_colour(std::size_t number);

}  // namespace scree::io
