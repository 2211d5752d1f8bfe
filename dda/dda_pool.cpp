#include "dda/dda_pool.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "model/outline.h"
#include "model/parallel.h"
#include "model/planar.h"

namespace scree::dda {
namespace {

constexpr std::int64_t kFewBodies = 1000;  // fewer are not worth waking threads for

// The last two nodes hold a summed strain.
constexpr std::array<double, 5> kTranslation{1.0, 0.0, 0.0, 0.0, 0.0};

Row affine_row(std::int32_t first, const Vec2& X) { return {{first, first + 1, first + 2}, {1.0, X.x(), X.y()}}; }

/// The six numbers of a body in q from its first node on, and their rates in v.
AffineState load(std::int32_t first, std::span<const double> q, std::span<const double> v) {
  const auto i = 2 * static_cast<std::size_t>(first);
  AffineState s;
  s.c << q[i], q[i + 1];
  s.F << q[i + 2], q[i + 4], q[i + 3], q[i + 5];
  s.vc << v[i], v[i + 1];
  s.Fdot << v[i + 2], v[i + 4], v[i + 3], v[i + 5];
  return s;
}

void store(std::int32_t first, const Vec2& c, const Mat2& F, std::span<double> q) {
  const auto i = 2 * static_cast<std::size_t>(first);
  q[i] = c.x();
  q[i + 1] = c.y();
  q[i + 2] = F(0, 0);
  q[i + 3] = F(1, 0);
  q[i + 4] = F(0, 1);
  q[i + 5] = F(1, 1);
}

/// The summed strain of BlockRotation::first_order: its columns are the two nodes after those of position.
Mat2 load_strain(std::int32_t first, std::span<const double> q) {
  const auto i = 2 * static_cast<std::size_t>(first) + 6;
  return (Mat2() << q[i], q[i + 2], q[i + 1], q[i + 3]).finished();
}

void store_strain(std::int32_t first, const Mat2& strain, std::span<double> q) {
  std::copy_n(strain.data(), 4, q.begin() + 2 * static_cast<std::ptrdiff_t>(first) + 6);
}

/// Moves the growth of a body that was rotated to first order into its reference shape, so that the remaining stretch
/// is that of the given strain, in the co-rotated axes.
void regrow(const Mat2& R, const Mat2& strain, Release& out) {
  const Mat2 F = R * (Mat2::Identity() + strain), growth = F.inverse() * out.motion.F;
  out.shape.outline = transformed(out.shape.outline, Vec2(0.0, 0.0), growth);
  out.shape.second = growth * out.shape.second * growth.transpose();
  out.motion.F = F;
  out.motion.Fdot = out.motion.Fdot * growth.inverse();
}

/// Lower triangle, column after column.
void put_lower(const Mat6& matrix, std::span<double> lower) {
  std::size_t at = 0;
  for (int j = 0; j < kUnknowns; ++j)
    for (int i = j; i < kUnknowns; ++i) lower[at++] = matrix(i, j);
}

}  // namespace

void DdaPool::add(const Model& model, const BodyRecord& record) {
  const int body = bodies();
  const std::int32_t first = first_node(body);
  Body b;
  b.shape = record.shape;
  b.law = model.elasticity_of(record.block);
  b.initial = InSituStress(model, record).mean();
  b.boundary = affine_boundary(record.shape.outline, body, [&](const Vec2& X) { return affine_row(first, X); });
  b.second_inverse = record.shape.second.inverse();
  if (record.form.rotation == BlockRotation::affine)
    b.affine.emplace(record.shape, b.law, Kinematics::corotational, b.initial);
  b.summed = record.form.rotation == BlockRotation::first_order;
  b.frequency = affine_frequency(record.shape, b.law);
  b.cells = drawing_cells(record.shape.outline);
  first_.push_back(first + (b.summed ? 5 : 3));
  bodies_.push_back(std::move(b));
}

Row DdaPool::row_at(int body, const Vec2& X) const { return affine_row(first_node(body), X); }
std::span<const double> DdaPool::translation(int body) const {
  return std::span(kTranslation).first(of(body).summed ? 5 : 3);
}

DdaPool::Stressed DdaPool::stress_of(int body, std::span<const double> q) const {
  const Body& b = of(body);
  const Mat2 F = load(first_node(body), q, q).F;
  if (!b.summed) {
    const ElasticResponse r = elastic_response(b.law, F, b.initial);
    return {r.energy, r.P};
  }
  // U = 1/2 s:D:s minus that of the in-situ stress alone: the energy of the stretch in the co-rotated axes.
  const Mat2 strain = load_strain(first_node(body), q), stress = b.law.stress(strain);
  return {0.5 * (stress.cwiseProduct(strain).sum() - b.initial.cwiseProduct(b.law.strain(b.initial)).sum()),
          stress * F.transpose().inverse()};
}

void DdaPool::place(int body, const AffineMotion& m, std::span<double> q, std::span<double> v) const {
  store(first_node(body), m.c, m.F, q);
  store(first_node(body), m.vc, m.Fdot, v);
  if (!of(body).summed) return;
  const ElasticResponse r = elastic_response(of(body).law, m.F, of(body).initial);
  store_strain(first_node(body), of(body).law.strain(r.R * r.stress * r.R.transpose()), q);
  store_strain(first_node(body), Mat2::Zero(), v);
}

Release DdaPool::release(int body, std::span<const double> q, std::span<const double> v) const {
  const AffineState s = load(first_node(body), q, v);
  Release out;
  out.shape = of(body).shape;
  out.motion = {s.c, s.F, s.vc, s.Fdot};
  out.initial = of(body).initial;
  if (of(body).summed) {
    const Mat2 R = polar_rotation(s.F), stress = of(body).law.stress(load_strain(first_node(body), q));
    regrow(R, of(body).law.strain(R.transpose() * stress * R - out.initial), out);
  }
  return out;
}

BodyTotals DdaPool::totals(int body, std::span<const double> q, std::span<const double> v) const {
  const AffineState s = load(first_node(body), q, v);
  const ReferenceShape& shape = of(body).shape;
  const Mat2 B = s.Fdot * shape.second * s.F.transpose();
  BodyTotals t;
  t.mass = shape.mass;
  t.centre = s.c;
  t.momentum = shape.mass * s.vc;
  t.angular_momentum = cross(s.c, t.momentum) + B(1, 0) - B(0, 1);
  t.kinetic = 0.5 * shape.mass * s.vc.squaredNorm() + 0.5 * (s.Fdot * shape.second * s.Fdot.transpose()).trace();
  t.elastic = shape.area * stress_of(body, q).energy;
  return t;
}

template <class Of>
double DdaPool::sum_of_bodies(Of&& of_body) const {
  return parallel_sum(
      bodies(), sums_,
      [&](std::int64_t begin, std::int64_t end) {
        double sum = 0.0;
        for (std::int64_t b = begin; b < end; ++b) sum += of_body(static_cast<int>(b));
        return sum;
      },
      kFewBodies);
}

double DdaPool::internal_force(std::span<const double> q, std::span<double> f) const {
  return sum_of_bodies([&](int b) {
    const auto i = 2 * static_cast<std::size_t>(first_node(b));
    const AffineState s = load(first_node(b), q, q);
    const Stressed r = stress_of(b, q);
    const double area = of(b).shape.area;
    f[i + 2] -= area * r.P(0, 0);
    f[i + 3] -= area * r.P(1, 0);
    f[i + 4] -= area * r.P(0, 1);
    f[i + 5] -= area * r.P(1, 1);
    return s.F.determinant() > 0.0 ? area * r.energy : std::numeric_limits<double>::quiet_NaN();
  });
}

Fault DdaPool::find_fault(std::span<const double> q) const {
  for (int b = 0; b < bodies(); ++b) {
    const AffineState s = load(first_node(b), q, q);
    const double J = s.F.determinant();
    if (!std::isfinite(J) || !s.c.allFinite()) return {b, "its position or gradient is not finite"};
    if (J <= 0.0) return {b, fmt::format("it is turned inside out (det F = {:.3g})", J)};
  }
  return {};
}

void DdaPool::stiffness_damping(std::span<const double> q, std::span<const double> v, double rate,
                                std::span<double> f) const {
  // Gradient of the dissipation A0/2 rate U':C:U' by F', U' the rate of the stretch U = R^T F:
  //   R^T F' = omega W U + U',  omega = W:(R^T F')/tr U,  P = R (s + w W),  s = C:U',  w = -(s:WU)/tr U
  for (int b = 0; b < bodies(); ++b) {
    const auto i = 2 * static_cast<std::size_t>(first_node(b));
    const AffineState s = load(first_node(b), q, v);
    const Mat2 R = polar_rotation(s.F), U = R.transpose() * s.F, Z = R.transpose() * s.Fdot, W = quarter_turn(),
               WU = W * U;
    const Mat2 stretching = Z - W.cwiseProduct(Z).sum() / U.trace() * WU;
    const Mat2 stress = of(b).law.stress(0.5 * (stretching + stretching.transpose()));
    const Mat2 P = R * (stress - stress.cwiseProduct(WU).sum() / U.trace() * W);
    const double scale = rate * of(b).shape.area;
    f[i + 2] -= scale * P(0, 0);
    f[i + 3] -= scale * P(1, 0);
    f[i + 4] -= scale * P(0, 1);
    f[i + 5] -= scale * P(1, 1);
  }
}

void DdaPool::body_force(const Vec2& a, std::span<double> f) const {
  for (int b = 0; b < bodies(); ++b) {
    const auto i = 2 * static_cast<std::size_t>(first_node(b));
    f[i] += of(b).shape.mass * a.x();
    f[i + 1] += of(b).shape.mass * a.y();
  }
}

void DdaPool::mass_solve(std::span<const double>, std::span<const double> f, std::span<double> a) const {
  parallel_for(
      bodies(),
      [&](std::int64_t at) {
        const auto b = static_cast<int>(at);
        const AffineState s = load(first_node(b), f, f);
        const Body& body = of(b);
        store(first_node(b), s.c / body.shape.mass, s.F * body.second_inverse, a);
        if (body.summed) store_strain(first_node(b), Mat2::Zero(), a);
      },
      kFewBodies);
}

void DdaPool::mass_apply(int body, std::span<const double>, std::span<const double> v, std::span<double> p) const {
  const AffineState s = load(first_node(body), v, v);
  store(first_node(body), of(body).shape.mass * s.c, s.F * of(body).shape.second, p);
  if (of(body).summed) store_strain(first_node(body), Mat2::Zero(), p);
}

double DdaPool::kinetic_energy(std::span<const double> q, std::span<const double> v,
                               std::span<const char> counted) const {
  return sum_of_bodies([&](int b) {
    if (counted[static_cast<std::size_t>(b)] == 0) return 0.0;
    const AffineState s = load(first_node(b), q, v);
    const ReferenceShape& shape = of(b).shape;
    return 0.5 * shape.mass * s.vc.squaredNorm() + 0.5 * (s.Fdot * shape.second * s.Fdot.transpose()).trace();
  });
}

double DdaPool::compliance(int body, const Row& row) const {
  const Vec2 X(row.w[1], row.w[2]);
  return row.w[0] * row.w[0] / of(body).shape.mass + X.dot(of(body).second_inverse * X);
}

void DdaPool::bound_groups(int body, const Row&, std::vector<std::int32_t>& groups) const {
  groups.assign(1, first_node(body));
}

ChartRow DdaPool::chart_row(int body, const Row& row, std::span<const double> q) const {
  const std::int32_t first = first_node(body);
  std::array<double, 3> w = row.w;
  if (row.node[0] != first || row.node[1] != first + 1 || row.node[2] != first + 2) {  // the nodes are in another order
    w = {};
    for (std::size_t k = 0; k < 3; ++k) w[static_cast<std::size_t>(row.node[k] - first)] += row.w[k];
  }
  if (of(body).affine) return of(body).affine->chart_row(w[0], {w[1], w[2]});
  const Mat26 T = shi_matrix(load(first, q, q).F * Vec2(w[1], w[2]));
  ChartRow out;
  out.n = kUnknowns;
  for (int k = 0; k < kUnknowns; ++k) {
    const auto at = static_cast<std::size_t>(k);
    out.dof[at] = k;
    out.tx[at] = k < 2 ? w[0] * T(0, k) : T(0, k);
    out.ty[at] = k < 2 ? w[0] * T(1, k) : T(1, k);
  }
  return out;
}

ElementDofs DdaPool::element_dofs(int) const { return {{0, kUnknowns}, {0, 1, 2, 3, 4, 5}}; }

void DdaPool::element_masses(int body, std::span<const double> q, std::span<double> mass) const {
  if (of(body).affine) return of(body).affine->mass(mass);
  const Mat2 F = load(first_node(body), q, q).F;
  put_lower(mass_matrix(of(body).shape.mass, F * of(body).shape.second * F.transpose()), mass);
}

void DdaPool::rates(int body, std::span<const double> q, std::span<const double> v, std::span<double> rate) const {
  const AffineState s = load(first_node(body), q, v);
  if (of(body).affine) return of(body).affine->unknowns(s.vc, s.Fdot, rate);
  Eigen::Map<Vec6>(rate.data()) = rates_of(s.vc, s.Fdot * s.F.inverse());
}

double DdaPool::linearise(int body, std::span<const double> q, Stiffness kind, std::span<double> stiffness,
                          std::span<double> force) const {
  const Body& b = of(body);
  const Mat2 F = load(first_node(body), q, q).F;
  if (b.affine) return b.affine->linearise(F, kind, stiffness, force);
  if (!stiffness.empty()) put_lower(stiffness_matrix(b.shape.area, b.law), stiffness);
  if (b.summed) {
    const Stressed r = stress_of(body, q);
    Eigen::Map<Vec6>(force.data()) = unknowns_of_stress(b.shape.area, r.P * F.transpose());
    return b.shape.area * r.energy;
  }
  Eigen::Map<Vec6>(force.data()) = scree::dda::internal_force(b.shape.area, b.law, F, b.initial);
  return b.shape.area * elastic_response(b.law, F, b.initial).energy;
}

void DdaPool::retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
                      std::span<double> v) const {
  const AffineState before = load(first_node(body), q, v);
  if (const auto& affine = of(body).affine) {
    store(first_node(body), before.c + AffineForm::translation(d), before.F + affine->gradient(d), q);
    store(first_node(body), AffineForm::translation(rate), affine->gradient(rate), v);
    return;
  }
  const Vec6 D(d.data());
  const AffineState after =
      of(body).summed ? first_order_update(before, D, Vec6(rate.data())) : exact_update(before, D, Vec6(rate.data()));
  if (of(body).summed) {
    const Mat2 L = step_gradient(D);
    store_strain(first_node(body), load_strain(first_node(body), q) + 0.5 * (L + L.transpose()), q);
  }
  store(first_node(body), after.c, after.F, q);
  store(first_node(body), after.vc, after.Fdot, v);
}

