// Refuses other things in place of a file: a named pipe would block its reader, a device has no end.
#pragma once

#include <filesystem>

namespace scree::io {

/// Checks that the path is a regular file, a link to one, or missing.
/// @throws FileError for a folder, a named pipe, a socket or a device, with its kind; opens nothing
void require_regular(const std::filesystem::path& path);

}  // namespace scree::io
