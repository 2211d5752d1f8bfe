// Ctrl-C and SIGTERM ask a run to stop.
#pragma once

#include "coupling/sink.h"

namespace scree::app {

/// From then on the first of these signals ends the run as soon as it can, with everything written: after the present
/// step, or before it if it takes long. The second one ends the program at once, with exit code 130. One that comes
/// when the run is over already changes nothing: the program ends as the run did.
class Signals final : public coupling::Control {
 public:
  Signals();
  bool stop_requested() override;
  bool give_up_step() override;
};

/// A file that grows beyond a limit (ulimit -f) is then an error of the write, as a full disk is, not the end of the
/// program.
void writes_tell_of_limits();

}  // namespace scree::app
