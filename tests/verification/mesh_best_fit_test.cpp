// Transfer of a block to another mesh: the field on the new covers, against the best fit of the old field by dense
// algebra.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "coupling/bodies/setup.h"
#include "coupling/transfer/transfer.h"
#include "model/dense_algebra.h"
#include "nmm/cover_mesh.h"
#include "nmm/field_projection.h"
#include "tests/support/scene.h"

namespace scree::test::mesh_best_fit_test {
namespace {

using nmm::CoverMesh;
using Corners = std::array<Vec2, 3>;

constexpr double kWave = 2.0, kLength = 4.0, kWidth = 0.3;  // wavelength; length and width of the bar [m]

/// Inverse of the matrix with the rows 1, x, y of the three corners: the weights of a point, and their gradients.
Eigen::Matrix3d inverse_corners(const Corners& s) {
  Eigen::Matrix3d A;
  for (int k = 0; k < 3; ++k) A.col(k) << 1.0, s[static_cast<std::size_t>(k)];
  return A.inverse();
}
Eigen::Vector3d weights_at(const Eigen::Matrix3d& inverse, const Vec2& X) {
  return inverse * Eigen::Vector3d(1.0, X.x(), X.y());
}

/// Intersection of a convex polygon with a counter-clockwise convex one.
Ring cut_by(Ring polygon, const Ring& by) {
  for (std::size_t k = 0; k < by.size() && !polygon.empty(); ++k) {
    const Vec2 &a = by[k], d = by[(k + 1) % by.size()] - a;
    Ring kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double at_p = cross(d, p - a), at_q = cross(d, q - a);
      if (at_p >= 0.0) kept.push_back(p);
      if (at_p * at_q < 0.0) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

/// Calls see(X, weight) at points whose weighted sum is the integral of any quadratic over a convex polygon.
template <class See>
void integrate(const Ring& ring, See&& see) {
  for (std::size_t k = 2; k < ring.size(); ++k) {
    const Vec2 &a = ring[0], &b = ring[k - 1], &c = ring[k];
    const double third = cross(b - a, c - a) / 6.0;
    see(0.5 * (a + b), third);
    see(0.5 * (b + c), third);
    see(0.5 * (c + a), third);
  }
}
double area_of(const Ring& ring) {
  double area = 0.0;
  integrate(ring, [&](const Vec2&, double w) { area += w; });
  return area;
}

/// A mesh for dense algebra: only stars, covers, ties and material of the elements. The material is convex.
struct DenseMesh {
  const CoverMesh& mesh;
  std::vector<Ring> material;
  std::vector<Eigen::Matrix3d> inverse;
  Eigen::MatrixXd free;  // covers by unknowns

  explicit DenseMesh(const CoverMesh& m) : mesh(m) {
    for (std::size_t e = 0; e < m.elements(); ++e) {
      material.push_back(m.material(e).outer);
      inverse.push_back(inverse_corners(m.stars(e)));
    }
    std::vector<int> unknown(m.star.size(), 0);
    for (const nmm::Tie& t : m.ties) unknown[static_cast<std::size_t>(t.cover)] = -1;
    int n = 0;
    for (int& u : unknown) u = u < 0 ? -1 : n++;
    free = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(m.star.size()), n);
    for (std::size_t c = 0; c < m.star.size(); ++c)
      if (unknown[c] >= 0) free(static_cast<Eigen::Index>(c), unknown[c]) = 1.0;
    for (const nmm::Tie& t : m.ties)
      for (std::size_t k = 0; k < 3; ++k) free(t.cover, unknown[static_cast<std::size_t>(t.root[k])]) += t.w[k];
  }
  [[nodiscard]] int cover(std::size_t e, int k) const { return mesh.cover[e][static_cast<std::size_t>(k)]; }
  /// Strain xx, yy, 2 xy of an element from x, y per cover: 3 x 6 over its covers.
  [[nodiscard]] Eigen::Matrix<double, 3, 6> strain(std::size_t e) const {
    Eigen::Matrix<double, 3, 6> B = Eigen::Matrix<double, 3, 6>::Zero();
    for (int k = 0; k < 3; ++k) {
      const double x = inverse[e](k, 1), y = inverse[e](k, 2);
      B.col(2 * k) << x, 0.0, y;
      B.col(2 * k + 1) << 0.0, y, x;
    }
    return B;
  }
  [[nodiscard]] Eigen::Vector3d strain_of(std::size_t e, const Eigen::VectorXd& u) const {
    Eigen::Matrix<double, 6, 1> own;
    for (int k = 0; k < 3; ++k) own.segment<2>(2 * k) = u.segment<2>(2 * cover(e, k));
    return strain(e) * own;
  }
};

Eigen::Matrix3d stiffness(const Elasticity& law) {
  const double m = law.lambda + 2.0 * law.mu;
  return (Eigen::Matrix3d() << m, law.lambda, 0.0, law.lambda, m, 0.0, 0.0, 0.0, law.mu).finished();
}

/// Elastic energy of displacements [J].
double energy(const DenseMesh& mesh, const Eigen::Matrix3d& D, const Eigen::VectorXd& u) {
  double sum = 0.0;
  for (std::size_t e = 0; e < mesh.material.size(); ++e) {
    const Eigen::Vector3d s = mesh.strain_of(e, u);
    sum += 0.5 * area_of(mesh.material[e]) * s.dot(D * s);
  }
  return sum;
}

/// Matrices of both best fits of a field of one mesh on another, dense: masses over covers, and
///   int B'^T D B' and int B'^T D e  with e the old strain.
struct BestFit {
  const DenseMesh &from, &to;
  Eigen::MatrixXd mass, mixed;                 // int w' w', int w' w: covers by covers
  Eigen::MatrixXd stiff;                       // over x, y per cover of `to`
  std::vector<std::array<double, 3>> overlap;  // from, to, area

  BestFit(const DenseMesh& a, const DenseMesh& b, const Eigen::Matrix3d& D) : from(a), to(b) {
    const auto n = static_cast<Eigen::Index>(b.mesh.star.size()), old = static_cast<Eigen::Index>(a.mesh.star.size());
    mass = Eigen::MatrixXd::Zero(n, n);
    mixed = Eigen::MatrixXd::Zero(n, old);
    stiff = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    for (std::size_t f = 0; f < b.material.size(); ++f) {
      integrate(b.material[f], [&](const Vec2& X, double w) {
        const Eigen::Vector3d own = weights_at(b.inverse[f], X);
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) mass(b.cover(f, i), b.cover(f, j)) += w * own[i] * own[j];
      });
      const Eigen::Matrix<double, 6, 6> K = area_of(b.material[f]) * b.strain(f).transpose() * D * b.strain(f);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) stiff(2 * b.cover(f, i / 2) + i % 2, 2 * b.cover(f, j / 2) + j % 2) += K(i, j);
      for (std::size_t e = 0; e < a.material.size(); ++e) meet(f, e);
    }
  }
  void meet(std::size_t f, std::size_t e) {
    const Ring both = cut_by(to.material[f], from.material[e]);
    if (both.size() < 3) return;
    integrate(both, [&](const Vec2& X, double w) {
      const Eigen::Vector3d own = weights_at(to.inverse[f], X), other = weights_at(from.inverse[e], X);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) mixed(to.cover(f, i), from.cover(e, j)) += w * own[i] * other[j];
    });
    overlap.push_back({static_cast<double>(e), static_cast<double>(f), area_of(both)});
  }

