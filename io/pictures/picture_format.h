// Picture formats, given by the names of the files.
#pragma once

#include <filesystem>
#include <optional>

namespace scree::io {

enum class PictureFormat { png, pdf, svg };
/// By the ending of the name, in small letters or capitals; nothing for any other.
[[nodiscard]] std::optional<PictureFormat> picture_format(const std::filesystem::path& file);
/// @throws FileError that lists the possible endings
[[nodiscard]] PictureFormat format_or_error(const std::filesystem::path& file);

}  // namespace scree::io
