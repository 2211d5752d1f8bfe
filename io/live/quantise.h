// Displacements as 16-bit numbers.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace scree::io {

/// Displacements of consecutive points: d = base + scale * q, to within scale / 2.
struct Quantised {
  std::array<double, 2> base{0.0, 0.0};  // [m]
  double scale = 0.0;                    // [m]; the widest range of x and y over 65534
  std::vector<std::int16_t> dx, dy;      // -32767 to 32767, or kNotFinite
};
inline constexpr std::int16_t kNotFinite = -32768;

/// @param dx,dy  one number per point [m]; may hold infinities and NaN
[[nodiscard]] Quantised quantise(std::span<const double> dx, std::span<const double> dy);

/// base + scale * q, NaN for kNotFinite.
[[nodiscard]] double restore(double base, double scale, std::int16_t q);

}  // namespace scree::io
