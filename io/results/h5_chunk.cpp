#include "io/results/h5_chunk.h"

#include <isa-l/igzip_lib.h>

namespace scree::io::h5 {

void ChunkPacker::Free::operator()(isal_zstream* stream) const { delete stream; }

ChunkPacker::ChunkPacker() : stream_(new isal_zstream()), tables_(ISAL_DEF_LVL1_DEFAULT) {}

ChunkPacker::Packed ChunkPacker::pack(std::span<const unsigned char> bytes, std::size_t number) {
  const std::size_t count = bytes.size() / number;
  grouped_.resize(bytes.size());
  for (std::size_t b = 0; b < number; ++b)
    for (std::size_t i = 0; i < count; ++i) grouped_[b * count + i] = bytes[i * number + b];
  deflated_.resize(bytes.size());
  isal_deflate_stateless_init(stream_.get());
  stream_->level = 1;  // level 0 is as fast, and makes files a quarter larger
  stream_->level_buf = tables_.data();
  stream_->level_buf_size = static_cast<std::uint32_t>(tables_.size());
  stream_->gzip_flag = IGZIP_ZLIB;
  stream_->end_of_stream = 1;
  stream_->next_in = grouped_.data();
  stream_->avail_in = static_cast<std::uint32_t>(grouped_.size());
  stream_->next_out = deflated_.data();
  stream_->avail_out = static_cast<std::uint32_t>(deflated_.size() - 1);
  if (isal_deflate_stateless(stream_.get()) != COMP_OK) return {bytes, kFilters};  // does not become smaller
  return {{deflated_.data(), stream_->total_out}, 0};
}

}  // namespace scree::io::h5
