#include "io/results/h5_chunk.h"

#include <libdeflate.h>

#include <new>

namespace scree::io::h5 {

namespace {

constexpr int kLevel = 1;  // files 2 % larger than with level 4, written in three quarters of the time

}  // namespace

void ChunkPacker::Free::operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }

ChunkPacker::ChunkPacker() : compressor_(libdeflate_alloc_compressor(kLevel)) {
  if (!compressor_) throw std::bad_alloc();
}

ChunkPacker::Packed ChunkPacker::pack(std::span<const unsigned char> bytes, std::size_t number) {
  const std::size_t count = bytes.size() / number;
  grouped_.resize(bytes.size());
  for (std::size_t b = 0; b < number; ++b)
    for (std::size_t i = 0; i < count; ++i) grouped_[b * count + i] = bytes[i * number + b];
  deflated_.resize(bytes.size());
  const std::size_t size = libdeflate_zlib_compress(compressor_.get(), grouped_.data(), grouped_.size(),
                                                    deflated_.data(), deflated_.size() - 1);
  if (size == 0) return {bytes, kFilters};  // does not become smaller
  return {{deflated_.data(), size}, 0};
}

}  // namespace scree::io::h5
