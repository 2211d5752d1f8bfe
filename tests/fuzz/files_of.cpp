#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/fuzz/harness.h"

namespace scree::fuzz {

std::vector<Input> files_of(const std::string& folder, const std::vector<std::string>& endings) {
  std::vector<std::filesystem::path> paths;
  const std::filesystem::path root = std::filesystem::path(SCREE_SOURCE_DIR) / folder;
  if (!std::filesystem::exists(root)) return {};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
    if (entry.is_regular_file() && std::ranges::find(endings, entry.path().extension().string()) != endings.end())
      paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<Input> out;
  for (const std::filesystem::path& path : paths) {
    std::ifstream in(path, std::ios::binary);
    out.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return out;
}

}  // namespace scree::fuzz
