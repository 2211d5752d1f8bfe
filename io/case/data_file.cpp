#include "io/case/data_file.h"

#include <fmt/format.h>

#include <cstdlib>

namespace scree::io {
namespace {

constexpr std::string_view kRecords = "$SCREE_RECORDS/";

}  // namespace

std::filesystem::path data_path(const Section& s, std::string_view key, const std::filesystem::path& folder,
                                std::string_view what) {
  const std::string& file = s.text(key);
  if (file.empty())
    throw s.error(key, "the path is empty", "path of a record", fmt::format("give the file with {}", what));
  if (!file.starts_with('$')) return folder / file;  // an absolute path stays one
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

}  // namespace scree::io
