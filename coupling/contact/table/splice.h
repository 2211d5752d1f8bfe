// Points of a list replaced by others, in place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "coupling/contact/table/contact_point.h"

namespace scree::coupling {

/// Points of a vertex that are made anew: new ones replace those of the list from `begin` to `end`.
struct Changed {
  VertexIndex vertex;
  std::int32_t begin, end;    // in the list
  std::int32_t first, count;  // of the new ones, among all new ones
};

/// Where the points of a list lie once those of some vertices have been replaced. The others keep their order, and only
/// those whose place changes are moved: those between a vertex that gains a point and one that loses one.
class Splice {
 public:
  void reserve(std::size_t vertices) {
    changed_.reserve(vertices);
    shift_.reserve(vertices + 1);
  }
  /// Nothing is replaced in a list of so many points.
  void begin(std::size_t size) {
    size_ = static_cast<std::ptrdiff_t>(size);
    changed_.clear();
    shift_.assign(1, 0);
  }
  /// @pre in the order of the points
  void replace(const Changed& c) {
    changed_.push_back(c);
    shift_.push_back(shift_.back() + c.count - (c.end - c.begin));
  }
  [[nodiscard]] const std::vector<Changed>& changed() const { return changed_; }
  [[nodiscard]] bool empty() const { return changed_.empty(); }
  /// Number of points of the list, before and after.
  [[nodiscard]] std::size_t size_before() const { return static_cast<std::size_t>(size_); }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(size_ + shift_.back()); }
  /// Moves what is stored of each point; that of new points is not set.
  template <class T>
  void move(std::vector<T>& of_point) const {
    of_point.resize(std::max(size_before(), size()));
    // Points move to the right first, the last of them before those whose place it takes, then to the left.
    for (std::size_t c = shift_.size(); c-- > 0;)
      if (shift_[c] > 0)
        std::move_backward(at(of_point, begin_of(c)), at(of_point, end_of(c)), at(of_point, end_of(c) + shift_[c]));
    for (std::size_t c = 0; c < shift_.size(); ++c)
      if (shift_[c] < 0)
        std::move(at(of_point, begin_of(c)), at(of_point, end_of(c)), at(of_point, begin_of(c) + shift_[c]));
    of_point.resize(size());
  }
  /// see(place, shift) for the points that have moved: their new place, and by how much that changed.
  template <class See>
  void for_moved(See&& see) const {
    for (std::size_t c = 0; c < shift_.size(); ++c)
      for (std::ptrdiff_t i = begin_of(c); i < end_of(c) && shift_[c] != 0; ++i)
        see(static_cast<std::size_t>(i + shift_[c]), static_cast<std::int32_t>(shift_[c]));
  }
  /// see(place, k) for the new points, in order: place in the list, and k among all new ones.
  template <class See>
  void for_new(See&& see) const {
    for (std::size_t c = 0; c < changed_.size(); ++c)
      for (std::int32_t k = 0; k < changed_[c].count; ++k)
        see(static_cast<std::size_t>(changed_[c].begin + shift_[c] + k),
            static_cast<std::size_t>(changed_[c].first + k));
  }
  /// By how much the points of later vertices move, up to those of the next changed one.
  [[nodiscard]] std::int32_t shift_after(std::size_t c) const { return static_cast<std::int32_t>(shift_[c + 1]); }

 private:
  template <class T>
  static auto at(std::vector<T>& of_point, std::ptrdiff_t i) {
    return of_point.begin() + i;
  }
  /// The points before changed vertex c that stay, in their old places.
  [[nodiscard]] std::ptrdiff_t begin_of(std::size_t c) const { return c == 0 ? 0 : changed_[c - 1].end; }
  [[nodiscard]] std::ptrdiff_t end_of(std::size_t c) const { return c < changed_.size() ? changed_[c].begin : size_; }

  std::ptrdiff_t size_ = 0;
  std::vector<Changed> changed_;
  std::vector<std::ptrdiff_t> shift_{0};  // of the points before changed vertex c
};

}  // namespace scree::coupling
