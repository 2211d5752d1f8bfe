// The HDF5 file driver through which results are written: bytes are saved in an undo log before they are overwritten.
#pragma once

#include <hdf5.h>

#include <filesystem>

#include "io/results/undo_log.h"

namespace scree::io::h5 {

/// Selects this driver for files that are opened with `access`.
/// @param log  outlives the file; it stores nothing until it is started
/// @throws FileError with the path of the file
void write_through(hid_t access, UndoLog& log, const std::filesystem::path& path);

}  // namespace scree::io::h5
