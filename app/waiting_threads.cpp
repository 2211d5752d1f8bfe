#include "app/waiting_threads.h"

#include <unistd.h>

#include <cstdlib>

namespace scree::app {

bool computes(std::string_view command) {
  return command == "run" || command == "resume" || command == "cases" || command == "digest" || command == "sweep" ||
         command == "fos";
}

void let_threads_sleep(char** argv) {
  constexpr const char* kPolicy = "OMP_WAIT_POLICY";
  if (std::getenv(kPolicy) != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr) return;
  if (::setenv(kPolicy, "passive", 0) == 0) ::execv("/proc/self/exe", argv);
}

}  // namespace scree::app
