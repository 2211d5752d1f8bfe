// Tangents of the elastic law against finite differences.
#include "model/elasticity.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "model/dense_algebra.h"

namespace scree::elasticity_test {
namespace {

Eigen::Vector4d flat(const Mat2& m) { return Eigen::Map<const Eigen::Vector4d>(m.data()); }

struct Sample {
  Mat2 F, s0;
};

std::vector<Sample> samples() {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<Sample> out;
  for (int i = 0; i < 50; ++i) {
    Mat2 U =
        Mat2::Identity() + 0.2 * (Mat2() << any(generator), any(generator), any(generator), any(generator)).finished();
    const double b = 0.3 * any(generator);
    const Mat2 s0 = (Mat2() << 0.3 * any(generator), b, b, 0.3 * any(generator)).finished();
    out.push_back({rotation(3.0 * any(generator)) * U, s0});
  }
  return out;
}

constexpr double kStep = 1e-5;  // change of F; the error of central differences is about 1e-10 of the modulus

TEST(Tangent, corotational_one_is_the_derivative_of_P_and_symmetric) {
  const Elasticity law = Elasticity::from(1.0, 0.3, Plane::strain);
  for (const Sample& s : samples()) {
    const Tangent D = elastic_tangent(law, s.F, s.s0);
    for (int k = 0; k < 4; ++k) {
      Mat2 dF = Mat2::Zero();
      dF.data()[k] = kStep;
      const Eigen::Vector4d difference =
          flat(elastic_response(law, s.F + dF, s.s0).P - elastic_response(law, s.F - dF, s.s0).P) / (2.0 * kStep);
      EXPECT_LT((D.col(k) - difference).norm(), 1e-7);
    }
    EXPECT_EQ((D - D.transpose()).norm(), 0.0);
  }
}

TEST(Tangent, corotational_one_is_the_second_derivative_of_the_energy) {
  const Elasticity law = Elasticity::from(1.0, 0.2, Plane::stress);
  const double h = 1e-3;  // truncation error h^2, round-off 1e-16/h^2
  for (const Sample& s : samples()) {
    const Tangent D = elastic_tangent(law, s.F, s.s0);
    const auto energy = [&](const Mat2& F) { return elastic_response(law, F, s.s0).energy; };
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        Mat2 a = Mat2::Zero(), b = Mat2::Zero();
        a.data()[i] = h;
        b.data()[j] = h;
        const double difference =
            (energy(s.F + a + b) - energy(s.F + a - b) - energy(s.F - a + b) + energy(s.F - a - b)) / (4.0 * h * h);
        EXPECT_NEAR(D(i, j), difference, 1e-5);
      }
  }
}

TEST(Tangent, linear_one_is_the_derivative_of_its_stress) {
  const Elasticity law = Elasticity::from(2.0, 0.3, Plane::strain);
  const Tangent D = linear_tangent(law);
  for (const Sample& s : samples()) {
    const Mat2 P = linear_response(law, s.F, s.s0).P - s.s0;
    EXPECT_LT((D * flat(s.F - Mat2::Identity()) - flat(P)).norm(), 1e-14);
    EXPECT_NEAR(linear_response(law, s.F, Mat2::Zero()).energy,
                0.5 * flat(s.F - Mat2::Identity()).dot(D * flat(s.F - Mat2::Identity())), 1e-14);
  }
}

TEST(Tangent, positive_part_has_no_negative_eigenvalue_and_keeps_definite_ones) {
  const Elasticity law = Elasticity::from(1.0, 0.3, Plane::strain);
  int indefinite = 0;
  for (const Sample& s : samples()) {
    const Tangent D = elastic_tangent(law, s.F, s.s0), P = positive_part(D);
    const Eigen::Vector4d was = symmetric_eigenvalues(D), is = symmetric_eigenvalues(P);
    if (was[0] < -1e-3) ++indefinite;
    EXPECT_LT((was.cwiseMax(0.0) - is).norm(), 1e-14);
  }
  EXPECT_GT(indefinite, 5);  // some samples are indefinite, because they are compressed
}

TEST(Tangent, material_one_is_semi_definite_and_knows_no_rotation) {
  const Elasticity law = Elasticity::from(1.0, 0.3, Plane::strain);
  for (const Sample& s : samples()) {
    const Tangent D = material_tangent(law, s.F);
    EXPECT_LT((D * flat(quarter_turn() * s.F)).norm(), 1e-14);
    EXPECT_GT(symmetric_eigenvalues(D)(0), -1e-14);
    if ((s.F - Mat2::Identity()).norm() < 1e-9) continue;
    // Without stress the material tangent is the whole tangent.
    const Mat2 R = polar_rotation(s.F);
    EXPECT_LT((material_tangent(law, R) - elastic_tangent(law, R, Mat2::Zero())).norm(), 1e-14);
  }
}

/// A strip is pulled along x and free across: in plane stress its modulus and strain ratio are E and -nu, in plane
/// strain E/(1 - nu^2) and -nu/(1 - nu).
TEST(Elasticity, strip_that_is_free_across_answers_as_a_bar_or_as_a_plate) {
  const double E = 3e9, nu = 0.3, pull = 2e6;
  Mat2 stress = Mat2::Zero();
  stress(0, 0) = pull;
  const Mat2 bar = Elasticity::from(E, nu, Plane::stress).strain(stress),
             plate = Elasticity::from(E, nu, Plane::strain).strain(stress);
  EXPECT_NEAR(bar(0, 0) / (pull / E), 1.0, 1e-14);
  EXPECT_NEAR(bar(1, 1) / (-nu * pull / E), 1.0, 1e-14);
  EXPECT_NEAR(plate(0, 0) / (pull * (1.0 - nu * nu) / E), 1.0, 1e-14);
  EXPECT_NEAR(plate(1, 1) / (-nu * (1.0 + nu) * pull / E), 1.0, 1e-14);
  EXPECT_NEAR((Elasticity::from(E, nu, Plane::stress).stress(bar) - stress).norm(), 0.0, 1e-6);
}

}  // namespace
}  // namespace scree::elasticity_test