  /// min int |u' - u|^2
  [[nodiscard]] Eigen::VectorXd in_mass(const Eigen::VectorXd& u) const {
    const Eigen::MatrixXd M = to.free.transpose() * mass * to.free;
    const Eigen::MatrixXd old =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>>(u.data(), u.size() / 2, 2);
    const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> out =
        to.free * solve_positive(M, to.free.transpose() * mixed * old);
    return Eigen::Map<const Eigen::VectorXd>(out.data(), out.size());
  }
  /// min int (e' - e):C:(e' - e), without rigid motion on the covers: the largest energy of u that the mesh can hold.
  [[nodiscard]] Eigen::VectorXd in_energy(const Eigen::Matrix3d& D, const Eigen::VectorXd& u) const {
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(stiff.rows());
    for (const auto& [e, f, area] : overlap) {
      const auto element = static_cast<std::size_t>(f);
      const Eigen::Matrix<double, 6, 1> b =
          area * to.strain(element).transpose() * D * from.strain_of(static_cast<std::size_t>(e), u);
      for (int i = 0; i < 6; ++i) rhs[2 * to.cover(element, i / 2) + i % 2] += b[i];
    }
    Eigen::MatrixXd T = Eigen::MatrixXd::Zero(stiff.rows(), 2 * to.free.cols());
    for (Eigen::Index c = 0; c < to.free.rows(); ++c)
      for (Eigen::Index k = 0; k < to.free.cols(); ++k) T(2 * c, 2 * k) = T(2 * c + 1, 2 * k + 1) = to.free(c, k);
    Eigen::MatrixXd rigid(stiff.rows(), 3);
    for (std::size_t c = 0; c < to.mesh.star.size(); ++c) {
      const auto i = static_cast<Eigen::Index>(2 * c);
      rigid.row(i) << 1.0, 0.0, -to.mesh.star[c].y();
      rigid.row(i + 1) << 0.0, 1.0, to.mesh.star[c].x();
    }
    const Eigen::MatrixXd R = T.transpose() * rigid;  // of the three motions without strain
    const double scale = stiff.trace() / R.squaredNorm();
    const Eigen::MatrixXd K = T.transpose() * stiff * T + scale * R * R.transpose();
    return T * solve_positive(K, T.transpose() * rhs);
  }
};

