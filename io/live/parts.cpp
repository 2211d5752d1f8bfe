#include "io/live/parts.h"

#include <utility>

#include "io/live/split.h"

namespace scree::io {

void send_parts(const header_v1_t& header, const Bytes& whole, const Send& send) {
  part_v1_t out{};
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

bool PartAssembly::put(part_v1_t&& part, std::size_t most) {
  if (part.total <= 0 || static_cast<std::size_t>(part.total) > most || part.chunks != chunks_for(part.total) ||
      part.chunk < 0 || part.chunk >= part.chunks || part.first != split_at(part.total, part.chunk, part.chunks) ||
      part.first + part.size != split_at(part.total, part.chunk + 1, part.chunks) || part.header.sequence < 0)
    return false;
  if (part.header.sequence < number_ || (part.header.sequence == number_ && missing_ == 0)) return true;  // is known
  if (part.header.sequence > number_ || pieces_.size() != static_cast<std::size_t>(part.chunks)) {
    number_ = part.header.sequence;
    pieces_.assign(static_cast<std::size_t>(part.chunks), {});
    missing_ = pieces_.size();
    fresh_ = false;
  }
  Bytes& piece = pieces_[static_cast<std::size_t>(part.chunk)];
  if (!piece.empty()) return true;
  piece = std::move(part.data);
  fresh_ = --missing_ == 0;
  return true;
}

std::optional<Bytes> PartAssembly::take() {
  if (!std::exchange(fresh_, false)) return std::nullopt;
  Bytes whole;
  for (const Bytes& piece : pieces_) whole.insert(whole.end(), piece.begin(), piece.end());
  pieces_.clear();
  return whole;
}

}  // namespace scree::io
