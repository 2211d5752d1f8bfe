// The folder of `scree fos`: its file names, and the record of its question.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace scree::app {

/// The question of a search: fos.json. Two folders with equal records have the same answer.
struct FosRecord {
  std::string case_file;                     // absolute; for people, not compared
  std::string case_sha256;                   // of its text
  std::map<std::string, std::string> files;  // named in the case, with their SHA-256; paths are not compared
  std::vector<std::string> set, load;        // --set, including other options expressed as --set; --load
  std::string what = "all";                  // strengths that are divided: all, friction or cohesion
  double tolerance = 0.01, least = 0.1, most = 10.0;
  [[nodiscard]] std::string text() const;
};

/// Names inside the folder.
///   fos.json     the question            rest, rest-0.1   runs to rest        F-1.25, ...   runs at a factor
///   k-0.05, ...  runs with k_h           logs/            what they printed   fos.csv, result.json   the answer
///   fos.svg      displacement over F     stable.png, failed.png               the two ends of the bracket
class FosFolder {
 public:
  /// Makes the folder and fos.json, or continues a search with the same record.
  /// @throws FileError where the folder holds something else, or another question; the message names the difference
  [[nodiscard]] static FosFolder open(const std::filesystem::path& path, const FosRecord& record);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path run(const std::string& name) const { return path_ / name; }
  [[nodiscard]] std::filesystem::path log(const std::string& name) const { return path_ / "logs" / (name + ".log"); }
  [[nodiscard]] std::filesystem::path file(const char* name) const { return path_ / name; }

 private:
  explicit FosFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

/// "F-1.25".
[[nodiscard]] std::string trial_name(double factor);

}  // namespace scree::app