/// Displacement of a standing P wave along the bar, at a point.
Vec2 mode(const Vec2& X) { return {std::cos(2.0 * std::numbers::pi * (X.x() + 0.5 * kLength) / kWave), 0.0}; }

Eigen::VectorXd on_covers(const CoverMesh& mesh, double size) {
  Eigen::VectorXd u(static_cast<Eigen::Index>(2 * mesh.star.size()));
  for (std::size_t c = 0; c < mesh.star.size(); ++c)
    u.segment<2>(static_cast<Eigen::Index>(2 * c)) = size * mode(mesh.star[c]);
  return u;
}
std::vector<double> places(const CoverMesh& mesh) {
  std::vector<double> x;
  for (const Vec2& X : mesh.star) x.insert(x.end(), {X.x(), X.y()});
  return x;
}

struct Kept {
  double best = 0.0, found = 0.0, by_mass = 0.0;  // elastic energies over that of the old mesh
  double strain_off = 0.0, velocity_off = 0.0;    // differences to the best fits: in the energy norm, over the largest
  double of_wave = 0.0;                           // energy of the old mesh over that of the exact wave
};

/// The standing wave on covers of size h, transferred to covers of size ratio h.
Kept keep(double h, double ratio) {
  const Elasticity law = Elasticity::from(60e9, 0.25, Plane::strain);
  const Eigen::Matrix3d D = stiffness(law);
  const Polygon bar = rectangle(-0.5 * kLength, -0.5 * kWidth, 0.5 * kLength, 0.5 * kWidth);
  const CoverMesh old_mesh = nmm::make_cover_mesh(bar, h), new_mesh = nmm::make_cover_mesh(bar, ratio * h);
  const DenseMesh from(old_mesh), to(new_mesh);
  const BestFit fit(from, to, D);
  Eigen::VectorXd u = on_covers(old_mesh, 1e-4);
  for (const nmm::Tie& t : old_mesh.ties) {  // tied covers follow their roots, as in the pool
    u.segment<2>(2 * t.cover).setZero();
    for (std::size_t k = 0; k < 3; ++k) u.segment<2>(2 * t.cover) += t.w[k] * u.segment<2>(2 * t.root[k]);
  }
  std::vector<double> q = places(old_mesh), v(q.size());
  for (std::size_t i = 0; i < q.size(); ++i) {
    v[i] = 1e4 * u[static_cast<Eigen::Index>(i)];
    q[i] += u[static_cast<Eigen::Index>(i)];
  }
  std::vector<double> q_new(2 * new_mesh.star.size()), v_new(q_new.size());
  nmm::project_motion({&old_mesh, q, v}, new_mesh, law, Kinematics::linear, q_new, v_new);
  const std::vector<double> X = places(new_mesh);
  Eigen::VectorXd moved(static_cast<Eigen::Index>(X.size()));
  for (std::size_t i = 0; i < X.size(); ++i) moved[static_cast<Eigen::Index>(i)] = q_new[i] - X[i];

  const Eigen::VectorXd best = fit.in_energy(D, u), by_mass = fit.in_mass(u);
  const double U = energy(from, D, u), U_best = energy(to, D, best);
  const Eigen::VectorXd speed = Eigen::Map<const Eigen::VectorXd>(v_new.data(), moved.size());
  Kept kept;
  kept.best = U_best / U;
  kept.found = energy(to, D, moved) / U;
  kept.by_mass = energy(to, D, by_mass) / U;
  kept.strain_off = std::sqrt(energy(to, D, moved - best) / U_best);
  kept.velocity_off = (speed - 1e4 * by_mass).cwiseAbs().maxCoeff() / speed.cwiseAbs().maxCoeff();
  const double k = 2.0 * std::numbers::pi / kWave;
  kept.of_wave = U / (0.25 * law.p_modulus() * k * k * 1e-8 * kLength * kWidth);
  return kept;
}

