// Numbers as people, spreadsheets and Fortran write them.
#pragma once

#include <optional>
#include <string_view>

namespace scree::io {

/// The number that the whole text represents: with decimal point, sign, exponent after e, E, d or D. A number too large
/// for a double is infinite, one too small is zero; "inf" and "nan" are numbers here, so that the caller can report
/// what is wrong with them. Independent of the locale.
/// @return nothing if the text is not a number
[[nodiscard]] std::optional<double> number_of_text(std::string_view text);

/// Length of the number that a text begins with, 0 if none: digits with or without a point, with or without an
/// exponent. "1.234-5.678" begins with "1.234"; "1.234-105" is one number, since Fortran leaves out the letter of
/// an exponent with three digits.
[[nodiscard]] std::size_t leading_number(std::string_view text);

}  // namespace scree::io
