#include "nmm/lumped_mass.h"

#include <Eigen/LU>
#include <algorithm>
#include <numeric>

#include "model/dense_algebra.h"
#include "model/parallel.h"

namespace scree::nmm {
namespace {

/// Mass, centre and second moments about it of each connected part.
struct PartMoments {
  double mass = 0.0;
  Vec2 centre{0.0, 0.0};
  Mat2 second = Mat2::Zero();
};

std::vector<PartMoments> part_moments(const CoverMesh& mesh, const ReferenceShape& shape, double density) {
  if (mesh.components == 1) return {{shape.mass, Vec2(0.0, 0.0), shape.second}};
  std::vector<PartMoments> parts(static_cast<std::size_t>(mesh.components));
  std::vector<Moments> of(mesh.elements());
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    of[e] = moments(mesh.material(e));
    PartMoments& p = parts[static_cast<std::size_t>(mesh.component[static_cast<std::size_t>(mesh.cover[e][0])])];
    p.mass += density * of[e].area;
    p.centre += density * of[e].area * of[e].centroid;
  }
  for (PartMoments& p : parts)
    if (p.mass > 0.0) p.centre /= p.mass;
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    PartMoments& p = parts[static_cast<std::size_t>(mesh.component[static_cast<std::size_t>(mesh.cover[e][0])])];
    const Vec2 arm = of[e].centroid - p.centre;
    p.second += density * (of[e].second + of[e].area * arm * arm.transpose());
  }
  return parts;
}

}  // namespace

std::vector<double> row_sums(const CoverMesh& mesh, double density) {
  std::vector<double> raw(mesh.star.size(), 0.0);
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    // Weights are linear: their integral is the area times their value at the centroid.
    const std::array<double, 3> third{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0};
    const auto w = mesh.piece[e] < 0 ? third : mesh.weights(e, mesh.centroid(e));
    for (std::size_t k = 0; k < 3; ++k)
      raw[static_cast<std::size_t>(mesh.cover[e][k])] += density * mesh.area[e] * w[k];
  }
  std::vector<double> lumped = raw;  // row sums of C^T M C are C^T m, because C 1 = 1
  for (const Tie& t : mesh.ties) {
    lumped[static_cast<std::size_t>(t.cover)] = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      lumped[static_cast<std::size_t>(t.root[k])] += t.w[k] * raw[static_cast<std::size_t>(t.cover)];
  }
  return lumped;
}

