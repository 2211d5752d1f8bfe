// Checkpoints: the input is the data between head and digest; both are corrected for every input.
#include <unistd.h>

#include <fstream>

#include "coupling/stages/driver.h"
#include "io/checkpoint/archive.h"
#include "io/checkpoint/checkpoint_file.h"
#include "io/results/file_error.h"
#include "io/results/sha256.h"
#include "tests/fuzz/harness.h"
#include "tests/support/scene.h"

namespace scree::fuzz {
namespace {

constexpr const char* kVersion = "fuzz";
constexpr std::string_view kMagic = "SCREE-CP";  // checkpoint_file.h
constexpr std::size_t kHead = kMagic.size() + 4 + 4 + 8, kDigest = 64;

std::filesystem::path scratch() {
  const std::filesystem::path memory = "/dev/shm";  // where the machine has it
  return (std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path()) /
         ("scree-fuzz-checkpoint-" + std::to_string(getpid()));
}

/// Keeps every 40th step.
struct Keep final : coupling::Keeper {
  std::vector<Input> kept;
  bool due(std::int64_t step) override { return step % 40 == 0; }
  void keep(const coupling::Checkpoint& checkpoint) override {
    io::RunRecord run;
    run.version = kVersion;
    io::write_checkpoint(scratch(), run, {}, checkpoint);
    std::ifstream in(scratch(), std::ios::binary);
    Input bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    kept.emplace_back(bytes.begin() + static_cast<std::ptrdiff_t>(kHead),
                      bytes.end() - static_cast<std::ptrdiff_t>(kDigest));
    std::filesystem::remove(scratch());
  }
};

}  // namespace

void take(std::span<const std::uint8_t> input) {
  std::string bytes(kMagic);
  const auto put = [&](const auto& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(std::uint32_t{1});
  put(std::uint32_t{0x01020304});
  put(std::uint64_t{input.size() + kDigest});
  bytes += text_of(input);
  bytes += io::sha256(bytes);
  std::ofstream(scratch(), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    static_cast<void>(io::read_checkpoint(scratch(), kVersion));
  } catch (const io::FileError&) {
  }
  std::filesystem::remove(scratch());
}

std::vector<Input> seeds() {
  Keep keep;
  static const coupling::Methods kMethods = coupling::standard_methods();
  for (const char* method : {"dda", "nmm"})
    for (const auto integrator : {coupling::Integrator::explicit_, coupling::Integrator::implicit}) {
      test::Scene scene;
      scene.add("base", test::rectangle(-2, -1, 4, 0), true);
      scene.add("block", test::rectangle(0, 0, 2, 1));
      scene.stage(method, integrator, 1.0,
                  integrator == coupling::Integrator::implicit ? std::optional(1e-3) : std::nullopt);
      coupling::Driver run(scene.model, scene.plan, kMethods);
      run.set_keeper(keep);
      run.run(0.05);
    }
  return keep.kept;
}

}  // namespace scree::fuzz
