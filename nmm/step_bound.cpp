#include "nmm/step_bound.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace scree::nmm {

double frequency_bound_of(const CoverMesh& mesh, const AffineMass& mass, const Elasticity& law) {
  struct Term {
    std::int32_t cover;
    Vec2 gradient;
  };
  std::vector<std::vector<Term>> terms(mesh.elements.size());  // gradients on free covers
  std::vector<double> diagonal(mesh.star.size(), 0.0);
  std::vector<std::pair<std::int32_t, double>> folded;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto g = mesh.elements[e].gradients();
    for (std::size_t k = 0; k < 3; ++k) {
      // The fold of a single cover: itself, or its roots.
      Row single;
      const std::int32_t first = mass.first();
      single.node = {mesh.elements[e].cover[k] + first, first, first};
      single.w = {1.0, 0.0, 0.0};
      mass.fold(single, folded);
      for (const auto& [cover, w] : folded) {
        if (w == 0.0) continue;
        auto at = std::find_if(terms[e].begin(), terms[e].end(), [c = cover](const Term& t) { return t.cover == c; });
        if (at == terms[e].end()) at = terms[e].insert(terms[e].end(), {cover, Vec2::Zero()});
        at->gradient += w * g.col(static_cast<Eigen::Index>(k));
      }
    }
    for (const Term& t : terms[e])
      diagonal[static_cast<std::size_t>(t.cover)] += mesh.elements[e].area * t.gradient.squaredNorm();
  }
  // K_e = A B^T C B has rank 3: its eigenvalues against D_e are those of A C^1/2 B D_e^-1 B^T C^1/2.
  const double c11 = law.p_modulus(), c12 = law.lambda;
  Eigen::Matrix3d C;
  C << c11, c12, 0.0, c12, c11, 0.0, 0.0, 0.0, law.mu;
  const Eigen::Matrix3d root = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(C).operatorSqrt();
  double bound = 0.0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const double area = mesh.elements[e].area;
    Eigen::Matrix3d BB = Eigen::Matrix3d::Zero();
    for (const Term& t : terms[e]) {
      const double share = area * t.gradient.squaredNorm() / diagonal[static_cast<std::size_t>(t.cover)];
      if (!(share > 0.0)) continue;
      const double inverse = 1.0 / (share * mass.lumped()[static_cast<std::size_t>(t.cover)]);
      Eigen::Matrix<double, 3, 2> B;
      B << t.gradient.x(), 0.0, 0.0, t.gradient.y(), t.gradient.y(), t.gradient.x();
      BB += inverse * B * B.transpose();
    }
    const Eigen::Matrix3d H = area * root * BB * root;
    bound = std::max(bound, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(H, Eigen::EigenvaluesOnly).eigenvalues()(2));
  }
  return bound;
}

}  // namespace scree::nmm
