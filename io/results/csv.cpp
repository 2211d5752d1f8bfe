#include "io/results/csv.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "io/results/bolt_writer.h"
#include "io/results/file_error.h"
#include "io/results/history_writer.h"

namespace scree::io {

namespace {

/// The text, quoted if a comma, a quote or a line end would break the table (RFC 4180).
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::vector<CsvFile::Column> history_columns(const Model& model) {
  std::vector<CsvFile::Column> columns{{"time", "s"}};
  for (const std::string& name : monitor_names(model))
    for (const auto& [end, units] : {std::pair{".x", "m"},
                                     {".y", "m"},
                                     {".ux", "m"},
                                     {".uy", "m"},
                                     {".vx", "m/s"},
                                     {".vy", "m/s"},
                                     {".sxx", "Pa"},
                                     {".syy", "Pa"},
                                     {".sxy", "Pa"}})
      columns.push_back({name + end, units});
  for (const auto& [name, units] : bolt_columns(model)) columns.push_back({name, units});
  return columns;
}

std::vector<CsvFile::Column> energy_columns() {
  std::vector<CsvFile::Column> columns{{"time", "s"}};
  for (int c = 0; c < coupling::kColumns; ++c)
    columns.push_back({std::string(coupling::info(static_cast<coupling::Column>(c)).name), "J"});
  for (const char* name : {"energy", "closure", "moved"}) columns.push_back({name, "J"});
  columns.push_back({"relative_closure", "1"});
  columns.push_back({"passed", "J"});
  columns.push_back({"passed_closure", "1"});
  return columns;
}

}  // namespace

CsvFile::CsvFile(std::filesystem::path path, std::span<const Column> columns, const TableMark& keep)
    : path_(std::move(path)), bytes_(keep.bytes), hash_(keep.bytes > 0 ? ByteHash(keep.hash) : ByteHash()) {
  if (keep.bytes > 0) {
    std::error_code error;
    std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(keep.bytes), error);
    if (error) throw FileError(path_, "cannot go on with the table: " + error.message());
  }
  out_.open(path_, std::ios::binary | (keep.bytes > 0 ? std::ios::app : std::ios::trunc));
  if (keep.bytes == 0) {
    std::string header;
    for (const Column& c : columns) header += (header.empty() ? "" : ",") + field(c.name + " [" + c.units + "]");
    put(header + '\n');
  }
  flush();
}

void CsvFile::put(std::string_view line) {
  out_.write(line.data(), static_cast<std::streamsize>(line.size()));
  bytes_ += static_cast<std::int64_t>(line.size());
  hash_.add(line.data(), line.size());
}

std::string CsvFile::lacks(const std::filesystem::path& file, const TableMark& mark) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return "is missing";
  ByteHash hash;
  std::array<char, 64 * 1024> part{};
  for (std::int64_t left = mark.bytes; left > 0;) {
    in.read(part.data(), std::min<std::int64_t>(left, part.size()));
    if (in.gcount() == 0) return "is shorter than it was";
    hash.add(part.data(), static_cast<std::size_t>(in.gcount()));
    left -= in.gcount();
  }
  return hash.value() == mark.hash ? std::string() : "holds other bytes than were written";
}

void CsvFile::row(std::span<const double> values) {
  fmt::memory_buffer line;
  for (std::size_t i = 0; i < values.size(); ++i)
    fmt::format_to(std::back_inserter(line), "{}{:.17g}", i == 0 ? "" : ",", values[i]);
  line.push_back('\n');
  put({line.data(), line.size()});
  check();
}

void CsvFile::flush() {
  out_.flush();
  check();
}

void CsvFile::sync() {
  flush();
  const int descriptor = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && ::fdatasync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!synced) throw FileError(path_, std::string("cannot write to the disk: ") + std::strerror(error));
}

void CsvFile::close() {
  if (!out_.is_open()) return;
  out_.close();
  check();
}

void CsvFile::check() const {
  if (!out_) throw FileError(path_, std::string("cannot write: ") + std::strerror(errno));
}

CsvHistories::CsvHistories(const std::filesystem::path& history, const std::filesystem::path& energy,
                           const Model& model, const std::array<TableMark, 2>& keep)
    : history_(history, history_columns(model), keep[0]), energy_(energy, energy_columns(), keep[1]) {}

void CsvHistories::append(const coupling::HistoryView& view) {
  row_.assign(1, view.time);
  for (std::size_t i = 0; 2 * i < view.position.size(); ++i) {
    for (const auto& span : {view.position, view.displacement, view.velocity})
      row_.insert(row_.end(), {span[2 * i], span[2 * i + 1]});
    row_.insert(row_.end(), {view.stress[3 * i], view.stress[3 * i + 1], view.stress[3 * i + 2]});
  }
  add_bolt_values(view, row_);
  history_.row(row_);

  row_.assign(1, view.time);
  for (int c = 0; c < coupling::kColumns; ++c) row_.push_back((*view.ledger)[static_cast<coupling::Column>(c)]);
  row_.insert(row_.end(), {view.ledger->energy(), view.ledger->closure(), view.ledger->moved(),
                           view.ledger->relative_closure(), view.ledger->passed(), view.ledger->passed_closure()});
  energy_.row(row_);
}

void CsvHistories::flush() {
  history_.flush();
  energy_.flush();
}

void CsvHistories::sync() {
  history_.sync();
  energy_.sync();
}

void CsvHistories::close() {
  history_.close();
  energy_.close();
}

}  // namespace scree::io
