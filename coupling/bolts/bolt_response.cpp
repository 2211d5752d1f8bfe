#include "coupling/bolts/bolt_response.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::coupling {
namespace {

constexpr int kIterations = 200, kHalvings = 60;
constexpr double kBalanced = 1e-13;   // of the largest force
constexpr double kLeastSlope = 1e-6;  // of the elastic one, so that Newton's matrix stays regular where all slips

/// Stiffness of a crossing of a bolt, or of a turn of a liner.
double cross_stiffness(const Bolt& bolt, std::size_t c) {
  return bolt.liner() ? bolt.turn_stiffness(c) : bolt.shear_stiffness;
}

double strength_in_compression(const Bolt& bolt, std::size_t segment) {
  if (bolt.liner()) return bolt.crushing;
  return bolt.slack(segment) ? 0.0 : bolt.yield;
}

/// A force that is linear up to a strength: the force itself, and its slope as a share of the elastic one.
struct Plastic {
  double force, slope;
};
Plastic plastic_law(double stiffness, double elongation, double least, double most) {
  const double trial = stiffness * elongation, force = std::clamp(trial, least, most);
  return {force, trial == force ? 1.0 : 0.0};
}

}  // namespace

BoltResponse::BoltResponse(const Bolt& bolt) : bolt_(&bolt) {
  const std::size_t n = bolt.nodes.size();
  for (std::size_t j = 0; j + 1 < n; ++j) k_.push_back(bolt.segment_stiffness(j));
  for (auto* v : {&slip_, &bond_, &bond_slope_, &residual_, &step_, &diagonal_, &scratch_, &old_}) v->assign(n, 0.0);
  for (auto* v : {&force_, &slope_}) v->assign(n - 1, 0.0);
  shear_slope_.assign(bolt.crossings.size() + bolt.turns(), 0.0);
}

double BoltResponse::evaluate(const BoltMemory& before, std::span<const double> lengths) {
  const std::size_t n = slip_.size();
  for (std::size_t j = 0; j + 1 < n; ++j) {
    const double e = lengths[j] - before.rest[j] + slip_[j + 1] - slip_[j] - before.plastic[j];
    if (j == 0 && pulled_ >= 0.0) {
      force_[j] = pulled_;
      slope_[j] = 0.0;
    } else if (!carries(j)) {
      force_[j] = slope_[j] = 0.0;
    } else {
      const Plastic p = plastic_law(k_[j], e, -strength_in_compression(*bolt_, j), bolt_->yield);
      force_[j] = p.force;
      slope_[j] = p.slope;
    }
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    residual_[i] = bond_[i] = bond_slope_[i] = 0.0;
    if (held(i)) continue;
    const Plastic p = plastic_law(bond_stiffness(i), slip_[i] - before.slipped[i], -bond_strength(i), bond_strength(i));
    bond_[i] = p.force;
    bond_slope_[i] = p.slope;
    residual_[i] = p.force + (i > 0 ? force_[i - 1] : 0.0) - (i + 1 < n ? force_[i] : 0.0);
    if (!(std::abs(residual_[i]) <= worst)) worst = std::abs(residual_[i]);
  }
  return worst;
}

double BoltResponse::round_off(const BoltMemory& before, std::span<const double> lengths) const {
  double most = 0.0;
  for (std::size_t j = 0; j < k_.size(); ++j)
    if (carries(j))
      most = std::max(most, k_[j] * (std::abs(lengths[j] - before.rest[j]) + std::abs(slip_[j]) +
                                     std::abs(slip_[j + 1]) + std::abs(before.plastic[j])));
  return 4.0 * std::numeric_limits<double>::epsilon() * most;
}

double BoltResponse::go(double part, const BoltMemory& before, std::span<const double> lengths) {
  for (std::size_t i = 0; i < slip_.size(); ++i) slip_[i] = old_[i] + part * step_[i];
  return evaluate(before, lengths);
}

double BoltResponse::search(const BoltMemory& before, std::span<const double> lengths) {
  // The slope along the step increases with the distance, since the function to be minimised is convex.
  double low = 0.0, high = 1.0, worst = 0.0;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double part = halving == 0 ? 1.0 : 0.5 * (low + high);
    worst = go(part, before, lengths);
    double slope = 0.0;
    for (std::size_t i = 0; i < slip_.size(); ++i) slope += residual_[i] * step_[i];
    if (slope <= 0.0) {
      low = part;
      if (halving == 0) break;
    } else {
      high = part;
    }
  }
  return worst;
}

