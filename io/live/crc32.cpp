#include "io/live/crc32.h"

#include <zlib.h>

namespace scree::io {

std::uint32_t crc32(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(::crc32_z(0, bytes.data(), bytes.size()));
}

}  // namespace scree::io