bool LumpedMass::add(const CoverMesh& mesh, std::int32_t first, const ReferenceShape& shape, MassKind kind) {
  const std::size_t covers = mesh.star.size(), begin = static_cast<std::size_t>(first);
  const double density = shape.mass / mesh.drawn_area();
  std::vector<char> present(static_cast<std::size_t>(mesh.components), 0);  // parts with elements in this mesh
  for (const auto& cover : mesh.cover)
    present[static_cast<std::size_t>(mesh.component[static_cast<std::size_t>(cover[0])])] = 1;
  const auto absent = [&](std::size_t cover) { return present[static_cast<std::size_t>(mesh.component[cover])] == 0; };
  const std::vector<double> lumped = row_sums(mesh, density);
  std::vector<char> tied(covers, 0);
  for (const Tie& t : mesh.ties) tied[static_cast<std::size_t>(t.cover)] = 1;
  for (std::size_t k = 0; k < covers; ++k)
    if (tied[k] == 0 && !absent(k) && !(lumped[k] > 0.0)) return false;

  lumped_.resize(begin);
  lumped_.insert(lumped_.end(), lumped.begin(), lumped.end());
  inverse_.resize(begin + covers);
  unit_.resize(begin + covers);
  X_.resize(begin + covers);
  part_of_.resize(begin + covers);
  const std::vector<PartMoments> exact = part_moments(mesh, shape, density);
  const auto first_part = static_cast<std::int32_t>(parts_.size());
  for (std::size_t k = 0; k < covers; ++k) {
    inverse_[begin + k] = tied[k] != 0 || absent(k) ? 0.0 : 1.0 / lumped[k];
    unit_[begin + k] = lumped[k];
    X_[begin + k] = mesh.star[k] - exact[static_cast<std::size_t>(mesh.component[k])].centre;
    part_of_[begin + k] = first_part + mesh.component[k];
  }
  for (std::int32_t p = 0; p < mesh.components; ++p) {
    Part part;
    part.begin = part.end = static_cast<std::int32_t>(chunks_.size());
    if (present[static_cast<std::size_t>(p)] == 0) {  // its covers are not changed
      parts_.push_back(part);
      continue;
    }
    for (std::size_t from = 0; from < covers; from += kChunk) {
      const std::size_t to = std::min(covers, from + static_cast<std::size_t>(kChunk));
      const auto mine = std::count(mesh.component.begin() + static_cast<std::ptrdiff_t>(from),
                                   mesh.component.begin() + static_cast<std::ptrdiff_t>(to), p);
      if (mine > 0)
        chunks_.push_back({.begin = first + static_cast<std::int32_t>(from),
                           .end = first + static_cast<std::int32_t>(to),
                           .part = first_part + p,
                           .mixed = static_cast<std::size_t>(mine) < to - from});
    }
    part.end = static_cast<std::int32_t>(chunks_.size());
    Eigen::Matrix3d hat = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < covers; ++k) {
      const Eigen::Vector3d P = affine_basis(X_[begin + k]);
      if (mesh.component[k] == p) hat += lumped[k] * P * P.transpose();
    }
    part.hat_inverse = hat.inverse();  // damp() needs the affine part for every kind of mass
    if (kind == MassKind::affine_exact) {
      Eigen::Matrix3d affine = Eigen::Matrix3d::Zero();
      affine(0, 0) = exact[static_cast<std::size_t>(p)].mass;
      affine.bottomRightCorner<2, 2>() = exact[static_cast<std::size_t>(p)].second;
      part.inverse_correction = affine.inverse() - part.hat_inverse;
      part.correction = part.hat_inverse * (hat - affine) * part.hat_inverse;
      part.theta = generalized_eigenvalues(hat, affine)(2);
      const Eigen::Vector3d y = part.hat_inverse * affine.col(0);
      for (std::size_t k = 0; k < covers; ++k)
        if (mesh.component[k] == p) unit_[begin + k] = lumped[k] * affine_basis(X_[begin + k]).dot(y);
    }
    parts_.push_back(part);
  }
  partial_.resize(chunks_.size());
  power_.resize(chunks_.size());
  moment_.resize(parts_.size());
  return true;
}

void LumpedMass::finish(const CoverChart& chart) {
  const auto roots = chart.roots();
  const auto ties = chart.ties();
  const auto root_at = [&](std::int32_t cover) {
    return static_cast<std::size_t>(std::lower_bound(roots.begin(), roots.end(), cover) - roots.begin());
  };
  const auto tie_at = [&](std::int32_t cover) {
    const auto before = [](const Tie& t, std::int32_t c) { return t.cover < c; };
    return static_cast<std::size_t>(std::lower_bound(ties.begin(), ties.end(), cover, before) - ties.begin());
  };
  for (Chunk& c : chunks_) {
    c.first_root = root_at(c.begin);
    c.last_root = root_at(c.end);
    c.first_tie = tie_at(c.begin);
    c.last_tie = tie_at(c.end);
  }
}

template <class See>
void LumpedMass::each_of(const Chunk& chunk, See&& see) const {
  if (chunk.mixed) {
    for (auto k = static_cast<std::size_t>(chunk.begin); k < static_cast<std::size_t>(chunk.end); ++k)
      if (part_of_[k] == chunk.part) see(k);
    return;
  }
#pragma omp simd
  for (auto k = static_cast<std::size_t>(chunk.begin); k < static_cast<std::size_t>(chunk.end); ++k) see(k);
}

template <class Of>
double LumpedMass::sum_of(const Chunk& chunk, Of&& of) const {
  double sum = 0.0;
  if (chunk.mixed) {
    for (auto k = static_cast<std::size_t>(chunk.begin); k < static_cast<std::size_t>(chunk.end); ++k)
      if (part_of_[k] == chunk.part) sum += of(k);
    return sum;
  }
#pragma omp simd reduction(+ : sum)
  for (auto k = static_cast<std::size_t>(chunk.begin); k < static_cast<std::size_t>(chunk.end); ++k) sum += of(k);
  return sum;
}

