// Conversion of values to bytes and back: visitors for State::visit() and similar functions. Native byte order, exact.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "model/geometry.h"

namespace scree::io {

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Passes on the bytes of the values that it visits, in pieces.
class Packer {
 public:
  using PassOn = std::function<void(std::string_view)>;
  explicit Packer(PassOn pass_on) : pass_on_(std::move(pass_on)) { piece_.reserve(kPiece); }
  /// Passes on the rest of the last piece.
  void flush();
  /// Number of bytes of all values visited so far.
  [[nodiscard]] std::uint64_t total() const { return total_ + piece_.size(); }

  template <Plain T>
  void operator()(const char*, const T& value) {
    bytes(&value, sizeof value);
  }
  void operator()(const char*, const std::string& text);
  template <Plain T>
  void operator()(const char*, const std::vector<T>& values) {
    count(values.size());
    bytes(values.data(), values.size() * sizeof(T));
  }
  template <Plain T, std::size_t N>
  void operator()(const char*, const std::array<T, N>& values) {
    bytes(values.data(), sizeof(T) * N);
  }
  void operator()(const char*, const Vec2& x) { bytes(x.data(), 2 * sizeof(double)); }
  void operator()(const char*, const Mat2& m) { bytes(m.data(), 4 * sizeof(double)); }
  void operator()(const char*, const Polygon& polygon);
  template <class T>
  void size(const char*, const std::vector<T>& list) {
    count(list.size());
  }

 private:
  static constexpr std::size_t kPiece = 1 << 16;  // bytes

  void bytes(const void* data, std::size_t size) {
    if (piece_.size() + size > kPiece) return long_bytes({static_cast<const char*>(data), size});
    piece_.append(static_cast<const char*>(data), size);
  }
  void long_bytes(std::string_view text);
  void count(std::uint64_t n) { bytes(&n, sizeof n); }

  PassOn pass_on_;
  std::string piece_;
  std::uint64_t total_ = 0;  // bytes passed on
};

/// The bytes end before the values, or the values before the bytes.
struct ArchiveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Fills the values that it visits from the bytes that a Packer made of the same values.   @throws ArchiveError
class Unpacker {
 public:
  explicit Unpacker(std::string_view in) : in_(in) {}

  template <Plain T>
  void operator()(const char* name, T& value) {
    bytes(name, &value, sizeof value);
  }
  void operator()(const char* name, std::string& text);
  template <Plain T>
  void operator()(const char* name, std::vector<T>& values) {
    values.resize(count(name, sizeof(T)));
    bytes(name, values.data(), values.size() * sizeof(T));
  }
  template <Plain T, std::size_t N>
  void operator()(const char* name, std::array<T, N>& values) {
    bytes(name, values.data(), sizeof(T) * N);
  }
  void operator()(const char* name, Vec2& x) { bytes(name, x.data(), 2 * sizeof(double)); }
  void operator()(const char* name, Mat2& m) { bytes(name, m.data(), 4 * sizeof(double)); }
  void operator()(const char* name, Polygon& polygon);
  template <class T>
  void size(const char* name, std::vector<T>& list) {
    list.resize(count(name, 1));
  }
  /// @throws ArchiveError where bytes are left
  void finish() const;

 private:
  void bytes(const char* name, void* data, std::size_t size);
  /// Reads a number of items of at least `least` bytes each; checks that the remaining bytes can contain them.
  [[nodiscard]] std::size_t count(const char* name, std::size_t least);

  std::string_view in_;
};

}  // namespace scree::io
