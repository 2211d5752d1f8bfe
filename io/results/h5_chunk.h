// Packs chunks with ISA-L as the filters of HDF5 (shuffle, deflate) would: the same format in a tenth of the time.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

struct isal_zstream;

namespace scree::io::h5 {

/// Filter mask for H5Dwrite_chunk() of a chunk without filters: both are left out.
inline constexpr std::uint32_t kFilters = 0b11;

/// Packs chunks one after the other. On reading, HDF5's own filters unpack them.
class ChunkPacker {
 public:
  struct Packed {
    std::span<const unsigned char> bytes;  // valid until the next call
    std::uint32_t skipped = 0;             // filters that were left out, as H5Dwrite_chunk() takes them
  };

  /// @throws std::bad_alloc, as every member
  ChunkPacker();
  /// Groups the first bytes of all numbers, then the second ones, and so on, and deflates them; a chunk that does not
  /// become smaller stays unpacked. A chunk of the full length never has a filter: HDF5 1.10 does not store which
  /// filters were left out where a chunk is replaced by one of the same length.
  /// @param bytes   the whole chunk   @param number  bytes of a number
  [[nodiscard]] Packed pack(std::span<const unsigned char> bytes, std::size_t number);

 private:
  struct Free {
    void operator()(isal_zstream* stream) const;
  };
  std::unique_ptr<isal_zstream, Free> stream_;
  std::vector<unsigned char> tables_, grouped_, deflated_;
};

}  // namespace scree::io::h5
