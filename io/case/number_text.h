// Numbers as people, spreadsheets and Fortran write them.
#pragma once

#include <optional>
#include <string_view>

namespace scree::io {

/// The number that a text is, all of it: decimal point, a sign, an exponent after e, E, d or D. Too large for a double
/// is infinite, too small is zero; "inf" and "nan" are numbers here, so that the caller can say what is wrong with
/// them. Independent of the locale.
/// @return nothing where the text is no number
[[nodiscard]] std::optional<double> number_of_text(std::string_view text);

/// Length of the number that a text begins with, 0 if none: digits with or without a point, with or without an
/// exponent. "1.234-5.678" begins with "1.234"; "1.234-105" with all of it, since Fortran leaves out the letter of an
/// exponent with three digits.
[[nodiscard]] std::size_t leading_number(std::string_view text);

}  // namespace scree::io
