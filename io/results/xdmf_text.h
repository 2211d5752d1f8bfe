// The text of an XDMF 3 file: one temporal collection of grids of polygons. Every array is in an HDF5 file beside it
// or, if it is short, in the text itself.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::io::xdmf {

/// An array of doubles or of int32, `width` numbers per row.
struct Array {
  std::string path;  // "run.vtkhdf:/xdmf/Points/0/0"
  std::int64_t rows = 0;
  int width = 1;
  bool whole = false;               // whole numbers (int32)
  std::span<const double> numbers;  // the array itself, in place of a path; the text reads back to the same bits
};
[[nodiscard]] std::string item(const Array& array);

/// Cells of the "Mixed" kind: for each cell its type (3: polygon), its number of points and the points.
[[nodiscard]] std::vector<std::int32_t> mixed_polygons(std::span<const std::int32_t> offsets,
                                                       std::span<const std::int32_t> connectivity);
[[nodiscard]] std::string topology(std::int64_t cells, const Array& mixed);
/// @param type  XYZ
[[nodiscard]] std::string geometry(std::string_view type, const Array& points);
/// @param center  Node or Cell   @param type  Scalar, Vector or Matrix
[[nodiscard]] std::string attribute(std::string_view name, std::string_view center, std::string_view type,
                                    const Array& values);
/// @param parts  topology, geometry, attributes   @param time [s]
[[nodiscard]] std::string grid(std::int64_t number, std::string_view parts, double time);
/// Text before the grids, and after them.
[[nodiscard]] std::string_view opening();
[[nodiscard]] std::string_view closing();

/// Distinct times, by which a reader can select a frame: of several equal times the last one stays, and each earlier
/// one is moved to just before the next, by 1 ps (a tick) or a few units of rounding of a double, if that is more.
/// @param times  ascending [s]   @return strictly ascending
[[nodiscard]] std::vector<double> told_apart(std::vector<double> times);

}  // namespace scree::io::xdmf
