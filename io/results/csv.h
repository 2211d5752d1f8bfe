// The histories as tables for spreadsheets and scripts.
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "coupling/sink.h"

namespace scree::io {

/// One table: a line of "name [unit]", then numbers with 17 significant digits, which read back to the same bits.
class CsvFile {
 public:
  struct Column {
    std::string name, units;
  };
  /// @throws FileError, as all of it
  CsvFile(std::filesystem::path path, std::span<const Column> columns);
  void row(std::span<const double> values);
  void flush();
  void close();

 private:
  void check() const;
  std::filesystem::path path_;
  std::ofstream out_;
};

/// history.csv: time, then <monitor>.x, .y (position), .ux, .uy (displacement), .vx, .vy (velocity) a monitor.
/// energy.csv: time, every ledger column, energy, closure, moved, relative_closure.
class CsvHistories {
 public:
  CsvHistories(const std::filesystem::path& history, const std::filesystem::path& energy, const Model& model);
  void append(const coupling::HistoryView& view);
  void flush();
  void close();

 private:
  CsvFile history_, energy_;
  std::vector<double> row_;
};

}  // namespace scree::io
