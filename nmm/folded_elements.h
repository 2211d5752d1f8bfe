// The elements of one block over its free covers: element matrices with the ties folded in.
#pragma once

#include <span>
#include <vector>

#include "nmm/cover_chart.h"

namespace scree::nmm {

using Mat3 = Eigen::Matrix3d;
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// q = C q_free: a tied cover follows three roots. An element whose covers are free has three unknown places, one with
/// ties up to nine; its matrix M becomes C_e^T M C_e. Matrices over places are kept as lower triangles, column after
/// column.
class FoldedElements {
 public:
  /// Covers and elements are counted from the mesh's first; covers without an element are left out.
  void make(const CoverMesh& mesh);

  [[nodiscard]] std::size_t size() const { return start_.size() - 1; }
  [[nodiscard]] std::int32_t free_covers() const { return static_cast<std::int32_t>(cover_of_.size()); }
  /// Free covers of an element, counted among the free ones.
  [[nodiscard]] std::span<const std::int32_t> places(std::size_t e) const {
    return std::span(place_).subspan(static_cast<std::size_t>(start_[e]),
                                     static_cast<std::size_t>(start_[e + 1] - start_[e]));
  }
  /// A free cover, counted from the block's first.
  [[nodiscard]] std::int32_t cover_of(std::int32_t free) const { return cover_of_[static_cast<std::size_t>(free)]; }
  /// Number of a cover among the free ones; -1 for a tied cover and for one that is left out.
  [[nodiscard]] std::int32_t free_of(std::int32_t cover) const { return free_of_[static_cast<std::size_t>(cover)]; }
  /// The block's ties.
  [[nodiscard]] const CoverChart& chart() const { return chart_; }

  /// C_e^T M C_e of a matrix over covers.   @param lower  n (n + 1)/2 numbers, n the places
  void fold(std::size_t e, const Mat3& M, std::span<double> lower) const;
  /// C_e^T K C_e for two unknowns per cover, in the order x, y of each.   @param lower  n (2 n + 1) numbers
  void fold(std::size_t e, const Mat6& K, std::span<double> lower) const;
  /// Adds forces on the covers of an element, f[2 k + d], to those on free covers.
  void fold_force(std::size_t e, const Eigen::Matrix<double, 6, 1>& f, std::span<double> free) const;

 private:
  /// C_e: one row per cover of the element, one column per place.
  [[nodiscard]] Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 9> element_chart(std::size_t e) const;

  CoverChart chart_;
  std::vector<std::int32_t> start_{0}, place_;  // per element: its places
  std::vector<std::int32_t> weight_start_;      // per element: into weight_; -1: all its covers are free
  std::vector<double> weight_;                  // C_e, column after column
  std::vector<std::int32_t> cover_of_, free_of_;
};

}  // namespace scree::nmm
