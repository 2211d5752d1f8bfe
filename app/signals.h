// What stops a run: Ctrl-C, SIGTERM, a terminal that was closed, output that nobody reads any more.
#pragma once

#include <initializer_list>

#include "coupling/sink.h"

namespace scree::app {

/// Once constructed, the first SIGINT, SIGTERM or SIGHUP ends the run as soon as possible, with everything written:
/// after the present step, or before its end if it takes long. Output that cannot be written has the same effect
/// (`scree run CASE | head -1`). Another SIGINT or SIGTERM, half a second later or more, ends the program at once, with
/// exit code 130; signals that are sent together count as one. A signal after the end of the run changes nothing: the
/// program ends with the exit code of the run.
class Signals final : public coupling::Control {
 public:
  /// @param prints  whether the run prints, and stops when the reader of its output has closed it
  explicit Signals(bool prints);
  bool stop_requested() override;
  bool give_up_step() override;

  /// Whether a signal has requested the end.
  [[nodiscard]] static bool came();

 private:
  bool prints_;
};

/// A signal before the start of a run ends the program at once, with exit code 130: there is nothing to keep yet. A
/// SIGHUP that was ignored when the program was started (nohup) stays ignored. From then on a write to a pipe without
/// a reader is an error of the write and does not end the program.
void take_signals_of_runs();

/// From then on these signals end a loop that asks whether one came, instead of the program: viewers and replays, which
/// have a terminal or a server to leave.
void take_signals_of_loops(std::initializer_list<int> signals);
[[nodiscard]] bool loop_is_to_end();

/// From then on a file that grows beyond a limit (ulimit -f) is an error of the write, like a full disk, and does not
/// end the program. A write to a pipe without a reader ends the program silently, as it ends other commands, whatever
/// setting was inherited.
void take_signals_of_writes();

}  // namespace scree::app
