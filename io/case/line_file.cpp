#include "io/case/line_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "io/case/case_error.h"
#include "io/case/number_text.h"
#include "io/case/text_fields.h"
#include "io/case/text_file.h"

namespace scree::io {
namespace {

constexpr std::size_t kLargestFile = std::size_t{64} << 20;  // bytes
constexpr const char* kForm = "columns x, y [m] and perhaps the name of the line";

}  // namespace

std::vector<FileLine> read_lines(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string text = read_text_file(file, "file of lines", kLargestFile);

  std::vector<FileLine> lines;
  bool heading_may_come = true, open = false;  // open: the last polyline may continue
  std::string label;
  const auto close = [&] {
    if (open && lines.back().points.size() < 2)
      throw CaseError(name, {lines.back().rows.front(), 1},
                      {"the line has one point only", "", "", "at least two points per line",
                       "blank lines separate lines; remove this one, or the point"});
    open = false;
  };
  TextLines text_lines(text);
  while (const std::optional<std::string_view> whole = text_lines.next()) {
    const int row = text_lines.row();
    const std::vector<Field> fields = fields_of(*whole);
    if (fields.empty()) {
      if (whole->find_first_not_of(" \t\r") == std::string_view::npos) close();
      continue;
    }
    const auto fail = [&](const Field& at, std::string problem, std::string allowed, std::string hint) {
      throw CaseError(name, {row, at.column},
                      {std::move(problem), "", in_quotes(at.text), std::move(allowed), std::move(hint)});
    };
    const std::optional<double> x = number_of_text(fields[0].text);
    const bool heading = heading_may_come && !x;
    heading_may_come = false;
    if (heading) continue;
    if (!x) fail(fields[0], "this is not a number", kForm, "decimals have a point; comments begin with #");
    if (fields.size() < 2 || fields.size() > 3)
      fail(fields[fields.size() < 2 ? 0 : 3], fmt::format("the row has {} columns", fields.size()), kForm,
           "decimals have a point, not a comma; write one point per row");
    const std::optional<double> y = number_of_text(fields[1].text);
    if (!y) fail(fields[1], "this is not a number", kForm, "decimals have a point; comments begin with #");
    const Vec2 p(*x, *y);
    constexpr double kFarthest = 1e9;  // [m], as for coordinates in the case file
    for (int i = 0; i < 2; ++i)
      if (!(std::abs(p[i]) <= kFarthest))
        fail(fields[static_cast<std::size_t>(i)], "the coordinate is out of range", "-1e9 <= value <= 1e9 [m]",
             "check the number and its unit");
    const std::string here(fields.size() == 3 ? fields[2].text : std::string_view{});
    if (open && here != label) close();
    if (!open) lines.emplace_back().label = here;
    open = true;
    label = here;
    lines.back().points.push_back(p);
    lines.back().rows.push_back(row);
  }
  close();
  if (lines.empty())
    throw CaseError(name, {std::max(text_lines.row(), 1), 1},
                    {"the file holds no line", "", "", "at least two points", kForm});
  return lines;
}

}  // namespace scree::io
