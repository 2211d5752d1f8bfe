#include "io/live/crc32.h"

#include <array>

namespace scree::io {
namespace {

constexpr auto kTable = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    std::uint32_t rest = i;
    for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1U) ^ ((rest & 1U) != 0U ? 0xEDB88320U : 0U);
    table[i] = rest;
  }
  return table;
}();

}  // namespace

std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  std::uint32_t rest = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) rest = (rest >> 8U) ^ kTable[(rest ^ byte) & 0xFFU];
  return ~rest;
}

}  // namespace scree::io
