// What asks a run to stop: Ctrl-C, SIGTERM, a terminal that was closed, output that nobody reads any more.
#pragma once

#include "coupling/sink.h"

namespace scree::app {

/// From then on the first of SIGINT, SIGTERM and SIGHUP ends the run as soon as it can, with everything written: after
/// the present step, or before it if it takes long. So does output that cannot be written (`scree run CASE | head -1`).
/// Another SIGINT or SIGTERM, half a second later or more, ends the program at once, with exit code 130; those that are
/// sent together count as one. One that comes when the run is over already changes nothing: the program ends as the run
/// did.
class Signals final : public coupling::Control {
 public:
  /// @param prints  whether the run prints, and is to stop when whoever read that has gone
  explicit Signals(bool prints);
  bool stop_requested() override;
  bool give_up_step() override;

  /// Whether a signal has asked for the end.
  [[nodiscard]] static bool came();

 private:
  bool prints_;
};

/// What comes before a run has begun ends the program at once, with exit code 130: there is nothing to keep yet. A
/// SIGHUP that was ignored when the program was started (nohup) stays so. A write to a pipe without a reader is an
/// error of the write from then on, and does not end the program.
void take_signals_of_runs();

/// A file that grows beyond a limit (ulimit -f) is then an error of the write, as a full disk is, not the end of the
/// program. A write to a pipe without a reader ends it quietly, as it ends other commands, whatever was inherited.
void take_signals_of_writes();

}  // namespace scree::app
