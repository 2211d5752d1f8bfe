#include "io/case/record.h"

#include <algorithm>

#include "io/case/text_file.h"

namespace scree::io {

namespace {
constexpr std::size_t kLargestRecord = std::size_t{64} << 20;  // bytes
}

Record read_record(const std::filesystem::path& file, Gaps gaps) {
  const std::string text = read_text_file(file, "record", kLargestRecord);
  std::string kind = file.extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return kind == ".at2" ? read_at2(text, file.string()) : read_columns(text, file.string(), gaps);
}

Record read_history(const std::filesystem::path& file, std::string_view quantity) {
  return read_columns(read_text_file(file, "table", kLargestRecord), file.string(), Gaps::accept, quantity);
}

}  // namespace scree::io
