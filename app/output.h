// What commands print: the only place that writes to standard output and standard error.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace scree::app {

/// Standard input, output and error are open from then on: a file that is opened later never takes their place.
void open_standard_streams();

/// Prints texts for people on standard output (say) and on standard error (complain). Names and paths in them cannot
/// steer the terminal (io::printable). Throws nothing: what cannot be written is lost, and output_error() tells why.
/// A reader that does not read holds the command up, but no longer than until a signal asks it to stop.
template <class... Args>
void say(fmt::format_string<Args...> form, Args&&... args);
template <class... Args>
void complain(fmt::format_string<Args...> form, Args&&... args);

/// The same for a line that stands by itself (io::Notice).
void complain_line(const std::string& line);

/// What is said while one lives goes out at its end, or when some has come together, unless standard output is a
/// terminal: in few pieces, so that a reader who has seen enough (`scree cases list | grep -q miller`) finds it all
/// written.
class CollectedOutput {
 public:
  CollectedOutput();
  CollectedOutput(const CollectedOutput&) = delete;
  CollectedOutput& operator=(const CollectedOutput&) = delete;
  ~CollectedOutput();
};

/// Standard output as it is, escape sequences of our own included.
void draw(std::string_view text);

/// errno of the first write that failed; 0: none has.
[[nodiscard]] int output_error();
/// Whether a write failed, or would because whoever read it has gone: looks again ten times a second.
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
