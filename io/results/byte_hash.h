// Hash of a sequence of bytes, independent of how it is split into calls: detects damage, not manipulation.
#pragma once

#include <cstddef>
#include <cstdint>

namespace scree::io {

/// FNV-1a, 64 bits.
class ByteHash {
 public:
  ByteHash() = default;
  /// Continues from an earlier value().
  explicit ByteHash(std::uint64_t value) : value_(value) {}
  void add(const void* data, std::size_t bytes) {
    const auto* at = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) value_ = (value_ ^ at[i]) * 0x100000001B3ULL;
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325ULL;
};

}  // namespace scree::io
