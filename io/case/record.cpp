#include "io/case/record.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "io/case/case_error.h"
#include "io/case/text_fields.h"
#include "io/case/text_file.h"

namespace scree::io {
namespace {

constexpr std::size_t kLargestRecord = std::size_t{64} << 20;  // bytes
constexpr const char* kForm = "two columns: time [s], acceleration";

}  // namespace

Record read_record(const std::filesystem::path& file, double factor) {
  const std::string name = file.string();
  std::string text = read_text_file(file, "record", kLargestRecord);
  std::string_view rest = text;
  if (rest.starts_with("\xEF\xBB\xBF")) rest.remove_prefix(3);

  Record record;
  int line = 0;
  bool heading_may_come = true;
  while (!rest.empty()) {
    ++line;
    const std::size_t end = rest.find('\n');
    const std::vector<Field> fields = fields_of(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    if (fields.empty()) continue;
    const auto fail = [&](const Field& at, std::string problem, std::string allowed, std::string hint) {
      throw CaseError(name, {line, at.column},
                      {std::move(problem), "", in_quotes(at.text), std::move(allowed), std::move(hint)});
    };
    double t = 0.0, a = 0.0;
    const bool first_is_number = read_number(fields[0].text, t);
    if (heading_may_come && !first_is_number) {
      heading_may_come = false;
      continue;
    }
    heading_may_come = false;
    if (!first_is_number)
      fail(fields[0], "this is not a number", kForm, "decimals have a point; comments begin with #");
    if (fields.size() != 2)
      fail(fields.size() < 2 ? fields[0] : fields[2], fmt::format("the row has {} columns", fields.size()), kForm,
           "decimals have a point, not a comma; keep one row a line");
    if (!read_number(fields[1].text, a))
      fail(fields[1], "this is not a number", kForm, "decimals have a point; comments begin with #");
    if (!std::isfinite(t)) fail(fields[0], "the time is not finite", "a finite number [s]", "remove the row");
    if (!std::isfinite(a) || !std::isfinite(a * factor))
      fail(fields[1], "the acceleration is not finite", "a finite number", "remove the row");
    if (!record.time.empty() && !(t > record.time.back()))
      fail(fields[0], fmt::format("the time does not increase: {:g} s comes after {:g} s", t, record.time.back()),
           fmt::format("> {:g}", record.time.back()), "sort the rows, and keep one of those with equal times");
    record.time.push_back(t);
    record.acceleration.push_back(a * factor);
  }
  if (record.time.size() < 2)
    throw CaseError(
        name, {std::max(line, 1), 1},
        {fmt::format("the record has {} rows of numbers", record.time.size()), "", "", "at least two rows", kForm});
  return record;
}

}  // namespace scree::io
