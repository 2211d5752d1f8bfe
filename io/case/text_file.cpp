#include "io/case/text_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <new>

#include "io/case/case_error.h"

namespace scree::io {

std::string read_text_file(const std::filesystem::path& file, const char* what, std::size_t most) {
  const std::string name = file.string();
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw CaseError(name, {},
                    {fmt::format("the {} does not exist", what), "", in_quotes(name, 400), "", "check the path"});
  if (std::filesystem::is_directory(status))
    throw CaseError(
        name, {},
        {fmt::format("the {} is a folder", what), "", in_quotes(name, 400), "a text file", "give the file in it"});
  if (!std::filesystem::is_regular_file(status))
    throw CaseError(name, {},
                    {fmt::format("the {} is not a regular file", what), "", in_quotes(name, 400), "a text file",
                     "copy it to a file first"});
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  std::string text;
  if (in) {
    const auto size = std::filesystem::file_size(file, error);
    if (!error && size <= most) text.reserve(size);
    char chunk[65536];
    while (text.size() <= most && (in.read(chunk, sizeof chunk), in.gcount() > 0))
      text.append(chunk, static_cast<std::size_t>(in.gcount()));
  }
  if (errno == ENOMEM) throw std::bad_alloc();
  if (!in.is_open() || in.bad())
    throw CaseError(name, {},
                    {fmt::format("the {} cannot be read: {}", what, std::strerror(errno)), "", in_quotes(name, 400), "",
                     "check its permissions"});
  if (text.size() > most)
    throw CaseError(name, {},
                    {fmt::format("the {} is too large", what), "", "", fmt::format("at most {} bytes", most),
                     "check that it is the file you mean"});
  return text;
}

}  // namespace scree::io
