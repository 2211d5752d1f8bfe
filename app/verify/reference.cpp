#include "app/verify/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/case/case_error.h"
#include "io/case/suggest.h"
#include "io/case/text_fields.h"
#include "io/case/text_file.h"

namespace scree::app {
namespace {

constexpr std::size_t kMostReferenceBytes = 64 << 20;

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Parts of a line between commas, without its comment.
std::vector<io::Field> parts_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<io::Field> parts;
  if (trimmed(line).empty()) return parts;
  std::size_t begin = 0;
  while (begin <= line.size()) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    parts.push_back({trimmed(line.substr(begin, end - begin)), static_cast<int>(begin) + 1});
    begin = end + 1;
  }
  return parts;
}

bool number(std::string_view text, double& value) {
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

}  // namespace

const std::vector<double>& ReferenceTable::column(std::string_view heading) const {
  for (std::size_t i = 0; i < headings.size(); ++i)
    if (headings[i] == heading && !columns[i].empty()) return columns[i];
  throw io::CaseError(file, {},
                      {.problem = fmt::format("has no column {}", io::in_quotes(heading)),
                       .allowed = io::listed(headings),
                       .hint = io::did_you_mean(heading, headings, "")});
}

ReferenceTable read_reference(const std::filesystem::path& file) {
  ReferenceTable table;
  table.file = file.string();
  const std::string text = io::read_text_file(file, "reference", kMostReferenceBytes);
  io::TextLines lines(text);
  bool named = false, first = true;
  while (const auto line = lines.next()) {
    const std::vector<io::Field> parts = parts_of(*line);
    if (parts.empty()) continue;
    if (table.headings.empty()) {
      for (const io::Field& p : parts) table.headings.emplace_back(trimmed(p.text.substr(0, p.text.find('['))));
      table.columns.resize(parts.size());
      continue;
    }
    const auto wrong = [&](int column, std::string problem, std::string allowed) {
      return io::CaseError(table.file, {lines.row(), column},
                           {.problem = std::move(problem), .allowed = std::move(allowed)});
    };
    if (parts.size() != table.headings.size())
      throw wrong(1, fmt::format("the row has {} fields", parts.size()),
                  fmt::format("{} fields, as there are headings", table.headings.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      double value = 0.0;
      const bool is_number = number(parts[i].text, value);
      if (first && i == 0) named = !is_number;
      if (i == 0 && named)
        table.names.emplace_back(parts[i].text);
      else if (is_number)
        table.columns[i].push_back(value);
      else
        throw wrong(parts[i].column, fmt::format("{} is no finite number", io::in_quotes(parts[i].text)), "a number");
    }
    first = false;
  }
  if (first) throw io::CaseError(table.file, {}, {.problem = "has no rows", .allowed = "headings, then rows"});
  return table;
}

double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return y.front();
  if (above == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(above - x.begin());
  return y[i - 1] + (at - x[i - 1]) / (x[i] - x[i - 1]) * (y[i] - y[i - 1]);
}

}  // namespace scree::app
