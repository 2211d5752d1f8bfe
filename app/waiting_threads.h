// How threads wait for each other.
#pragma once

#include <string_view>

namespace scree::app {

/// True for commands that compute in parallel; the others are not worth the 40 ms of a second beginning.
[[nodiscard]] bool computes(std::string_view command);

/// Threads that wait sleep, unless the environment says otherwise (OMP_WAIT_POLICY, GOMP_SPINCOUNT). By default GCC's
/// OpenMP has them spin, for minutes if need be: where anything else computes on the machine, steps of small models
/// take fifty times as long, all of it processor time. OpenMP reads its environment before main and has no call for it,
/// so the program begins anew, once. Where that cannot be done it goes on as it is.
/// @param argv  as main has it
void let_threads_sleep(char** argv);

}  // namespace scree::app
