// A dataset that shows rows of another one without storing them again (an HDF5 virtual dataset of the same file).
#pragma once

#include <cstdint>
#include <string>

#include "io/results/h5.h"

namespace scree::io::h5 {

/// Rows of a dataset of one dimension (width 1) or two.
struct Rows {
  std::string dataset;  // full path
  std::int64_t first = 0, count = 0;
  std::int64_t width = 1;
  bool whole = false;  // int32; false: double
};

/// Makes `name` (and its groups), which reads as `count` rows from row `first` of a dataset of the same file. Neither
/// the dataset nor the rows need to exist yet; missing rows read as zero. Nothing is read from the file for this: a run
/// makes a dozen windows per frame (40 us and 600 bytes each, of which the labels take 10 us and 120 bytes).
/// Virtual datasets need HDF5 1.10; the rest of the file stays in the layout that the library writes by default.
/// @param label  of the new dataset   @pre count > 0   @throws FileError
void window(const File& file, const std::string& name, const Rows& rows, const Label& label);

}  // namespace scree::io::h5
