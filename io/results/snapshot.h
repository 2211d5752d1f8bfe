// Pictures of a stored run, for papers and reports: a frame coloured by a field, and the energy ledger over time.
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

enum class Field { displacement, speed, sxx, syy, sxy, s1, s3, block, method };
/// Names as above, in that order.
[[nodiscard]] const std::vector<std::string>& field_names();
[[nodiscard]] std::optional<Field> field_named(std::string_view name);

struct SnapshotOptions {
  Field field = Field::displacement;
  std::optional<std::size_t> frame;                // counted from 0; before `time`
  std::optional<double> time;                      // the last frame not after it [s]; neither: the last frame
  int width = 1680;                                // of the picture [pixels]; its height follows from the model
  std::optional<std::pair<double, double>> range;  // of the colours, in SI units, low < high; else from the values
  std::optional<Box> window;                       // what to show [m]; empty: everything
};

/// Draws a stored frame. Blocks that are held whole (fixed or driven) are hatched grey and take no part in the colour
/// range, so that what moves stands out. Magnitudes in viridis from zero; stress (tension positive) from blue
/// through white to red, the range covering 99 % of the area, the rest in the end colours.
/// @throws FileError where the run cannot be read, there is no such frame, or the picture cannot be written
void snapshot(const std::filesystem::path& run_folder, const SnapshotOptions& options,
              const std::filesystem::path& png);

/// Draws energy, work and dissipation over time, columns that are zero throughout left out; below them |closure| over
/// energy moved on a logarithmic axis.   @throws FileError
void plot_ledger(const std::filesystem::path& run_folder, const std::filesystem::path& png);

}  // namespace scree::io
