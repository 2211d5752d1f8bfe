// The folder of a sweep: its file names, and the record of its question.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/parameters.h"

namespace scree::app {

/// What a sweep computes: sweep.json. Two sweeps with equal records have the same table.
struct SweepRecord {
  std::string case_file;                     // absolute; for people, not compared
  std::string case_sha256;                   // of its text
  std::map<std::string, std::string> files;  // named in the case, with their SHA-256; paths are not compared
  std::vector<std::string> set, load;        // --set, --load
  std::optional<double> until;               // [s]
  Parameters parameters;

  [[nodiscard]] std::size_t runs() const { return parameters.runs.size(); }
  /// --set of a run (counted from 1), the parameters last.
  [[nodiscard]] std::vector<std::string> overrides(std::size_t run) const;
  /// The document, without the origins of the parameters.
  [[nodiscard]] std::string text() const;
};

/// Names inside the folder of a sweep.
///   sweep.json   what is computed         0001, 0002, ...   run folders       logs/0001.log   what the run printed
///   sweep.csv, sweep.h5   the table       plots/*.svg       results over the parameter that varies
///   costs.csv    time and memory of the runs
class SweepFolder {
 public:
  /// Makes the folder and sweep.json, or continues a sweep of the same record.
  /// @throws FileError where the folder holds something else, or another sweep; the message names the difference
  [[nodiscard]] static SweepFolder open(const std::filesystem::path& path, const SweepRecord& record);
  /// As open(), for a folder that must exist. The record may lack some of the files that the case names: it may stem
  /// from the reading of one run.
  [[nodiscard]] static SweepFolder reopen(const std::filesystem::path& path, const SweepRecord& record);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path run(std::size_t run) const { return path_ / run_name(run, runs_); }
  [[nodiscard]] std::filesystem::path log(std::size_t run) const {
    return path_ / "logs" / (run_name(run, runs_) + ".log");
  }
  [[nodiscard]] std::filesystem::path csv() const { return path_ / "sweep.csv"; }
  [[nodiscard]] std::filesystem::path h5() const { return path_ / "sweep.h5"; }
  [[nodiscard]] std::filesystem::path costs() const { return path_ / "costs.csv"; }
  [[nodiscard]] std::filesystem::path plots() const { return path_ / "plots"; }
  /// Name of a run in the stream: that of the sweep and of the run.
  [[nodiscard]] std::string stream_name(std::size_t run) const;

 private:
  SweepFolder(std::filesystem::path path, std::size_t runs) : path_(std::move(path)), runs_(runs) {}
  std::filesystem::path path_;
  std::size_t runs_;
};

}  // namespace scree::app