void DdaPool::topology(MeshPart& mesh) const {
  mesh.offsets.assign(1, 0);
  for (int b = 0; b < bodies(); ++b) {
    const ReferenceShape& shape = of(b).shape;
    const AffineMotion origin = affine_fit(shape.outline, shape.origin);
    // Outline vertices have exact initial positions; of several vertices at one place the first is used.
    std::map<std::pair<double, double>, Vec2> corners;
    for (std::size_t r = 0; r < shape.outline.rings(); ++r)
      for (std::size_t i = 0; i < shape.outline.ring(r).size(); ++i) {
        const Vec2& X = shape.outline.ring(r)[i];
        corners.emplace(std::pair(X.x(), X.y()), shape.origin.ring(r)[i]);
      }
    const auto origin_of = [&](const Vec2& X) -> Vec2 {
      const auto corner = corners.find({X.x(), X.y()});
      return corner != corners.end() ? corner->second : Vec2(origin.c + origin.F * X);
    };
    for (const Ring& ring : of(b).cells) {
      for (const Vec2& X : ring) {
        mesh.connectivity.push_back(static_cast<std::int32_t>(mesh.points.size()));
        mesh.points.push_back(affine_row(first_node(b), X));
        mesh.origin.push_back(origin_of(X));
      }
      mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
      mesh.body.push_back(b);
    }
  }
}

