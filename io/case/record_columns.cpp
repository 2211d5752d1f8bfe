#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/case/case_error.h"
#include "io/case/number_text.h"
#include "io/case/record.h"
#include "io/case/text_fields.h"

namespace scree::io {
namespace {

/// One unit of the last digit of a number: 0.01 for "1.25", 100 for "3e2".
double last_place(std::string_view number) {
  const std::size_t exponent = number.find_first_of("eEdD");
  const std::string_view mantissa = number.substr(0, exponent);
  const std::size_t point = mantissa.find('.');
  double power = point == std::string_view::npos ? 0.0 : -static_cast<double>(mantissa.size() - point - 1);
  if (exponent != std::string_view::npos) power += number_of_text(number.substr(exponent + 1)).value_or(0.0);
  return std::pow(10.0, power);
}

/// The text of a time, from which its last decimal is taken, and its place.
struct Stamp {
  Field field;
  int line;
};

[[noreturn]] void fail(const std::string& name, int line, const Field& at, std::string problem, std::string allowed,
                       std::string hint) {
  throw CaseError(name, {line, at.column},
                  {std::move(problem), "", in_quotes(at.text), std::move(allowed), std::move(hint)});
}

void refuse_gaps(const std::string& name, const std::vector<double>& time, const std::vector<Stamp>& stamps) {
  std::vector<double> steps(time.size() - 1);
  for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = time[i + 1] - time[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  const double regular = *middle;
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double rounding = std::max(last_place(stamps[i - 1].field.text), last_place(stamps[i].field.text));
    const double tolerance = std::max(1e-3 * regular, std::min(rounding, 0.5 * regular));
    // 1e-9: the differences of rounded decimals are rounded again.
    if (std::abs(time[i] - time[i - 1] - regular) <= tolerance * (1.0 + 1e-9)) continue;
    fail(name, stamps[i].line, stamps[i].field,
         fmt::format("the step from {} s to {} s is not the {:.6g} s of the other rows", time[i - 1], time[i], regular),
         fmt::format("{:.9g}, within {:.2g} s", time[i - 1] + regular, tolerance),
         fmt::format(
             "fill the gap, split the record there into two files, or give the motion resample = {:.6g} to interpolate "
             "linearly",
             regular));
  }
}

}  // namespace

Record read_columns(std::string_view text, const std::string& name, Gaps gaps, std::string_view quantity) {
  const std::string form = fmt::format("two columns: time [s], {}", quantity);
  Record record;
  std::vector<Stamp> stamps;
  bool heading_may_come = true;
  TextLines lines(text);
  while (const std::optional<std::string_view> whole = lines.next()) {
    const int line = lines.row();
    const std::vector<Field> fields = fields_of(*whole);
    if (fields.empty()) continue;
    const std::optional<double> t = number_of_text(fields[0].text);
    const bool heading = heading_may_come && !t;
    heading_may_come = false;
    if (heading) continue;
    if (!t)
      fail(name, line, fields[0], "this is not a number", form,
           "decimals have a point; comments begin with #; the name of a PEER record must end in .AT2");
    if (fields.size() != 2)
      fail(name, line, fields.size() < 2 ? fields[0] : fields[2], fmt::format("the row has {} columns", fields.size()),
           form, "decimals have a point, not a comma; write one row per line");
    const std::optional<double> a = number_of_text(fields[1].text);
    if (!a) fail(name, line, fields[1], "this is not a number", form, "decimals have a point; comments begin with #");
    if (!std::isfinite(*t))
      fail(name, line, fields[0], "the time is not finite", "a finite number [s]", "remove the row");
    if (!std::isfinite(*a))
      fail(name, line, fields[1], fmt::format("the {} is not finite", quantity), "a finite number",
           "find the missing value; do not fill gaps of a record by guess");
    if (!record.time.empty() && !(*t > record.time.back()))
      fail(name, line, fields[0],
           fmt::format("the time does not increase: {} s comes after {} s", *t, record.time.back()),
           fmt::format("> {}", record.time.back()), "sort the rows, and keep one of those with equal times");
    record.time.push_back(*t);
    record.acceleration.push_back(*a);
    stamps.push_back({fields[0], line});
  }
  if (record.time.size() < 2)
    throw CaseError(
        name, {std::max(lines.row(), 1), 1},
        {fmt::format("the record has {} rows of numbers", record.time.size()), "", "", "at least two rows", form});
  if (gaps == Gaps::refuse) refuse_gaps(name, record.time, stamps);
  return record;
}

}  // namespace scree::io
