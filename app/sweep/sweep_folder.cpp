#include "app/sweep/sweep_folder.h"

#include <fmt/format.h>

#include <algorithm>
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
using OrderedJson = nlohmann::ordered_json;

constexpr const char* kRecord = "sweep.json";
constexpr int kFormat = 1;

OrderedJson json_of(const SweepRecord& record) {
  OrderedJson json;
  json["format"] = kFormat;
  json["case"] = record.case_file;
  json["case_sha256"] = record.case_sha256;
  json["files"] = OrderedJson::array();
  for (const auto& [path, sha256] : record.files)
    json["files"].push_back(OrderedJson{{"path", path}, {"sha256", sha256}});
  json["set"] = record.set;
  json["load"] = record.load;
  json["until"] = record.until ? OrderedJson(*record.until) : OrderedJson();
  json["keys"] = OrderedJson::array();
  for (const ParameterKey& key : record.parameters.keys) json["keys"].push_back(key.name);
  json["runs"] = OrderedJson::array();
  for (const std::vector<ParameterValue>& run : record.parameters.runs) {
    OrderedJson& values = json["runs"].emplace_back(OrderedJson::array());
    for (const ParameterValue& value : run) values.push_back(value.toml);
  }
  return json;
}

std::set<std::string> digests(const OrderedJson& record) {
  std::set<std::string> out;
  for (const OrderedJson& file : record["files"]) out.insert(file.at("sha256").get<std::string>());
  return out;
}

/// What differs between two records, as the end of a sentence; empty where nothing does.
/// @param all_files  whether both have all the files that the case names, or `wanted` some of them
std::string difference(const OrderedJson& there, const OrderedJson& wanted, bool all_files) {
  static const std::vector<std::pair<std::string, std::string>> kWords{
      {"format", "it is of another version of Scree"},  {"case_sha256", "its case file had another text"},
      {"set", "it was begun with other --set options"}, {"load", "it was begun with other --load options"},
      {"until", "it was begun with another --until"},   {"keys", "its parameters are others"},
      {"runs", "its parameters have other values"}};
  for (const auto& [key, words] : kWords)
    if (!there.contains(key) || there[key] != wanted[key]) return words;
  try {
    const std::set<std::string> known = digests(there), now = digests(wanted);
    const bool same = all_files ? known == now : std::includes(known.begin(), known.end(), now.begin(), now.end());
    return same ? std::string() : "a file that its case names had another content";
  } catch (const OrderedJson::exception&) {
    return "its list of files is damaged";
  }
}

/// @throws FileError where the folder's sweep is not this one
void require_same(const fs::path& path, const OrderedJson& wanted, bool all_files) {
  const fs::path file = path / kRecord;
  io::require_regular(file);
  std::ifstream in(file, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in.is_open() || in.bad()) throw io::FileError(file, "cannot read what the sweep was begun for");
  const OrderedJson there = OrderedJson::parse(text, nullptr, false);
  if (!there.is_object()) throw io::FileError(file, "is damaged; remove it to begin the sweep anew in another folder");
  if (const std::string differs = difference(there, wanted, all_files); !differs.empty())
    throw io::FileError(path, "holds another sweep: " + differs + "; choose another folder (--out)");
}

void make_logs(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path / "logs", error);
  if (error) throw io::FileError(path / "logs", "cannot make the folder: " + error.message());
}

}  // namespace

std::vector<std::string> SweepRecord::overrides(std::size_t run) const {
  std::vector<std::string> out = set;
  for (std::string& option : parameters.overrides(run)) out.push_back(std::move(option));
  return out;
}

std::string SweepRecord::text() const {
  return json_of(*this).dump(1, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

SweepFolder SweepFolder::open(const fs::path& path, const SweepRecord& record) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw io::FileError(path, "cannot make the folder of the sweep: " + error.message());
  if (fs::exists(path / kRecord, error)) {
    require_same(path, OrderedJson::parse(record.text()), true);
    make_logs(path);
    return {path, record.runs()};
  }
  for (fs::directory_iterator it(path, error), last; !error && it != last; it.increment(error))
    if (it->path().filename() != std::string(kRecord) + ".tmp" &&
        it->path().filename() != "logs")  // killed as it began
      throw io::FileError(path, "has files in it that are not of a sweep; choose an empty or a new folder (--out)");
  if (error) throw io::FileError(path, "cannot list the folder: " + error.message());
  make_logs(path);
  io::write_atomically(path / kRecord, record.text());
  return {path, record.runs()};
}

SweepFolder SweepFolder::reopen(const fs::path& path, const SweepRecord& record) {
  std::error_code error;
  if (!fs::exists(path / kRecord, error))
    throw io::FileError(path, "holds no sweep: there is no sweep.json in it; `scree sweep` makes it, with --emit too");
  require_same(path, OrderedJson::parse(record.text()), false);
  make_logs(path);
  return {path, record.runs()};
}

std::string SweepFolder::stream_name(std::size_t run) const {
  const fs::path full = fs::absolute(path_).lexically_normal();
  const fs::path& named = full.has_filename() ? full : full.parent_path();
  return named.filename().string() + "-" + run_name(run, runs_);
}

}  // namespace scree::app
