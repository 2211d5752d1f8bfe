// The file driver of HDF5 through which results are written: what is overwritten is kept in an undo log first.
#pragma once

#include <hdf5.h>

#include <filesystem>

#include "io/results/undo_log.h"

namespace scree::io::h5 {

/// Makes files that are opened with `access` go by the driver.
/// @param log  outlives the file; it stores nothing until it is started
/// @throws FileError, by the path of the file
void write_through(hid_t access, UndoLog& log, const std::filesystem::path& path);

}  // namespace scree::io::h5
