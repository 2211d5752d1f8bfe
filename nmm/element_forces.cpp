#include "nmm/element_forces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "model/parallel.h"

namespace scree::nmm {
namespace {

constexpr std::int32_t kRun = 32;               // cells or single elements per run
constexpr std::int32_t kChunkElements = 128;    // of a chunk
constexpr std::int64_t kSerialElements = 4000;  // fewer run serially: waking threads costs more

/// A P, A W and det F of many elements from A C and the edges' gradients; one entry per element in each array.
struct Lanes {
  alignas(64) double F00[kRun], F01[kRun], F10[kRun], F11[kRun];
  alignas(64) double P00[kRun], P01[kRun], P10[kRun], P11[kRun];
  alignas(64) double energy[kRun], det[kRun];
};

/// R = polar(F), e = R^T F - I, s = C:e + s0, P = R (s + w W), W = 1/2 e:C:e + s0:e (see elastic_response()).
/// lambda, two_mu and s0 are multiplied by the element's area.
struct Corotational {
  template <bool Initial>
  static inline void evaluate(double lambda, double two_mu, double s00, double s11, double s01, double F00, double F01,
                              double F10, double F11, double& P00, double& P01, double& P10, double& P11,
                              double& energy, double& det) {
    const double a = F00 + F11, b = F10 - F01, r = 1.0 / std::sqrt(a * a + b * b), c = a * r, s = b * r;
    const double U00 = c * F00 + s * F10, U11 = c * F11 - s * F01, U01 = c * F01 + s * F11;
    const double e00 = U00 - 1.0, e11 = U11 - 1.0, trace = lambda * (e00 + e11);
    double t00 = trace + two_mu * e00, t11 = trace + two_mu * e11, t01 = two_mu * U01;
    energy = 0.5 * (t00 * e00 + t11 * e11) + t01 * U01;
    det = F00 * F11 - F01 * F10;
    double t10 = t01;
    if constexpr (Initial) {
      energy += s00 * e00 + s11 * e11 + 2.0 * s01 * U01;
      t00 += s00;
      t11 += s11;
      t01 += s01;
      t10 = t01;
      const double w = -((t10 * U00 + t11 * U01) - (t00 * U01 + t01 * U11)) / (U00 + U11);
      t01 -= w;
      t10 += w;
    }
    P00 = c * t00 - s * t10;
    P01 = c * t01 - s * t11;
    P10 = s * t00 + c * t10;
    P11 = s * t01 + c * t11;
  }
};

/// s = C:sym(F - I) + s0.
struct Linear {
  template <bool Initial>
  static inline void evaluate(double lambda, double two_mu, double s00, double s11, double s01, double F00, double F01,
                              double F10, double F11, double& P00, double& P01, double& P10, double& P11,
                              double& energy, double& det) {
    const double e00 = F00 - 1.0, e11 = F11 - 1.0, e01 = 0.5 * (F01 + F10), trace = lambda * (e00 + e11);
    double t00 = trace + two_mu * e00, t11 = trace + two_mu * e11, t01 = two_mu * e01;
    energy = 0.5 * (t00 * e00 + t11 * e11) + t01 * e01;
    det = 1.0;
    if constexpr (Initial) {
      energy += s00 * e00 + s11 * e11 + 2.0 * s01 * e01;
      t00 += s00;
      t11 += s11;
      t01 += s01;
    }
    P00 = t00;
    P01 = P10 = t01;
    P11 = t11;
  }
};

/// Sum of n <= kRun energies in four strands; not a number where a determinant is not positive.
double sum_of(const double* energy, const double* det, std::int32_t n) {
  double sum[4] = {0.0, 0.0, 0.0, 0.0};
  int bad = 0;
  for (std::int32_t i = 0; i < n; ++i) bad += det[i] > 0.0 ? 0 : 1;
  for (std::int32_t i = 0; i < n; ++i) sum[i & 3] += energy[i];
  return bad == 0 ? (sum[0] + sum[1]) + (sum[2] + sum[3]) : std::numeric_limits<double>::quiet_NaN();
}

/// The two triangles of each of n cells. Differences of positions against the first cover, d = x_1 - x_0 and x_2 - x_0,
/// give F = d_1 g_1^T + d_2 g_2^T because the gradients sum to zero.
template <class Law>
double strip(const ElementLaw& law, double area, const Gradients& up, const Gradients& down, std::int32_t n,
             const double* qb, const double* qt, double* fb, double* ft) {
  const double lambda = area * law.law.lambda, two_mu = 2.0 * area * law.law.mu;
  alignas(64) double bx[kRun + 1], by[kRun + 1], tx[kRun + 1], ty[kRun + 1];
  // Forces on covers 1 and 2 of the two triangles of cell i are at i + 1; the ends stay zero.
  alignas(64) double u1x[kRun + 2], u1y[kRun + 2], u2x[kRun + 2], u2y[kRun + 2];
  alignas(64) double v1x[kRun + 2], v1y[kRun + 2], v2x[kRun + 2], v2y[kRun + 2];
  alignas(64) double energy[kRun], det[kRun];
#pragma omp simd
  for (std::int32_t i = 0; i <= n; ++i) {
    bx[i] = qb[2 * i];
    by[i] = qb[2 * i + 1];
    tx[i] = qt[2 * i];
    ty[i] = qt[2 * i + 1];
  }
  const double p1x = up(0, 1), p1y = up(1, 1), p2x = up(0, 2), p2y = up(1, 2);
  const double m1x = down(0, 1), m1y = down(1, 1), m2x = down(0, 2), m2y = down(1, 2);
  u1x[0] = u1y[0] = u2x[0] = u2y[0] = v1x[0] = v1y[0] = v2x[0] = v2y[0] = 0.0;
  u1x[n + 1] = u1y[n + 1] = u2x[n + 1] = u2y[n + 1] = v1x[n + 1] = v1y[n + 1] = v2x[n + 1] = v2y[n + 1] = 0.0;
#pragma omp simd
  for (std::int32_t i = 0; i < n; ++i) {
    double P00, P01, P10, P11, Wu, Ju, Wd, Jd;
    {
      const double ax = bx[i + 1] - bx[i], ay = by[i + 1] - by[i], cx = tx[i] - bx[i], cy = ty[i] - by[i];
      Law::template evaluate<false>(lambda, two_mu, 0.0, 0.0, 0.0, ax * p1x + cx * p2x, ax * p1y + cx * p2y,
                                    ay * p1x + cy * p2x, ay * p1y + cy * p2y, P00, P01, P10, P11, Wu, Ju);
      u1x[i + 1] = P00 * p1x + P01 * p1y;
      u1y[i + 1] = P10 * p1x + P11 * p1y;
      u2x[i + 1] = P00 * p2x + P01 * p2y;
      u2y[i + 1] = P10 * p2x + P11 * p2y;
    }
    {
      const double ax = tx[i + 1] - bx[i + 1], ay = ty[i + 1] - by[i + 1], cx = tx[i] - bx[i + 1],
                   cy = ty[i] - by[i + 1];
      Law::template evaluate<false>(lambda, two_mu, 0.0, 0.0, 0.0, ax * m1x + cx * m2x, ax * m1y + cx * m2y,
                                    ay * m1x + cy * m2x, ay * m1y + cy * m2y, P00, P01, P10, P11, Wd, Jd);
      v1x[i + 1] = P00 * m1x + P01 * m1y;
      v1y[i + 1] = P10 * m1x + P11 * m1y;
      v2x[i + 1] = P00 * m2x + P01 * m2y;
      v2y[i + 1] = P10 * m2x + P11 * m2y;
    }
    energy[i] = Wu + Wd;
    det[i] = Ju < Jd ? Ju : Jd;
  }
#pragma omp simd
  for (std::int32_t i = 0; i <= n; ++i) {
    fb[2 * i] += (u1x[i + 1] + u2x[i + 1]) + ((v1x[i] + v2x[i]) - u1x[i]);
    fb[2 * i + 1] += (u1y[i + 1] + u2y[i + 1]) + ((v1y[i] + v2y[i]) - u1y[i]);
    ft[2 * i] -= (u2x[i + 1] + v2x[i + 1]) + v1x[i];
    ft[2 * i + 1] -= (u2y[i + 1] + v2y[i + 1]) + v1y[i];
  }
  return sum_of(energy, det, n);
}

template <class Law, bool Initial>
void evaluate_lanes(double lambda, double mu, const double* area, const std::array<double, 3>* s0, std::int32_t n,
                    Lanes& l) {
#pragma omp simd
  for (std::int32_t i = 0; i < n; ++i) {
    const double A = area[i];
    double s00 = 0.0, s11 = 0.0, s01 = 0.0;
    if constexpr (Initial) {
      s00 = A * s0[i][0];
      s11 = A * s0[i][1];
      s01 = A * s0[i][2];
    }
    Law::template evaluate<Initial>(A * lambda, 2.0 * A * mu, s00, s11, s01, l.F00[i], l.F01[i], l.F10[i], l.F11[i],
                                    l.P00[i], l.P01[i], l.P10[i], l.P11[i], l.energy[i], l.det[i]);
  }
}

}  // namespace

void ElementForces::add(const CoverMesh& mesh, std::int32_t first, double scale, const ElementLaw& law,
                        std::vector<std::array<double, 3>> initial) {
  const auto first_shape = static_cast<std::uint32_t>(shapes_.size()), own = static_cast<std::uint32_t>(laws_.size());
  shapes_.insert(shapes_.end(), mesh.shapes.begin(), mesh.shapes.end());
  laws_.push_back(law);
  if (!initial.empty() || !initial_.empty()) {
    initial_.resize(cover_.size(), {0.0, 0.0, 0.0});
    initial.resize(mesh.elements(), {0.0, 0.0, 0.0});
    initial_.insert(initial_.end(), initial.begin(), initial.end());
  }
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    cover_.push_back({mesh.cover[e][0] + first, mesh.cover[e][1] + first, mesh.cover[e][2] + first});
    shape_.push_back(first_shape + mesh.shape[e]);
    law_.push_back(own);
    area_.push_back(scale * mesh.area[e]);
    whole_.push_back(mesh.piece[e] < 0 ? 1 : 0);
  }
}

