// Case files: from text to model and plan, including cutting, checks and estimates of meshes.
#include "io/case/read_case.h"
#include "tests/fuzz/harness.h"

namespace scree::fuzz {

void take(std::span<const std::uint8_t> input) {
  static const std::vector<std::string> kMethods = {"nmm", "dda"};
  try {
    static_cast<void>(io::read_case_text(std::string(text_of(input)), "no such folder/case.toml", {}, kMethods));
  } catch (const io::CaseError&) {
  }
}

std::vector<Input> seeds() {
  std::vector<Input> out;
  for (const char* folder : {"cases", "tests/unit/io", "tests/fault/cases", "tests/e2e"})
    for (Input& input : files_of(folder, {".toml"}))
      if (input.size() < 20000 && text_of(input).find("10,000 blocks") == std::string_view::npos)  // takes a second
        out.push_back(std::move(input));
  return out;
}

}  // namespace scree::fuzz
