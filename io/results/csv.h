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
#include "io/results/byte_hash.h"
#include "io/results/results_mark.h"

namespace scree::io {

/// One table: a line of "name [unit]", then numbers with 17 significant digits, which read back to the same bits.
class CsvFile {
 public:
  struct Column {
    std::string name, units;
  };
  /// @param keep  leading bytes of an older file that are kept (lacks() is empty for them); none: a new file
  /// @throws FileError, as every member
  CsvFile(std::filesystem::path path, std::span<const Column> columns, const TableMark& keep = {});
  void row(std::span<const double> values);
  void flush();
  /// Writes everything so far to the disk.
  void sync();
  void close();
  /// Bytes written so far and their hash.
  [[nodiscard]] TableMark mark() const { return {bytes_, hash_.value()}; }
  /// How a file differs from its content at a mark, as the end of a sentence; empty if it begins with those bytes.
  [[nodiscard]] static std::string lacks(const std::filesystem::path& file, const TableMark& mark);

 private:
  void put(std::string_view line);
  void check() const;
  std::filesystem::path path_;
  std::ofstream out_;
  std::int64_t bytes_ = 0;
  ByteHash hash_;
};

/// history.csv: time, then <monitor>.x, .y (position), .ux, .uy (displacement), .vx, .vy (velocity) per monitor.
/// energy.csv: time, every ledger column, energy, closure, moved, relative_closure, passed, passed_closure.
class CsvHistories {
 public:
  CsvHistories(const std::filesystem::path& history, const std::filesystem::path& energy, const Model& model,
               const std::array<TableMark, 2>& keep = {});
  void append(const coupling::HistoryView& view);
  void flush();
  void sync();
  void close();
  [[nodiscard]] std::array<TableMark, 2> marks() const { return {history_.mark(), energy_.mark()}; }

 private:
  CsvFile history_, energy_;
  std::vector<double> row_;
};

}  // namespace scree::io
