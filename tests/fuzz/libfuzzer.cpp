// libFuzzer's side of a harness (preset fuzz). With SCREE_SEEDS=FOLDER in the environment it writes the seeds
// there and ends.
#include <cstdlib>
#include <fstream>

#include "tests/fuzz/harness.h"

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  const char* folder = std::getenv("SCREE_SEEDS");
  if (folder == nullptr) return 0;
  std::filesystem::create_directories(folder);
  std::size_t i = 0;
  for (const scree::fuzz::Input& seed : scree::fuzz::seeds())
    std::ofstream(std::filesystem::path(folder) / ("seed-" + std::to_string(i++)), std::ios::binary)
        .write(reinterpret_cast<const char*>(seed.data()), static_cast<std::streamsize>(seed.size()));
  std::exit(0);
}

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  scree::fuzz::take({data, size});
  return 0;
}
