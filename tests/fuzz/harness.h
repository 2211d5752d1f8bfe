// What every harness of this folder gives: one input after another, and inputs to begin with. replay.cpp and libFuzzer
// (preset fuzz) drive them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace scree::fuzz {

using Input = std::vector<std::uint8_t>;

/// Gives an input to what is tried. Returns where it was read or refused as its interface says; anything else (another
/// exception, a signal, a sanitizer) is a fault.
void take(std::span<const std::uint8_t> input);

/// Sound inputs, made by the program of today.
[[nodiscard]] std::vector<Input> seeds();

/// Files of a folder of the project and those below it, with one of these endings.
[[nodiscard]] std::vector<Input> files_of(const std::string& folder, const std::vector<std::string>& endings);

/// A message as it stands in an input of several: two bytes for the harness, its length (16 bits, low byte first),
/// itself.
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
