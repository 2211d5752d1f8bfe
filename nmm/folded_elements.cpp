#include "nmm/folded_elements.h"

#include <algorithm>

namespace scree::nmm {

void FoldedElements::make(std::int32_t covers, std::span<const std::array<std::int32_t, 3>> elements,
                          std::span<const Tie> ties) {
  ties_.assign(ties.begin(), ties.end());
  std::vector<std::int32_t> tie_of(static_cast<std::size_t>(covers), -1);
  for (std::size_t t = 0; t < ties_.size(); ++t)
    tie_of[static_cast<std::size_t>(ties_[t].cover)] = static_cast<std::int32_t>(t);
  free_of_.assign(static_cast<std::size_t>(covers), -1);
  cover_of_.clear();
  for (std::int32_t c = 0; c < covers; ++c) {
    if (tie_of[static_cast<std::size_t>(c)] >= 0) continue;
    free_of_[static_cast<std::size_t>(c)] = free_covers();
    cover_of_.push_back(c);
  }

  start_.assign(1, 0);
  place_.clear();
  weight_start_.clear();
  weight_.clear();
  for (const auto& cover : elements) {
    const std::size_t first = place_.size();
    std::array<std::array<double, 9>, 3> C{};
    bool folded = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto add = [&](std::int32_t root, double w) {
        const std::int32_t free = free_of_[static_cast<std::size_t>(root)];
        const auto at = std::find(place_.begin() + static_cast<std::ptrdiff_t>(first), place_.end(), free);
        C[k][static_cast<std::size_t>(at - place_.begin()) - first] += w;
        if (at == place_.end()) place_.push_back(free);
      };
      if (const std::int32_t t = tie_of[static_cast<std::size_t>(cover[k])]; t >= 0) {
        folded = true;
        const Tie& tie = ties_[static_cast<std::size_t>(t)];
        for (std::size_t m = 0; m < 3; ++m) add(tie.root[m], tie.w[m]);
      } else {
        add(cover[k], 1.0);
      }
    }
    weight_start_.push_back(folded ? static_cast<std::int32_t>(weight_.size()) : -1);
    if (folded)
      for (std::size_t j = 0; j < place_.size() - first; ++j)
        for (std::size_t k = 0; k < 3; ++k) weight_.push_back(C[k][j]);
    start_.push_back(static_cast<std::int32_t>(place_.size()));
  }
}

Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 9> FoldedElements::chart(std::size_t e) const {
  return Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>>(weight_.data() + weight_start_[e], 3,
                                                                    start_[e + 1] - start_[e]);
}

void FoldedElements::fold(std::size_t e, const Mat3& M, std::span<double> lower) const {
  std::size_t at = 0;
  if (weight_start_[e] < 0) {
    for (int j = 0; j < 3; ++j)
      for (int i = j; i < 3; ++i) lower[at++] = M(i, j);
    return;
  }
  const auto C = chart(e);
  for (Eigen::Index j = 0; j < C.cols(); ++j) {
    const Eigen::Vector3d Mc = M * C.col(j);
    for (Eigen::Index i = j; i < C.cols(); ++i) lower[at++] = C.col(i).dot(Mc);
  }
}

void FoldedElements::fold(std::size_t e, const Mat6& K, std::span<double> lower) const {
  std::size_t at = 0;
  if (weight_start_[e] < 0) {
    for (int j = 0; j < 6; ++j)
      for (int i = j; i < 6; ++i) lower[at++] = K(i, j);
    return;
  }
  const auto C = chart(e);
  for (Eigen::Index j = 0; j < 2 * C.cols(); ++j) {
    Eigen::Matrix<double, 6, 1> Kc = Eigen::Matrix<double, 6, 1>::Zero();
    for (int k = 0; k < 3; ++k) Kc += C(k, j / 2) * K.col(2 * k + static_cast<int>(j % 2));
    for (Eigen::Index i = j; i < 2 * C.cols(); ++i) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) sum += C(k, i / 2) * Kc[2 * k + static_cast<int>(i % 2)];
      lower[at++] = sum;
    }
  }
}

void FoldedElements::fold_force(std::size_t e, const Eigen::Matrix<double, 6, 1>& f, std::span<double> free) const {
  const auto at = places(e);
  if (weight_start_[e] < 0) {
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 2; ++d)
        free[2 * static_cast<std::size_t>(at[k]) + d] += f[static_cast<Eigen::Index>(2 * k + d)];
    return;
  }
  const auto C = chart(e);
  for (std::size_t j = 0; j < at.size(); ++j)
    for (std::size_t d = 0; d < 2; ++d) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) sum += C(k, static_cast<Eigen::Index>(j)) * f[2 * k + static_cast<int>(d)];
      free[2 * static_cast<std::size_t>(at[j]) + d] += sum;
    }
}

}  // namespace scree::nmm
