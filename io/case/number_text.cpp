#include "io/case/number_text.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace scree::io {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return c == '+' || c == '-'; }

std::size_t digits_at(std::string_view text, std::size_t from) {
  std::size_t end = from;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - from;
}

/// Value of a number outside the range of double: from_chars does not report whether it is too large or too small.
double beyond_range(const std::string& text) {
  std::istringstream in(text);
  in.imbue(std::locale::classic());
  double value = 0.0;
  if (in >> value) return value;  // too small
  return text.starts_with('-') ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

}  // namespace

std::optional<double> number_of_text(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  std::string plain;
  if (text.find_first_of("dD") != std::string_view::npos) {
    plain = text;
    std::replace_if(
        plain.begin(), plain.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
    text = plain;
  }
  double value = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec == std::errc::invalid_argument || read.ptr != text.data() + text.size()) return std::nullopt;
  if (read.ec == std::errc::result_out_of_range) return beyond_range(std::string(text));
  return value;
}

std::size_t leading_number(std::string_view text) {
  std::size_t i = !text.empty() && is_sign(text[0]) ? 1 : 0;
  std::size_t digits = digits_at(text, i);
  i += digits;
  if (i < text.size() && text[i] == '.') {
    const std::size_t decimals = digits_at(text, i + 1);
    digits += decimals;
    i += decimals + 1;
  }
  if (digits == 0) return 0;
  if (i >= text.size()) return i;
  if (text[i] == 'e' || text[i] == 'E' || text[i] == 'd' || text[i] == 'D') {
    std::size_t power = i + 1;
    if (power < text.size() && is_sign(text[power])) ++power;
    const std::size_t length = digits_at(text, power);
    return length > 0 ? power + length : i;
  }
  // A field of acceleration has a decimal point, so three digits without a point are an exponent.
  if (is_sign(text[i]) && digits_at(text, i + 1) == 3 && (i + 4 == text.size() || is_sign(text[i + 4]))) return i + 4;
  return i;
}

}  // namespace scree::io
