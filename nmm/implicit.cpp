#include "nmm/implicit.h"

#include <algorithm>

namespace scree::nmm {

void ImplicitBody::make(FoldedElements folded, std::vector<Mat3> masses, bool lumped, std::int32_t first,
                        std::vector<std::size_t> held) {
  folded_ = std::move(folded);
  mass_ = std::move(masses);
  lumped_ = lumped;
  first_ = first;
  held_ = std::move(held);
  value_start_.assign(1, 0);
  const auto add_values = [&](std::size_t e) {
    const auto n = static_cast<std::int32_t>(2 * folded_.places(e).size());
    value_start_.push_back(value_start_.back() + n * (n + 1) / 2);
  };
  for (std::size_t e = 0; e < folded_.size(); ++e) add_values(e);
  for (const std::size_t e : held_) add_values(e);
}

ElementDofs ImplicitBody::element_dofs() const {
  ElementDofs out;
  const auto add = [&](std::size_t e) {
    for (const std::int32_t free : folded_.places(e)) {
      out.dof.push_back(2 * free);
      out.dof.push_back(2 * free + 1);
    }
    out.start.push_back(static_cast<std::int32_t>(out.dof.size()));
  };
  for (std::size_t e = 0; e < folded_.size(); ++e) add(e);
  for (const std::size_t e : held_) add(e);
  return out;
}

void ImplicitBody::add_hold(std::size_t k, const Mat6& matrix, const Eigen::Matrix<double, 6, 1>& force_of_hold,
                            std::span<double> stiffness, std::span<double> force) const {
  const std::size_t at = folded_.size() + k;
  folded_.fold_force(held_[k], force_of_hold, force);
  if (!stiffness.empty()) folded_.fold(held_[k], matrix, stiffness.subspan(value(at), value(at + 1) - value(at)));
}

ChartRow ImplicitBody::chart_row(const Row& row) const {
  ChartRow out;
  const auto add = [&](std::int32_t free, double w) {
    if (free < 0) return;  // of the half of a divided block that does not act
    for (int i = 0; i < out.n; i += 2)
      if (out.dof[static_cast<std::size_t>(i)] == 2 * free) {
        out.tx[static_cast<std::size_t>(i)] += w;
        out.ty[static_cast<std::size_t>(i) + 1] += w;
        return;
      }
    const auto i = static_cast<std::size_t>(out.n);
    out.dof[i] = 2 * free;
    out.dof[i + 1] = 2 * free + 1;
    out.tx[i] = out.ty[i + 1] = w;
    out.tx[i + 1] = out.ty[i] = 0.0;
    out.n += 2;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (row.w[k] == 0.0) continue;
    for (const Share& s : folded_.chart().shares(row.node[k] - first_)) add(folded_.free_of(s.cover), row.w[k] * s.w);
  }
  return out;
}

void ImplicitBody::element_masses(std::span<double> mass) const {
  std::array<double, 45> scalar{};
  std::fill(mass.begin() + static_cast<std::ptrdiff_t>(value(folded_.size())), mass.end(), 0.0);
  for (std::size_t e = 0; e < folded_.size(); ++e) {
    folded_.fold(e, mass_[e], scalar);
    const std::size_t n = folded_.places(e).size();
    if (lumped_) {  // row sums
      std::array<double, 9> sum{};
      std::size_t at = 0;
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = j; i < n; ++i, ++at) {
          sum[j] += scalar[at];
          if (i != j) sum[i] += scalar[at];
        }
      at = 0;
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = j; i < n; ++i, ++at) scalar[at] = i == j ? sum[j] : 0.0;
    }
    // The scalar matrix on x and on y.
    std::size_t at = value(e);
    const auto entry = [&](std::size_t i, std::size_t j) { return scalar[j * n - j * (j + 1) / 2 + i]; };  // i >= j
    for (std::size_t j = 0; j < 2 * n; ++j)
      for (std::size_t i = j; i < 2 * n; ++i) mass[at++] = i % 2 == j % 2 ? entry(i / 2, j / 2) : 0.0;
  }
}

void ImplicitBody::rates(std::span<const double> v, std::span<double> rate) const {
  for (std::int32_t k = 0; k < folded_.free_covers(); ++k) {
    const auto i = 2 * static_cast<std::size_t>(first_ + folded_.cover_of(k));
    rate[2 * static_cast<std::size_t>(k)] = v[i];
    rate[2 * static_cast<std::size_t>(k) + 1] = v[i + 1];
  }
}

void ImplicitBody::retract(std::span<const double> d, std::span<const double> rate, std::span<double> q,
                           std::span<double> v) const {
  for (std::int32_t k = 0; k < folded_.free_covers(); ++k)
    for (std::size_t c = 0; c < 2; ++c) {
      const auto i = 2 * static_cast<std::size_t>(first_ + folded_.cover_of(k)) + c;
      q[i] += d[2 * static_cast<std::size_t>(k) + c];
      v[i] = rate[2 * static_cast<std::size_t>(k) + c];
    }
  const std::size_t first = 2 * static_cast<std::size_t>(first_);
  folded_.chart().follow(q.subspan(first));
  folded_.chart().follow(v.subspan(first));
}

}  // namespace scree::nmm