void BoltResponse::newton_step() {
  // Elimination from the toe: H has -k' beside its diagonal.
  const std::size_t n = slip_.size();
  const auto k = [&](std::size_t j) { return (carries(j) ? std::max(slope_[j], kLeastSlope) : 0.0) * k_[j]; };
  for (std::size_t i = 0; i < n; ++i) {
    step_[i] = held(i) ? 0.0 : -residual_[i];
    diagonal_[i] = held(i) ? 1.0
                           : std::max(bond_slope_[i], kLeastSlope) * bond_stiffness(i) + (i > 0 ? k(i - 1) : 0.0) +
                                 (i + 1 < n ? k(i) : 0.0);
  }
  for (std::size_t i = n - 1; i-- > 0;) {
    if (held(i) || held(i + 1)) continue;
    const double factor = k(i) / diagonal_[i + 1];
    diagonal_[i] -= factor * k(i);
    step_[i] += factor * step_[i + 1];
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (held(i)) continue;
    if (i > 0 && !held(i - 1)) step_[i] += k(i - 1) * step_[i - 1];
    step_[i] /= diagonal_[i];
  }
}

bool BoltResponse::solve(const BoltMemory& before, std::span<const double> lengths, std::span<const double> shears,
                         BoltMemory& after) {
  const std::size_t n = slip_.size();
  broken_ = before.broken;
  std::copy(before.slip.begin(), before.slip.end(), slip_.begin());
  double worst = evaluate(before, lengths);
  bool found = false;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    double largest = 0.0;
    for (const double f : force_) largest = std::max(largest, std::abs(f));
    for (const double f : bond_) largest = std::max(largest, std::abs(f));
    const double least = std::max(kBalanced * largest, round_off(before, lengths));
    found = worst <= least;
    if (found) break;
    newton_step();
    old_ = slip_;
    const double left = worst;
    worst = go(1.0, before, lengths);
    if (!(worst <= 0.5 * left)) worst = search(before, lengths);
    if (!std::isfinite(worst)) return false;
    if (worst >= left && worst <= 8.0 * least) {  // round-off
      slip_ = old_;
      worst = evaluate(before, lengths);
      found = true;
      break;
    }
  }
  if (!found) return false;
  after.slip = slip_;
  after.force = force_;
  after.bond = bond_;
  after.rest = before.rest;
  after.broken = before.broken;
  after.plastic = before.plastic;
  after.slipped = before.slipped;
  after.offset = before.offset;
  after.installed = before.installed;
  after.slack = 0.0;
  after.breaking = 0.0;
  double lost = 0.0;
  for (std::size_t j = 0; j + 1 < n; ++j) {
    if (slope_[j] != 0.0 || !carries(j) || (j == 0 && pulled_ >= 0.0)) continue;
    const double e = lengths[j] - before.rest[j] + slip_[j + 1] - slip_[j];
    if (force_[j] == 0.0) {
      after.slack = e - before.plastic[j];
      continue;
    }
    after.plastic[j] = e - force_[j] / k_[j];
    lost += force_[j] * (after.plastic[j] - before.plastic[j]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (held(i) || bond_slope_[i] != 0.0) continue;
    after.slipped[i] = slip_[i] - bond_[i] / bond_stiffness(i);
    lost += bond_[i] * (after.slipped[i] - before.slipped[i]);
  }
  after.dissipated = before.dissipated + lost;
  shear_forces(before, shears, after);
  after.energy = bolt_energy(*bolt_, after);
  return true;
}

void BoltResponse::shear_forces(const BoltMemory& before, std::span<const double> shears, BoltMemory& after) {
  after.shear.resize(shears.size());
  after.sheared = before.sheared;
  for (std::size_t c = 0; c < shears.size(); ++c) {
    if (!carries_across(c)) {
      after.shear[c] = shear_slope_[c] = 0.0;
      continue;
    }
    const double elastic = shears[c] - before.offset[c] - before.sheared[c];
    const double k = cross_stiffness(*bolt_, c);
    const Plastic p = plastic_law(k, elastic, -bolt_->shear_strength, bolt_->shear_strength);
    after.shear[c] = p.force;
    shear_slope_[c] = p.slope * k;
    if (p.slope != 0.0) continue;
    const double more = elastic - p.force / k;
    after.sheared[c] += more;
    after.dissipated += p.force * more;
  }
}

bool BoltResponse::carries_across(std::size_t c) const {
  if (bolt_->liner()) return carries(c) && carries(bolt_->segment_after(c));
  return carries(static_cast<std::size_t>(bolt_->crossings[c].segment));
}

