// The words of an XDMF 3 file: one temporal collection of grids of polygons, every array in an HDF5 file beside it or,
// a short one, in the text itself.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::io::xdmf {

/// An array of doubles or of int32, `width` a row.
struct Array {
  std::string path;  // "run.vtkhdf:/xdmf/Points/0/0"
  std::int64_t rows = 0;
  int width = 1;
  bool whole = false;               // numbers
  std::span<const double> numbers;  // the array itself, in place of a path; read back to the same bits
};
[[nodiscard]] std::string item(const Array& array);

/// Cells of the "Mixed" kind, which tells of each cell its kind (3: polygon) and its number of points, then the points.
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
/// What stands before the grids, and after.
[[nodiscard]] std::string_view opening();
[[nodiscard]] std::string_view closing();

/// Times that a reader can choose by: where several are equal, the last one stays and each before it is moved to just
/// before the next, by 1 ps (a tick) or by what a double can still tell apart there.
/// @param times  ascending [s]   @return strictly ascending
[[nodiscard]] std::vector<double> told_apart(std::vector<double> times);

}  // namespace scree::io::xdmf