bool ElementForces::is_cell(std::size_t e) const {
  if (e + 1 >= cover_.size() || whole_[e] == 0 || whole_[e + 1] == 0 || law_[e] != law_[e + 1]) return false;
  const auto &up = cover_[e], &down = cover_[e + 1];
  return shape_[e] + 1 == shape_[e + 1] && up[1] == up[0] + 1 && down[0] == up[1] && down[2] == up[2] &&
         down[1] == up[2] + 1;
}

void ElementForces::find_runs() {
  for (std::size_t e = 0; e < cover_.size();) {
    Run run;
    run.element = static_cast<std::int32_t>(e);
    if (initial_.empty() && is_cell(e)) {
      run.bottom = cover_[e][0];
      run.top = cover_[e][2];
      while (run.count < kRun && is_cell(e) && law_[e] == law_[static_cast<std::size_t>(run.element)] &&
             cover_[e][0] == run.bottom + run.count && cover_[e][2] == run.top + run.count) {
        ++run.count;
        e += 2;
      }
    } else {
      while (e < cover_.size() && run.count < kRun && law_[e] == law_[static_cast<std::size_t>(run.element)] &&
             !(initial_.empty() && is_cell(e))) {
        ++run.count;
        ++e;
      }
    }
    runs_.push_back(run);
  }
}

