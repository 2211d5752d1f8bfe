#include "io/live/parts.h"

#include <utility>

#include "io/live/split.h"

namespace scree::io {

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
