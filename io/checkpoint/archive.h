// Values as bytes and back: visitors for State::visit() and its like. Native byte order, every bit kept.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "model/geometry.h"

namespace scree::io {

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Appends what it is shown to a string.
class Packer {
 public:
  explicit Packer(std::string& out) : out_(&out) {}

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
  void bytes(const void* data, std::size_t size) { out_->append(static_cast<const char*>(data), size); }
  void count(std::uint64_t n) { bytes(&n, sizeof n); }

  std::string* out_;
};

/// The bytes end before the values do, or the other way round.
struct ArchiveError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Fills what it is shown from the bytes that a Packer made of its like.   @throws ArchiveError
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
  /// A number of items that take at least `least` bytes each: never more than can follow.
  [[nodiscard]] std::size_t count(const char* name, std::size_t least);

  std::string_view in_;
};

}  // namespace scree::io
