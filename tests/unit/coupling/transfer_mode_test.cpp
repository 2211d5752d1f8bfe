// Releases after limit_release(), against formulas by hand.
#include "coupling/transfer/transfer_mode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/nmm_block.h"
#include "tests/support/schemes.h"

namespace scree::test::transfer_mode_test {
namespace {

using namespace coupling;

/// A body of 3 kg with second moments 2 and 5 kg m2, strain rates 0.4 and -0.1 1/s and a spin of 0.7 rad/s.
struct Leaving {
  static constexpr double kSpin = 0.7, kX = 0.4, kY = -0.1, kXX = 2.0, kYY = 5.0;
  Release release;
  explicit Leaving(double rest) {
    release.shape.mass = 3.0;
    release.shape.area = 1.0;
    release.shape.second << kXX, 0.0, 0.0, kYY;
    release.motion.vc = {0.2, -0.3};
    release.motion.Fdot << kX, -kSpin, kSpin, kY;
    release.kinetic_rest = rest;
    release.velocity_rest = {0.1, -0.2, 0.3, 0.4};
  }
  /// Kinetic energy of the strain rates, (e_x^2 S_xx + e_y^2 S_yy)/2.
  static double deforming() { return 0.5 * (kX * kX * kXX + kY * kY * kYY); }
};

TEST(TakeAlong, reservoir_changes_nothing) {
  Leaving l(1.0);
  EXPECT_EQ(limit_release(TransferMode::reservoir, 1.1, l.release), 0.0);
  EXPECT_EQ(l.release.kinetic_rest, 1.0);
  EXPECT_EQ(l.release.motion.Fdot(0, 0), Leaving::kX);
  EXPECT_EQ(l.release.velocity_rest[3], 0.4);
}

TEST(TakeAlong, strain_rates_take_the_rest_where_the_cap_lets_them) {
  const double rest = 0.1 * Leaving::deforming();
  Leaving l(rest);
  const double before = kinetic_of(l.release.shape, l.release.motion);
  EXPECT_EQ(limit_release(TransferMode::strain_rate, 1.1, l.release), 0.0);
  const double factor = std::sqrt(1.1);  // 1.049: below the cap
  EXPECT_NEAR(l.release.motion.Fdot(0, 0), factor * Leaving::kX, 1e-14);
  EXPECT_NEAR(l.release.motion.Fdot(1, 1), factor * Leaving::kY, 1e-14);
  EXPECT_NEAR(l.release.motion.Fdot(1, 0), Leaving::kSpin, 1e-14);
  EXPECT_NEAR(l.release.motion.Fdot(0, 1), -Leaving::kSpin, 1e-14);
  EXPECT_NEAR(l.release.kinetic_rest, 0.0, 1e-14);
  EXPECT_NEAR(kinetic_of(l.release.shape, l.release.motion), before + rest, 1e-14);
}

TEST(TakeAlong, cap_limits_the_strain_rates_and_leaves_the_remainder_in_the_reservoir) {
  const double rest = 2.0 * Leaving::deforming();
  for (const double cap : {1.0, 1.1, 1.5}) {
    Leaving l(rest);
    const double before = kinetic_of(l.release.shape, l.release.motion);
    EXPECT_EQ(limit_release(TransferMode::strain_rate, cap, l.release), 0.0);
    EXPECT_NEAR(l.release.motion.Fdot(0, 0), cap * Leaving::kX, 1e-14);
    const double left = rest - (cap * cap - 1.0) * Leaving::deforming();
    EXPECT_NEAR(l.release.kinetic_rest, left, 1e-14);
    EXPECT_NEAR(l.release.velocity_rest[0], 0.1 * std::sqrt(left / rest), 1e-14);
    EXPECT_NEAR(kinetic_of(l.release.shape, l.release.motion) + l.release.kinetic_rest, before + rest, 1e-14);
  }
}

TEST(TakeAlong, rotational_turns_at_the_root_of_the_mean_square_spin_and_returns_what_that_breaks) {
  for (const double sign : {1.0, -1.0}) {
    Leaving l(0.5);
    l.release.motion.Fdot(1, 0) *= sign;
    l.release.motion.Fdot(0, 1) *= sign;
    l.release.spin_squared = 1.44;
    const double before = kinetic_of(l.release.shape, l.release.motion);
    const double booked = limit_release(TransferMode::rotational, 1.1, l.release);
    const Mat2& G = l.release.motion.Fdot;
    EXPECT_NEAR(0.5 * (G(1, 0) - G(0, 1)), sign * 1.2, 1e-14);
    EXPECT_NEAR(G(0, 0), Leaving::kX, 1e-14);
    EXPECT_NEAR(G(1, 1), Leaving::kY, 1e-14);
    EXPECT_EQ(l.release.kinetic_rest, 0.0);
    EXPECT_NEAR(booked, before + 0.5 - kinetic_of(l.release.shape, l.release.motion), 1e-14);
    EXPECT_NEAR(l.release.velocity_rest[3], 0.0, 0.0);
  }
}

/// A rigidly rotating mesh: the mean square spin of its elements is that of the rotation, at any position.
TEST(Release, spin_of_a_mesh_that_turns_as_one_is_its_own) {
  const double spin = 0.8;
  NmmBlock block({{{1, 0}, {3, 0.2}, {2.6, 1.3}, {1.1, 1}}, {}}, {.cover_size = 0.4}, {"rock", 2500.0, 1e9, 0.2});
  AffineMotion m;
  m.c = {0.4, -2.0};
  m.F = rotation(0.6);
  m.vc = {1.0, 2.0};
  m.Fdot = spin * quarter_turn() * m.F;
  block.pool.place(0, m, block.q, block.v);
  const Release r = block.pool.release(0, block.q, block.v);
  EXPECT_NEAR(r.spin_squared, spin * spin, 1e-12);
  EXPECT_NEAR(r.kinetic_rest, 0.0, 1e-12);
}

/// A bar that bends in flight changes to the DDA: with a cap of 1 the strain rates take no energy, with 1.1 they do.
TEST(TransferCap, of_the_stage_is_the_one_that_holds) {
  const auto rest = [](TransferMode mode, double cap) {
    Scene scene(1e8, 0.2, 2500.0);
    scene.model.gravity.setZero();
    const BlockId id = scene.add("bar", rectangle(0, 0, 4, 0.5));
    scene.model.point_loads.push_back({id, {4.0, 0.5}, {3e4, 5e4}, {}});
    scene.stage("nmm", Integrator::explicit_, 0.03, std::nullopt, 0.25);
    Stage& stage = scene.stage("dda", Integrator::implicit, 0.001, 1e-3);
    stage.transfer = mode;
    stage.transfer_cap = cap;
    Driver run(scene.model, scene.plan, methods());
    EXPECT_EQ(run.run().status, RunEnd::Status::done);
    return run.transfers().at(0).reservoir_kinetic;
  };
  const double reservoir = rest(TransferMode::reservoir, 1.1);
  EXPECT_GT(reservoir, 0.0);
  EXPECT_NEAR(rest(TransferMode::strain_rate, 1.0) / reservoir, 1.0, 1e-9);
  const double some = rest(TransferMode::strain_rate, 1.02), more = rest(TransferMode::strain_rate, 1.1);
  EXPECT_LT(some, reservoir);
  // The strain rates take (cap^2 - 1) times the kinetic energy that they have.
  EXPECT_NEAR((reservoir - more) / (reservoir - some), (1.1 * 1.1 - 1.0) / (1.02 * 1.02 - 1.0), 1e-6);
}

}  // namespace
}  // namespace scree::test::transfer_mode_test
