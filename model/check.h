// Assertions for programmer errors; bad input is a CaseError, non-convergence a status.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace scree {
[[noreturn]] inline void assertion_failed(const char* what, const char* file, int line) {
  std::fprintf(stderr, "%s:%d: assertion failed: %s\n", file, line, what);
  std::abort();
}
}  // namespace scree

#if defined(SCREE_AUDIT) || !defined(NDEBUG)
#define SCREE_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::scree::assertion_failed(#condition, __FILE__, __LINE__))
#else
#define SCREE_ASSERT(condition) static_cast<void>(0)
#endif
