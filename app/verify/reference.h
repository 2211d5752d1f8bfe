// Reference data of a case: a CSV table.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scree::app {

/// A table of numbers under headings "name" or "name [unit]"; its first column may hold names instead.
struct ReferenceTable {
  std::string file;
  std::vector<std::string> headings;         // without units
  std::vector<std::string> names;            // of rows; empty where the first column holds numbers
  std::vector<std::vector<double>> columns;  // as many as headings; of names: empty

  /// @throws io::CaseError that lists the existing headings
  [[nodiscard]] const std::vector<double>& column(std::string_view heading) const;
};

/// Columns separated by commas; '#' begins a comment; the first line that is no comment holds the headings.
/// @throws io::CaseError with the place: unreadable, no rows, a row with other fields than headings, not a number
[[nodiscard]] ReferenceTable read_reference(const std::filesystem::path& file);

/// Piecewise linear interpolation through (x, y) at a place; constant beyond the ends.   @pre x increasing, not empty
[[nodiscard]] double interpolated(const std::vector<double>& x, const std::vector<double>& y, double at);

}  // namespace scree::app
