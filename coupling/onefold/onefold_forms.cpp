#include "coupling/onefold/onefold_forms.h"

#include <array>
#include <utility>

#include "model/check.h"
#include "model/dense_algebra.h"
#include "nmm/nmm_pool.h"
#include "nmm/tangent.h"

namespace scree::coupling {
namespace {

constexpr int kSix = AffineForm::kUnknowns;

nmm::Mat6 from_lower(const std::array<double, 21>& lower) {
  nmm::Mat6 A;
  std::size_t at = 0;
  for (int j = 0; j < kSix; ++j)
    for (int i = j; i < kSix; ++i) A(i, j) = A(j, i) = lower[at++];
  return A;
}

OnefoldMatrices zero(int n, std::size_t contacts) {
  const Eigen::MatrixXd O = Eigen::MatrixXd::Zero(n, n);
  const auto rows = 2 * static_cast<Eigen::Index>(contacts);
  return {O, O, Eigen::MatrixXd::Zero(rows, n), Eigen::VectorXd::Zero(rows)};
}

}  // namespace

OnefoldForms onefold_forms(const Setup& setup, std::span<const double> q, const ContactList& contacts) {
  std::vector<int> first(setup.bodies().size(), -1);
  int n = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    if (!setup.bodies()[i].driven) first[i] = std::exchange(n, n + kSix);
  const std::size_t count = contacts.points.size();
  OnefoldForms out{zero(n, count), zero(n, count), Eigen::MatrixXd::Zero(n, n)};
  std::vector<const nmm::OnefoldCover*> cover(first.size(), nullptr);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] < 0) continue;
    const Body& b = setup.bodies()[i];
    const auto& pool = dynamic_cast<const nmm::NmmPool&>(setup.pool_of(b));
    cover[i] = pool.onefold(b.index);
    SCREE_ASSERT(cover[i] != nullptr);
    const auto own = setup.part(q, static_cast<std::size_t>(b.pool));
    const Mat2 F = cover[i]->gradient(own);
    const auto block = [&](Eigen::MatrixXd& A) { return A.block<kSix, kSix>(first[i], first[i]); };
    const auto e = static_cast<std::size_t>(pool.boundary(b.index).segments.front().cell);
    const nmm::ElementForces& elements = pool.elements();
    block(out.stars.mass) = cover[i]->star_mass();
    block(out.stars.stiffness) = nmm::element_stiffness({elements.gradients(e), elements.area(e), elements.law(e).law,
                                                         elements.law(e).kinematics, elements.initial_stress(e)},
                                                        F, Stiffness::exact);
    std::array<double, 21> lower{};
    std::array<double, kSix> force{};
    cover[i]->form().mass(lower);
    block(out.centroidal.mass) = from_lower(lower);
    (void)cover[i]->form().linearise(F, Stiffness::exact, lower, force);
    block(out.centroidal.stiffness) = from_lower(lower);
    block(out.map) = cover[i]->star_map();
  }

  const Outlines& o = setup.outlines();
  Eigen::Index r = 0;
  for (std::size_t c = 0; c < count; ++c) {
    const ContactPoint& p = contacts.points[c];
    const ContactMemory& m = contacts.memory[c];
    for (const auto& [scalar, k] : {std::pair(gap_row(p.at), m.kn), std::pair(stretch_row(p.at, m.anchor), m.kt)}) {
      auto stars = out.stars.rows.row(r), centroidal = out.centroidal.rows.row(r);
      out.stars.springs[r] = out.centroidal.springs[r] = k;
      ++r;
      for (std::size_t end = 0; end < 3; ++end) {
        const OutlineNode node = p.node[end];
        const std::size_t body = o.node_body[node].index();
        if (first[body] < 0) continue;
        const Body& b = setup.bodies()[body];
        for (std::size_t star = 0; star < 3; ++star)
          stars.segment<2>(first[body] + 2 * (o.nodes[node].node[star] - b.first_node)) +=
              o.nodes[node].w[star] * scalar[end].transpose();
        const ChartRow row = cover[body]->chart_row(setup.local(b, o.nodes[node]));
        for (std::size_t u = 0; u < static_cast<std::size_t>(row.n); ++u)
          centroidal[first[body] + row.dof[u]] += row.tx[u] * scalar[end].x() + row.ty[u] * scalar[end].y();
      }
    }
  }
  return out;
}

double condition_number(const Eigen::MatrixXd& A) {
  const Eigen::VectorXd s = singular_values(A);
  return s[0] / s[s.size() - 1];
}

}  // namespace scree::coupling
