// Pictures of a stored run, for papers and reports: a frame coloured by a field, histories and the energy ledger over
// time. A name that ends in .pdf or .svg keeps lines and letters as such; .png has pixels.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/results/file_error.h"
#include "model/geometry.h"

namespace scree::io {

enum class Field { displacement, speed, sxx, syy, sxy, s1, s3, block, method, material, utilisation };
/// Names as above, in that order.
[[nodiscard]] const std::vector<std::string>& field_names();
[[nodiscard]] std::optional<Field> field_named(std::string_view name);

enum class Arrows { none, displacement, velocity };

struct SnapshotOptions {
  Field field = Field::displacement;
  std::optional<std::size_t> frame;                // counted from 0; takes precedence over `time`
  std::optional<double> time;                      // the last frame not after it [s]; neither: the last frame
  int width = 1680;                                // of a PNG [pixels]; its height follows from the model
  std::optional<std::pair<double, double>> range;  // of the colours, in SI units, low < high; else from the values
  std::optional<Box> window;                       // what to show [m]; empty: everything
  Arrows arrows = Arrows::none;                    // one per block, more on large blocks
  bool labels = false;                             // names of the blocks, small where they do not fit in
  bool smooth = true;                              // stress recovered at the corners of elements; false: as stored
};

/// Draws a stored frame. Blocks that are held whole (fixed or driven) are hatched grey and excluded from the colour
/// range, so that moving blocks stand out. Magnitudes in viridis from zero; stress (tension positive) from blue
/// through white to red, recovered at the corners of elements (recovered_stress.h) and linear between them, the range
/// covering 99 % of the area, the rest in the end colours. White is zero also where the given range is not about zero.
/// @param file  .png, .pdf or .svg   @pre the range and the window, where given, are not empty
/// @throws FileError where the run cannot be read, there is no such frame, or the picture cannot be written
void snapshot(const std::filesystem::path& run_folder, const SnapshotOptions& options,
              const std::filesystem::path& file);

/// Draws energy, work and dissipation over time, columns that stay below a thousandth of the largest left out; below
/// them |closure| over energy moved on a logarithmic axis.   @throws FileError
void plot_ledger(const std::filesystem::path& run_folder, const std::filesystem::path& file);

/// Draws displacement (x, y) and speed of monitors over time.
/// @param names  of monitors ("slide-1#2") or of blocks (all of the block), in this order; none: all
/// @throws FileError, also when there is no such monitor
void plot_history(const std::filesystem::path& run_folder, const std::vector<std::string>& names,
                  const std::filesystem::path& file);

}  // namespace scree::io