void ElementForces::colour_chunks(std::int32_t covers) {
  std::vector<Chunk> chunks;
  for (std::int32_t r = 0; r < static_cast<std::int32_t>(runs_.size());) {
    Chunk chunk{r, r};
    for (std::int32_t elements = 0; r < static_cast<std::int32_t>(runs_.size()) && elements < kChunkElements; ++r) {
      const Run& run = runs_[static_cast<std::size_t>(r)];
      elements += run.bottom < 0 ? run.count : 2 * run.count;
    }
    chunk.end = r;
    chunks.push_back(chunk);
  }
  // The first colour that no other chunk with one of the same covers has; a cover belongs to few chunks.
  std::vector<std::uint32_t> used(static_cast<std::size_t>(covers), 0);
  std::vector<int> colour(chunks.size());
  int colours = 0;
  const auto elements_of = [&](const Chunk& chunk, auto&& see) {
    for (std::int32_t r = chunk.begin; r < chunk.end; ++r) {
      const Run& run = runs_[static_cast<std::size_t>(r)];
      const std::int32_t count = run.bottom < 0 ? run.count : 2 * run.count;
      for (std::int32_t e = run.element; e < run.element + count; ++e) see(cover_[static_cast<std::size_t>(e)]);
    }
  };
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    std::uint32_t taken = 0;
    elements_of(chunks[c], [&](const auto& cover) {
      for (const std::int32_t k : cover) taken |= used[static_cast<std::size_t>(k)];
    });
    colour[c] = std::countr_one(taken);
    if (colour[c] >= 32) throw std::runtime_error("a cover belongs to more chunks of elements than there are colours");
    elements_of(chunks[c], [&](const auto& cover) {
      for (const std::int32_t k : cover) used[static_cast<std::size_t>(k)] |= std::uint32_t{1} << colour[c];
    });
    colours = std::max(colours, colour[c] + 1);
  }
  for (int k = 0; k < colours; ++k) {
    colour_start_.push_back(static_cast<std::int32_t>(chunks_.size()));
    for (std::size_t c = 0; c < chunks.size(); ++c)
      if (colour[c] == k) chunks_.push_back(chunks[c]);
  }
  colour_start_.push_back(static_cast<std::int32_t>(chunks_.size()));
  partial_.resize(chunks_.size());
}

