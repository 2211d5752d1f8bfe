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

/// The ties of all blocks of a pool. Tied covers follow three roots; forces on them are moved to the roots.
class CoverChart {
 public:
  /// Appends the covers of a mesh.   @param first  its first cover in the pool
  void add(const CoverMesh& mesh, std::int32_t first);
  /// Called once after the last mesh.
  void finish();

  [[nodiscard]] bool tied(std::int32_t cover) const { return tie_of_[static_cast<std::size_t>(cover)] >= 0; }
  /// The free covers that represent a cover: itself, or its three roots.
  [[nodiscard]] std::span<const Share> shares(std::int32_t cover) const {
    const auto c = static_cast<std::size_t>(cover);
    return std::span(share_).subspan(static_cast<std::size_t>(share_start_[c]),
                                     static_cast<std::size_t>(share_start_[c + 1] - share_start_[c]));
  }
  /// Weights on free covers equivalent to a row, each cover once.
  void fold(const Row& row, std::vector<Share>& folded) const;
  /// Covers that others follow, in their order.
  [[nodiscard]] std::span<const std::int32_t> roots() const { return root_; }
  /// Adds to a root (a place in roots()) the values of its tied covers, each times its weight and `scale`.
  void gather(std::size_t root, std::span<const double> f, double scale, std::span<double> a) const {
    const auto cover = static_cast<std::size_t>(root_[root]);
    Vec2 sum(0.0, 0.0);
    for (auto k = static_cast<std::size_t>(root_start_[root]); k < static_cast<std::size_t>(root_start_[root + 1]); ++k)
      sum += follower_[k].w * node(f, follower_[k].cover);
    a[2 * cover] += scale * sum.x();
    a[2 * cover + 1] += scale * sum.y();
  }
  /// Moves the values of tied covers to their roots.
  void fold_forces(std::span<double> f) const;
  /// Sets tied covers to the weighted sums of their roots.
  void follow(std::span<double> v) const {
    for (const Tie& t : ties_) follow(t, v);
  }
  static void follow(const Tie& t, std::span<double> v) {
    Vec2 sum(0.0, 0.0);
    for (std::size_t k = 0; k < 3; ++k) sum += t.w[k] * node(v, t.root[k]);
    v[2 * static_cast<std::size_t>(t.cover)] = sum.x();
    v[2 * static_cast<std::size_t>(t.cover) + 1] = sum.y();
  }
  /// All ties, ordered by cover.
  [[nodiscard]] std::span<const Tie> ties() const { return ties_; }

 private:
  std::vector<Tie> ties_;  // covers counted in the pool
  std::vector<std::int32_t> tie_of_, share_start_{0};
  std::vector<Share> share_;
  std::vector<std::int32_t> root_, root_start_;  // covers that others follow, and their first followers
  std::vector<Share> follower_;
};

}  // namespace scree::nmm
