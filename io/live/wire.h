// Bytes of a message: sealed with a CRC when sent, and checked completely before a generated decoder reads them. The
// decoders of LCM 1.3.1 do not check the lengths inside a message fully: 2^30 elements overflow their size check, and a
// negative length of a text passes it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::io {

using Bytes = std::vector<std::uint8_t>;
inline constexpr std::size_t kMaxMessage = 60000;  // bytes; lost on loopback at 500 Hz: 60 kB none, 1 MB nearly all

/// Layout of the encoding of a type after its fingerprint, one letter per field:
///   1 2 4 8  a number of 1, 2, 4 or 8 bytes   n  a count (int32); counts are named a, b, c, ... in their order
///   s  a text                                 H  a header_v1_t
///   xa  an array: the field x (1 2 4 8 s), repeated by count a
/// Every type ends with its CRC, a 4.
template <class Message>
[[nodiscard]] std::string_view layout();

/// True when the bytes after the fingerprint are exactly a message of this layout: counts not negative, texts ended by
/// a zero byte and without one inside, no missing and no additional bytes.
[[nodiscard]] bool fits(std::string_view layout, std::span<const std::uint8_t> body);

/// True when the last four bytes are the CRC-32 of those before them.
[[nodiscard]] bool crc_holds(std::span<const std::uint8_t> bytes);
/// Writes the CRC into the last four bytes.   @pre at least four
void write_crc(Bytes& bytes);

/// Present time in microseconds since 1970.
[[nodiscard]] std::int64_t utime_now();
/// Sets the utime in the header of a sealed message that is sent again.   @pre the message has a header
void stamp(Bytes& bytes, std::int64_t utime);

/// A text for a message: cut to `most` bytes (complete UTF-8 characters), and at a zero byte.
[[nodiscard]] std::string wire_text(std::string_view text, std::size_t most = 200);

/// Encodes a message and fills in its CRC.   @pre counts match their arrays; texts have no zero bytes
template <class Message>
[[nodiscard]] Bytes seal(const Message& message) {
  Bytes bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  write_crc(bytes);
  return bytes;
}

/// Decodes a message; empty when its size, CRC, fingerprint or any length inside is wrong.
template <class Message>
[[nodiscard]] std::optional<Message> unseal(std::span<const std::uint8_t> bytes, std::size_t most = kMaxMessage) {
  if (bytes.size() > most || bytes.size() < 12 || !crc_holds(bytes) || !fits(layout<Message>(), bytes.subspan(8)))
    return std::nullopt;
  Message message;
  const int size = static_cast<int>(bytes.size());
  if (message.decode(bytes.data(), 0, size) != size) return std::nullopt;  // here: a wrong fingerprint
  return message;
}

}  // namespace scree::io
