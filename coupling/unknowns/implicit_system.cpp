#include "coupling/unknowns/implicit_system.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/parallel.h"

namespace scree::coupling {
namespace {

/// True for a body of six unknowns that all belong to one element, in order.
bool dense_six(int dofs, const ElementDofs& elements) {
  constexpr std::array<std::int32_t, 6> kAll{0, 1, 2, 3, 4, 5};
  return dofs == 6 && elements.size() == 1 &&
         std::equal(elements.dof.begin(), elements.dof.end(), kAll.begin(), kAll.end());
}

}  // namespace

ImplicitSystem::ImplicitSystem(const Setup& setup) : setup_(&setup), first_value_(1, 0) {
  std::vector<std::int32_t> row, column;
  for (const Body& b : setup.bodies()) {
    const Pool& pool = setup.pool_of(b);
    first_dof_.push_back(b.driven ? -1 : dofs_);
    nonlinear_body_.push_back(!b.driven && pool.nonlinear(b.index) ? 1 : 0);
    if (!b.driven) {
      const ElementDofs elements = pool.element_dofs(b.index);
      for (std::size_t e = 0; e < elements.size(); ++e)
        for (auto j = static_cast<std::size_t>(elements.start[e]); j < static_cast<std::size_t>(elements.start[e + 1]);
             ++j)
          for (std::size_t i = j; i < static_cast<std::size_t>(elements.start[e + 1]); ++i) {
            row.push_back(dofs_ + elements.dof[i]);
            column.push_back(dofs_ + elements.dof[j]);
          }
      nonlinear_ = nonlinear_ || nonlinear_body_.back() != 0;
      affine_ = affine_ && nonlinear_body_.back() == 0 && dense_six(pool.dofs(b.index), elements);
      constant_charts_ = constant_charts_ && pool.constant_chart(b.index);
      dofs_ += pool.dofs(b.index);
      nonlinear_dof_.resize(static_cast<std::size_t>(dofs_), nonlinear_body_.back() != 0 ? 1.0 : 0.0);
    }
    first_value_.push_back(row.size());
  }
  place_ = pattern_.make(dofs_, row, column);
  mass_.resize(pattern_.size());
  scratch_.resize(row.size());
  rate_.resize(static_cast<std::size_t>(dofs_));
}

BodyIndex ImplicitSystem::body_of(std::int32_t dof) const {
  BodyIndex found;
  for (std::size_t b = 0; b < first_dof_.size(); ++b)
    if (first_dof_[b] >= 0 && first_dof_[b] <= dof) found = BodyIndex::of(b);
  return found;
}

void ImplicitSystem::scatter(std::size_t body, std::span<const double> values, std::span<double> out) const {
  const std::size_t first = first_value_[body];
  for (std::size_t k = 0; k < values.size(); ++k) out[static_cast<std::size_t>(place_[first + k])] += values[k];
}

void ImplicitSystem::find_units(std::span<const double> reference) {
  unit_.assign(static_cast<std::size_t>(dofs_), 0.0);
  const Outlines& o = setup_->outlines();
  for (const OutlineNode k : o.nodes.indices()) {
    const BodyIndex body = o.node_body[k];
    if (first_dof(body) < 0) continue;
    const ChartRow row = chart(body, o.nodes[k], reference);
    for (std::size_t j = 0; j < static_cast<std::size_t>(row.n); ++j) {
      double& unit = unit_[static_cast<std::size_t>(row.dof[j])];
      unit = std::max(unit, std::hypot(row.tx[j], row.ty[j]));
    }
  }
  // For displacements of the inside, and unknowns that hardly move the outline.
  for (std::size_t i = 0; i < first_dof_.size(); ++i) {
    if (first_dof_[i] < 0) continue;
    const auto n = static_cast<std::size_t>(setup_->pool_of(setup_->bodies()[i]).dofs(setup_->bodies()[i].index));
    const std::span<double> of_body = std::span(unit_).subspan(static_cast<std::size_t>(first_dof_[i]), n);
    if (setup_->pool_of(setup_->bodies()[i]).constant_chart(setup_->bodies()[i].index))
      std::fill(of_body.begin(), of_body.end(), 1.0);
    for (double& unit : of_body)
      if (unit == 0.0) unit = 1.0;
  }
}

template <class Of>
void ImplicitSystem::for_bodies(bool all, Of&& of) const {
  // Pools of affine bodies keep nothing between calls, so that threads may call them.
  constexpr std::int64_t kFew = 1000;
  const auto of_body = [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    if (takes(i, all)) of(i);
  };
  const auto bodies = std::ssize(first_dof_);
  parallel_for(bodies, of_body, affine_ ? kFew : bodies + 1);
}

void ImplicitSystem::compute_masses(std::span<const double> q, std::span<const double> v) {
  for_bodies(true, [&](std::size_t i) {
    const Body& b = setup_->bodies()[i];
    const auto p = static_cast<std::size_t>(b.pool), first = static_cast<std::size_t>(first_dof_[i]);
    const Pool& pool = setup_->pool_of(b);
    const auto n = static_cast<std::size_t>(pool.dofs(b.index));
    pool.rates(b.index, setup_->part(q, p), setup_->part(v, p), std::span(rate_).subspan(first, n));
    if (has_masses_ && pool.constant_chart(b.index)) return;
    const std::span<double> values = values_of(i);
    pool.element_masses(b.index, setup_->part(q, p), values);
    clear_columns(first, n, mass_);
    scatter(i, values, mass_);
  });
  has_masses_ = true;
}

void ImplicitSystem::clear_columns(std::size_t first, std::size_t n, std::span<double> values) const {
  std::fill(values.begin() + pattern_.column_start[first], values.begin() + pattern_.column_start[first + n], 0.0);
}

double ImplicitSystem::linearise(std::span<const double> q, Stiffness kind, bool all, std::span<double> K,
                                 std::span<double> force) {
  double energy = 0.0;
  for_bodies(all, [&](std::size_t i) {
    const Body& b = setup_->bodies()[i];
    const Pool& pool = setup_->pool_of(b);
    const auto first = static_cast<std::size_t>(first_dof_[i]), n = static_cast<std::size_t>(pool.dofs(b.index));
    std::span<double> values;
    if (!K.empty()) {
      values = values_of(i);
      clear_columns(first, n, K);
    }
    const double stored = pool.linearise(b.index, setup_->part(q, static_cast<std::size_t>(b.pool)), kind, values,
                                         force.subspan(first, n));
    if (nonlinear_body_[i] != 0) energy += stored;  // then the loop runs on one thread
    if (!K.empty()) scatter(i, values, K);
  });
  return energy;
}

ChartRow ImplicitSystem::chart(BodyIndex body, const Row& row, std::span<const double> q) const {
  const Body& b = setup_->body(body);
  ChartRow chart =
      setup_->pool_of(b).chart_row(b.index, setup_->local(b, row), setup_->part(q, static_cast<std::size_t>(b.pool)));
  for (std::size_t k = 0; k < static_cast<std::size_t>(chart.n); ++k) chart.dof[k] += first_dof(body);
  return chart;
}

void ImplicitSystem::add_forces(std::span<const double> f, std::span<const double> q, std::span<double> out) const {
  for_bodies(true, [&](std::size_t i) {
    const Body& b = setup_->bodies()[i];
    const auto of_pool = setup_->part(q, static_cast<std::size_t>(b.pool));
    const auto first = static_cast<std::size_t>(first_dof_[i]);
    const std::int32_t end = b.first_node + b.nodes;
    for (std::int32_t k = b.first_node; k < end; ++k) {
      const std::size_t n = 2 * static_cast<std::size_t>(k);
      if (f[n] == 0.0 && f[n + 1] == 0.0) continue;
      const ChartRow chart =
          setup_->pool_of(b).chart_row(b.index, setup_->local(b, Row{{k, k, k}, {1.0, 0.0, 0.0}}), of_pool);
      for (std::size_t j = 0; j < static_cast<std::size_t>(chart.n); ++j)
        out[first + static_cast<std::size_t>(chart.dof[j])] += f[n] * chart.tx[j] + f[n + 1] * chart.ty[j];
    }
  });
}

void ImplicitSystem::accelerations(std::span<const double> q, std::span<const double> nodes,
                                   std::span<double> dofs) const {
  for_bodies(true, [&](std::size_t i) {
    const Body& b = setup_->bodies()[i];
    const auto p = static_cast<std::size_t>(b.pool);
    const Pool& pool = setup_->pool_of(b);
    pool.rates(b.index, setup_->part(q, p), setup_->part(nodes, p),
               dofs.subspan(static_cast<std::size_t>(first_dof_[i]), static_cast<std::size_t>(pool.dofs(b.index))));
  });
}

void ImplicitSystem::node_accelerations(std::span<const double> dofs, std::span<double> nodes) const {
  // A constant chart maps rates to velocities as it maps accelerations.
  std::vector<double> nowhere(nodes.size(), 0.0);
  const std::vector<double> still(dofs.size(), 0.0);
  std::fill(nodes.begin(), nodes.end(), 0.0);
  retract(still, dofs, true, nowhere, nodes);
}

void ImplicitSystem::retract(std::span<const double> d, std::span<const double> rate, bool all, std::span<double> q,
                             std::span<double> v) const {
  for_bodies(all, [&](std::size_t i) {
    const Body& b = setup_->bodies()[i];
    const auto p = static_cast<std::size_t>(b.pool), first = static_cast<std::size_t>(first_dof_[i]),
               n = static_cast<std::size_t>(setup_->pool_of(b).dofs(b.index));
    setup_->pool_of(b).retract(b.index, d.subspan(first, n), rate.subspan(first, n), setup_->part(q, p),
                               setup_->part(v, p));
  });
}

}  // namespace scree::coupling