void LumpedMass::project(std::size_t first, std::size_t last, std::span<const double> v, bool weighted) const {
  if (first == last) return;
  const std::int64_t from = parts_[first].begin, count = parts_[last - 1].end - from;
  const std::int64_t covers = count == 0 ? 0
                                         : chunks_[static_cast<std::size_t>(from + count) - 1].end -
                                               chunks_[static_cast<std::size_t>(from)].begin;
  const double *u = v.data(), *mass = lumped_.data(), *X = X_.data()->data();
  const auto of_chunk = [&](std::int64_t n) {
    const auto c = static_cast<std::size_t>(from + n);
    const Chunk& chunk = chunks_[c];
    double x = 0.0, y = 0.0, Xx = 0.0, Xy = 0.0, Yx = 0.0, Yy = 0.0;
#pragma omp simd reduction(+ : x, y, Xx, Xy, Yx, Yy)
    for (auto k = static_cast<std::size_t>(chunk.begin); k < static_cast<std::size_t>(chunk.end); ++k) {
      const double w = chunk.mixed && part_of_[k] != chunk.part ? 0.0 : (weighted ? mass[k] : 1.0);
      const double ux = w * u[2 * k], uy = w * u[2 * k + 1];
      x += ux;
      y += uy;
      Xx += X[2 * k] * ux;
      Xy += X[2 * k] * uy;
      Yx += X[2 * k + 1] * ux;
      Yy += X[2 * k + 1] * uy;
    }
    partial_[c] << x, y, Xx, Xy, Yx, Yy;
  };
  if (covers < kSerialBelow) {  // a parallel region has a cost even with one thread
    for (std::int64_t n = 0; n < count; ++n) of_chunk(n);
  } else {
#pragma omp parallel for schedule(static)
    for (std::int64_t n = 0; n < count; ++n) of_chunk(n);
  }
  for (std::size_t p = first; p < last; ++p) {
    moment_[p].setZero();
    for (auto c = static_cast<std::size_t>(parts_[p].begin); c < static_cast<std::size_t>(parts_[p].end); ++c)
      moment_[p] += partial_[c];
  }
}

void LumpedMass::solve(const CoverChart& chart, std::span<const double> f, std::span<double> a) const {
  // P^T C^T f: ties keep affine fields, so the moments of the folded forces are those of the forces.
  project(0, parts_.size(), f, false);
  for (std::size_t p = 0; p < parts_.size(); ++p) moment_[p] = (parts_[p].inverse_correction * moment_[p]).eval();
  const auto count = static_cast<std::int64_t>(chunks_.size());
  const double *force = f.data(), *inverse = inverse_.data(), *X = X_.data()->data();
  double* to = a.data();
  // Each thread does all the work on its covers: data written by another core are slow to read.
  const auto all = [&] {
#pragma omp for schedule(static)
    for (std::int64_t n = 0; n < count; ++n) {
      const Chunk& chunk = chunks_[static_cast<std::size_t>(n)];
      const AffineMoments z = moment_[static_cast<std::size_t>(chunk.part)];
      each_of(chunk, [&](std::size_t k) {
        const double Xk = X[2 * k], Yk = X[2 * k + 1];
        to[2 * k] = force[2 * k] * inverse[k] + (z(0, 0) + Xk * z(1, 0) + Yk * z(2, 0));
        to[2 * k + 1] = force[2 * k + 1] * inverse[k] + (z(0, 1) + Xk * z(1, 1) + Yk * z(2, 1));
      });
      for (std::size_t r = chunk.first_root; r < chunk.last_root; ++r) {
        const auto k = static_cast<std::size_t>(chart.roots()[r]);
        if (part_of_[k] == chunk.part) chart.gather(r, f, inverse_[k], a);
      }
    }
    if (!chart.ties().empty())
#pragma omp for schedule(static)
      for (std::int64_t n = 0; n < count; ++n) {
        const Chunk& chunk = chunks_[static_cast<std::size_t>(n)];
        for (std::size_t t = chunk.first_tie; t < chunk.last_tie; ++t)
          if (part_of_[static_cast<std::size_t>(chart.ties()[t].cover)] == chunk.part)
            CoverChart::follow(chart.ties()[t], a);
      }
  };
  if (std::ssize(lumped_) < kSerialBelow) {
    all();
  } else {
#pragma omp parallel
    all();
  }
}

std::pair<std::size_t, std::size_t> LumpedMass::parts_of(std::int32_t begin, std::int32_t end) const {
  auto low = static_cast<std::int32_t>(parts_.size()), high = std::int32_t{-1};
  for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
    low = std::min(low, part_of_[k]);
    high = std::max(high, part_of_[k]);
  }
  return {static_cast<std::size_t>(low), static_cast<std::size_t>(high + 1)};
}

