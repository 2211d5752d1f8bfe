#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "io/case/case_error.h"
#include "io/case/number_text.h"
#include "io/case/record.h"
#include "io/case/text_fields.h"

namespace scree::io {
namespace {

constexpr int kTitleLines = 20;  // the header of PEER is the fourth line; leave room for notes
constexpr const char* kHeaderForms = "a line \"NPTS=  3930, DT= .00500 SEC\" or \"3930 0.00500 NPTS, DT\"";

/// A part of a line, and its place.
struct Spot {
  std::string_view text;
  int line = 0;
  std::size_t offset = 0;  // in the line
};

bool blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
std::string upper(std::string_view text) {
  std::string out;
  for (const char c : text) out += upper(c);
  return out;
}

class At2 {
 public:
  At2(std::string_view text, const std::string& name) : lines_(text), name_(name) {}
  Record read() {
    read_header();
    while (!ended_) {
      const std::optional<std::string_view> line = lines_.next();
      if (!line) break;
      read_values(*line);
    }
    if (record_.acceleration.size() != count_)
      fail(count_spot_,
           fmt::format("the header announces {} values, the file holds {}", count_, record_.acceleration.size()),
           fmt::format("{} values after the header", count_),
           "the file is cut or was edited: get it again, or correct NPTS");
    return std::move(record_);
  }

 private:
  [[noreturn]] void fail(const Spot& at, std::string problem, std::string allowed, std::string hint) const {
    throw CaseError(name_, {at.line, static_cast<int>(at.offset) + 1},
                    {std::move(problem), "", in_quotes(at.text), std::move(allowed), std::move(hint)});
  }

  /// The next word of a line from an offset on; words end at blanks, commas and equals signs.
  [[nodiscard]] Spot word(std::string_view line, std::size_t from) const {
    const auto separates = [](char c) { return blank(c) || c == ',' || c == '='; };
    while (from < line.size() && separates(line[from])) ++from;
    std::size_t end = from;
    while (end < line.size() && !separates(line[end])) ++end;
    return {line.substr(from, end - from), lines_.row(), from};
  }

  void read_header() {
    std::string first;
    while (lines_.row() < kTitleLines) {
      const std::optional<std::string_view> line = lines_.next();
      if (!line) break;
      if (lines_.row() == 1) first = line->substr(0, line->find('\r'));
      const std::size_t key = upper(*line).find("NPTS");
      if (key != std::string::npos) return read_counts(*line, key);
      read_unit(*line);
    }
    fail({first, 1, 0}, "the file has no header with NPTS and DT", kHeaderForms,
         "add the header that the record had; two columns with time are read from a file whose name does not end in "
         ".AT2");
  }

  /// Reads the unit from a line of title, if the line contains it.
  void read_unit(std::string_view line) {
    const std::string capital = upper(line);
    std::size_t at = std::string::npos;
    for (const std::string_view words : {"UNITS OF", "UNIT OF", "UNITS:", "UNITS="})
      if (at = capital.find(words); at != std::string::npos) {
        at += words.size();
        break;
      }
    if (at == std::string::npos) return;
    Spot spot = word(line, at);
    while (!spot.text.empty() && spot.text.front() == '(') spot.text.remove_prefix(1), ++spot.offset;
    while (!spot.text.empty() && std::string_view(".;:)").find(spot.text.back()) != std::string_view::npos)
      spot.text.remove_suffix(1);
    std::string unit = upper(spot.text);
    const auto put = [&unit](std::string_view from, std::string_view to) {
      for (std::size_t i = unit.find(from); i != std::string::npos; i = unit.find(from))
        unit.replace(i, from.size(), to);
    };
    put("SEC", "S");
    put("**", "");
    put("^", "");
    put("/S/S", "/S2");
    constexpr const char* kUnits = "G, CM/S/S, GAL or M/S/S";
    if (unit == "G" || unit == "G'S")
      record_.unit = "g";
    else if (unit == "CM/S2" || unit == "GAL" || unit == "GALS")
      record_.unit = "cm/s2";
    else if (unit == "M/S2")
      record_.unit = "m/s2";
    else if (unit == "CM/S" || unit == "M/S" || unit == "CM" || unit == "M")
      fail(spot,
           fmt::format("the file holds {}, not accelerations", unit.ends_with('S') ? "velocities" : "displacements"),
           kUnits, "take the .AT2 file of the same record");
    else
      fail(spot, "the unit of the accelerations is not known", kUnits,
           "write the unit in one of these ways, or remove the words \"in units of\" and give the motion a unit");
  }

