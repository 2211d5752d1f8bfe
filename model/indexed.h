// Arrays that accept an index of one type only, so that the number of a node cannot index an array of edges.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/ids.h"

namespace scree {

/// The index k places after another one of the same array, and before it.
template <class Tag>
[[nodiscard]] constexpr Id<Tag> operator+(Id<Tag> i, std::int32_t k) {
  return Id<Tag>{i.value + k};
}
template <class Tag>
[[nodiscard]] constexpr Id<Tag> operator-(Id<Tag> i, std::int32_t k) {
  return Id<Tag>{i.value - k};
}
/// How many places `i` comes after `first`.
template <class Tag>
[[nodiscard]] constexpr std::int32_t operator-(Id<Tag> i, Id<Tag> first) {
  return i.value - first.value;
}

/// Indices [begin, end), for loops.
template <class Index>
class IndexRange {
 public:
  struct Iterator {
    Index at;
    [[nodiscard]] Index operator*() const { return at; }
    Iterator& operator++() {
      ++at.value;
      return *this;
    }
    [[nodiscard]] bool operator==(const Iterator&) const = default;
  };
  IndexRange() = default;
  IndexRange(Index begin, Index end) : begin_(begin), end_(end) {}
  [[nodiscard]] Iterator begin() const { return {begin_}; }
  [[nodiscard]] Iterator end() const { return {end_}; }
  [[nodiscard]] Index first() const { return begin_; }
  /// One beyond the last.
  [[nodiscard]] Index end_index() const { return end_; }
  [[nodiscard]] std::int32_t size() const { return end_ - begin_; }

 private:
  Index begin_{0}, end_{0};
};

/// A span over values that belong to indices of one type, counted from 0.
template <class Index, class T>
class IndexedSpan {
 public:
  constexpr IndexedSpan() = default;
  constexpr explicit IndexedSpan(std::span<T> values) : values_(values) {}
  [[nodiscard]] constexpr T& operator[](Index i) const { return values_[i.index()]; }
  [[nodiscard]] constexpr std::size_t size() const { return values_.size(); }
  [[nodiscard]] constexpr std::span<T> values() const { return values_; }
  [[nodiscard]] constexpr auto begin() const { return values_.begin(); }
  [[nodiscard]] constexpr auto end() const { return values_.end(); }

 private:
  std::span<T> values_;
};

/// A vector whose values belong to indices of one type, counted from 0.
template <class Index, class T>
class IndexedVector {
 public:
  IndexedVector() = default;
  explicit IndexedVector(std::size_t size) : values_(size) {}
  IndexedVector(std::size_t size, const T& value) : values_(size, value) {}

  [[nodiscard]] T& operator[](Index i) { return values_[i.index()]; }
  [[nodiscard]] const T& operator[](Index i) const { return values_[i.index()]; }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] T& back() { return values_.back(); }
  [[nodiscard]] const T& back() const { return values_.back(); }
  [[nodiscard]] auto begin() { return values_.begin(); }
  [[nodiscard]] auto end() { return values_.end(); }
  [[nodiscard]] auto begin() const { return values_.begin(); }
  [[nodiscard]] auto end() const { return values_.end(); }
  /// The index of the value that the next push_back() adds, which is one beyond the last.
  [[nodiscard]] Index next() const { return Index{static_cast<std::int32_t>(values_.size())}; }
  [[nodiscard]] Index last() const { return Index{static_cast<std::int32_t>(values_.size()) - 1}; }
  [[nodiscard]] IndexRange<Index> indices() const { return {Index{0}, next()}; }
  void push_back(const T& value) { values_.push_back(value); }
  void resize(std::size_t size) { values_.resize(size); }
  void reserve(std::size_t size) { values_.reserve(size); }
  void assign(std::size_t size, const T& value) { values_.assign(size, value); }
  /// Implicit conversion, as from a vector to a span.
  // NOLINTNEXTLINE(google-explicit-constructor)
  operator IndexedSpan<Index, const T>() const { return IndexedSpan<Index, const T>(std::span<const T>(values_)); }
  /// The values alone, in the order of their indices.
  [[nodiscard]] std::vector<T>& values() { return values_; }
  [[nodiscard]] const std::vector<T>& values() const { return values_; }

 private:
  std::vector<T> values_;
};

}  // namespace scree
