#include "app/sweep/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/case/case_error.h"
#include "io/case/document.h"
#include "io/case/number_text.h"

namespace scree::app {
namespace {

constexpr const char* kParameterForm = "KEY=A:B:N, N numbers from A to B, or KEY=V1,V2,...";

/// A piece of an option.
struct Piece {
  std::string_view text;
  std::size_t at = 0;  // of its first character in the option
};

Piece trimmed(Piece p) {
  while (!p.text.empty() && p.text.front() == ' ') p.text.remove_prefix(1), ++p.at;
  while (!p.text.empty() && p.text.back() == ' ') p.text.remove_suffix(1);
  return p;
}

/// Pieces between the separators that stand outside quotation marks, brackets and braces.
std::vector<Piece> split(Piece whole, char separator) {
  std::vector<Piece> pieces;
  std::size_t begin = 0;
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < whole.text.size(); ++i) {
    const char c = whole.text[i];
    if (quote != 0) {
      if (c == '\\' && quote == '"')
        ++i;
      else if (c == quote)
        quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    } else if (c == separator && depth <= 0) {
      pieces.push_back(trimmed({whole.text.substr(begin, i - begin), whole.at + begin}));
      begin = i + 1;
    }
  }
  pieces.push_back(trimmed({whole.text.substr(begin), whole.at + begin}));
  return pieces;
}

/// One option --param being read.
class Option {
 public:
  Option(const std::string& text, std::size_t number) : text_(text), number_(static_cast<int>(number)) {
    const std::vector<Piece> sides = split({text_, 0}, '=');
    key_ = sides.front();
    if (sides.size() < 2)
      fail({text_, 0}, "the equals sign is missing", kParameterForm, "write the key, an equals sign and the values");
    if (key_.text.empty()) fail(key_, "the key is missing", kParameterForm, "`scree schema` lists every key");
    spec_ = trimmed({std::string_view(text_).substr(sides[1].at), sides[1].at});
    if (spec_.text.empty()) fail(spec_, "the values are missing", kParameterForm, "for example 8:16:5 or 8,12,16");
  }

  [[nodiscard]] ParameterKey key() const { return {std::string(key_.text), origin(key_)}; }
  [[nodiscard]] std::vector<ParameterValue> values() const {
    if (const std::vector<Piece> ends = split(spec_, ':'); ends.size() > 1) return range(ends);
    std::vector<ParameterValue> values;
    for (const Piece& piece : split(spec_, ',')) {
      if (piece.text.empty()) fail(piece, "a value is missing", kParameterForm, "take the surplus comma out");
      values.push_back({toml_of(piece.text), origin(piece)});
    }
    return values;
  }

 private:
  [[nodiscard]] Origin origin(const Piece& piece) const { return {"--param", number_, static_cast<int>(piece.at) + 1}; }

  [[noreturn]] void fail(const Piece& at, std::string problem, std::string allowed, std::string hint) const {
    throw io::CaseError(
        "--param", {number_, static_cast<int>(at.at) + 1},
        {std::move(problem), std::string(key_.text), io::in_quotes(at.text), std::move(allowed), std::move(hint)});
  }

  [[nodiscard]] double number(const Piece& piece) const {
    const std::optional<double> value = io::number_of_text(piece.text);
    if (!value || !std::isfinite(*value))
      fail(piece, "this end of a range is not a finite number", kParameterForm,
           "give values with a unit or a colon one by one, in quotation marks: \"5 ms\",\"10 ms\"");
    return *value;
  }

  [[nodiscard]] std::vector<ParameterValue> range(const std::vector<Piece>& ends) const {
    if (ends.size() != 3)
      fail(spec_, "a range has three parts", kParameterForm, "for example 8:16:5 for 8, 10, 12, 14, 16");
    const double a = number(ends[0]), b = number(ends[1]);
    std::size_t count = 0;
    const std::string_view text = ends[2].text;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
    if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || count < 2 || count > kMostRuns)
      fail(ends[2], "this is no number of values", fmt::format("2 to {}", kMostRuns),
           "the third part of a range is how many values it has, both ends included");
    std::vector<ParameterValue> values;
    for (std::size_t i = 0; i < count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count - 1);
      // Fifteen digits hide the rounding of the spacing: 0.3, not 0.30000000000000004.
      values.push_back({fmt::format("{:.15g}", a + share * (b - a)), origin(spec_)});
    }
    return values;
  }

  const std::string& text_;
  int number_;
  Piece key_, spec_;
};

}  // namespace

std::vector<std::string> Parameters::overrides(std::size_t run) const {
  std::vector<std::string> out;
  for (std::size_t k = 0; k < keys.size(); ++k) out.push_back(keys[k].name + "=" + runs[run - 1][k].toml);
  return out;
}

Parameters parameter_grid(std::span<const std::string> options) {
  Parameters grid;
  grid.runs.emplace_back();
  for (std::size_t o = 0; o < options.size(); ++o) {
    const Option option(options[o], o + 1);
    grid.keys.push_back(option.key());
    const std::vector<ParameterValue> values = option.values();
    if (grid.runs.size() > kMostRuns / values.size())
      throw io::CaseError(
          "--param", {static_cast<int>(o) + 1, 1},
          {fmt::format("the grid has {} x {} runs", grid.runs.size(), values.size()), grid.keys.back().name, "",
           fmt::format("at most {} runs", kMostRuns), "give the combinations that count with --table"});
    std::vector<std::vector<ParameterValue>> runs;
    for (const std::vector<ParameterValue>& run : grid.runs)
      for (const ParameterValue& value : values) {
        runs.push_back(run);
        runs.back().push_back(value);
      }
    grid.runs = std::move(runs);
  }
  require_distinct(grid.keys);
  return grid;
}

std::string toml_of(std::string_view text) {
  try {
    (void)io::parse_set_value(text, 1, 1);
    return std::string(text);
  } catch (const io::CaseError&) {
    std::string quoted = "\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
    return quoted + '"';
  }
}

void require_distinct(std::span<const ParameterKey> keys) {
  for (std::size_t k = 0; k < keys.size(); ++k)
    for (std::size_t other = 0; other < k; ++other)
      if (keys[k].name == keys[other].name)
        throw io::CaseError(
            keys[k].origin.file, {keys[k].origin.line, keys[k].origin.column},
            {"the key is given twice", keys[k].name, "", "each key once", "give all its values at once"});
}

std::string run_name(std::size_t run, std::size_t runs) {
  return fmt::format("{:0{}}", run, std::max<std::size_t>(4, fmt::formatted_size("{}", runs)));
}

}  // namespace scree::app
