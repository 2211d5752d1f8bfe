// Momenta and the affine part of a body's motion on a new mesh, against their values on the old one.
#include "coupling/transfer/field_transfer.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "tests/support/nmm_block.h"
#include "tests/support/scene.h"

namespace scree::test::field_transfer_test {
namespace {

using coupling::keep_momenta;
using coupling::project_fields;

NmmBlock block(double cover_size) {
  Formulation form;
  form.cover_size = cover_size;
  return {rectangle(1.0, 2.0, 2.3, 2.9), form, {"rock", 2600.0, 1e9, 0.2}};
}

/// Stretches and shears the block and moves it as a whole, with a superposed short wave.
void stir(NmmBlock& b, double wave) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-wave, wave);
  const Vec2 c = b.centre();
  for (std::size_t i = 0; i < b.q.size(); i += 2) {
    const Vec2 x = Vec2(b.q[i], b.q[i + 1]) - c;
    b.q[i] += 0.01 * x.x() + 0.02 * x.y() + 0.3;
    b.q[i + 1] += -0.02 * x.x() + 0.005 * x.y() - 0.1;
    b.v[i] = 1.0 + 0.4 * x.x() - 0.9 * x.y() + any(random);
    b.v[i + 1] = -2.0 + 0.7 * x.x() + 0.2 * x.y() + any(random);
  }
}

TEST(FieldTransfer, rigid_motion_restores_both_momenta_and_is_rigid) {
  NmmBlock b = block(0.15);
  stir(b, 0.5);
  const std::vector<double> before = b.v;
  BodyTotals wanted = b.pool.totals(0, b.q, b.v);
  wanted.momentum += wanted.mass * Vec2(0.3, -0.2);
  wanted.angular_momentum += 40.0;
  keep_momenta(b.pool, 0, wanted, b.q, b.v);
  const BodyTotals now = b.pool.totals(0, b.q, b.v);
  EXPECT_LT((now.momentum - wanted.momentum).norm(), 1e-12 * wanted.momentum.norm());
  EXPECT_NEAR(now.angular_momentum, wanted.angular_momentum, 1e-12 * std::abs(wanted.angular_momentum));
  const auto added = [&](std::size_t i) { return b.v[i] - before[i]; };
  for (std::size_t i = 2; i < b.q.size(); i += 2) {  // the added velocity is rigid
    const Vec2 x(b.q[i] - b.q[0], b.q[i + 1] - b.q[1]), u(added(i) - added(0), added(i + 1) - added(1));
    EXPECT_NEAR(x.dot(u), 0.0, 1e-12) << i;
  }
}

TEST(FieldTransfer, new_mesh_keeps_centre_momenta_and_affine_motion_under_a_short_wave) {
  for (const double to : {0.2, 0.11}) {
    NmmBlock was = block(0.15), now = block(to);
    stir(was, 0.5);
    const BodyTotals wanted = was.pool.totals(0, was.q, was.v);
    project_fields(was.pool, 0, was.q, was.v, now.pool, 0, wanted, now.q, now.v);
    const BodyTotals got = now.pool.totals(0, now.q, now.v);
    EXPECT_LT((got.centre - wanted.centre).norm(), 1e-12);
    EXPECT_LT((got.momentum - wanted.momentum).norm(), 1e-12 * wanted.momentum.norm());
    EXPECT_NEAR(got.angular_momentum, wanted.angular_momentum, 1e-12 * std::abs(wanted.angular_momentum));
    EXPECT_LE(got.kinetic, wanted.kinetic * (1.0 + 1e-12));
    const AffineMotion a = was.pool.release(0, was.q, was.v).motion, b = now.pool.release(0, now.q, now.v).motion;
    EXPECT_LT((a.F - b.F).norm(), 1e-3) << "of the shape: it is projected";
    EXPECT_LT((a.Fdot * a.F.inverse() - b.Fdot * b.F.inverse()).norm(), 1e-10) << to;
  }
}

TEST(FieldTransfer, affine_motion_is_the_same_on_any_mesh) {
  NmmBlock was = block(0.15), now = block(0.2);
  stir(was, 0.0);
  project_fields(was.pool, 0, was.q, was.v, now.pool, 0, was.pool.totals(0, was.q, was.v), now.q, now.v);
  NmmBlock meant = block(0.2);
  stir(meant, 0.0);
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    EXPECT_NEAR(now.q[i], meant.q[i], 1e-10) << i;
    EXPECT_NEAR(now.v[i], meant.v[i], 1e-9) << i;
  }
}

}  // namespace
}  // namespace scree::test::field_transfer_test
