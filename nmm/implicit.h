// One manifold block in implicit steps: two unknowns per free cover.
#pragma once

#include "model/parallel.h"
#include "nmm/consistent_mass.h"
#include "nmm/tangent.h"

namespace scree::nmm {

/// Chart, pattern and element matrices of a block. The unknowns are the displacements of its free covers in a step;
/// tied covers follow, so the chart is a constant matrix and retraction exact.
/// @source docs/theory/kinematics-and-nmm.md, "Elastic law"; docs/theory/kinematics-and-nmm.md, "Masses"
class ImplicitBody {
 public:
  /// @param folded  the block's elements; stored
  /// @param masses  scalar mass of each element over its covers
  /// @param lumped  true: row sums of the folded matrices, on the diagonal
  /// @param first   first cover of the block in the pool's arrays
  /// @param held    element of each edge hold; every hold adds a matrix of its own, without mass
  void make(FoldedElements folded, std::vector<Mat3> masses, bool lumped, std::int32_t first,
            std::vector<std::size_t> held = {});

  [[nodiscard]] int dofs() const { return 2 * folded_.free_covers(); }
  [[nodiscard]] ElementDofs element_dofs() const;
  [[nodiscard]] ChartRow chart_row(const Row& row) const;
  /// Mass of each element with its ties folded in, on x and on y: lower triangles in the order of element_dofs() [kg].
  void element_masses(std::span<double> mass) const;
  /// Stiffness of the elements [N/m] and internal force on the unknowns [N] at the positions q of the pool.
  /// @param covers     of each element, counted in the pool
  /// @param stiffness  lower triangles in the order of element_dofs(); empty: only the force is computed
  /// @param of(e)      StiffElement of the block's element e
  /// @return elastic energy, the elements in their order [J]
  template <class ElementAt>
  double linearise(std::span<const std::array<std::int32_t, 3>> covers, std::span<const double> q, Stiffness kind,
                   std::span<double> stiffness, std::span<double> force, ElementAt&& of) const;
  /// Adds hold k after linearise(), which sets the values of holds to zero.   @param stiffness  empty: not computed
  void add_hold(std::size_t k, const Mat6& matrix, const Eigen::Matrix<double, 6, 1>& force_of_hold,
                std::span<double> stiffness, std::span<double> force) const;
  /// Velocities of the free covers, from those of the pool.
  void rates(std::span<const double> v, std::span<double> rate) const;
  /// q += d and v = rate on the free covers, then the ties.
  void retract(std::span<const double> d, std::span<const double> rate, std::span<double> q, std::span<double> v) const;

 private:
  /// First number of the lower triangle of element e.
  [[nodiscard]] std::size_t value(std::size_t e) const { return static_cast<std::size_t>(value_start_[e]); }

  FoldedElements folded_;
  std::vector<Mat3> mass_;
  bool lumped_ = false;
  std::int32_t first_ = 0;
  std::vector<std::size_t> held_;          // elements of the holds
  std::vector<std::int32_t> value_start_;  // elements, then holds
  mutable std::vector<Eigen::Matrix<double, 6, 1>> corner_force_;
  mutable std::vector<double> energy_;
};

// ---------------------------------------------------------------------------------------------------------------

template <class ElementAt>
double ImplicitBody::linearise(std::span<const std::array<std::int32_t, 3>> covers, std::span<const double> q,
                               Stiffness kind, std::span<double> stiffness, std::span<double> force,
                               ElementAt&& of) const {
  corner_force_.resize(folded_.size());
  const double energy =
      parallel_sum(static_cast<std::int64_t>(folded_.size()), energy_, [&](std::int64_t begin, std::int64_t end) {
        double sum = 0.0;
        for (auto e = static_cast<std::size_t>(begin); e < static_cast<std::size_t>(end); ++e) {
          const StiffElement element = of(e);
          const auto& g = element.gradient;
          const Mat2 F = node(q, covers[e][0]) * g.col(0).transpose() + node(q, covers[e][1]) * g.col(1).transpose() +
                         node(q, covers[e][2]) * g.col(2).transpose();
          const ElasticResponse r = response(element, F);
          sum += element.area * r.energy;
          corner_force_[e] = element_force(element, r.P);
          if (!stiffness.empty())
            folded_.fold(e, element_stiffness(element, F, kind), stiffness.subspan(value(e), value(e + 1) - value(e)));
        }
        return sum;
      });
  if (!stiffness.empty())
    std::fill(stiffness.begin() + static_cast<std::ptrdiff_t>(value(folded_.size())), stiffness.end(), 0.0);
  std::fill(force.begin(), force.end(), 0.0);
  for (std::size_t e = 0; e < folded_.size(); ++e) folded_.fold_force(e, corner_force_[e], force);
  return energy;
}

}  // namespace scree::nmm