void ElementForces::finish(std::int32_t covers) {
  find_runs();
  colour_chunks(covers);
}

double ElementForces::cells(const Run& run, const double* q, double* f) const {
  const auto e = static_cast<std::size_t>(run.element);
  const ElementLaw& law = laws_[law_[e]];
  const Gradients &up = shapes_[shape_[e]], &down = shapes_[shape_[e + 1]];
  const double *qb = q + 2 * static_cast<std::size_t>(run.bottom), *qt = q + 2 * static_cast<std::size_t>(run.top);
  double *fb = f + 2 * static_cast<std::size_t>(run.bottom), *ft = f + 2 * static_cast<std::size_t>(run.top);
  return law.kinematics == Kinematics::linear ? strip<Linear>(law, area_[e], up, down, run.count, qb, qt, fb, ft)
                                              : strip<Corotational>(law, area_[e], up, down, run.count, qb, qt, fb, ft);
}

double ElementForces::singles(const Run& run, const double* q, double* f) const {
  const auto first = static_cast<std::size_t>(run.element);
  const auto n = static_cast<std::size_t>(run.count);
  const ElementLaw& law = laws_[law_[first]];
  Lanes l;  // NOLINT(cppcoreguidelines-pro-type-member-init): each lane is written before it is read
  for (std::size_t i = 0; i < n; ++i) {
    const auto& c = cover_[first + i];
    const Gradients& g = shapes_[shape_[first + i]];
    const double *x0 = q + 2 * static_cast<std::size_t>(c[0]), *x1 = q + 2 * static_cast<std::size_t>(c[1]),
                 *x2 = q + 2 * static_cast<std::size_t>(c[2]);
    const double ax = x1[0] - x0[0], ay = x1[1] - x0[1], bx = x2[0] - x0[0], by = x2[1] - x0[1];
    l.F00[i] = ax * g(0, 1) + bx * g(0, 2);
    l.F01[i] = ax * g(1, 1) + bx * g(1, 2);
    l.F10[i] = ay * g(0, 1) + by * g(0, 2);
    l.F11[i] = ay * g(1, 1) + by * g(1, 2);
  }
  const double *area = area_.data() + first, lambda = law.law.lambda, mu = law.law.mu;
  const std::array<double, 3>* s0 = initial_.empty() ? nullptr : initial_.data() + first;
  const bool linear = law.kinematics == Kinematics::linear;
  if (s0 == nullptr)
    linear ? evaluate_lanes<Linear, false>(lambda, mu, area, s0, run.count, l)
           : evaluate_lanes<Corotational, false>(lambda, mu, area, s0, run.count, l);
  else
    linear ? evaluate_lanes<Linear, true>(lambda, mu, area, s0, run.count, l)
           : evaluate_lanes<Corotational, true>(lambda, mu, area, s0, run.count, l);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& c = cover_[first + i];
    const Gradients& g = shapes_[shape_[first + i]];
    double *f0 = f + 2 * static_cast<std::size_t>(c[0]), *f1 = f + 2 * static_cast<std::size_t>(c[1]),
           *f2 = f + 2 * static_cast<std::size_t>(c[2]);
    const double ax = l.P00[i] * g(0, 1) + l.P01[i] * g(1, 1), ay = l.P10[i] * g(0, 1) + l.P11[i] * g(1, 1),
                 bx = l.P00[i] * g(0, 2) + l.P01[i] * g(1, 2), by = l.P10[i] * g(0, 2) + l.P11[i] * g(1, 2);
    f0[0] += ax + bx;
    f0[1] += ay + by;
    f1[0] -= ax;
    f1[1] -= ay;
    f2[0] -= bx;
    f2[1] -= by;
  }
  return sum_of(l.energy, l.det, run.count);
}

