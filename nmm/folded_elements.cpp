#include "nmm/folded_elements.h"

#include <algorithm>

namespace scree::nmm {

void FoldedElements::make(const CoverMesh& mesh) {
  const auto covers = static_cast<std::int32_t>(mesh.star.size());
  chart_ = CoverChart();
  chart_.add(mesh, 0);
  chart_.finish();
  free_of_.assign(mesh.star.size(), -1);
  cover_of_.clear();
  std::vector<char> used(mesh.star.size(), 0);  // not those of the other half of a divided block
  for (const auto& cover : mesh.cover)
    for (const std::int32_t c : cover)
      for (const Share& s : chart_.shares(c)) used[static_cast<std::size_t>(s.cover)] = 1;
  for (std::int32_t c = 0; c < covers; ++c) {
    if (used[static_cast<std::size_t>(c)] == 0) continue;
    free_of_[static_cast<std::size_t>(c)] = free_covers();
    cover_of_.push_back(c);
  }

  start_.assign(1, 0);
  place_.clear();
  weight_start_.clear();
  weight_.clear();
  for (const auto& cover : mesh.cover) {
    const std::size_t first = place_.size();
    std::array<std::array<double, 9>, 3> C{};
    bool folded = false;
    for (std::size_t k = 0; k < 3; ++k) {
      folded = folded || chart_.tied(cover[k]);
      for (const Share& s : chart_.shares(cover[k])) {
        const std::int32_t free = free_of_[static_cast<std::size_t>(s.cover)];
        const auto at = std::find(place_.begin() + static_cast<std::ptrdiff_t>(first), place_.end(), free);
        C[k][static_cast<std::size_t>(at - place_.begin()) - first] += s.w;
        if (at == place_.end()) place_.push_back(free);
      }
    }
    weight_start_.push_back(folded ? static_cast<std::int32_t>(weight_.size()) : -1);
    if (folded)
      for (std::size_t j = 0; j < place_.size() - first; ++j)
        for (std::size_t k = 0; k < 3; ++k) weight_.push_back(C[k][j]);
    start_.push_back(static_cast<std::int32_t>(place_.size()));
  }
}

Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 9> FoldedElements::element_chart(std::size_t e) const {
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
  const auto C = element_chart(e);
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
  const auto C = element_chart(e);
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
  const auto C = element_chart(e);
  for (std::size_t j = 0; j < at.size(); ++j)
    for (std::size_t d = 0; d < 2; ++d) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k) sum += C(k, static_cast<Eigen::Index>(j)) * f[2 * k + static_cast<int>(d)];
      free[2 * static_cast<std::size_t>(at[j]) + d] += sum;
    }
}

}  // namespace scree::nmm
