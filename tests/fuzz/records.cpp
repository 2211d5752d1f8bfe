// Files that a case names: ground motions in columns and as .AT2, and polylines.
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "io/case/case_error.h"
#include "io/case/line_file.h"
#include "io/case/record.h"
#include "tests/fuzz/harness.h"

namespace scree::fuzz {
namespace {

/// A folder in memory where the machine has one.
std::filesystem::path folder() {
  const std::filesystem::path memory = "/dev/shm";
  return std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
}

/// A scratch file of this process.
const std::filesystem::path& scratch() {
  struct File {
    std::filesystem::path path = folder() / ("scree-fuzz-" + std::to_string(getpid()));
    File() = default;
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() { std::filesystem::remove(path); }
  };
  static const File kFile;
  return kFile.path;
}

}  // namespace

void take(std::span<const std::uint8_t> input) {
  const std::string_view text = text_of(input);
  const auto tried = [](const auto& read) {
    try {
      read();
    } catch (const io::CaseError&) {
    }
  };
  tried([&] { static_cast<void>(io::read_columns(text, "fuzz.csv", io::Gaps::refuse)); });
  tried([&] { static_cast<void>(io::read_columns(text, "fuzz.csv", io::Gaps::accept)); });
  tried([&] { static_cast<void>(io::read_at2(text, "fuzz.AT2")); });
  std::ofstream(scratch(), std::ios::binary).write(text.data(), static_cast<std::streamsize>(text.size()));
  tried([&] { static_cast<void>(io::read_lines(scratch())); });
}

std::vector<Input> seeds() {
  std::vector<Input> out;
  for (const char* folder : {"cases", "tests/unit/io", "tests/fault/cases", "tests/e2e"})
    for (Input& input : files_of(folder, {".csv", ".AT2"}))
      if (input.size() < 20000) out.push_back(std::move(input));
  return out;
}

}  // namespace scree::fuzz
