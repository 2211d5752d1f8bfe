#include "io/case/unit.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "io/case/case_error.h"

namespace scree::io {
namespace {

/// ratio * 10^exponent kg^a m^b s^c rad^d
struct Unit {
  double ratio = 1.0;
  int exponent = 0;
  std::array<int, 4> power{};
};

struct Named {
  std::string_view name;
  Unit unit;
  bool prefixed;
};
const Named kUnits[] = {{"g", {1.0, -3, {1, 0, 0, 0}}, true},
                        {"t", {1.0, 3, {1, 0, 0, 0}}, false},
                        {"m", {1.0, 0, {0, 1, 0, 0}}, true},
                        {"s", {1.0, 0, {0, 0, 1, 0}}, true},
                        {"min", {60.0, 0, {0, 0, 1, 0}}, false},
                        {"h", {3600.0, 0, {0, 0, 1, 0}}, false},
                        {"N", {1.0, 0, {1, 1, -2, 0}}, true},
                        {"Pa", {1.0, 0, {1, -1, -2, 0}}, true},
                        {"Hz", {1.0, 0, {0, 0, -1, 0}}, true},
                        {"rad", {1.0, 0, {0, 0, 0, 1}}, true},
                        {"deg", {std::numbers::pi / 180.0, 0, {0, 0, 0, 1}}, false}};

struct Prefix {
  std::string_view name;
  int exponent;
};
constexpr Prefix kPrefixes[] = {{"n", -9}, {"u", -6}, {"\u00b5", -6}, {"m", -3}, {"c", -2},
                                {"k", 3},  {"M", 6},  {"G", 9},       {"T", 12}};

std::optional<Unit> named_unit(std::string_view name) {
  for (const Named& u : kUnits)
    if (u.name == name) return u.unit;
  for (const Prefix& p : kPrefixes)
    for (const Named& u : kUnits)
      if (u.prefixed && name.size() == p.name.size() + u.name.size() && name.starts_with(p.name) &&
          name.ends_with(u.name)) {
        Unit unit = u.unit;
        unit.exponent += p.exponent;
        return unit;
      }
  return std::nullopt;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// One factor: a named unit and its power ("m", "m3", "s^-2"), or 1.
std::optional<Unit> factor(std::string_view text) {
  if (text == "1") return Unit{};
  std::size_t end = text.size();
  while (end > 0 && is_digit(text[end - 1])) --end;
  int power = 1;
  if (text.size() - end > 1) return std::nullopt;  // no powers of two digits
  if (end < text.size()) power = text[end] - '0';
  if (end < text.size() && end > 0 && text[end - 1] == '-') power = -power, --end;
  if (end < text.size() && end > 0 && text[end - 1] == '^') --end;
  const auto unit = named_unit(text.substr(0, end));
  if (!unit) return std::nullopt;
  Unit out{std::pow(unit->ratio, power), unit->exponent * power, unit->power};
  for (int& p : out.power) p *= power;
  return out;
}

std::optional<Unit> parse_unit(std::string_view text) {
  Unit out;
  bool divide = false;
  while (true) {
    const std::size_t next = text.find_first_of("*/");
    const auto f = factor(text.substr(0, next));
    if (!f) return std::nullopt;
    const int sign = divide ? -1 : 1;
    out.ratio = divide ? out.ratio / f->ratio : out.ratio * f->ratio;
    out.exponent += sign * f->exponent;
    for (std::size_t i = 0; i < out.power.size(); ++i) out.power[i] += sign * f->power[i];
    if (next == std::string_view::npos) return out;
    divide = text[next] == '/';
    text.remove_prefix(next + 1);
  }
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// The number 'digits' times 10^shift, rounded once.
double shifted(std::string_view digits, int shift) {
  const std::size_t e = digits.find_first_of("eE");
  int exponent = shift;
  if (e != std::string_view::npos) {
    std::string_view tail = digits.substr(e + 1);
    if (tail.starts_with('+')) tail.remove_prefix(1);
    int own = 0;
    const auto read = std::from_chars(tail.data(), tail.data() + tail.size(), own);
    if (read.ec == std::errc{}) exponent += std::max(-100000, std::min(100000, own));
  }
  const std::string text = fmt::format("{}e{}", digits.substr(0, e), exponent);
  double value = std::nan("");
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  return read.ec == std::errc{} ? value : std::nan("");
}

/// Fault for a weight where a mass is required, such as kN/m3 for a density, or for the reverse: the hint contains the
/// converted number.
std::optional<UnitFault> weight_for_mass(std::string_view digits, std::string_view name, const Unit& unit,
                                         const Unit& wanted, std::string_view base) {
  constexpr double kG = 9.81;                           // [m/s2]
  constexpr std::array<int, 4> kPowerOfG{0, 1, -2, 0};  // of kg, m, s and rad in g
  int sign = 0;
  for (const int s : {1, -1}) {
    bool fits = true;
    for (std::size_t i = 0; i < kPowerOfG.size(); ++i)
      fits = fits && unit.power[i] - wanted.power[i] == s * kPowerOfG[i];
    if (fits) sign = s;
  }
  if (sign == 0 || unit.power[0] != 1) return std::nullopt;
  const double si = shifted(digits, unit.exponent - wanted.exponent) * (unit.ratio / wanted.ratio);
  if (!std::isfinite(si)) return std::nullopt;
  return UnitFault{fmt::format("the unit {} is one of {}, and this key holds a {}", in_quotes(name),
                               sign > 0 ? "weight" : "mass", sign > 0 ? "mass" : "force"),
                   fmt::format("{} by g: {} {} {} {:g} m/s2 = {:.4g} {}", sign > 0 ? "divide" : "multiply", digits,
                               name, sign > 0 ? "/" : "*", kG, sign > 0 ? si / kG : si * kG, base)};
}

}  // namespace

std::variant<double, UnitFault> in_unit(std::string_view text, std::string_view base) {
  const std::string plain = base.empty()
                                ? "write a plain number, without quotation marks"
                                : fmt::format("write a plain number [{}], or a text such as \"1 {}\"", base, base);
  if (base.empty()) return UnitFault{"a number is expected here, not a text", plain};
  std::string_view rest = trimmed(text);
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double value = 0.0;
  const auto read = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  const auto length = static_cast<std::size_t>(read.ptr - rest.data());
  if (length == 0) return UnitFault{"the text does not begin with a number", plain};
  const std::string_view digits = rest.substr(0, length);
  if (read.ec == std::errc{} && !std::isfinite(value)) return UnitFault{"the number is not finite", plain};
  const std::string_view name = trimmed(rest.substr(length));
  if (name.empty()) return UnitFault{"the number has quotation marks but no unit", plain};

  const auto unit = parse_unit(name);
  if (!unit)
    return UnitFault{
        fmt::format("the unit {} is not known", in_quotes(name)),
        "units are products of g t m s min h N Pa Hz rad deg with prefixes n u m c k M G T, as in \"GN/m\", "
        "\"t/m3\", \"m/s2\""};
  const auto wanted = parse_unit(base);
  if (wanted)
    if (auto fault = weight_for_mass(digits, name, *unit, *wanted, base)) return *fault;
  if (!wanted || unit->power != wanted->power)
    return UnitFault{fmt::format("the unit {} does not fit the quantity of this key", in_quotes(name)), plain};
  value = shifted(digits, unit->exponent - wanted->exponent);
  if (unit->ratio != wanted->ratio) value *= unit->ratio / wanted->ratio;
  if (!std::isfinite(value)) return UnitFault{"the number is out of the range of double precision", plain};
  return value;
}

}  // namespace scree::io
