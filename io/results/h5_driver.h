// The file driver of HDF5 through which results are written: what is overwritten is kept in an undo log first.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>

#include "io/results/undo_log.h"

namespace scree::io::h5 {

/// What the driver knows of a file.
struct Writes {
  explicit Writes(const std::filesystem::path& file) : undo(file) {}
  UndoLog undo;            // stores nothing until it is started
  std::uint64_t made = 0;  // writes so far: what HDF5 holds back is not among them
};

/// Makes files that are opened with `access` go by the driver.
/// @param writes  outlives the file   @throws FileError, by the path of the file
void write_through(hid_t access, Writes& writes, const std::filesystem::path& path);

}  // namespace scree::io::h5
