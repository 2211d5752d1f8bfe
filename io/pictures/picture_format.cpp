#include "io/pictures/picture_format.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "io/results/file_error.h"

namespace scree::io {

std::optional<PictureFormat> picture_format(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".pdf") return PictureFormat::pdf;
  if (ending == ".svg") return PictureFormat::svg;
  return std::nullopt;
}

PictureFormat format_or_error(const std::filesystem::path& file) {
  if (const auto format = picture_format(file)) return *format;
  throw FileError(file, "is no name of a picture; it must end in .png, .pdf or .svg");
}

}  // namespace scree::io
