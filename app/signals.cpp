#include "app/signals.h"

#include <unistd.h>

#include <csignal>

#include "app/commands.h"

namespace scree::app {
namespace {

volatile std::sig_atomic_t stop_signal = 0;

extern "C" void on_signal(int signal) {
  if (stop_signal != 0) ::_exit(kInterrupted);
  stop_signal = signal;
}

}  // namespace

Signals::Signals() {
  stop_signal = 0;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool Signals::stop_requested() { return stop_signal != 0; }
bool Signals::give_up_step() { return stop_signal != 0; }

void writes_tell_of_limits() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace scree::app