double ElementForces::add_force(std::span<const double> q, std::span<double> f) const {
  const auto by_colour = [&] {
    for (std::size_t colour = 0; colour + 1 < colour_start_.size(); ++colour) {
#pragma omp for schedule(static)
      for (std::int32_t c = colour_start_[colour]; c < colour_start_[colour + 1]; ++c) {
        const Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
        double energy = 0.0;
        for (std::int32_t r = chunk.begin; r < chunk.end; ++r) {
          const Run& run = runs_[static_cast<std::size_t>(r)];
          energy += run.bottom < 0 ? singles(run, q.data(), f.data()) : cells(run, q.data(), f.data());
        }
        partial_[static_cast<std::size_t>(c)] = energy;
      }
    }
  };
  if (static_cast<std::int64_t>(cover_.size()) < kSerialElements) {  // a parallel region has a cost even then
    by_colour();
  } else {
#pragma omp parallel
    by_colour();
  }
  double sum = 0.0;
  for (const double e : partial_) sum += e;
  return sum;
}

void ElementForces::add_rate_force(std::span<const double> q, std::span<const double> v, double rate,
                                   std::span<double> f) const {
  const auto count = static_cast<std::int64_t>(cover_.size());
#pragma omp parallel if (count >= kSerialElements)
  for (std::size_t colour = 0; colour + 1 < colour_start_.size(); ++colour) {
#pragma omp for schedule(static)
    for (std::int32_t c = colour_start_[colour]; c < colour_start_[colour + 1]; ++c) {
      const Chunk& chunk = chunks_[static_cast<std::size_t>(c)];
      const Run &first = runs_[static_cast<std::size_t>(chunk.begin)],
                &last = runs_[static_cast<std::size_t>(chunk.end - 1)];
      const std::int32_t end = last.element + (last.bottom < 0 ? last.count : 2 * last.count);
      for (auto e = static_cast<std::size_t>(first.element); e < static_cast<std::size_t>(end); ++e) {
        const ElementLaw& law = laws_[law_[e]];
        const Mat2 F = gradient(e, q), rate_of_F = gradient(e, v);
        Mat2 P;
        if (law.kinematics == Kinematics::linear) {
          P = law.law.stress(0.5 * (rate_of_F + rate_of_F.transpose()));
        } else {
          const Mat2 R = polar_rotation(F), U = R.transpose() * F, B = R.transpose() * rate_of_F;
          const double spin = (B(1, 0) - B(0, 1)) / U.trace();
          Mat2 s = law.law.stress(B - spin * quarter_turn() * U);
          s = 0.5 * (s + s.transpose()).eval();
          const Mat2 sU = s * U;
          P = R * (s - (sU(1, 0) - sU(0, 1)) / U.trace() * quarter_turn());
        }
        const Mat2 AP = rate * area_[e] * P;
        for (int k = 0; k < 3; ++k) {
          const Vec2 force = AP * shapes_[shape_[e]].col(k);
          const auto i = 2 * static_cast<std::size_t>(cover_[e][static_cast<std::size_t>(k)]);
          f[i] -= force.x();
          f[i + 1] -= force.y();
        }
      }
    }
  }
}

Mat2 ElementForces::initial_stress(std::size_t e) const {
  if (initial_.empty()) return Mat2::Zero();
  return (Mat2() << initial_[e][0], initial_[e][2], initial_[e][2], initial_[e][1]).finished();
}

Mat2 ElementForces::gradient(std::size_t e, std::span<const double> q) const {
  const auto& c = cover_[e];
  const Gradients& g = shapes_[shape_[e]];
  const Vec2 x0 = node(q, c[0]);
  return (node(q, c[1]) - x0) * g.col(1).transpose() + (node(q, c[2]) - x0) * g.col(2).transpose();
}

ElasticResponse ElementForces::response(std::size_t e, std::span<const double> q) const {
  const ElementLaw& l = law(e);
  const Mat2 F = gradient(e, q), s0 = initial_stress(e);
  return l.kinematics == Kinematics::linear ? linear_response(l.law, F, s0) : elastic_response(l.law, F, s0);
}

}  // namespace scree::nmm
