// Something else in place of a file: a named pipe would make its reader wait, a device never ends.
#pragma once

#include <filesystem>

namespace scree::io {

/// What stands there: a regular file, or a link to one, or nothing.
/// @throws FileError for a folder, a named pipe, a socket or a device, which it names; opens nothing
void require_regular(const std::filesystem::path& path);

}  // namespace scree::io
