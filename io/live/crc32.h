// CRC-32 of a message, to detect damage (not manipulation).
#pragma once

#include <cstdint>
#include <span>

namespace scree::io {

/// The common CRC-32: polynomial 0x04C11DB7 reflected, start and final xor 0xFFFFFFFF; "123456789" gives 0xCBF43926.
/// @source [ISO3309]
[[nodiscard]] std::uint32_t crc32(std::span<const std::uint8_t> bytes);

}  // namespace scree::io
