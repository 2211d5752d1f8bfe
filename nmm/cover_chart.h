// Free covers and tied ones: q = C q_free.
#pragma once

#include <span>
#include <vector>

#include "nmm/cover_mesh.h"

namespace scree::nmm {

/// One term of a sum over free covers.
struct Share {
  std::int32_t cover;
  double w;
};

/// The ties of all blocks of a pool. Tied covers follow three roots; forces on them go to the roots.
class CoverChart {
 public:
  /// Appends the covers of a mesh.   @param first  its first cover in the pool
  void add(const CoverMesh& mesh, std::int32_t first);
  /// Called once after the last mesh.
  void finish();

  [[nodiscard]] bool tied(std::int32_t cover) const { return tie_of_[static_cast<std::size_t>(cover)] >= 0; }
  /// The free covers that a cover stands for: itself, or its three roots.
  [[nodiscard]] std::span<const Share> shares(std::int32_t cover) const {
    const auto c = static_cast<std::size_t>(cover);
    return std::span(share_).subspan(static_cast<std::size_t>(share_start_[c]),
                                     static_cast<std::size_t>(share_start_[c + 1] - share_start_[c]));
  }
  /// Weights on free covers that a row stands for, each cover once.
  void fold(const Row& row, std::vector<Share>& folded) const;
  /// Adds to every root what its tied covers hold, each by its weight times `scale` (a number a cover).
  void gather(std::span<const double> f, std::span<const double> scale, std::span<double> a) const;
  /// Tied covers take the sum of their roots.
  void follow(std::span<double> v) const;
  [[nodiscard]] std::span<const Tie> ties() const { return ties_; }

 private:
  std::vector<Tie> ties_;  // covers counted in the pool
  std::vector<std::int32_t> tie_of_, share_start_{0};
  std::vector<Share> share_;
  std::vector<std::int32_t> root_, root_start_;  // covers that others follow, and who follows them
  std::vector<Share> follower_;
};

}  // namespace scree::nmm
