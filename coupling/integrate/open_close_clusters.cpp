// Contact states settled in clusters of bodies around the points that have switched, between the passes of all
// bodies.
#include <algorithm>
#include <cmath>

#include "coupling/integrate/open_close.h"

namespace scree::coupling {
namespace {

constexpr std::size_t kSide = kBlockSide;

}  // namespace

void OpenClose::find_cluster_bodies() {
  BodyClusters& c = clusters_;
  const BlockSystem& system = blocks_.system;
  c.inside.assign(static_cast<std::size_t>(system.matrix().rows()), 0);
  c.bodies.clear();
  const auto take = [&c](std::int32_t body) {
    if (body < 0 || c.inside[static_cast<std::size_t>(body)] != 0) return;
    c.inside[static_cast<std::size_t>(body)] = 1;
    c.bodies.push_back(body);
  };
  for (const std::size_t i : states_.changed())
    for (const std::int32_t body : system.bodies_of(i)) take(body);
  const std::size_t ring = c.bodies.size();
  for (std::size_t k = 0; k < ring; ++k)
    for (const BlockSystem::Incidence& at : system.incidences(c.bodies[k])) {
      const auto unit = static_cast<std::size_t>(at.unit);
      if (unit < springs_->size() || states_[unit - springs_->size()].status == ContactStatus::open) continue;
      for (const std::int32_t body : system.bodies_of(unit - springs_->size())) take(body);
    }
  std::sort(c.bodies.begin(), c.bodies.end());
}

void OpenClose::settle_clusters(std::span<double> d, StepReport& report) {
  BodyClusters& c = clusters_;
  find_cluster_bodies();
  const std::size_t bodies = c.inside.size();
  c.place.resize(bodies);
  for (const std::int32_t seed : c.bodies) {
    if (c.inside[static_cast<std::size_t>(seed)] != 1) continue;
    // Finds all bodies inside that are connected with the seed; 2: found.
    c.cluster.assign(1, seed);
    c.inside[static_cast<std::size_t>(seed)] = 2;
    for (std::size_t k = 0; k < c.cluster.size(); ++k) {
      const BlockMatrix& m = blocks_.system.matrix();
      for (std::int32_t at = m.row_begin(c.cluster[k]); at < m.row_begin(c.cluster[k] + 1); ++at)
        if (char& in = c.inside[static_cast<std::size_t>(m.column(at))]; in == 1) {
          in = 2;
          c.cluster.push_back(m.column(at));
        }
    }
    constexpr std::size_t kPart = 4;  // a cluster of more than a quarter of all bodies is left to the next pass
    if (kPart * c.cluster.size() > bodies) continue;
    std::sort(c.cluster.begin(), c.cluster.end());
    settle_cluster(d, report);
  }
}

void OpenClose::begin_cluster() {
  BodyClusters& c = clusters_;
  const BlockMatrix& m = blocks_.system.matrix();
  for (std::size_t k = 0; k < c.cluster.size(); ++k)
    c.place[static_cast<std::size_t>(c.cluster[k])] = static_cast<std::int32_t>(k);
  c.pairs.clear();
  c.points.clear();
  const auto in_cluster = [&c](std::int32_t body) {
    const std::int32_t k = c.place[static_cast<std::size_t>(body)];
    return k >= 0 && k < static_cast<std::int32_t>(c.cluster.size()) && c.cluster[static_cast<std::size_t>(k)] == body;
  };
  c.unit.clear();
  for (const std::int32_t body : c.cluster) {
    for (std::int32_t at = m.diagonal(body) + 1; at < m.row_begin(body + 1); ++at)
      if (in_cluster(m.column(at)))
        c.pairs.push_back({c.place[static_cast<std::size_t>(body)], c.place[static_cast<std::size_t>(m.column(at))]});
    for (const BlockSystem::Incidence& at : blocks_.system.incidences(body))
      if (const auto unit = static_cast<std::size_t>(at.unit);
          unit >= springs_->size() && !list_->points[unit - springs_->size()].suppressed)
        c.points.push_back(unit - springs_->size());
    const auto first = system_->unit().begin() + static_cast<std::ptrdiff_t>(kSide * static_cast<std::size_t>(body));
    c.unit.insert(c.unit.end(), first, first + kBlockSide);
  }
  std::sort(c.points.begin(), c.points.end());
  c.points.erase(std::unique(c.points.begin(), c.points.end()), c.points.end());
  c.matrix.set_pattern(static_cast<std::int32_t>(c.cluster.size()), c.pairs);
  c.seen.clear();
}

double OpenClose::find_cluster_residual(std::span<const double> d) {
  BodyClusters& c = clusters_;
  c.normal.resize(states_.size());
  c.tangential.resize(states_.size());
  double largest = 0.0;
  for (const std::size_t i : c.points) {
    const LinearContactForce f = states_.linear_force(i);
    blocks_.system.set(i, f.k);
    const double gap = states_.normal(i).change(d), stretch = states_.tangential(i).change(d);
    c.normal[i] = f.normal - f.k.nn * gap - f.k.nt * stretch;
    c.tangential[i] = f.tangential - f.k.tn * gap - f.k.tt * stretch;
    largest = std::max({largest, std::abs(c.normal[i]), std::abs(c.tangential[i])});
  }
  c.residual.resize(kSide * c.cluster.size());
  for (std::size_t k = 0; k < c.cluster.size(); ++k) {
    const std::int32_t body = c.cluster[k];
    double* sum = &c.residual[kSide * k];
    for (std::size_t j = 0; j < kSide; ++j) {
      sum[j] = base_[kSide * static_cast<std::size_t>(body) + j];
      largest = std::max(largest, std::abs(sum[j]) / c.unit[kSide * k + j]);
    }
    blocks_.system.subtract_own(body, d, sum);
    for (const BlockSystem::Incidence& at : blocks_.system.incidences(body)) {
      const auto unit = static_cast<std::size_t>(at.unit);
      if (unit < springs_->size()) {
        blocks_.system.add_force(unit, at.own, springs_->force(unit, d), sum);
        continue;
      }
      const std::size_t i = unit - springs_->size(), row = springs_->size() + 2 * i;
      if (list_->points[i].suppressed) continue;
      blocks_.system.add_force(row, at.own, c.normal[i], sum);
      blocks_.system.add_force(row + 1, at.own, c.tangential[i], sum);
    }
  }
  return largest;
}

bool OpenClose::solve_cluster(std::span<double> d) {
  constexpr double kRough = 1e-7;  // of the largest force; the next pass of all bodies is solved accurately enough
  constexpr int kMost = 40;
  BodyClusters& c = clusters_;
  const double largest = find_cluster_residual(d);
  const BlockMatrix& all = blocks_.system.matrix();
  for (std::size_t k = 0; k < c.cluster.size(); ++k) {
    const std::int32_t body = c.cluster[k], row = static_cast<std::int32_t>(k);
    blocks_.system.refresh(body);
    // Columns of both matrices are in the same order: those of bodies outside are skipped.
    std::int32_t from = all.row_begin(body);
    for (std::int32_t at = c.matrix.row_begin(row); at < c.matrix.row_begin(row + 1); ++at, ++from) {
      const std::int32_t column = c.cluster[static_cast<std::size_t>(c.matrix.column(at))];
      while (all.column(from) != column) ++from;
      std::copy_n(all.block(from), kBlockSize, c.matrix.block(at));
    }
  }
  if (!c.factor.factorise(c.matrix, c.unit)) return false;
  c.change.assign(c.residual.size(), 0.0);
  const int taken = c.residuals.solve([&](std::span<const double> x, std::span<double> y) { c.matrix.multiply(x, y); },
                                      [&](std::span<const double> r, std::span<float> z) { c.factor.solve(r, z); },
                                      c.residual, c.unit, kRough * largest, kMost, c.change);
  if (taken < 0) return false;
  blocks_.work += static_cast<double>(c.matrix.blocks()) * (8.0 + 1.75 * taken);
  for (std::size_t k = 0; k < c.cluster.size(); ++k)
    for (std::size_t j = 0; j < kSide; ++j)
      d[kSide * static_cast<std::size_t>(c.cluster[k]) + j] += c.change[kSide * k + j];
  return true;
}

void OpenClose::settle_cluster(std::span<double> d, StepReport& report) {
  constexpr int kMost = 25;
  BodyClusters& c = clusters_;
  begin_cluster();
  bool only_worst = false;
  for (int pass = 0; pass < kMost; ++pass) {
    ++report.local_passes;
    if (!solve_cluster(d)) return;
    for (const std::size_t i : c.points) states_.evaluate_point(i, d);
    const std::size_t now = states_.hash(c.points);
    if (std::find(c.seen.begin(), c.seen.end(), now) != c.seen.end()) {
      if (only_worst) return;
      only_worst = true;
      c.seen.clear();
    }
    c.seen.push_back(now);
    if (!states_.change_among(c.points, only_worst)) return;
  }
}

}  // namespace scree::coupling
