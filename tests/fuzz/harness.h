// Interface of every harness of this folder: it processes one input at a time and provides seeds. replay.cpp and
// libFuzzer (preset fuzz) drive the harnesses.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace scree::fuzz {

using Input = std::vector<std::uint8_t>;

/// Passes an input to the code under test. Returns if the input was read, or refused as the interface documents;
/// anything else (another exception, a signal, a sanitizer) is a fault.
void take(std::span<const std::uint8_t> input);

/// Valid inputs, made by the current program.
[[nodiscard]] std::vector<Input> seeds();

/// Contents of the files with one of these endings in a folder of the project and its subfolders.
[[nodiscard]] std::vector<Input> files_of(const std::string& folder, const std::vector<std::string>& endings);

/// A message in the format of an input that contains several: two bytes for the harness, the length of the message
/// (16 bits, low byte first), the message.
[[nodiscard]] inline Input message(std::uint8_t first, std::uint8_t second, std::span<const std::uint8_t> bytes) {
  Input out = {first, second, static_cast<std::uint8_t>(bytes.size() & 0xFFU),
               static_cast<std::uint8_t>(bytes.size() >> 8U)};
  out.insert(out.end(), bytes.begin(), bytes.end());
  return out;
}

[[nodiscard]] inline std::string_view text_of(std::span<const std::uint8_t> input) {
  return {reinterpret_cast<const char*>(input.data()), input.size()};
}

}  // namespace scree::fuzz