void LumpedMass::apply(std::int32_t begin, std::int32_t end, std::span<const double> v, std::span<double> p) const {
  const auto [first, last] = parts_of(begin, end);
  project(first, last, v, true);
  for (std::size_t i = first; i < last; ++i) moment_[i] = (parts_[i].correction * moment_[i]).eval();
  const double *u = v.data(), *mass = lumped_.data(), *X = X_.data()->data();
  double* to = p.data();
  const auto of_node = [=](std::size_t k, const AffineMoments& z) {
    to[2 * k] = mass[k] * (u[2 * k] - z(0, 0) - X[2 * k] * z(1, 0) - X[2 * k + 1] * z(2, 0));
    to[2 * k + 1] = mass[k] * (u[2 * k + 1] - z(0, 1) - X[2 * k] * z(1, 1) - X[2 * k + 1] * z(2, 1));
  };
  if (last - first == 1) {
    const AffineMoments z = moment_[first];
#pragma omp simd
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) of_node(k, z);
    return;
  }
  for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
    of_node(k, moment_[static_cast<std::size_t>(part_of_[k])]);
}

double LumpedMass::kinetic_energy(std::int32_t begin, std::int32_t end, std::span<const double> v) const {
  double sum = 0.0;
  for (std::int32_t k = begin; k < end; ++k) sum += lumped_[static_cast<std::size_t>(k)] * node(v, k).squaredNorm();
  const auto [first, last] = parts_of(begin, end);
  project(first, last, v, true);
  for (std::size_t p = first; p < last; ++p)
    sum -= (moment_[p].transpose() * parts_[p].correction * moment_[p]).trace();
  return 0.5 * sum;
}

double LumpedMass::damp(double factor, double rate, std::span<const double> along, std::span<double> v,
                        std::span<double> f, std::span<double> a) const {
  project(0, parts_.size(), v, true);
  for (std::size_t p = 0; p < parts_.size(); ++p) moment_[p] = (parts_[p].hat_inverse * moment_[p]).eval();
  const auto count = static_cast<std::int64_t>(chunks_.size());
  const double *mass = lumped_.data(), *X = X_.data()->data(), *u = along.data();
  double *to_v = v.data(), *to_a = a.data(), *to_f = f.data();
#pragma omp parallel for schedule(static) if (std::ssize(lumped_) >= kSerialBelow)
  for (std::int64_t n = 0; n < count; ++n) {
    const Chunk& chunk = chunks_[static_cast<std::size_t>(n)];
    const AffineMoments z = moment_[static_cast<std::size_t>(chunk.part)];
    each_of(chunk, [&](std::size_t k) {
      const double x = z(0, 0) + X[2 * k] * z(1, 0) + X[2 * k + 1] * z(2, 0),
                   y = z(0, 1) + X[2 * k] * z(1, 1) + X[2 * k + 1] * z(2, 1);
      const double wx = factor * (to_v[2 * k] - x), wy = factor * (to_v[2 * k + 1] - y);
      to_v[2 * k] = x + wx;
      to_v[2 * k + 1] = y + wy;
      to_a[2 * k] -= rate * wx;
      to_a[2 * k + 1] -= rate * wy;
      to_f[2 * k] = -rate * mass[k] * wx;  // P^T M_L w = 0, so M w = M_L w
      to_f[2 * k + 1] = -rate * mass[k] * wy;
    });
    power_[static_cast<std::size_t>(n)] =
        sum_of(chunk, [&](std::size_t k) { return to_f[2 * k] * u[2 * k] + to_f[2 * k + 1] * u[2 * k + 1]; });
  }
  return std::accumulate(power_.begin(), power_.end(), 0.0);
}

void LumpedMass::add_weight(std::int32_t begin, std::int32_t end, const Vec2& g, std::span<double> f) const {
  for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
    f[2 * k] += unit_[k] * g.x();
    f[2 * k + 1] += unit_[k] * g.y();
  }
}

double LumpedMass::theta(std::int32_t begin, std::int32_t end) const {
  const auto [first, last] = parts_of(begin, end);
  double most = 1.0;
  for (std::size_t p = first; p < last; ++p) most = std::max(most, parts_[p].theta);
  return most;
}

}  // namespace scree::nmm
