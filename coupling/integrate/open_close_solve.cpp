// The linear systems of the open-close iteration: for given contact states, with the friction of slipping points.
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/integrate/open_close.h"
#include "model/parallel.h"

namespace scree::coupling {

void OpenClose::multiply(std::span<const double> x, std::span<double> y) const {
  system_->pattern().multiply(A_, x, y);
  for (const std::size_t r : active_) rows_[r].add_force(k_[r] * (rows_[r].change(x) - rows_[r].known), y);
  for (const LowRank& term : damping_) {
    const Eigen::Map<const Eigen::MatrixX3d> Z(term.Z, static_cast<Eigen::Index>(term.count), 3);
    const Eigen::Map<const Eigen::VectorXd> of_x(x.data() + term.first, static_cast<Eigen::Index>(term.count));
    const Eigen::Vector3d z = term.W * (Z.transpose() * of_x);
    for (std::size_t k = 0; k < term.count; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      y[term.first + k] -= Z(row, 0) * z(0) + Z(row, 1) * z(1) + Z(row, 2) * z(2);
    }
  }
  for (const Slipping& s : slipping_) {
    const DofRow normal = states_.normal(s.point), tangential = states_.tangential(s.point);
    const double gap = normal.change(x) - normal.known;
    if (!s.dilates) {
      tangential.add_force(s.friction_per_gap * gap, y);
      continue;
    }
    const double kn = states_[s.point].k,
                 loss = s.dilation.per_gap * gap + s.dilation.per_stretch * (tangential.change(x) - tangential.known);
    normal.add_force(loss - kn * gap, y);
    tangential.add_force(s.friction_per_gap / kn * loss, y);
  }
}

double OpenClose::force_scale(std::span<const double> d) const {
  const auto unit = system_->unit();
  const double of_bodies = parallel_largest(std::ssize(rhs_), [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    return std::max(std::abs(rhs_[i]), std::abs(base_[i])) / unit[i];
  });
  return std::max(of_bodies, parallel_largest(std::ssize(active_), [&](std::int64_t at) {
                    const std::size_t r = active_[static_cast<std::size_t>(at)];
                    return k_[r] * std::abs(at_[r] + rows_[r].change(d));
                  }));
}

double OpenClose::round_off(std::span<const double> d) const {
  const SymmetricPattern& p = system_->pattern();
  std::vector<double> size(d.size(), 0.0);
  for (std::int32_t c = 0; c < p.n; ++c)
    for (std::int32_t k = p.column_start[static_cast<std::size_t>(c)];
         k < p.column_start[static_cast<std::size_t>(c) + 1]; ++k) {
      const auto at = static_cast<std::size_t>(k), row = static_cast<std::size_t>(p.row[at]),
                 column = static_cast<std::size_t>(c);
      size[row] += std::abs(A_[at] * d[column]);
      if (row != column) size[column] += std::abs(A_[at] * d[row]);
    }
  // For a stiff spring, round-off of large displacements that cancel in its elongation: interface constraints of small
  // halves.
  for (const std::size_t r : active_) {
    const DofRow row = rows_[r];
    double length = std::abs(at_[r]);
    for (std::size_t j = 0; j < row.dof.size(); ++j)
      length += std::abs(row.h[j] * d[static_cast<std::size_t>(row.dof[j])]);
    for (std::size_t j = 0; j < row.dof.size(); ++j)
      size[static_cast<std::size_t>(row.dof[j])] += k_[r] * length * std::abs(row.h[j]);
  }
  for (std::size_t i = 0; i < size.size(); ++i) size[i] /= system_->unit()[i];
  return 4.0 * std::numeric_limits<double>::epsilon() * *std::max_element(size.begin(), size.end());
}

int OpenClose::iterate(std::span<const double> rhs, double enough, int most, std::span<double> d) {
  using In = std::span<const double>;
  using Out = std::span<double>;
  if (blocks_.acts)
    return residuals_.solve([this](In x, Out y) { blocks_.system.multiply(x, y); },
                            [this](In x, Out y) { blocks_.system.matrix().multiply(x, y); },
                            [this](In r, std::span<float> z) { blocks_.factor.solve(r, z); }, rhs, system_->unit(),
                            enough, most, d);
  return residuals_.solve([this](In x, Out y) { multiply(x, y); }, [this](In r, Out z) { cholesky_.solve(r, z); }, rhs,
                          system_->unit(), enough, most, d);
}

int OpenClose::improve(int most, std::span<double> d, StepReport& report) {
  // Of the largest force. The work of what is left adds up over the steps of a slide.
  constexpr double kAccurate = 3e-14, kRough = 1e-7;  // the latter while states still switch
  // A complete factor mostly takes fewer than eight: then round-off is probably above what is asked for.
  constexpr int kAtOnce = ConjugateResiduals::kDepth, kByFactorAtOnce = 8;
  // Friction causes most of the iterations; without it, and with the factor of the matrix, one or two are enough.
  rough_ = !exact_ && (keep_ || blocks_.acts || unsymmetric());
  const double part_of = rough_ ? kRough : kAccurate;
  double least = 0.0;
  int taken = 0;
  for (bool looked = false;;) {
    const int part = std::min(most - taken, blocks_.acts || looked ? kAtOnce : kByFactorAtOnce);
    const int more = blocks_.acts ? iterate_blocks(part_of, least, part, d)
                                  : iterate(rhs_, std::max(least, part_of * force_scale(d)), part, d);
    taken += more >= 0 ? more : part;
    if (more >= 0 || (looked && taken >= most)) {
      report.corrections += taken;
      counts_.corrections += taken;
      if (blocks_.acts) report.block_iterations += taken;
      return more >= 0 ? taken : -1;
    }
    // Static steps of stiff meshes: forces inside blocks are far larger than those on them, and so is their round-off.
    if (blocks_.acts) apply_states();
    least = round_off(d);
    looked = true;
  }
}

void OpenClose::correct(std::span<const double> left, std::span<double> d, StepReport& report) {
  constexpr double kPart = 1e-8;  // of the forces: those that move a body as a whole are small among them
  constexpr int kMost = 8;
  double largest = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i) largest = std::max(largest, std::abs(left[i]) / system_->unit()[i]);
  correction_.assign(d.size(), 0.0);
  const int taken = iterate(left, kPart * largest, kMost, correction_);
  report.corrections += taken >= 0 ? taken : kMost;
  std::vector<double>& rhs = blocks_.acts ? base_ : rhs_;  // of the system that d solves, for check()
  for (std::size_t i = 0; i < d.size(); ++i) {
    d[i] += correction_[i];
    rhs[i] += left[i];
  }
  states_.evaluate(d);
}

bool OpenClose::solve_states(std::span<double> d, StepReport& report) {
  constexpr int kRefinements = 6, kFriction = 200;
  friction_settled_ = true;
  if (blocks_.acts) {
    if (solve_blocks(d, report)) return true;
    leave_blocks(report);
    if (!factorise_anew(report)) return false;
  }
  if (keep_) {
    const int taken = improve(corrections_left_, d, report);
    corrections_left_ -= std::max(taken, 0);
    if (taken >= 0) return true;
    constexpr std::int32_t kLongest = 15;
    patience_.wait = patience_.next_wait = std::min(2 * patience_.next_wait + 1, kLongest);
    if (!factorise_anew(report)) return false;
  }
  if (updated_) {
    if (!unsymmetric()) cholesky_.solve(rhs_, d);
    if (improve(unsymmetric() ? kFriction : kRefinements, d, report) >= 0) return true;
    if (!factorise_anew(report)) return false;
  }
  if (!unsymmetric()) {
    rough_ = false;
    cholesky_.solve(rhs_, d);
  } else {
    friction_settled_ = improve(kFriction, d, report) >= 0;
  }
  return true;
}

}  // namespace scree::coupling
