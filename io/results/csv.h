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
  /// @param keep  goes on after so many bytes of an older file, which holds(); none: a new one
  /// @throws FileError, as all of it
  CsvFile(std::filesystem::path path, std::span<const Column> columns, const TableMark& keep = {});
  void row(std::span<const double> values);
  void flush();
  /// Everything so far to the disk.
  void sync();
  void close();
  /// Written so far.
  [[nodiscard]] TableMark mark() const { return {bytes_, hash_.value()}; }
  /// What a file lacks that it had at a mark, as the end of a sentence; empty where it begins with those very bytes.
  [[nodiscard]] static std::string lacks(const std::filesystem::path& file, const TableMark& mark);

 private:
  void put(std::string_view line);
  void check() const;
  std::filesystem::path path_;
  std::ofstream out_;
  std::int64_t bytes_ = 0;
  ByteHash hash_;
};

/// history.csv: time, then <monitor>.x, .y (position), .ux, .uy (displacement), .vx, .vy (velocity) a monitor.
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