void BoltResponse::tangent(const BoltMemory& after, Eigen::MatrixXd& out) {
  broken_ = after.broken;
  const auto n = static_cast<Eigen::Index>(slip_.size()), m = n - 1;
  Eigen::MatrixXd H = Eigen::MatrixXd::Identity(n, n), G = Eigen::MatrixXd::Zero(n, m);
  out = Eigen::MatrixXd::Zero(m, m);
  for (Eigen::Index i = 0; i < n; ++i)
    if (!held(static_cast<std::size_t>(i)))
      H(i, i) =
          std::max(bond_slope_[static_cast<std::size_t>(i)], kLeastSlope) * bond_stiffness(static_cast<std::size_t>(i));
  for (Eigen::Index j = 0; j < m; ++j) {
    const auto s = static_cast<std::size_t>(j);
    const double k = slope_[s] * k_[s];
    out(j, j) = k;
    const bool a = !held(s), b = !held(s + 1);
    if (a) H(j, j) += k, G(j, j) = -k;
    if (b) H(j + 1, j + 1) += k, G(j + 1, j) = k;
    if (a && b) H(j, j + 1) = H(j + 1, j) = -k;
  }
  out -= G.transpose() * H.ldlt().solve(G);
}

bool BoltResponse::tangent_changed(std::vector<double>& slopes, const BoltMemory& after) {
  scratch_.assign(slope_.begin(), slope_.end());
  scratch_.insert(scratch_.end(), bond_slope_.begin(), bond_slope_.end());
  for (const std::int8_t b : after.broken) scratch_.push_back(b);
  if (scratch_ == slopes) return false;
  slopes = scratch_;
  return true;
}

double BoltResponse::elastic_change(const BoltMemory& before, const BoltMemory& after) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < k_.size(); ++j) {
    const double change = after.force[j] - before.force[j];
    sum += 0.5 * change * change / k_[j];
  }
  sum += after.force[0] * (after.slack - before.slack);
  for (std::size_t i = 0; i < slip_.size(); ++i) {
    if (held(i)) continue;
    const double change = after.bond[i] - before.bond[i];
    sum += 0.5 * change * change / bond_stiffness(i);
  }
  for (std::size_t c = 0; c < after.shear.size(); ++c) {
    const double change = after.shear[c] - before.shear[c];
    if (change != 0.0) sum += 0.5 * change * change / cross_stiffness(*bolt_, c);
  }
  return sum;
}

void BoltResponse::install(std::span<const double> lengths, std::span<const double> shears, BoltMemory& memory) {
  const std::size_t n = slip_.size();
  BoltMemory begin;
  begin.rest.assign(lengths.begin(), lengths.end());
  begin.offset.assign(shears.begin(), shears.end());
  begin.plastic.assign(n - 1, 0.0);
  begin.force = begin.plastic;
  begin.broken.assign(n - 1, 0);
  begin.slip.assign(n, 0.0);
  begin.slipped = begin.bond = begin.slip;
  begin.sheared.assign(shears.size(), 0.0);
  begin.shear = begin.sheared;
  begin.installed = 1;
  // The jack holds the force of the first segment; then its length is locked where it has that force.
  if (bolt_->pretension > 0.0) pulled_ = bolt_->pretension;
  if (!solve(begin, lengths, shears, memory)) {  // the bond cannot bear it: no pretension
    memory = begin;
    pulled_ = -1.0;
  }
  if (pulled_ >= 0.0) memory.rest[0] = lengths[0] + memory.slip[1] - memory.slip[0] - pulled_ / k_[0];
  pulled_ = -1.0;
}

bool BoltResponse::rupture(BoltMemory& memory) const {
  bool broke = false;
  for (std::size_t j = 0; j < k_.size(); ++j) {
    if (memory.broken[j] != 0) continue;
    const double length = bolt_->nodes[j + 1].at - bolt_->nodes[j].at;
    bool breaks = memory.plastic[j] > bolt_->rupture_strain * length;
    for (std::size_t c = 0; c < bolt_->crossings.size(); ++c)
      breaks = breaks || (static_cast<std::size_t>(bolt_->crossings[c].segment) == j &&
                          std::abs(memory.sheared[c]) > bolt_->rupture_shear);
    if (!breaks) continue;
    broke = true;
    memory.broken[j] = 1;
  }
  return broke;
}

double bolt_energy(const Bolt& bolt, const BoltMemory& memory) {
  double sum = 0.0;
  for (std::size_t j = 0; j < memory.force.size(); ++j)
    sum += 0.5 * memory.force[j] * memory.force[j] / bolt.segment_stiffness(j);
  for (std::size_t i = 0; i < memory.bond.size(); ++i)
    if (bolt.nodes[i].length > 0.0)
      sum += 0.5 * memory.bond[i] * memory.bond[i] / (bolt.bond_stiffness * bolt.nodes[i].length);
  for (std::size_t c = 0; c < memory.shear.size(); ++c)
    if (const double q = memory.shear[c]; q != 0.0) sum += 0.5 * q * q / cross_stiffness(bolt, c);
  return sum;
}

}  // namespace scree::coupling
