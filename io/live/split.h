// Division of large data into messages; sender and receiver use the same rule, so a receiver can compute every range.
#pragma once

#include <algorithm>
#include <cstdint>

namespace scree::io {

inline constexpr std::int64_t kChunkPayload = 56000;  // bytes; the rest of a message stays far below kMaxMessage

inline constexpr std::int32_t kMonitorsPerMessage = 256;  // 40 kB with names of at most 100 bytes

/// Number of chunks for this number of bytes, at least one.
[[nodiscard]] constexpr std::int32_t chunks_for(std::int64_t bytes) {
  return static_cast<std::int32_t>(std::max<std::int64_t>(1, (bytes + kChunkPayload - 1) / kChunkPayload));
}

/// Number of chunks of a frame.
[[nodiscard]] constexpr std::int32_t frame_chunks(std::int64_t maps, std::int64_t points, std::int64_t cells) {
  return chunks_for(28 * maps + 4 * points + 4 * cells);
}

/// Where chunk k of n begins in a list of `total`; split_at(total, n, n) is total.   @pre 0 <= k <= n, n > 0
[[nodiscard]] constexpr std::int32_t split_at(std::int64_t total, std::int64_t k, std::int64_t n) {
  return static_cast<std::int32_t>(total * k / n);
}

}  // namespace scree::io
