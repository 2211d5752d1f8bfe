#include "app/waiting_threads.h"

#include <unistd.h>

#include <cstdlib>

namespace scree::app {

bool computes(std::string_view command) {
  return command == "run" || command == "resume" || command == "cases" || command == "digest" || command == "sweep" ||
         command == "fos";
}

void let_threads_sleep(char** argv) {
  constexpr const char* kSpins = "GOMP_SPINCOUNT";
  if (std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv(kSpins) != nullptr) return;
  if (::setenv(kSpins, "3000", 0) == 0) ::execv("/proc/self/exe", argv);
}

}  // namespace scree::app
