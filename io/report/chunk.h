// Arrays of numbers for the page of a report: named, typed, compressed, as text that HTML can carry.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::io {

/// Bytes of a chunk before compression, little endian:
///   u32 count of arrays; for each: 16 bytes of name (ASCII, filled with zeros), u32 type, u32 length
///   then the arrays in that order, the bytes of each in planes: all first bytes of its numbers, all second bytes, ...
/// Types: 0 float32, 1 int32, 2 uint8. The page reads the same layout from a report, from `scree view` and from a
/// stream.
class Chunk {
 public:
  /// @pre the name has 1 to 15 characters and is new in this chunk
  void add(std::string_view name, std::span<const float> values);
  void add(std::string_view name, std::span<const std::int32_t> values);
  void add(std::string_view name, std::span<const std::uint8_t> values);

  [[nodiscard]] std::vector<std::uint8_t> bytes() const;
  /// bytes() compressed (zlib).   @param level  1: fastest, 9: smallest
  [[nodiscard]] std::vector<std::uint8_t> packed(int level) const;
  /// packed(9) in base64.
  [[nodiscard]] std::string text() const;

 private:
  struct Array {
    std::string name;
    std::uint32_t type = 0, length = 0;
    std::vector<std::uint8_t> planes;
  };
  template <class T>
  void append(std::string_view name, std::uint32_t type, std::span<const T> values);
  std::vector<Array> arrays_;
};

/// The nearest float with `bits` explicit bits of its mantissa, so that the rest compresses to nothing.
/// @pre 1 <= bits <= 23   @return value itself where it is not finite
[[nodiscard]] float rounded(double value, int bits);

/// @source [RFC4648] section 4
[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace scree::io
