#include "coupling/linear/conjugate_residuals.h"

#include <algorithm>

#include "model/parallel.h"

namespace scree::coupling {
namespace {

constexpr std::size_t kSums = ConjugateResiduals::kDepth + 2;  // per chunk

double dot(const double* u, const double* v, std::int64_t begin, std::int64_t end) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::int64_t i = begin; i < end; ++i) sum += u[i] * v[i];
  return sum;
}

template <class Number>
void subtract(double factor, const Number* u, double* from, std::int64_t begin, std::int64_t end) {
#pragma omp simd
  for (std::int64_t i = begin; i < end; ++i) from[i] -= factor * static_cast<double>(u[i]);
}

/// The largest |r|; not a number if any is none.
double largest_of(const double* r, std::int64_t begin, std::int64_t end) {
  double most = 0.0, sum = 0.0;
#pragma omp simd reduction(max : most) reduction(+ : sum)
  for (std::int64_t i = begin; i < end; ++i) {
    const double size = std::abs(r[i]);
    most = size > most ? size : most;
    sum += size;
  }
  return std::isfinite(sum) ? most : sum;
}

std::size_t chunk_of(std::int64_t begin) { return static_cast<std::size_t>(begin / kChunk); }

/// chunk(begin, end) over [0, n), on threads where there is enough to do for the many short loops of an iteration.
template <class Chunk>
void for_chunks(std::int64_t n, Chunk&& chunk) {
  constexpr std::int64_t kFew = 20000;
  if (n >= kFew) return parallel_for_chunks(n, chunk);
  for (std::int64_t begin = 0; begin < n; begin += kChunk) chunk(begin, std::min(begin + kChunk, n));
}

/// Sum of of(begin, end) over the chunks of [0, n), in their order.
template <class Of>
double sum_of(std::int64_t n, std::vector<double>& partial, Of&& of) {
  for_chunks(n, [&](std::int64_t begin, std::int64_t end) { partial[kSums * chunk_of(begin)] = of(begin, end); });
  double sum = 0.0;
  for (std::int64_t begin = 0; begin < n; begin += kChunk) sum += partial[kSums * chunk_of(begin)];
  return sum;
}

/// The larger; not a number if either is none.
double larger(double a, double b) { return a <= b ? b : (a > b ? a : a + b); }

}  // namespace

void ConjugateResiduals::begin(std::span<const double> unit, bool single) {
  unit_ = unit;
  single_ = single;
  r_.resize(unit.size());
  product_.resize(unit.size());
  partial_.resize(kSums * (chunk_of(static_cast<std::int64_t>(unit.size())) + 1));
}

void ConjugateResiduals::take_residual(std::span<const double> b) {
  const auto n = static_cast<std::int64_t>(r_.size());
  for_chunks(n, [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      r_[i] = (b[i] - product_[i]) / unit_[i];
    partial_[kSums * chunk_of(begin)] = largest_of(r_.data(), begin, end);
  });
  largest_ = 0.0;
  for (std::int64_t begin = 0; begin < n; begin += kChunk)
    largest_ = larger(largest_, partial_[kSums * chunk_of(begin)]);
}

ConjugateResiduals::Correction& ConjugateResiduals::next(std::size_t depth) {
  if (corrections_.size() == depth) corrections_.emplace_back();
  Correction& c = corrections_[depth];
  if (single_)
    c.single.resize(r_.size());
  else
    c.z.resize(r_.size());
  c.q.resize(r_.size());
  for_chunks(static_cast<std::int64_t>(r_.size()), [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      product_[i] = r_[i] * unit_[i];
  });
  return c;
}

double ConjugateResiduals::orthogonalise(std::size_t depth) {
  Correction& c = corrections_[depth];
  const auto n = static_cast<std::int64_t>(r_.size());
  for_chunks(n, [&](std::int64_t begin, std::int64_t end) {
    double* sums = &partial_[kSums * chunk_of(begin)];
    for (std::size_t k = 0; k < depth; ++k) sums[k] = dot(c.q.data(), corrections_[k].q.data(), begin, end);
  });
  std::array<double, kDepth> part{};
  for (std::int64_t begin = 0; begin < n; begin += kChunk)
    for (std::size_t k = 0; k < depth; ++k) part[k] += partial_[kSums * chunk_of(begin) + k];
  for (std::size_t k = 0; k < depth; ++k) {
    part[k] /= corrections_[k].square;
    c.part[k] += part[k];
  }
  return sum_of(n, partial_, [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t k = 0; k < depth; ++k) subtract(part[k], corrections_[k].q.data(), c.q.data(), begin, end);
    return dot(c.q.data(), c.q.data(), begin, end);
  });
}

std::span<const double> ConjugateResiduals::in_double(std::span<const float> z) {
  z_.resize(z.size());
  for_chunks(static_cast<std::int64_t>(z.size()), [&](std::int64_t begin, std::int64_t end) {
    std::copy(z.begin() + begin, z.begin() + end, z_.begin() + begin);
  });
  return z_;
}

bool ConjugateResiduals::correct(std::size_t depth) {
  Correction& c = corrections_[depth];
  const auto n = static_cast<std::int64_t>(r_.size());
  c.part.fill(0.0);
  const double before = sum_of(n, partial_, [&](std::int64_t begin, std::int64_t end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      c.q[i] = product_[i] / unit_[i];
    return dot(c.q.data(), c.q.data(), begin, end);
  });
  constexpr double kLittle = 1e-4;  // of the square: where less is left, cancellation has made it less orthogonal
  c.square = depth > 0 ? orthogonalise(depth) : before;
  if (c.square < kLittle * before) c.square = orthogonalise(depth);
  c.step = sum_of(n, partial_,
                  [&](std::int64_t begin, std::int64_t end) { return dot(r_.data(), c.q.data(), begin, end); }) /
           c.square;
  if (!std::isfinite(c.step) || c.step == 0.0) return false;
  for_chunks(n, [&](std::int64_t begin, std::int64_t end) {
    subtract(c.step, c.q.data(), r_.data(), begin, end);
    partial_[kSums * chunk_of(begin)] = largest_of(r_.data(), begin, end);
  });
  largest_ = 0.0;
  for (std::int64_t begin = 0; begin < n; begin += kChunk)
    largest_ = larger(largest_, partial_[kSums * chunk_of(begin)]);
  return true;
}

void ConjugateResiduals::add_corrections(std::size_t depth, std::span<double> x) {
  std::array<double, kDepth> y{};
  for (std::size_t j = depth; j-- > 0;) {
    y[j] = corrections_[j].step;
    for (std::size_t m = j + 1; m < depth; ++m) y[j] -= corrections_[m].part[j] * y[m];
  }
  for_chunks(static_cast<std::int64_t>(x.size()), [&](std::int64_t begin, std::int64_t end) {
    for (std::size_t j = 0; j < depth; ++j) {
      const Correction& c = corrections_[j];
      if (single_)
        subtract(-y[j], c.single.data(), x.data(), begin, end);
      else
        subtract(-y[j], c.z.data(), x.data(), begin, end);
    }
  });
}

}  // namespace scree::coupling
