// Sends a large block of bytes as messages of one type, each with a range of the bytes.
#pragma once

#include "io/live/encode.h"
#include "io/live/split.h"

namespace scree::io {

/// @tparam Message  topo_v1_t or part_v1_t: header, chunk of chunks, total, first, size, data
template <class Message>
void send_pieces(const header_v1_t& header, const Bytes& whole, const Send& send) {
  Message out{};
  out.header = header;
  out.total = static_cast<std::int32_t>(whole.size());
  out.chunks = chunks_for(out.total);
  for (out.chunk = 0; out.chunk < out.chunks; ++out.chunk) {
    out.first = split_at(out.total, out.chunk, out.chunks);
    const std::int32_t last = split_at(out.total, out.chunk + 1, out.chunks);
    out.size = last - out.first;
    out.data.assign(whole.begin() + out.first, whole.begin() + last);
    send(seal(out));
  }
}

}  // namespace scree::io
