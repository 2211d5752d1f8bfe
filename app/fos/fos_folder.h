// The folder of `scree fos`: the names of its files, and the record of the inputs of its search.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace scree::app {

/// The inputs of a search, stored in fos.json. Searches with equal records have the same result.
struct FosRecord {
  std::string case_file;                     // absolute path; information only, not compared
  std::string case_sha256;                   // of the text of the case file
  std::map<std::string, std::string> files;  // SHA-256 of the files named in the case, by path; paths are not compared
  std::vector<std::string> set, load;        // --set, including other options expressed as --set; --load
  std::string what = "all";                  // strengths that are divided: all, friction or cohesion
  double tolerance = 0.01, least = 0.1, most = 10.0;
  [[nodiscard]] std::string text() const;
};

/// The folder of a search. It contains:
///   fos.json      inputs of the search       rest, rest-0.1           runs to rest
///   F-1.25, ...   runs at a factor           k-0.05, ...              runs to rest with k_h
///   logs/         output of the runs         fos.csv, result.json     result of the search
///   fos.svg       displacement over F        stable.png, failed.png   runs at the two ends of the bracket
class FosFolder {
 public:
  /// Makes the folder and fos.json, or opens the folder of a search with the same record.
  /// @throws FileError if the folder has other files, or belongs to another search; the message names the difference
  [[nodiscard]] static FosFolder open(const std::filesystem::path& path, const FosRecord& record);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path run(const std::string& name) const { return path_ / name; }
  [[nodiscard]] std::filesystem::path log(const std::string& name) const { return path_ / "logs" / (name + ".log"); }
  [[nodiscard]] std::filesystem::path file(const char* name) const { return path_ / name; }

 private:
  explicit FosFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

/// Name of the run at a factor, such as "F-1.25".
[[nodiscard]] std::string trial_name(double factor);

}  // namespace scree::app
