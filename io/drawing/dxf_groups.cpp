#include "io/drawing/dxf_groups.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "io/text/printable.h"

namespace scree::io {
namespace {

std::string_view without_space(std::string_view text) {
  const auto from = text.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

/// A text in quotes, shortened, for messages.
std::string shown(std::string_view text) {
  std::string cut(text.substr(0, 40));
  return '"' + printable_line(cut) + '"';
}

template <class Number>
std::optional<Number> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number out{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return out;
}

}  // namespace

bool is_real(int code) {
  return (code >= 10 && code <= 59) || (code >= 110 && code <= 149) || (code >= 210 && code <= 239) ||
         (code >= 460 && code <= 469) || (code >= 1010 && code <= 1059);
}

bool is_whole(int code) {
  return (code >= 60 && code <= 99) || (code >= 160 && code <= 179) || (code >= 270 && code <= 289) ||
         (code >= 370 && code <= 389) || (code >= 400 && code <= 409) || (code >= 420 && code <= 429) ||
         (code >= 440 && code <= 459);
}

double real_of(const DxfGroup& group) { return number<double>(group.value).value_or(0.0); }
std::int64_t whole_of(const DxfGroup& group) { return number<std::int64_t>(group.value).value_or(0); }

DxfGroups::DxfGroups(std::string_view text) : rest_(text) {
  if (text.starts_with("AutoCAD Binary DXF"))
    throw DrawingError(0, "this is a binary DXF", "a DXF of text", "save it as ASCII DXF, R12 to 2018");
  if (text.starts_with("AC10"))
    throw DrawingError(0, "this is a DWG", "a DXF of text", "save it as ASCII DXF, R12 to 2018");
  if (rest_.starts_with("\xef\xbb\xbf")) rest_.remove_prefix(3);
  if (without_space(rest_.substr(0, 200)).empty())
    throw DrawingError(0, "the drawing is empty", "a DXF of text", "save it again");
}

std::optional<std::string_view> DxfGroups::line() {
  if (rest_.empty()) return {};
  const auto end = rest_.find('\n');
  const std::string_view out = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  ++row_;
  return out;
}

std::optional<DxfGroup> DxfGroups::next() {
  const auto code_line = line();
  if (!code_line) return {};
  const std::string_view code_text = without_space(*code_line);
  // Some programs end a file with an empty line.
  if (code_text.empty() && without_space(rest_).empty()) return {};
  const auto code = number<int>(code_text);
  if (!code || *code < -5 || *code > 1071)
    throw DrawingError(row_, fmt::format("{} is no group code", shown(*code_line)), "a whole number from -5 to 1071",
                       "a DXF is pairs of lines, a code and its value: the file is damaged at or before this line");
  const auto value_line = line();
  if (!value_line)
    throw DrawingError(row_, fmt::format("the file ends after the group code {}", *code), "a value in the next line",
                       "the file is cut off: save it again");
  DxfGroup out{*code, without_space(*value_line), row_};
  if (value_line->size() > 100000)
    throw DrawingError(row_, "the line is too long", "at most 100000 characters", "the file is damaged");
  if (is_real(*code)) {
    const auto value = number<double>(out.value);
    if (!value)
      throw DrawingError(row_, fmt::format("{} is no number", shown(out.value)),
                         fmt::format("a number: the group code is {}", *code), "the file is damaged");
    if (!std::isfinite(*value))
      throw DrawingError(row_, fmt::format("{} is not finite", shown(out.value)), "a finite number",
                         "the file is damaged");
  } else if (is_whole(*code) && !number<std::int64_t>(out.value)) {
    throw DrawingError(row_, fmt::format("{} is no whole number", shown(out.value)),
                       fmt::format("a whole number: the group code is {}", *code), "the file is damaged");
  }
  return out;
}

}  // namespace scree::io
