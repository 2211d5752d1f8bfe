// How threads wait for each other.
#pragma once

#include <string_view>

namespace scree::app {

/// True for commands that compute in parallel; the others are not worth the 40 ms of a second beginning.
[[nodiscard]] bool computes(std::string_view command);

/// Threads that wait look for some microseconds whether they may go on, and then sleep, unless the environment says
/// otherwise (OMP_WAIT_POLICY, GOMP_SPINCOUNT). To wake one that sleeps takes longer than most loops of a step:
/// sleeping at once, two threads took 1.27 of the time of one in cases/threads, and so 1.06 (a quiet machine). By
/// default GCC's OpenMP has them spin, for minutes if need be: where anything else computes on the machine, steps of
/// small models take fifty times as long, all of it processor time. OpenMP reads its environment before main and has no
/// call for it, so the program begins anew, once. Where that cannot be done it goes on as it is.
/// @param argv  as main has it
void let_threads_sleep(char** argv);

}  // namespace scree::app
