// Settings of the process that libraries read before main: how threads wait, size of memory pages.
#pragma once

#include <string_view>

namespace scree::app {

/// True for commands that compute in parallel; for the others a restart of the program (5 ms) does not pay.
[[nodiscard]] bool computes(std::string_view command);

/// Makes waiting threads poll for some microseconds and then sleep, unless the environment sets another policy
/// (OMP_WAIT_POLICY, GOMP_SPINCOUNT). Waking a sleeping thread takes longer than most loops of a step: if they slept at
/// once, two threads took 1.27 times as long as one in cases/threads, with this policy 1.06 times (a quiet machine).
/// By default GCC's OpenMP lets waiting threads spin, for minutes if necessary: if anything else computes on the
/// machine, steps of small models take fifty times as long, all of it processor time.
///
/// Also asks the allocator for large pages (2 MB) where arrays are large (GLIBC_TUNABLES, glibc.malloc.hugetlb, unless
/// the environment sets it): a step of 10,000 blocks takes 0.9 of the time, since it reads memory through fewer entries
/// of the processor's page table cache. And starts the BLAS on one thread: it starts threads that nothing uses.
///
/// These libraries read their environment before main, so the program restarts itself once. If it cannot, or if a
/// policy for threads is set, it continues unchanged.
/// @param argv  as passed to main
void restart_with_settings(char** argv);

}  // namespace scree::app
