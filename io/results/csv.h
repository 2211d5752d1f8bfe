// The histories as tables for spreadsheets and scripts.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/sink.h"

namespace scree::io {

/// One table: a line of "name [unit]", then numbers with 17 significant digits, which read back to the same bits.
class CsvFile {
 public:
  struct Column {
    std::string name, units;
  };
  /// @param keep  goes on after so many bytes of an older file; 0: a new one
  /// @throws FileError, as all of it, also where the older file is shorter
  CsvFile(std::filesystem::path path, std::span<const Column> columns, std::int64_t keep = 0);
  void row(std::span<const double> values);
  void flush();
  void close();
  /// Written so far.
  [[nodiscard]] std::int64_t bytes() const { return bytes_; }

 private:
  void put(std::string_view line);
  void check() const;
  std::filesystem::path path_;
  std::ofstream out_;
  std::int64_t bytes_ = 0;
};

/// history.csv: time, then <monitor>.x, .y (position), .ux, .uy (displacement), .vx, .vy (velocity) a monitor.
/// energy.csv: time, every ledger column, energy, closure, moved, relative_closure, passed, passed_closure.
class CsvHistories {
 public:
  CsvHistories(const std::filesystem::path& history, const std::filesystem::path& energy, const Model& model,
               const std::array<std::int64_t, 2>& keep = {});
  void append(const coupling::HistoryView& view);
  void flush();
  void close();
  [[nodiscard]] std::array<std::int64_t, 2> bytes() const { return {history_.bytes(), energy_.bytes()}; }

 private:
  CsvFile history_, energy_;
  std::vector<double> row_;
};

}  // namespace scree::io
