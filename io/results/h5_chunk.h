// A chunk as the filters of HDF5 would make it (shuffle, deflate), by libdeflate: the same format in 0.4 of the time.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct libdeflate_compressor;

namespace scree::io::h5 {

/// What H5Dwrite_chunk() is told of a chunk without filters: both are left out.
inline constexpr std::uint32_t kFilters = 0b11;

/// Packs chunks one after the other. What is read back is undone by HDF5's own filters.
class ChunkPacker {
 public:
  struct Packed {
    std::span<const unsigned char> bytes;  // until the next call
    std::uint32_t skipped = 0;             // filters that were left out, as H5Dwrite_chunk() takes them
  };

  /// @throws std::bad_alloc, as all of it
  ChunkPacker();
  /// Groups the first bytes of all numbers, then the second ones, and so on, and deflates them; what does not become
  /// smaller so stays as it is. Never is there a chunk of the full length with any filter but none: HDF5 1.10 does not
  /// store which filters were left out where a chunk is replaced by one of its length.
  /// @param bytes   the whole chunk   @param number  bytes of a number
  [[nodiscard]] Packed pack(std::span<const unsigned char> bytes, std::size_t number);

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const;
  };
  std::unique_ptr<libdeflate_compressor, Free> compressor_;
  std::vector<unsigned char> grouped_, deflated_;
};

}  // namespace scree::io::h5
