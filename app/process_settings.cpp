#include "app/process_settings.h"

#include <unistd.h>

#include <cstdlib>
#include <string>

namespace scree::app {

bool computes(std::string_view command) {
  return command == "run" || command == "resume" || command == "cases" || command == "digest" || command == "sweep" ||
         command == "fos";
}

void restart_with_settings(char** argv) {
  constexpr const char *kSpins = "GOMP_SPINCOUNT", *kTunables = "GLIBC_TUNABLES", *kLargePages = "glibc.malloc.hugetlb";
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv(kSpins) != nullptr) return;
  const char* const given = std::getenv(kTunables);
  std::string tunables = given != nullptr ? given : "";
  if (tunables.find(kLargePages) == std::string::npos)
    tunables += (tunables.empty() ? "" : ":") + std::string(kLargePages) + "=1";  // madvise()
  // A BLAS with threads of its own starts them before main, and they spin for 25 ms each until they sleep. Scree calls
  // it on one thread at a time.
  if (::setenv(kSpins, "3000", 0) == 0 && ::setenv("OPENBLAS_NUM_THREADS", "1", 1) == 0 &&
      ::setenv(kTunables, tunables.c_str(), 1) == 0)
    ::execv("/proc/self/exe", argv);
}

}  // namespace scree::app
