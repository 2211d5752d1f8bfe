#include "io/results/regular_file.h"

#include <string>
#include <system_error>

#include "io/results/file_error.h"

namespace scree::io {

void require_regular(const std::filesystem::path& path) {
  using Type = std::filesystem::file_type;
  std::error_code ignored;  // a path without a status cannot be opened either, and opening it reports why
  const Type type = std::filesystem::status(path, ignored).type();
  const char* what = type == Type::directory   ? "a folder"
                     : type == Type::fifo      ? "a named pipe"
                     : type == Type::socket    ? "a socket"
                     : type == Type::character ? "a device"
                     : type == Type::block     ? "a device"
                                               : nullptr;
  if (what != nullptr) throw FileError(path, std::string("is ") + what + " where a regular file must stand");
}

}  // namespace scree::io
