#include "nmm/cover_chart.h"

#include <algorithm>

namespace scree::nmm {

void CoverChart::add(const CoverMesh& mesh, std::int32_t first) {
  tie_of_.resize(static_cast<std::size_t>(first) + mesh.star.size(), -1);
  for (Tie t : mesh.ties) {
    t.cover += first;
    for (std::int32_t& r : t.root) r += first;
    tie_of_[static_cast<std::size_t>(t.cover)] = static_cast<std::int32_t>(ties_.size());
    ties_.push_back(t);
  }
}

void CoverChart::finish() {
  const auto covers = static_cast<std::int32_t>(tie_of_.size());
  share_.reserve(tie_of_.size() + 2 * ties_.size());
  for (std::int32_t c = 0; c < covers; ++c) {
    if (const std::int32_t t = tie_of_[static_cast<std::size_t>(c)]; t >= 0) {
      const Tie& tie = ties_[static_cast<std::size_t>(t)];
      for (std::size_t k = 0; k < 3; ++k) share_.push_back({tie.root[k], tie.w[k]});
    } else {
      share_.push_back({c, 1.0});
    }
    share_start_.push_back(static_cast<std::int32_t>(share_.size()));
  }
  std::vector<std::pair<std::int32_t, Share>> follows;
  for (const Tie& t : ties_)
    for (std::size_t k = 0; k < 3; ++k) follows.push_back({t.root[k], {t.cover, t.w[k]}});
  std::stable_sort(follows.begin(), follows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [root, follower] : follows) {
    if (root_.empty() || root_.back() != root) {
      root_.push_back(root);
      root_start_.push_back(static_cast<std::int32_t>(follower_.size()));
    }
    follower_.push_back(follower);
  }
  root_start_.push_back(static_cast<std::int32_t>(follower_.size()));
}

void CoverChart::fold(const Row& row, std::vector<Share>& folded) const {
  folded.clear();
  for (std::size_t k = 0; k < 3; ++k)
    for (const Share& s : shares(row.node[k])) {
      const auto at =
          std::find_if(folded.begin(), folded.end(), [&](const Share& other) { return other.cover == s.cover; });
      if (at == folded.end())
        folded.push_back({s.cover, row.w[k] * s.w});
      else
        at->w += row.w[k] * s.w;
    }
}

void CoverChart::fold_forces(std::span<double> f) const {
  for (const Tie& t : ties_)
    for (std::size_t d = 0; d < 2; ++d) {
      double& tied = f[2 * static_cast<std::size_t>(t.cover) + d];
      for (std::size_t k = 0; k < 3; ++k) f[2 * static_cast<std::size_t>(t.root[k]) + d] += t.w[k] * tied;
      tied = 0.0;
    }
}

}  // namespace scree::nmm
