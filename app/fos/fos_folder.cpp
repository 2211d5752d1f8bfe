#include "app/fos/fos_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "io/results/atomic_file.h"
#include "io/results/file_error.h"
#include "io/results/regular_file.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kRecord = "fos.json";
constexpr int kFormat = 1;

std::set<std::string> digests(const Json& record) {
  std::set<std::string> out;
  for (const Json& file : record.at("files")) out.insert(file.at("sha256").get<std::string>());
  return out;
}

/// The first difference between two records, as a clause for an error message; empty if they are equal.
std::string difference(const Json& there, const Json& wanted) {
  static const std::vector<std::pair<std::string, std::string>> kWords{
      {"format", "it is of another version of Scree"}, {"case_sha256", "its case file had another text"},
      {"set", "it was begun with other options"},      {"load", "it was begun with other --load options"},
      {"what", "it was begun for other strengths"},    {"tolerance", "it was begun with another --tolerance"},
      {"least", "it was begun with another --least"},  {"most", "it was begun with another --most"}};
  for (const auto& [key, words] : kWords)
    if (!there.contains(key) || there[key] != wanted[key]) return words;
  try {
    return digests(there) == digests(wanted) ? std::string() : "a file that its case names had another content";
  } catch (const Json::exception&) {
    return "its list of files is damaged";
  }
}

void require_same(const fs::path& path, const Json& wanted) {
  const fs::path file = path / kRecord;
  io::require_regular(file);
  std::ifstream in(file, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const Json there = Json::parse(text, nullptr, false);
  if (!there.is_object()) throw io::FileError(file, "is damaged; choose another folder (--out)");
  if (const std::string differs = difference(there, wanted); !differs.empty())
    throw io::FileError(path, "holds another search: " + differs + "; choose another folder (--out)");
}

}  // namespace

std::string FosRecord::text() const {
  Json json;
  json["format"] = kFormat;
  json["case"] = case_file;
  json["case_sha256"] = case_sha256;
  json["files"] = Json::array();
  for (const auto& [path, sha256] : files) json["files"].push_back(Json{{"path", path}, {"sha256", sha256}});
  json["set"] = set;
  json["load"] = load;
  json["what"] = what;
  json["tolerance"] = tolerance;
  json["least"] = least;
  json["most"] = most;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

FosFolder FosFolder::open(const fs::path& path, const FosRecord& record) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw io::FileError(path, "cannot make the folder: " + error.message());
  if (fs::exists(path / kRecord, error)) {
    require_same(path, Json::parse(record.text()));
  } else {
    for (fs::directory_iterator it(path, error), last; !error && it != last; it.increment(error))
      if (it->path().filename() != std::string(kRecord) + ".tmp" && it->path().filename() != "logs")
        throw io::FileError(path,
                            "has files in it that are not of `scree fos`; choose an empty or a new folder (--out)");
    io::write_atomically(path / kRecord, record.text());
  }
  fs::create_directories(path / "logs", error);
  if (error) throw io::FileError(path / "logs", "cannot make the folder: " + error.message());
  return FosFolder(path);
}

std::string trial_name(double factor) { return fmt::format("F-{:.6g}", factor); }

}  // namespace scree::app
