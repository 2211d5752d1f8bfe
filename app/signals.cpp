#include "app/signals.h"

#include <unistd.h>

#include <atomic>
#include <csignal>
#include <ctime>

#include "app/commands.h"
#include "app/output.h"

namespace scree::app {
namespace {

constexpr std::int64_t kTogether = 500;  // [ms]; closing a terminal, timeout and systemd send two at a time

std::atomic<std::int64_t> came_at = 0;  // time of the signal [ms]; 0: none
std::atomic<bool> running = false;

std::int64_t now() {
  timespec t{};
  ::clock_gettime(CLOCK_MONOTONIC, &t);
  return 1000 * static_cast<std::int64_t>(t.tv_sec) + t.tv_nsec / 1'000'000 + 1;
}

extern "C" void on_signal(int signal) {
  if (!running) ::_exit(kInterrupted);
  std::int64_t first = 0;
  if (came_at.compare_exchange_strong(first, now())) return;
  if (signal != SIGHUP && now() - first >= kTogether) ::_exit(kInterrupted);
}

volatile std::sig_atomic_t of_loop = 0;
extern "C" void on_signal_of_loop(int signal) { of_loop = signal; }

}  // namespace

Signals::Signals(bool prints) : prints_(prints) {
  take_signals_of_runs();
  came_at = 0;
  running = true;
}

bool Signals::came() { return came_at != 0; }
bool Signals::stop_requested() { return came() || output_error() != 0 || (prints_ && output_is_lost()); }
bool Signals::give_up_step() { return stop_requested(); }

void take_signals_of_runs() {
  static_assert(std::atomic<std::int64_t>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  if (std::signal(SIGHUP, on_signal) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
}

void take_signals_of_loops(std::initializer_list<int> signals) {
  of_loop = 0;
  for (const int signal : signals) std::signal(signal, on_signal_of_loop);
}

bool loop_is_to_end() { return of_loop != 0; }

void take_signals_of_writes() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_DFL);
}

}  // namespace scree::app
