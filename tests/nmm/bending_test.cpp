// Bending frequencies of a free-free bar against Timoshenko's beam, and their order of convergence.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "model/dense_algebra.h"
#include "tests/support/nmm_block.h"
#include "tests/support/order_table.h"
#include "tests/support/scene.h"

namespace scree::test::bending_test {
namespace {

struct Bar {
  double length = 10.0, height = 0.5;
  Material rock{"rock", 2000.0, 1e9, 0.25};
};

/// det of the two free-end conditions at angular frequency w: the state (deflection, rotation, moment, shear) obeys
///   u' = r + V/(kGA),  r' = M/EI,  M' = -V - rho I w^2 r,  V' = -rho A w^2 u,
/// and free ends have no M and V. Plane stress, k = 10 (1 + nu)/(12 + 11 nu) [Cowper1966].
double free_free(const Bar& bar, double w) {
  const double E = bar.rock.young, nu = bar.rock.poisson, G = E / (2 * (1 + nu)), rho = bar.rock.density,
               A = bar.height, I = std::pow(bar.height, 3) / 12, k = 10 * (1 + nu) / (12 + 11 * nu);
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  D(0, 1) = 1.0;
  D(0, 3) = 1.0 / (k * G * A);
  D(1, 2) = 1.0 / (E * I);
  D(2, 1) = -rho * I * w * w;
  D(2, 3) = -1.0;
  D(3, 0) = -rho * A * w * w;
  // Scaled so that the four components are of one magnitude and the determinant is not lost in round-off.
  const Eigen::Vector4d unit(1.0, 1.0 / bar.length, E * I / std::pow(bar.length, 2), E * I / std::pow(bar.length, 3));
  const Eigen::Matrix4d scaled = unit.cwiseInverse().asDiagonal() * D * unit.asDiagonal() * bar.length;
  const Eigen::Matrix4d T = scaled.exp();
  return T.bottomLeftCorner<2, 2>().determinant();
}

/// The first roots of free_free() above zero, by bisection of sign changes.
std::vector<double> beam_frequencies(const Bar& bar, std::size_t count) {
  const double E = bar.rock.young,
               euler = std::sqrt(E * std::pow(bar.height, 2) / 12 / bar.rock.density) / std::pow(bar.length, 2);
  std::vector<double> found;
  const double step = 0.5 * euler;
  for (double w = 5.0 * euler; found.size() < count; w += step) {
    double low = w, high = w + step;
    if (free_free(bar, low) * free_free(bar, high) > 0.0) continue;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      (free_free(bar, low) * free_free(bar, middle) <= 0.0 ? high : low) = middle;
    }
    found.push_back(0.5 * (low + high));
  }
  return found;
}

/// Lowest frequencies above the rigid motions: subspace iteration on (K + s M)^-1 M with the pool's own lumped mass.
std::vector<double> block_frequencies(const NmmBlock& block, double guess, int count) {
  const Eigen::SparseMatrix<double> K = block.stiffness();
  const int n = static_cast<int>(K.rows()), m = count + 6;
  const std::vector<int> of = [&] {
    int unused = 0;
    return block.unknowns(&unused);
  }();
  const auto mass = [&](const Eigen::VectorXd& x) {
    std::vector<double> v = block.spread(x), p(v.size(), 0.0);
    block.pool.mass().apply(0, block.pool.first_node(1), v, p);
    Eigen::VectorXd out(n);
    for (std::size_t c = 0; c < of.size(); ++c)
      if (of[c] >= 0) out.segment<2>(of[c]) = Vec2(p[2 * c], p[2 * c + 1]);
    return out;
  };
  Eigen::SparseMatrix<double> shifted = K;
  const auto lumped = block.pool.mass().lumped();
  for (std::size_t c = 0; c < of.size(); ++c)
    for (int d = 0; d < 2; ++d)
      if (of[c] >= 0) shifted.coeffRef(of[c] + d, of[c] + d) += guess * guess * lumped[c];
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(shifted);
  Eigen::MatrixXd X = Eigen::MatrixXd::Random(n, m);
  Eigen::VectorXd lambda = Eigen::VectorXd::Zero(m);
  for (int it = 0; it < 60; ++it) {
    // The shift uses the plain row sums as a preconditioner of the corrected mass: iterate, then Rayleigh-Ritz.
    Eigen::MatrixXd Y(n, m);
    for (int j = 0; j < m; ++j) Y.col(j) = solver.solve(mass(X.col(j)));
    Eigen::MatrixXd MY(n, m);
    for (int j = 0; j < m; ++j) MY.col(j) = mass(Y.col(j));
    const Modes ritz = generalized_modes(Y.transpose() * (K * Y), Y.transpose() * MY);
    X = Y * ritz.vectors;
    const double change = (ritz.values - lambda).cwiseAbs().head(3 + count).maxCoeff();
    lambda = ritz.values;
    if (change < 1e-10 * lambda[3 + count - 1]) break;
  }
  std::vector<double> out;
  for (int j = 3; j < 3 + count; ++j) out.push_back(std::sqrt(lambda[j]));
  return out;
}

TEST(Bending, first_three_frequencies_of_a_free_bar) {
  const Bar bar;
  const std::vector<double> beam = beam_frequencies(bar, 3);
  const double euler =
      std::sqrt(bar.rock.young * std::pow(bar.height, 2) / 12 / bar.rock.density) / std::pow(bar.length, 2);
  EXPECT_NEAR(beam[0] / euler, 22.373, 0.3);  // Euler's roots 4.730^2, 7.853^2, 10.996^2, less for shear and inertia
  EXPECT_NEAR(beam[1] / euler, 61.673, 1.6);
  std::vector<OrderRow> rows;
  rows.reserve(3);
  for (int k = 0; k < 3; ++k)
    rows.push_back({"free-free bar: bending frequency " + std::to_string(k + 1) + ", over cover size", {}, {}, 1.6});
  for (const double h : {0.2, 0.1, 0.05}) {
    const NmmBlock block(transformed(rectangle(0.0, 0.0, bar.length, bar.height), Vec2::Zero(), rotation(0.4)),
                         {.cover_size = h}, bar.rock, Plane::stress);
    const std::vector<double> found = block_frequencies(block, beam[0], 3);
    for (std::size_t k = 0; k < 3; ++k) {
      rows[k].size.push_back(h);
      rows[k].error.push_back(std::abs(found[k] / beam[k] - 1.0));
    }
  }
  for (const OrderRow& row : rows) {
    EXPECT_LT(row.error.back(), 0.01);
    expect_order(row);
  }
}

}  // namespace
}  // namespace scree::test::bending_test
