#include "coupling/integrate/block_system.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "model/parallel.h"

namespace scree::coupling {
namespace {

/// B += u v^T + w z^T.
void add_products(const DoubleColumn& u, const double* v, const DoubleColumn& w, const double* z, double* block) {
  for (int c = 0; c < kBlockSide; ++c, block += kBlockSide) {
    DoubleColumn sum(block);
    sum.add(v[c], u, z[c], w);
    sum.store(block);
  }
}

constexpr std::int64_t kFewBodies = 1000;  // below it loops over bodies run on one thread

/// True if a row has all unknowns of its bodies, at most two.
bool couples_pair(const DofRow& row) {
  const std::size_t n = row.dof.size();
  if (n % kBlockSide != 0 || n > 2 * kBlockSide) return false;
  for (std::size_t i = 0; i < n; i += kBlockSide)  // unknowns are in order, each once
    if (row.dof[i] % kBlockSide != 0 || row.dof[i + kBlockSide - 1] != row.dof[i] + kBlockSide - 1) return false;
  return true;
}

}  // namespace

bool BlockSystem::begin(const DofRows& rows, std::size_t springs) {
  rows_ = &rows;
  springs_ = springs;
  const std::size_t units = springs + (rows.size() - springs) / 2;
  found_.resize(units);
  const double more = parallel_largest(
      static_cast<std::int64_t>(units),
      [&](std::int64_t at) {
        const auto u = static_cast<std::size_t>(at);
        const DofRow row = rows[u < springs ? u : springs + 2 * (u - springs)];
        if (!couples_pair(row)) return 1.0;
        found_[u] = {row.dof.empty() ? -1 : row.dof[0] / kBlockSide,
                     row.dof.size() <= kBlockSide ? -1 : row.dof[kBlockSide] / kBlockSide};
        return 0.0;
      },
      kFewPoints);
  if (more > 0.0) return false;
  k_.clear();  // the values of the matrix are outdated: its rows are those of another step
  tangent_.clear();
  changed_.clear();
  if (found_ == bodies_ && matrix_.rows() > 0) return true;
  bodies_ = found_;
  find_incidences();
  return true;
}

void BlockSystem::find_incidences() {
  const std::int32_t n = system_->dofs() / kBlockSide;
  const auto same = [](const BlockMatrix::Pair& p, const BlockMatrix::Pair& q) {
    return p[0] == q[0] && p[1] == q[1];  // operator== calls memcmp
  };
  pairs_.clear();
  for (const BlockMatrix::Pair& p : bodies_)
    if (p[1] >= 0 && (pairs_.empty() || !same(p, pairs_.back()))) pairs_.push_back(p);
  // Which of two vertices that nearly coincide is a contact point changes from step to step: most lists that differ in
  // their points have the same pairs of bodies.
  matrix_.find(pairs_, places_);
  if (!matrix_.has_pattern(n, pairs_, places_)) {
    matrix_.set_pattern(n, pairs_);
    matrix_.find(pairs_, places_);
  }
  first_.assign(static_cast<std::size_t>(n) + 1, 0);
  for (const BlockMatrix::Pair& p : bodies_)
    for (const std::int32_t b : p)
      if (b >= 0) ++first_[static_cast<std::size_t>(b) + 1];
  for (std::size_t b = 0; b < static_cast<std::size_t>(n); ++b) first_[b + 1] += first_[b];
  incidence_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  std::size_t pair = 0;  // number of those begun: several points in succession may have the same
  for (std::size_t u = 0; u < bodies_.size(); ++u) {
    const auto [a, b] = bodies_[u];
    if (b >= 0 && (pair == 0 || !same(bodies_[u], pairs_[pair - 1]))) ++pair;
    const BlockMatrix::Pair places = b >= 0 ? places_[pair - 1] : BlockMatrix::Pair{-1, -1};
    const auto unit = static_cast<std::int32_t>(u);
    const auto put = [&](std::int32_t body, const Incidence& i) {
      incidence_[static_cast<std::size_t>(next[static_cast<std::size_t>(body)]++)] = i;
    };
    if (a >= 0) put(a, {unit, 0, b >= 0 ? kBlockSide : -1, places[0]});
    if (b >= 0) put(b, {unit, kBlockSide, 0, places[1]});
  }
}

bool BlockSystem::begin_assembly(std::span<const double> A, bool fresh, std::span<const double> k,
                                 std::span<const double> at, std::size_t points) {
  const auto bodies = static_cast<std::size_t>(matrix_.rows());
  const bool all = fresh || k_.size() != k.size() || tangent_.size() != points || changed_.size() != bodies;
  if (all) changed_.assign(bodies, 1);
  tangent_.resize(points);
  k_.assign(k.begin(), k.end());  // springs stay as they are during a step
  constant_.resize(rows_->size());
  for (std::size_t s = 0; s < k.size(); ++s) constant_[s] = -k[s] * (at[s] + (*rows_)[s].known);
  A_ = A;
  return all;
}

void BlockSystem::take(std::size_t point, const LinearContactForce& force, bool all) {
  const PointTangent& k = force.k;
  const std::size_t row = springs_ + 2 * point;
  const double gap = rows_->known()[row], stretch = rows_->known()[row + 1];
  constant_[row] = force.normal - k.nn * gap - k.nt * stretch;
  constant_[row + 1] = force.tangential - k.tn * gap - k.tt * stretch;
  if (all) {
    tangent_[point] = k;
    return;
  }
  if (tangent_[point] == k) return;
  tangent_[point] = k;
  for (const std::int32_t b : bodies_of(point))
    if (b >= 0) std::atomic_ref(changed_[static_cast<std::size_t>(b)]).store(1, std::memory_order_relaxed);
}

void BlockSystem::end_assembly() {
  parallel_for(
      matrix_.rows(), [this](std::int64_t b) { refresh(static_cast<std::int32_t>(b)); }, kFewBodies);
}

void BlockSystem::set(std::size_t point, const PointTangent& tangent) {
  tangent_[point] = tangent;
  for (const std::int32_t b : bodies_of(point))
    if (b >= 0) changed_[static_cast<std::size_t>(b)] = 1;
}

void BlockSystem::refresh(std::int32_t body) {
  if (changed_[static_cast<std::size_t>(body)] == 0) return;
  changed_[static_cast<std::size_t>(body)] = 0;
  sum_row(body);
}

void BlockSystem::sum_row(std::int32_t body) {
  matrix_.clear_row(body);
  double* own = matrix_.block(matrix_.diagonal(body));
  const double* value =
      &A_[static_cast<std::size_t>(system_->pattern().column_start[kBlockSide * static_cast<std::size_t>(body)])];
  for (int c = 0; c < kBlockSide; ++c)
    for (int r = c; r < kBlockSide; ++r) own[kBlockSide * c + r] = own[kBlockSide * r + c] = *value++;
  const auto b = static_cast<std::size_t>(body);
  for (auto i = static_cast<std::size_t>(first_[b]); i < static_cast<std::size_t>(first_[b + 1]); ++i) {
    const Incidence& at = incidence_[i];
    const auto unit = static_cast<std::size_t>(at.unit);
    if (unit >= springs_) {
      if (!tangent_[unit - springs_].zero()) add_point(at, body);
      continue;
    }
    if (k_[unit] == 0.0) continue;
    const double* h = &rows_->h()[static_cast<std::size_t>(rows_->start()[unit])];
    const auto add = [&](int of, double* block) {
      for (int c = 0; c < kBlockSide; ++c)
        for (int r = 0; r < kBlockSide; ++r) block[kBlockSide * c + r] += h[at.own + r] * (k_[unit] * h[of + c]);
    };
    add(at.own, own);
    if (at.other >= 0) add(at.other, matrix_.block(at.place));
  }
}

void BlockSystem::add_point(const Incidence& at, std::int32_t body) {
  const auto point = static_cast<std::size_t>(at.unit) - springs_;
  const std::size_t row = springs_ + 2 * point;
  const PointTangent& k = tangent_[point];
  const double *n = &rows_->h()[static_cast<std::size_t>(rows_->start()[row])],
               *t = &rows_->h()[static_cast<std::size_t>(rows_->start()[row + 1])];
  const DoubleColumn own_n(n + at.own), own_t(t + at.own);
  const auto add = [&](int of, double* block) {
    double normal[kBlockSide], tangential[kBlockSide];
    const DoubleColumn of_n(n + of), of_t(t + of);
    DoubleColumn sum;
    sum.set(k.nn, of_n, k.nt, of_t);
    sum.store(normal);
    sum.set(k.tn, of_n, k.tt, of_t);
    sum.store(tangential);
    add_products(own_n, normal, own_t, tangential, block);
  };
  add(at.own, matrix_.block(matrix_.diagonal(body)));
  if (at.other >= 0) add(at.other, matrix_.block(at.place));
}

double BlockSystem::elongation(std::size_t row, std::size_t unit, std::span<const double> x) const {
  const double* h = &rows_->h()[static_cast<std::size_t>(rows_->start()[row])];
  DoubleColumn products;
  for (const std::int32_t body : bodies_[unit]) {
    if (body < 0) break;
    products.add_products(DoubleColumn(h), DoubleColumn(&x[kBlockSide * static_cast<std::size_t>(body)]));
    h += kBlockSide;
  }
  return products.sum();
}

void BlockSystem::subtract_own(std::int32_t body, std::span<const double> x, double* sum) const {
  const auto first = kBlockSide * static_cast<std::size_t>(body);
  const double *of_body = &x[first], *value = &A_[static_cast<std::size_t>(system_->pattern().column_start[first])];
  for (int c = 0; c < kBlockSide; ++c) {
    sum[c] -= *value++ * of_body[c];
    for (int r = c + 1; r < kBlockSide; ++r, ++value) {
      sum[r] -= *value * of_body[c];
      sum[c] -= *value * of_body[r];
    }
  }
}

template <bool Constant>
void BlockSystem::find_force(std::size_t unit, std::span<const double> x) {
  if (unit < springs_) {
    force_[unit] = k_[unit] != 0.0 ? k_[unit] * elongation(unit, unit, x) - (Constant ? constant_[unit] : 0.0) : 0.0;
    return;
  }
  const PointTangent& k = tangent_[unit - springs_];
  const std::size_t row = springs_ + 2 * (unit - springs_);
  force_[row] = Constant ? -constant_[row] : 0.0;
  force_[row + 1] = Constant ? -constant_[row + 1] : 0.0;
  if (k.zero()) return;
  const double gap = elongation(row, unit, x), stretch = elongation(row + 1, unit, x);
  force_[row] += k.nn * gap + k.nt * stretch;
  force_[row + 1] += k.tn * gap + k.tt * stretch;
}

template <bool Constant>
void BlockSystem::multiply_rows(std::span<const double> x, std::span<double> y) {
  force_.resize(rows_->size());
  parallel_for(
      std::ssize(bodies_), [&](std::int64_t unit) { find_force<Constant>(static_cast<std::size_t>(unit), x); },
      kFewPoints);
  const auto of_body = [&](std::int64_t at) {
    const auto body = static_cast<std::int32_t>(at);
    double of_A[kBlockSide] = {};
    subtract_own(body, x, of_A);
    DoubleColumn sum(of_A);
    sum.scale(-1.0);
    add_forces(body, sum);
    sum.store(&y[kBlockSide * static_cast<std::size_t>(at)]);
  };
  parallel_for(matrix_.rows(), of_body, kFewBodies);
}

void BlockSystem::multiply(std::span<const double> x, std::span<double> y) { multiply_rows<false>(x, y); }

void BlockSystem::balance(std::span<const double> x, std::span<double> y) { multiply_rows<true>(x, y); }

double BlockSystem::largest_force() const {
  return parallel_largest(
      std::ssize(force_), [this](std::int64_t row) { return std::abs(force_[static_cast<std::size_t>(row)]); },
      2 * kFewPoints);
}

void BlockSystem::add_forces(std::int32_t body, DoubleColumn& sum) const {
  for (const Incidence& i : incidences(body)) {
    const auto unit = static_cast<std::size_t>(i.unit);
    const std::size_t row = unit < springs_ ? unit : springs_ + 2 * (unit - springs_);
    if (force_[row] != 0.0) sum.add(force_[row], coefficients(row, i.own));
    if (unit >= springs_ && force_[row + 1] != 0.0) sum.add(force_[row + 1], coefficients(row + 1, i.own));
  }
}

}  // namespace scree::coupling
