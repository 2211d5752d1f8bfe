// A recorded acceleration in a text file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scree::io {

struct Record {
  std::vector<double> time;          // [s], strictly increasing, at least two
  std::vector<double> acceleration;  // same number of values, finite, in the unit of the file
  std::string unit{};                // "g", "cm/s2" or "m/s2" if stated in the file, else empty
};

/// Treatment of samples whose time steps are not equal.
enum class Gaps { refuse, accept };

/// Reads a file as PEER .AT2 if its name ends so (in any letter case), as columns otherwise.
/// @throws CaseError without line and column: unreadable; with them: what read_at2 and read_columns throw
[[nodiscard]] Record read_record(const std::filesystem::path& file, Gaps gaps);

/// Two columns of a file with any time steps: the history of a load.   @param quantity  in the second column
/// @throws CaseError as read_record
[[nodiscard]] Record read_history(const std::filesystem::path& file, std::string_view quantity);

/// Time [s] and acceleration in two columns, separated by comma, semicolon or white space. '#' begins a comment; one
/// line of headings may come before the numbers. A step is a gap where it differs from the median step by more than
/// what rounding of the times explains (a unit of their last decimal, at most half a step) and by more than 0.1 %.
/// @param text  of the file     @param name  of the file, for errors     @param quantity  in the second column
/// @throws CaseError with line and column: no number, not finite, not two columns, time that does not increase, a gap,
///         fewer than two rows
[[nodiscard]] Record read_columns(std::string_view text, const std::string& name, Gaps gaps,
                                  std::string_view quantity = "acceleration");

/// A PEER strong motion record: lines of title, one of them with "IN UNITS OF G" (or cm/s/s, gal, m/s/s in their usual
/// spellings), then "NPTS=  3930, DT= .00500 SEC" or "3930 0.00500 NPTS, DT", then NPTS numbers in rows of any length.
/// Numbers without a separator are split at their sign: 1.234-5.678 is two numbers; exponents may be Fortran's (1.5D-3,
/// 1.5-103).
/// @param text  of the file     @param name  of the file, for errors
/// @throws CaseError with line and column: no header, wrong NPTS or DT, velocities, unknown unit, no number, not
///         finite, other than NPTS numbers
/// @source [PEER], .AT2; the two forms of the header are those of its old and its NGA files
[[nodiscard]] Record read_at2(std::string_view text, const std::string& name);

}  // namespace scree::io