Mat2 DdaPool::cauchy(int body, std::span<const double> q) const {
  const Mat2 F = load(first_node(body), q, q).F;
  const Mat2 s = stress_of(body, q).P * F.transpose() / F.determinant();
  return 0.5 * (s + s.transpose());
}

void DdaPool::stress(std::span<const double> q, std::span<double> cells) const {
  std::size_t cell = 0;
  for (int b = 0; b < bodies(); ++b) {
    const Mat2 s = cauchy(b, q);
    for (std::size_t k = 0; k < of(b).cells.size(); ++k, ++cell) {
      cells[3 * cell] = s(0, 0);
      cells[3 * cell + 1] = s(1, 1);
      cells[3 * cell + 2] = s(0, 1);
    }
  }
}

void DdaPool::recovered_stress(std::span<const double> q, std::span<const char>, std::span<double> nodes) const {
  // Rows have the weight 1 on the first node of a block, its centre: every point gets the stress of the block.
  std::fill(nodes.begin(), nodes.end(), 0.0);
  for (int b = 0; b < bodies(); ++b) {
    const Mat2 s = cauchy(b, q);
    const auto centre = 3 * static_cast<std::size_t>(first_node(b));
    nodes[centre] = s(0, 0);
    nodes[centre + 1] = s(1, 1);
    nodes[centre + 2] = s(0, 1);
  }
}

}  // namespace scree::dda
