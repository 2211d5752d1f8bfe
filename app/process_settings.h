// How threads wait for each other.
#pragma once

#include <string_view>

namespace scree::app {

/// True for commands that compute in parallel; for the others a restart of the program (40 ms) does not pay.
[[nodiscard]] bool computes(std::string_view command);

/// Makes waiting threads poll for some microseconds and then sleep, unless the environment sets another policy
/// (OMP_WAIT_POLICY, GOMP_SPINCOUNT). Waking a sleeping thread takes longer than most loops of a step: if they slept at
/// once, two threads took 1.27 times as long as one in cases/threads, with this policy 1.06 times (a quiet machine).
/// By default GCC's OpenMP lets waiting threads spin, for minutes if necessary: if anything else computes on the
/// machine, steps of small models take fifty times as long, all of it processor time. OpenMP reads its environment
/// before main and has no call for this setting, so the program restarts itself once, with a BLAS on one thread as
/// well: that library starts threads which nothing uses. If it cannot restart, it continues unchanged.
/// @param argv  as passed to main
void restart_with_settings(char** argv);

}  // namespace scree::app
