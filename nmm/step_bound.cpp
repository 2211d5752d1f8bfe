#include "nmm/step_bound.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

namespace scree::nmm {
namespace {

struct Term {  // gradient of an element's weights on a free cover
  std::int32_t cover = 0;
  Vec2 gradient{0.0, 0.0};
};

/// The element's gradients on free covers, each cover once.
void terms_of(const CoverMesh& mesh, const CoverChart& chart, std::int32_t first, std::size_t e,
              std::vector<Term>& terms) {
  const Gradients& g = mesh.shapes[mesh.shape[e]];
  terms.clear();
  for (std::size_t k = 0; k < 3; ++k)
    for (const Share& s : chart.shares(first + mesh.cover[e][k])) {
      if (s.w == 0.0) continue;
      auto at = std::find_if(terms.begin(), terms.end(), [&](const Term& t) { return t.cover == s.cover; });
      if (at == terms.end()) at = terms.insert(terms.end(), {s.cover, Vec2::Zero()});
      at->gradient += s.w * g.col(static_cast<Eigen::Index>(k));
    }
}

}  // namespace

FrequencyBound frequency_bound_of(const CoverMesh& mesh, const CoverChart& chart, std::int32_t first,
                                  std::span<const double> lumped, double scale, const Elasticity& law) {
  std::vector<double> diagonal(mesh.star.size(), 0.0);
  std::vector<std::int8_t> plain(mesh.star.size(), 0);  // whole elements of untied covers; 100 with any other
  std::vector<Term> terms;
  const auto local = [&](std::int32_t cover) { return static_cast<std::size_t>(cover - first); };
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    terms_of(mesh, chart, first, e, terms);
    for (const Term& t : terms) {
      diagonal[local(t.cover)] += scale * mesh.area[e] * t.gradient.squaredNorm();
      auto& count = plain[local(t.cover)];
      count = static_cast<std::int8_t>(std::min(mesh.piece[e] < 0 && terms.size() == 3 ? count + 1 : 100, 100));
    }
  }
  const double c11 = law.p_modulus(), c12 = law.lambda;
  Eigen::Matrix3d C;
  C << c11, c12, 0.0, c12, c11, 0.0, 0.0, 0.0, law.mu;
  const Eigen::Matrix3d root = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(C).operatorSqrt();
  FrequencyBound bound;
  std::array<bool, 2> seen{false, false};  // elements inside the regular mesh are equal: one per shape
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const auto& cover = mesh.cover[e];
    const bool regular = mesh.piece[e] < 0 && std::all_of(cover.begin(), cover.end(), [&](std::int32_t c) {
                           return plain[static_cast<std::size_t>(c)] == 6 && !chart.tied(first + c);
                         });
    if (regular) {
      if (seen[mesh.shape[e]]) continue;
      seen[mesh.shape[e]] = true;
    }
    terms_of(mesh, chart, first, e, terms);
    // K_e = A B^T C B has rank 3: its eigenvalues against D_e are those of A C^1/2 B D_e^-1 B^T C^1/2.
    const double area = scale * mesh.area[e];
    Eigen::Matrix3d BB = Eigen::Matrix3d::Zero();
    for (const Term& t : terms) {
      const double share = area * t.gradient.squaredNorm() / diagonal[local(t.cover)];
      if (!(share > 0.0)) continue;
      const double inverse = 1.0 / (share * lumped[static_cast<std::size_t>(t.cover)]);
      Eigen::Matrix<double, 3, 2> B;
      B << t.gradient.x(), 0.0, 0.0, t.gradient.y(), t.gradient.y(), t.gradient.x();
      BB += inverse * B * B.transpose();
    }
    const Eigen::Matrix3d H = area * root * BB * root;
    const double lambda = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(H, Eigen::EigenvaluesOnly).eigenvalues()(2);
    if (lambda > bound.lambda) bound = {lambda, static_cast<std::int32_t>(e)};
  }
  return bound;
}

}  // namespace scree::nmm
