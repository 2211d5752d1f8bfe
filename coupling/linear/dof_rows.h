// Scalars of a step that are linear in its unknowns: gaps, stretches, displacements of supports.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace scree::coupling {

/// change = h.d + known.
struct DofRow {
  std::span<const std::int32_t> dof;  // each once, in order
  std::span<const double> h;
  double known = 0.0;  // part of driven bodies

  [[nodiscard]] double change(std::span<const double> d) const {
    double sum = known;
    if (whole_bodies()) {  // the same sum, without looking up every unknown
      for (std::size_t b = 0; b < dof.size(); b += kBody) {
        const double *of_body = &d[static_cast<std::size_t>(dof[b])], *of_row = &h[b];
        for (std::size_t i = 0; i < kBody; ++i) sum += of_row[i] * of_body[i];
      }
      return sum;
    }
    for (std::size_t i = 0; i < dof.size(); ++i) sum += h[i] * d[static_cast<std::size_t>(dof[i])];
    return sum;
  }
  /// out += force h.
  void add_force(double force, std::span<double> out) const {
    if (whole_bodies()) {
      for (std::size_t b = 0; b < dof.size(); b += kBody) {
        double* of_body = &out[static_cast<std::size_t>(dof[b])];
        for (std::size_t i = 0; i < kBody; ++i) of_body[i] += force * h[b + i];
      }
      return;
    }
    for (std::size_t i = 0; i < dof.size(); ++i) out[static_cast<std::size_t>(dof[i])] += force * h[i];
  }

 private:
  static constexpr std::size_t kBody = 6;  // unknowns of an affine body
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
  /// Of all rows, one after another, and where each begins.
  [[nodiscard]] const std::vector<std::int32_t>& start() const { return start_; }
  [[nodiscard]] const std::vector<std::int32_t>& dof() const { return dof_; }
  [[nodiscard]] const std::vector<double>& h() const { return h_; }

  /// Begins a row; add() fills it.
  void begin_row() {
    start_.push_back(start_.back());
    known_.push_back(0.0);
  }
  void add_known(double change) { known_.back() += change; }
  void add(std::int32_t dof, double h) {
    // In order, from the end: charts name their unknowns in order.
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
    const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(h.size()), size = static_cast<std::ptrdiff_t>(dof_.size()),
                         row = start_[start_.size() - 2];
    if (size == row || dof_.back() < first) {
      for (std::size_t i = 0; i < h.size(); ++i) dof_.push_back(first + static_cast<std::int32_t>(i));
      h_.insert(h_.end(), h.begin(), h.end());
      start_.back() += static_cast<std::int32_t>(n);
    } else if (size - row >= n && dof_[dof_.size() - h.size()] == first &&
               dof_.back() == first + static_cast<std::int32_t>(n) - 1) {
      for (std::size_t i = 0; i < h.size(); ++i) h_[h_.size() - h.size() + i] += h[i];
    } else {
      for (std::size_t i = 0; i < h.size(); ++i) add(first + static_cast<std::int32_t>(i), h[i]);
    }
  }
  void add_row(const DofRow& row) {
    begin_row();
    known_.back() = row.known;
    dof_.insert(dof_.end(), row.dof.begin(), row.dof.end());
    h_.insert(h_.end(), row.h.begin(), row.h.end());
    start_.back() += static_cast<std::int32_t>(row.dof.size());
  }
  /// Row i has the numbers of another one.   @pre on the same unknowns
  void take_row(std::size_t i, const DofRow& row) {
    known_[i] = row.known;
    std::copy(row.h.begin(), row.h.end(), h_.begin() + start_[i]);
  }

 private:
  std::vector<std::int32_t> start_{0}, dof_;
  std::vector<double> h_, known_;
};

}  // namespace scree::coupling