TEST(MeshBestFit, elastic_energy_is_the_most_that_the_new_covers_can_hold) {
  std::printf(
      "covers a wave  h'/h   U/U_wave   best/U   found/U   1 - found/best   strain off   nearest in mass/U   v off\n");
  for (const double ratio : {0.5, 0.7, 2.0}) {
    double before = 0.0;
    for (const double h : {0.2, 0.1}) {
      const Kept k = keep(h, ratio);
      std::printf("%8.0f %9.1f %11.5f %9.5f %9.5f %13.1e %13.1e %15.5f %14.1e", kWave / h, ratio, k.of_wave, k.best,
                  k.found, 1.0 - k.found / k.best, k.strain_off, k.by_mass, k.velocity_off);
      // Velocities are the best fit in the mass norm, within round-off of two solutions.
      EXPECT_LT(k.velocity_off, 1e-10);
      // Displacements are the best fit in the energy norm, up to the term that fixes rigid motion, 1e-6 of the modulus.
      EXPECT_LT(k.strain_off, 1e-6);
      EXPECT_NEAR(k.found, k.best, 1e-7);
      EXPECT_LE(k.best, 1.0 + 1e-12);
      const double lost = 1.0 - k.best;
      if (before > 0.0) {
        std::printf("   order of 1 - best/U %.2f", std::log2(before / lost));
        EXPECT_GT(std::log2(before / lost), 1.7);
      }
      std::printf("\n");
      before = lost;
    }
  }
}

/// The bar translates, rotates and vibrates when a stage begins with other covers.
TEST(MeshBestFit, a_stage_hands_on_the_best_fit_and_the_momenta) {
  const coupling::Methods methods = coupling::standard_methods();
  for (const double ratio : {0.5, 0.7, 2.0}) {
    Scene scene(60e9, 0.25, 2600.0);
    scene.add("bar", rectangle(-0.5 * kLength, -0.5 * kWidth, 0.5 * kLength, 0.5 * kWidth));
    coupling::Stage stage = scene.stage("nmm", coupling::Integrator::explicit_, 1.0, std::nullopt, 0.1);
    stage.kinematics = Kinematics::linear;
    coupling::State state;
    state.bodies = coupling::initial_records(scene.model, coupling::body_requests(scene.model, stage));
    const coupling::Setup setup(scene.model, methods, state.bodies);
    const CoverMesh old_mesh = nmm::make_cover_mesh(state.bodies[0].shape.outline, stage.cover_size),
                    new_mesh = nmm::make_cover_mesh(state.bodies[0].shape.outline, ratio * stage.cover_size);
    ASSERT_EQ(static_cast<std::size_t>(setup.nodes()), old_mesh.star.size());
    state.q = places(old_mesh);
    state.v.resize(state.q.size());
    const Eigen::VectorXd wave = on_covers(old_mesh, 1e-4);
    for (std::size_t k = 0; k < state.q.size(); k += 2) {
      state.v[k] = 0.7 - 0.4 * state.q[k + 1] + 1e3 * wave[static_cast<Eigen::Index>(k)];
      state.v[k + 1] = -0.2 + 0.4 * state.q[k];
      state.q[k] += wave[static_cast<Eigen::Index>(k)];
    }
    setup.pool(0).settle(0, state.q, state.v);
    Eigen::VectorXd u(wave.size());
    const std::vector<double> X = places(old_mesh);
    for (std::size_t i = 0; i < X.size(); ++i) u[static_cast<Eigen::Index>(i)] = state.q[i] - X[i];
    const BodyTotals was = totals_of(setup, state, setup.bodies()[0]);
    state.ledger.set(coupling::Column::elastic, was.elastic);
    state.ledger.open(std::array{was.kinetic});

    const Eigen::Matrix3d D = stiffness(Elasticity::from(60e9, 0.25, Plane::strain));
    const DenseMesh from(old_mesh), to(new_mesh);
    const double U = energy(from, D, u), best = energy(to, D, BestFit(from, to, D).in_energy(D, u));
    stage.cover_size = ratio * stage.cover_size;
    const coupling::TransferReport handed = coupling::transfer_bodies(scene.model, methods, setup, stage, state);
    ASSERT_EQ(handed.rows.size(), 1U);
    const coupling::TransferRow& row = handed.rows[0];
    std::printf("h'/h %.1f: U'/U %.6f, best %.6f, errors of momentum %.0e, angular momentum %.0e\n", ratio,
                row.after.elastic / row.before.elastic, best / U, row.momentum_error, row.angular_error);
    EXPECT_NEAR(row.before.elastic, U, 1e-9 * U);
    EXPECT_NEAR(row.after.elastic, best, 1e-7 * U);
    EXPECT_LE(row.after.kinetic, row.before.kinetic * (1.0 + 1e-12));
    EXPECT_LT(row.momentum_error, 1e-12);
    EXPECT_LT(row.angular_error, 1e-12);
    EXPECT_LT(row.energy_error, 1e-12);
  }
}

}  // namespace
}  // namespace scree::test::mesh_best_fit_test
