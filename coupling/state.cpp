#include "coupling/state.h"

#include <array>
#include <cstring>
#include <span>
#include <string>

namespace scree::coupling {
namespace {

/// FNV-1a over 64-bit words with a final mix; every bit of a value counts, including the sign of zero.
class Hasher {
 public:
  void bytes(const void* data, std::size_t size) {
    const auto* p = static_cast<const unsigned char*>(data);
    for (; size >= 8; p += 8, size -= 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, p, 8);
      mix(word);
    }
    std::uint64_t rest = size;
    if (size > 0) std::memcpy(&rest, p, size);
    mix(rest ^ (static_cast<std::uint64_t>(size) << 56U));
  }
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void operator()(const char*, const T& value) { bytes(&value, sizeof value); }
  void operator()(const char*, const std::string& text) { bytes(text.data(), text.size()); }
  template <class T>
  void operator()(const char*, const std::vector<T>& values) {
    mix(values.size());
    bytes(values.data(), values.size() * sizeof(T));
  }
  template <class T, std::size_t N>
  void operator()(const char*, const std::array<T, N>& values) {
    bytes(values.data(), sizeof(T) * N);
  }
  void operator()(const char*, const Vec2& x) { bytes(x.data(), 2 * sizeof(double)); }
  void operator()(const char*, const Mat2& m) { bytes(m.data(), 4 * sizeof(double)); }
  void operator()(const char* name, const Polygon& p) {
    mix(p.rings());
    for (std::size_t r = 0; r < p.rings(); ++r) {
      mix(p.ring(r).size());
      for (const Vec2& x : p.ring(r)) {
        (*this)(name, x.x());
        (*this)(name, x.y());
      }
    }
  }
  template <class T>
  void size(const char*, const std::vector<T>& list) {
    mix(list.size());
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  void mix(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x9E3779B97F4A7C15ULL;
    hash_ ^= hash_ >> 29U;
  }
  std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

}  // namespace

std::uint64_t state_hash(const State& state) {
  Hasher hasher;
  state.visit(hasher);
  return hasher.value();
}

}  // namespace scree::coupling
