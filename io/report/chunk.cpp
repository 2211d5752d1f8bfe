#include "io/report/chunk.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/check.h"

namespace scree::io {
namespace {

constexpr std::size_t kNameBytes = 16;

void put(std::vector<std::uint8_t>& out, std::uint32_t value) {
  for (int byte = 0; byte < 4; ++byte) out.push_back(static_cast<std::uint8_t>(value >> (8 * byte)));
}

std::vector<std::uint8_t> compressed(const std::vector<std::uint8_t>& bytes, int level) {
  uLongf size = compressBound(bytes.size());
  std::vector<std::uint8_t> out(size);
  if (compress2(out.data(), &size, bytes.data(), bytes.size(), level) != Z_OK)
    throw std::runtime_error("cannot compress an array of a page: out of memory");
  out.resize(size);
  return out;
}

}  // namespace

template <class T>
void Chunk::append(std::string_view name, std::uint32_t type, std::span<const T> values) {
  SCREE_ASSERT(!name.empty() && name.size() < kNameBytes);
  Array array{std::string(name), type, static_cast<std::uint32_t>(values.size()), {}};
  array.planes.resize(values.size_bytes());
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint32_t bits = 0;
    if constexpr (sizeof(T) == 1)
      bits = static_cast<std::uint32_t>(values[i]);
    else
      bits = std::bit_cast<std::uint32_t>(values[i]);
    for (std::size_t byte = 0; byte < sizeof(T); ++byte)
      array.planes[byte * values.size() + i] = static_cast<std::uint8_t>(bits >> (8 * byte));
  }
  arrays_.push_back(std::move(array));
}

void Chunk::add(std::string_view name, std::span<const float> values) { append(name, 0, values); }
void Chunk::add(std::string_view name, std::span<const std::int32_t> values) { append(name, 1, values); }
void Chunk::add(std::string_view name, std::span<const std::uint8_t> values) { append(name, 2, values); }

std::vector<std::uint8_t> Chunk::bytes() const {
  std::vector<std::uint8_t> out;
  put(out, static_cast<std::uint32_t>(arrays_.size()));
  for (const Array& array : arrays_) {
    out.insert(out.end(), array.name.begin(), array.name.end());
    out.insert(out.end(), kNameBytes - array.name.size(), 0);
    put(out, array.type), put(out, array.length);
  }
  for (const Array& array : arrays_) out.insert(out.end(), array.planes.begin(), array.planes.end());
  return out;
}

std::vector<std::uint8_t> Chunk::packed(int level) const { return compressed(bytes(), level); }
std::string Chunk::text() const { return base64(packed(Z_BEST_COMPRESSION)); }

float rounded(double value, int bits) {
  const auto number = static_cast<float>(value);
  if (!std::isfinite(number)) return number;
  const std::uint32_t dropped = 23U - static_cast<std::uint32_t>(bits);
  if (dropped == 0) return number;
  const std::uint32_t half = 1U << (dropped - 1U);
  const float near = std::bit_cast<float>((std::bit_cast<std::uint32_t>(number) + half) & ~((1U << dropped) - 1U));
  return std::isfinite(near) ? near : number;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = word << 8U | (k < here ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out.push_back(k <= here ? kDigits[word >> (18U - 6U * static_cast<unsigned>(k)) & 63U] : '=');
  }
  return out;
}

}  // namespace scree::io