  /// Reads "NPTS=  3930, DT= .00500 SEC", or the form with both numbers before their names.
  void read_counts(std::string_view line, std::size_t key) {
    Spot step;
    const Spot before = word(line, 0);
    if (before.offset < key) {
      count_spot_ = before;
      step = word(line, before.offset + before.text.size());
      if (step.offset >= key) fail(count_spot_, "the header has one number before NPTS", kHeaderForms, "give both");
    } else {
      count_spot_ = word(line, key + 4);
      const std::size_t name = upper(line).find("DT", key + 4);
      if (name == std::string::npos)
        fail({line.substr(key, 4), lines_.row(), key}, "the header has no DT", kHeaderForms,
             "add the time step in seconds");
      step = word(line, name + 2);
    }
    const char* end = count_spot_.text.data() + count_spot_.text.size();
    const auto read = std::from_chars(count_spot_.text.data(), end, count_);
    if (count_spot_.text.empty() || read.ec != std::errc{} || read.ptr != end || count_ < 2)
      fail(count_spot_, "NPTS is not a number of samples", "a whole number, at least 2", kHeaderForms);
    const std::size_t length = leading_number(step.text);  // "SEC" may follow without a blank
    const std::optional<double> dt = number_of_text(step.text.substr(0, length));
    if (!dt || !std::isfinite(*dt) || !(*dt > 0.0) || !std::isfinite(*dt * static_cast<double>(count_)) ||
        (length < step.text.size() && upper(step.text[length]) != 'S'))
      fail(step, "DT is not a time step", "a number > 0 [s]", kHeaderForms);
    dt_ = *dt;
  }

  /// Reads the numbers of a line; numbers without a blank between them are split at their signs.
  void read_values(std::string_view line) {
    std::size_t i = 0;
    while (i < line.size()) {
      if (blank(line[i])) {
        ++i;
        continue;
      }
      if (line[i] == '\x1A') {  // end-of-file character of DOS
        ended_ = true;
        return;
      }
      std::size_t end = i;
      while (end < line.size() && !blank(line[end])) ++end;
      for (std::size_t at = i; at < end;) {
        const std::string_view left = line.substr(at, end - at);
        const std::size_t length = leading_number(left);
        const bool closed = length == left.size() || left[length] == '+' || left[length] == '-';
        if (length == 0 || !closed) refuse({left, lines_.row(), at});
        take({left.substr(0, length), lines_.row(), at});
        at += length;
      }
      i = end;
    }
  }

  void take(const Spot& at) {
    const double value = number_of_text(with_exponent(at.text)).value_or(std::nan(""));
    if (!std::isfinite(value)) fail(at, "the acceleration is not finite", "a finite number", "get the file again");
    if (record_.acceleration.size() == count_)
      fail(at, fmt::format("the file goes on after the {} values that the header announces", count_),
           fmt::format("the end of the file; NPTS is in line {}", count_spot_.line),
           "the file was edited, or two were joined: get it again, or correct NPTS");
    record_.time.push_back(static_cast<double>(record_.time.size()) * dt_);
    record_.acceleration.push_back(value);
  }

  /// Converts "1.5-103" to "1.5e-103".
  static std::string with_exponent(std::string_view number) {
    const std::size_t sign = number.find_last_of("+-");
    if (sign == std::string_view::npos || sign == 0 || number.find_first_of("eEdD") != std::string_view::npos)
      return std::string(number);
    return std::string(number.substr(0, sign)) + 'e' + std::string(number.substr(sign));
  }

  [[noreturn]] void refuse(const Spot& at) const {
    const std::string word = upper(at.text);
    if (word.find("NAN") != std::string::npos || word.find("INF") != std::string::npos)
      fail(at, "the acceleration is not finite", "a finite number", "get the file again");
    if (at.text.front() == '*')
      fail(at, "this is not a number", "numbers",
           "Fortran writes stars where a number does not fit: write the file again in a wider format");
    fail(at, "this is not a number", "numbers, with blanks or a sign between them",
         "decimals have a point; the file is damaged if PEER wrote it: get it again");
  }

  TextLines lines_;
  const std::string& name_;
  bool ended_ = false;
  Spot count_spot_;
  std::size_t count_ = 0;
  double dt_ = 0.0;
  Record record_;
};

}  // namespace

Record read_at2(std::string_view text, const std::string& name) { return At2(text, name).read(); }

}  // namespace scree::io
