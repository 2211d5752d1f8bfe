#include "app/output.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <string>

#include "app/signals.h"
#include "io/text/printable.h"

namespace scree::app {
namespace {

using SteadyClock = std::chrono::steady_clock;

int first_error = 0;

constexpr std::size_t kPiece = 4096;  // bytes; a ready pipe accepts them without blocking (PIPE_BUF)
bool collects = false;
std::string collected;

/// Writes no more at once than a ready pipe or terminal accepts without blocking, so that a signal is noticed.
void write_all(int descriptor, std::string_view text) {
  // A terminal that nobody reads may accept less.
  const std::size_t piece = collects ? kPiece : 256;
  while (!text.empty()) {
    pollfd ready{descriptor, POLLOUT, 0};
    if (::poll(&ready, 1, 100) <= 0) {
      if (Signals::came()) return;
      continue;
    }
    const ssize_t written = ::write(descriptor, text.data(), std::min(text.size(), piece));
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR && errno != EAGAIN) {
      if (first_error == 0) first_error = errno;
      return;
    }
  }
}

void flush() {
  write_all(STDOUT_FILENO, collected);
  collected.clear();
}

}  // namespace

void open_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0) (void)::open("/dev/null", O_RDWR);  // takes the lowest number that is free
}

void draw(std::string_view text) {
  flush();
  write_all(STDOUT_FILENO, text);
}
void say_text(std::string_view text) {
  collected += io::printable(text);
  if (!collects || collected.size() >= kPiece) flush();
}
void complain_text(std::string_view text) {
  flush();
  write_all(STDERR_FILENO, io::printable(text));
}

void complain_line(const std::string& line) { complain_text(line + "\n"); }

CollectedOutput::CollectedOutput() { collects = ::isatty(STDOUT_FILENO) == 0; }
CollectedOutput::~CollectedOutput() {
  flush();
  collects = false;
}

int output_error() { return first_error; }

bool output_is_lost() {
  static SteadyClock::time_point next{};
  static bool gone = false;
  if (first_error != 0 || gone) return true;
  if (SteadyClock::now() < next) return false;
  next = SteadyClock::now() + std::chrono::milliseconds(100);
  std::array<pollfd, 2> streams{{{STDOUT_FILENO, 0, 0}, {STDERR_FILENO, 0, 0}}};
  gone = ::poll(streams.data(), streams.size(), 0) > 0;  // errors and hang-ups are always reported
  return gone;
}

}  // namespace scree::app
