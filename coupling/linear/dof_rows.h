// Scalars of a step that are linear in its unknowns: gaps, stretches, displacements of supports.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include "coupling/linear/small_block.h"

namespace scree::coupling {

/// change = h.d + known.
struct DofRow {
  std::span<const std::int32_t> dof;  // each once, in order
  std::span<const double> h;
  double known = 0.0;  // part of driven bodies

  [[nodiscard]] double change(std::span<const double> d) const {
    if (whole_bodies()) {  // without looking up every unknown
      DoubleColumn products;
      for (std::size_t b = 0; b < dof.size(); b += kBody)
        products.add_products(DoubleColumn(&h[b]), DoubleColumn(&d[static_cast<std::size_t>(dof[b])]));
      return known + products.sum();
    }
    double sum = known;
    for (std::size_t i = 0; i < dof.size(); ++i) sum += h[i] * d[static_cast<std::size_t>(dof[i])];
    return sum;
  }
  /// out += force h.
  void add_force(double force, std::span<double> out) const {
    if (whole_bodies()) {
      for (std::size_t b = 0; b < dof.size(); b += kBody) {
        double* of_body = &out[static_cast<std::size_t>(dof[b])];
        DoubleColumn sum(of_body);
        sum.add(force, DoubleColumn(&h[b]));
        sum.store(of_body);
      }
      return;
    }
    for (std::size_t i = 0; i < dof.size(); ++i) out[static_cast<std::size_t>(dof[i])] += force * h[i];
  }

 private:
  static constexpr std::size_t kBody = kBlockSide;
  /// True if the unknowns are one or two runs of six.
  [[nodiscard]] bool whole_bodies() const {
    const std::size_t n = dof.size();
    if (n != kBody && n != 2 * kBody) return false;
    constexpr std::int32_t kToLast = kBody - 1;
    return dof[kBody - 1] == dof[0] + kToLast && dof[n - 1] == dof[n - kBody] + kToLast;
  }
};

/// Many rows, one after another in contiguous arrays.
class DofRows {
 public:
  void clear() {
    start_.assign(1, 0);
    dof_.clear();
    h_.clear();
    known_.clear();
  }
  [[nodiscard]] std::size_t size() const { return known_.size(); }
  [[nodiscard]] DofRow operator[](std::size_t i) const {
    const auto first = static_cast<std::size_t>(start_[i]), n = static_cast<std::size_t>(start_[i + 1]) - first;
    return {std::span(dof_).subspan(first, n), std::span(h_).subspan(first, n), known_[i]};
  }
  /// Starts, unknowns, coefficients and known parts of all rows, one after another.
  [[nodiscard]] std::span<const std::int32_t> start() const { return start_; }
  [[nodiscard]] std::span<const std::int32_t> dof() const { return dof_; }
  [[nodiscard]] std::span<const double> h() const { return h_; }
  [[nodiscard]] std::span<const double> known() const { return known_; }

  /// Appends a row of sizes[i] unknowns for each i, whose numbers have no meaning before they are set; fill() gives
  /// their places, in any order.
  void extend(std::span<const std::int32_t> sizes) {
    const std::size_t rows = size() + sizes.size();
    grow(start_, rows + 1);
    for (const std::int32_t n : sizes) start_.push_back(start_.back() + n);
    const auto numbers = static_cast<std::size_t>(start_.back());
    grow(dof_, numbers);
    grow(h_, numbers);
    grow(known_, rows);
    dof_.resize(numbers);
    h_.resize(numbers);
    known_.resize(rows);
  }
  /// Places of the numbers of a row that extend() has made: unknowns in order, each once.
  struct Filled {
    std::span<std::int32_t> dof;
    std::span<double> h;
    double* known;
  };
  [[nodiscard]] Filled fill(std::size_t i) {
    const auto first = static_cast<std::size_t>(start_[i]), n = static_cast<std::size_t>(start_[i + 1]) - first;
    return {std::span(dof_).subspan(first, n), std::span(h_).subspan(first, n), &known_[i]};
  }

  /// Begins a row; add() fills it.
  void begin_row() {
    start_.push_back(start_.back());
    known_.push_back(0.0);
  }
  void add_known(double change) { known_.back() += change; }
  void add(std::int32_t dof, double h) {
    // In order, from the end: charts list their unknowns in order.
    auto at = dof_.size();
    const auto first = static_cast<std::size_t>(start_[start_.size() - 2]);
    while (at > first && dof_[at - 1] > dof) --at;
    if (at > first && dof_[at - 1] == dof) {
      h_[at - 1] += h;
      return;
    }
    dof_.insert(dof_.begin() + static_cast<std::ptrdiff_t>(at), dof);
    h_.insert(h_.begin() + static_cast<std::ptrdiff_t>(at), h);
    ++start_.back();
  }
  /// add() of unknowns that follow each other.   @param first  the first of them   @param h  as many numbers
  void add_run(std::int32_t first, std::span<const double> h) {
    const auto row = static_cast<std::size_t>(start_[start_.size() - 2]);
    const std::size_t n = h.size();
    const std::int32_t end = first + static_cast<std::int32_t>(n);
    auto at = dof_.size();
    while (at > row && dof_[at - 1] >= first) --at;
    if (at == dof_.size() || dof_[at] >= end) {
      const auto place = static_cast<std::ptrdiff_t>(at);
      dof_.insert(dof_.begin() + place, n, first);
      for (std::size_t i = 1; i < n; ++i) dof_[at + i] += static_cast<std::int32_t>(i);
      h_.insert(h_.begin() + place, h.begin(), h.end());
      start_.back() += static_cast<std::int32_t>(n);
    } else if (dof_[at] == first && dof_.size() - at >= n && dof_[at + n - 1] == end - 1) {
      for (std::size_t i = 0; i < n; ++i) h_[at + i] += h[i];
    } else {
      for (std::size_t i = 0; i < n; ++i) add(first + static_cast<std::int32_t>(i), h[i]);
    }
  }
  void add_row(const DofRow& row) {
    begin_row();
    known_.back() = row.known;
    dof_.insert(dof_.end(), row.dof.begin(), row.dof.end());
    h_.insert(h_.end(), row.h.begin(), row.h.end());
    start_.back() += static_cast<std::int32_t>(row.dof.size());
  }
  /// Gives row i the numbers of another row.   @pre on the same unknowns
  void take_row(std::size_t i, const DofRow& row) {
    known_[i] = row.known;
    std::copy(row.h.begin(), row.h.end(), h_.begin() + start_[i]);
  }

 private:
  /// Allocator of arrays whose resize() leaves new numbers without a value: extend() would write all of them twice.
  template <class Number>
  struct Raw : std::allocator<Number> {
    template <class Other>
    void construct(Other* at) {
      ::new (static_cast<void*>(at)) Other;
    }
    template <class Other, class... From>
    void construct(Other* at, From&&... from) {
      ::new (static_cast<void*>(at)) Other(std::forward<From>(from)...);
    }
  };
  template <class Number>
  using Numbers = std::vector<Number, Raw<Number>>;

  /// Reserves room for `size` numbers and a sixteenth more: resize() alone may double the capacity.
  template <class Vector>
  static void grow(Vector& v, std::size_t size) {
    constexpr std::size_t kMore = 16;
    if (size > v.capacity()) v.reserve(size + size / kMore);
  }
  std::vector<std::int32_t> start_{0};
  Numbers<std::int32_t> dof_;
  Numbers<double> h_, known_;
};

}  // namespace scree::coupling
