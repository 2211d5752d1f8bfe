#include "io/case/data_file.h"

#include <fmt/format.h>

#include <cstdlib>

namespace scree::io {
namespace {

constexpr std::string_view kRecords = "$SCREE_RECORDS/";

void collect(const Value& value, const std::filesystem::path& folder, std::vector<std::filesystem::path>& out) {
  if (const Array* items = value.as<Array>())
    for (const Value& item : *items) collect(item, folder, out);
  const Table* table = value.as<Table>();
  if (table == nullptr) return;
  for (const Member& m : *table) {
    const std::string* file = m.value.as<std::string>();
    if (file == nullptr || !(m.key == "file" || m.key.ends_with("_file"))) {
      collect(m.value, folder, out);
    } else if (!file->starts_with('$')) {
      out.push_back(folder / *file);
    } else if (const char* records = std::getenv("SCREE_RECORDS"); records && file->starts_with(kRecords)) {
      out.push_back(std::filesystem::path(records) / file->substr(kRecords.size()));
    }
  }
}

}  // namespace

std::filesystem::path data_path(const Section& s, std::string_view key, const std::filesystem::path& folder,
                                std::string_view what) {
  const std::string& file = s.text(key);
  if (file.empty())
    throw s.error(key, "the path is empty", "path of a record", fmt::format("give the file with {}", what));
  if (!file.starts_with('$')) return folder / file;  // an absolute path is kept
  if (!file.starts_with(kRecords))
    throw s.error(key, "only the variable SCREE_RECORDS is known", "a path, or \"$SCREE_RECORDS/...\"",
                  "write the path out");
  const char* records = std::getenv("SCREE_RECORDS");
  if (!records || !*records)
    throw s.error(key, "the environment variable SCREE_RECORDS is not set",
                  "a path, or \"$SCREE_RECORDS/...\" with the variable set",
                  "export SCREE_RECORDS=FOLDER, the folder with the recorded motions");
  return std::filesystem::path(records) / file.substr(kRecords.size());
}

std::vector<std::filesystem::path> data_files(const Value& document, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> out;
  collect(document, folder, out);
  return out;
}

}  // namespace scree::io
