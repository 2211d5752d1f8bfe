#include "io/checkpoint/archive.h"

#include <fmt/format.h>

namespace scree::io {

void Packer::flush() {
  if (piece_.empty()) return;
  pass_on_(piece_);
  total_ += piece_.size();
  piece_.clear();
}

void Packer::long_bytes(std::string_view text) {
  flush();
  if (text.size() > kPiece) {
    pass_on_(text);
    total_ += text.size();
  } else {
    piece_.append(text);
  }
}

void Packer::operator()(const char*, const std::string& text) {
  count(text.size());
  bytes(text.data(), text.size());
}

void Packer::operator()(const char* name, const Polygon& polygon) {
  count(polygon.rings());
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    count(polygon.ring(r).size());
    for (const Vec2& x : polygon.ring(r)) (*this)(name, x);
  }
}

void Unpacker::bytes(const char* name, void* data, std::size_t size) {
  if (size > in_.size()) throw ArchiveError(fmt::format("ends before {}", name));
  if (size > 0) std::memcpy(data, in_.data(), size);
  in_.remove_prefix(size);
}

std::size_t Unpacker::count(const char* name, std::size_t least) {
  std::uint64_t n = 0;
  bytes(name, &n, sizeof n);
  if (n > in_.size() / least) throw ArchiveError(fmt::format("ends before {}", name));
  return n;
}

void Unpacker::operator()(const char* name, std::string& text) {
  text.resize(count(name, 1));
  bytes(name, text.data(), text.size());
}

void Unpacker::operator()(const char* name, Polygon& polygon) {
  const std::size_t rings = count(name, 1);
  if (rings == 0) throw ArchiveError(fmt::format("{} has no outline", name));
  polygon.holes.resize(rings - 1);
  for (std::size_t r = 0; r < rings; ++r) {
    polygon.ring(r).resize(count(name, 2 * sizeof(double)));
    for (Vec2& x : polygon.ring(r)) (*this)(name, x);
  }
}

void Unpacker::finish() const {
  if (!in_.empty()) throw ArchiveError(fmt::format("{} bytes too many", in_.size()));
}

}  // namespace scree::io
