// Full-screen drawing on the terminal.
#pragma once

#include <string>
#include <vector>

namespace scree::app {

struct TerminalSize {
  int width = 0, height = 0;
};
/// Size of the terminal on standard output, at least 40 x 10 and at most 500 x 200; where there is none, 100 columns
/// and 60 lines.
[[nodiscard]] TerminalSize terminal_size();

/// Switches to the alternate screen; the destructor restores the previous screen, whatever the reason of the end.
class Screen {
 public:
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  /// Shows these lines, the first one in reverse video; lines longer than the terminal is wide do not wrap.
  /// @pre no control characters
  void draw(const std::vector<std::string>& lines, TerminalSize size) const;
};

}  // namespace scree::app
