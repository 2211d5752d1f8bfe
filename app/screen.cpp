#include "app/screen.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>

namespace scree::app {
namespace {

/// A closed terminal is no error here: the next read from it reports the fault.
void to_terminal(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
    if (written < 0 && errno != EINTR) return;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace

TerminalSize terminal_size() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {100, 60};
  return {std::clamp<int>(size.ws_col, 40, 500), std::clamp<int>(size.ws_row, 10, 200)};
}

// Alternate screen, no cursor, no wrapping.
Screen::Screen() { to_terminal("\033[?1049h\033[?25l\033[?7l\033[2J"); }

Screen::~Screen() { to_terminal("\033[0m\033[?7h\033[?25h\033[?1049l"); }

void Screen::draw(const std::vector<std::string>& lines, TerminalSize size) const {
  std::string text = "\033[H";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto length = static_cast<int>(std::count_if(lines[i].begin(), lines[i].end(), [](char c) {
      return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;  // characters of UTF-8
    }));
    const auto rest = static_cast<std::size_t>(std::max(0, size.width - length));
    if (i == 0)
      text += "\033[7m" + lines[i] + std::string(rest, ' ') + "\033[0m";
    else
      text += "\r\n" + lines[i] + (rest > 0 ? "\033[K" : "");  // in the last column it would erase the last character
  }
  if (lines.size() < static_cast<std::size_t>(size.height)) text += "\r\n\033[J";
  to_terminal(text);
}

}  // namespace scree::app
