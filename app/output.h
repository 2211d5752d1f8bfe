// What commands print: the only place that writes to standard output and standard error.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace scree::app {

/// Opens those of standard input, output and error that are closed, so that no file opened later takes their place.
void open_standard_streams();

/// Prints texts for people on standard output (say) and on standard error (complain). Names and paths in them cannot
/// control the terminal (io::printable). Throws nothing: text that cannot be written is lost, and output_error() gives
/// the reason. A reader that does not read blocks the command, but only until a signal requests its end.
template <class... Args>
void say(fmt::format_string<Args...> form, Args&&... args);
template <class... Args>
void complain(fmt::format_string<Args...> form, Args&&... args);

/// complain() for one complete line (io::Notice).
void complain_line(const std::string& line);

/// Collects the text for standard output during its lifetime and writes it in few pieces (at its end, or when a piece
/// is full), unless standard output is a terminal: a reader that closes early (`scree cases list | grep -q miller`)
/// then finds everything written.
class CollectedOutput {
 public:
  CollectedOutput();
  CollectedOutput(const CollectedOutput&) = delete;
  CollectedOutput& operator=(const CollectedOutput&) = delete;
  ~CollectedOutput();
};

/// Writes to standard output without changes, including our own escape sequences.
void draw(std::string_view text);

/// errno of the first write that failed; 0: none has.
[[nodiscard]] int output_error();
/// Whether a write failed, or would fail because the reader has closed the stream; tested ten times per second.
[[nodiscard]] bool output_is_lost();

// ---------------------------------------------------------------------------------------------------------------

void say_text(std::string_view text);
void complain_text(std::string_view text);

template <class... Args>
void say(fmt::format_string<Args...> form, Args&&... args) {
  say_text(fmt::format(form, std::forward<Args>(args)...));
}
template <class... Args>
void complain(fmt::format_string<Args...> form, Args&&... args) {
  complain_text(fmt::format(form, std::forward<Args>(args)...));
}

}  // namespace scree::app
