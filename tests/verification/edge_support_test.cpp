// Supports along edges in whole runs: a uniform stress, a beam and a column on rollers, each compared with its elastic
// solution, and changes of method, which must not move a block at rest.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "coupling/integrate/point_springs.h"
#include "tests/support/schemes.h"

namespace scree::test::edge_support_test {
namespace {

using namespace coupling;

EdgeSupport held(BlockId block, std::int32_t edge, const Mat2& directions) {
  return {{block, {0, edge}, 0.0, 1.0}, directions, std::nullopt};
}
Mat2 along(const Vec2& a) { return a * a.transpose(); }
const Mat2 kX = along({1.0, 0.0}), kY = along({0.0, 1.0});

/// Mean stress of a block.
Mat2 stress_of(const Driver& run, BlockId id) {
  const Body& b = run.setup().bodies()[id.index()];
  const Pool& pool = run.setup().pool_of(b);
  MeshPart part;
  pool.topology(part);
  std::vector<double> s(3 * part.body.size());
  pool.stress(run.setup().part(std::span<const double>(run.state().q), static_cast<std::size_t>(b.pool)), s);
  Mat2 sum = Mat2::Zero();
  double n = 0.0;
  for (std::size_t c = 0; c < part.body.size(); ++c) {
    if (part.body[c] != b.index) continue;
    sum += (Mat2() << s[3 * c], s[3 * c + 2], s[3 * c + 2], s[3 * c + 1]).finished();
    n += 1.0;
  }
  return sum / n;
}

/// Present position of a material point.
Vec2 now_at(const Driver& run, BlockId id, const Vec2& X) {
  const Body& b = run.setup().bodies()[id.index()];
  const ReferenceShape& shape = run.state().bodies[id.index()].shape;
  const AffineMotion map = affine_fit(shape.origin, shape.outline);
  return position(run.setup().global(b, run.setup().pool_of(b).row_at(b.index, map.c + map.F * X)), run.state().q);
}

/// Static equilibrium by steps without velocity.
Stage& at_rest(Scene& scene, const std::string& method, double cover_size = 0.3, double dt = 0.5, int steps = 12) {
  Stage& s = scene.stage(method, Integrator::implicit, dt * steps, dt, cover_size);
  s.dynamics = 0.0;
  return s;
}

TEST(EdgeSupports, pressed_block_on_rollers_has_the_stress_of_the_load) {
  // p on top, rollers below and to the left: s_yy = -p, free to expand sideways.
  const double p = 2e6, young = 5e9, nu = 0.2;
  for (const char* method : {"nmm", "dda"}) {
    Scene scene(young, nu);
    scene.model.gravity = {0.0, 0.0};
    const BlockId block = scene.add("block", rectangle(0.03, 0.02, 1.03, 2.02));
    scene.model.edge_supports = {held(block, 0, kY), held(block, 3, kX)};
    scene.model.tractions.push_back({{block, {0, 2}, 0.0, 1.0}, {0.0, -p}, FunctionId{}});
    at_rest(scene, method).kinematics = Kinematics::linear;
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const Mat2 s = stress_of(run, block);
    const Vec2 top = now_at(run, block, {1.03, 2.02}) - Vec2(1.03, 2.02);
    const double settled = p * 2.0 * (1.0 - nu * nu) / young, widened = p * nu * (1.0 + nu) / young;
    std::printf("%s: s_yy %.9g, s_xx %.2e; top %.6e of %.6e, side %.6e of %.6e\n", method, s(1, 1), s(0, 0), -top.y(),
                settled, top.x(), widened);
    EXPECT_NEAR(s(1, 1), -p, 1e-3 * p * (method[0] == 'd' ? 1.0 : 1e-6));
    EXPECT_NEAR(s(0, 0), 0.0, 1e-3 * p * (method[0] == 'd' ? 1.0 : 1e-6));
    // The rollers of DDA deform by p/k, k = 10 (K + 4G/3)/sqrt(area).
    const double k = 10.0 * scene.model.elasticity_of(block).p_modulus() / std::sqrt(2.0);
    EXPECT_NEAR(-top.y(), settled + (method[0] == 'd' ? p / k : 0.0), 1e-3 * settled);
    EXPECT_NEAR(top.x(), widened, 2e-3 * widened);
  }
}

TEST(EdgeSupports, beam_on_rollers_bends_as_the_plane_solution) {
  // Uniform q on a beam of half length l, half depth c, its ends held across: [Timoshenko1951] art. 22,
  //   w = 5 q l^4/(24 E I) [1 + 12/5 (c/l)^2 (4/5 + nu/2)],  I = 2 c^3/3, plane stress.
  const double q = 1e4, young = 1e9, nu = 0.25, l = 4.0, c = 0.4;
  const double exact = 5.0 * q * std::pow(l, 4) / (24.0 * young * 2.0 / 3.0 * std::pow(c, 3)) *
                       (1.0 + 2.4 * std::pow(c / l, 2) * (0.8 + 0.5 * nu));
  std::vector<double> found;
  for (const double h : {0.16, 0.08}) {
    Scene scene(young, nu);
    scene.model.plane = Plane::stress;
    scene.model.gravity = {0.0, 0.0};
    const BlockId beam = scene.add("beam", rectangle(-l + 0.013, -c + 0.021, l + 0.013, c + 0.021));
    scene.model.edge_supports = {held(beam, 1, kY), held(beam, 3, kY)};
    scene.model.point_supports.push_back({beam, {0.013, 0.021}, true, false, {}});
    scene.model.tractions.push_back({{beam, {0, 2}, 0.0, 1.0}, {0.0, -q}, FunctionId{}});
    at_rest(scene, "nmm", h, 2.0, 25).kinematics = Kinematics::linear;
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    found.push_back(0.021 - now_at(run, beam, {0.013, 0.021}).y());
  }
  const double limit = found[1] + (found[1] - found[0]) / 3.0;  // the error is of order two
  std::printf("beam: %.5e, %.5e, extrapolated %.5e of %.5e\n", found[0], found[1], limit, exact);
  EXPECT_NEAR(found[1], exact, 0.02 * exact);
  EXPECT_NEAR(limit, exact, 0.005 * exact);
}

class EdgeSupportSteps : public testing::TestWithParam<Scheme> {};

TEST_P(EdgeSupportSteps, a_column_let_go_on_rollers_swings_about_its_settlement) {
  // Gravity is applied at once: the top oscillates between 0 and twice the settlement rho g H^2/(2 M), M for uniaxial
  // strain as both sides are on rollers; the first mode has the period 4 H/c_p. One period is run, and the
  // ledger closes.
  const Scheme scheme = GetParam();
  const double young = 1e9, nu = 0.25, density = 2500.0, H = 4.0;
  Scene scene(young, nu, density);
  const BlockId column = scene.add("column", rectangle(0.01, 0.02, 1.01, H + 0.02));
  scene.model.edge_supports = {held(column, 0, kY), held(column, 1, kX), held(column, 3, kX)};
  const double modulus = scene.model.elasticity_of(column).p_modulus(), wave = std::sqrt(modulus / density);
  scene.stage(scheme.method, scheme.integrator, 4.0 * H / wave,
              scheme.integrator == Integrator::explicit_ ? std::nullopt : std::optional<double>(2e-5), 0.25);
  scene.plan.stages[0].sliding_damping = 0.0;
  scene.plan.output.every = scene.plan.output.history_every = ticks(4.0 * H / wave / 400.0);
  Driver run(scene.model, scene.plan, methods());
  double deepest = 0.0, at = 0.0, closure = 0.0;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    const double down = H + 0.02 - now_at(run, column, {0.51, H + 0.02}).y();
    if (down > deepest) deepest = down, at = seconds(view.state->time);
    closure = std::max(closure, view.state->ledger.relative_closure());
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const double settlement = density * 9.81 * H * H / (2.0 * modulus);
  std::printf("%s: deepest %.4e of %.4e at %.4e of %.4e s, closure %.1e\n", scheme.name, deepest, 2.0 * settlement, at,
              2.0 * H / wave, closure);
  EXPECT_LT(closure, 1e-9);
  if (std::string(scheme.method) == "nmm") {
    EXPECT_NEAR(deepest, 2.0 * settlement, 0.03 * settlement);
    EXPECT_NEAR(at, 2.0 * H / wave, 0.03 * H / wave);
  } else {  // one strain for the whole column, and rollers that deform: the order of magnitude
    EXPECT_GT(deepest, settlement);
    EXPECT_LT(deepest, 3.0 * settlement);
  }
}
INSTANTIATE_TEST_SUITE_P(schemes, EdgeSupportSteps,
                         testing::Values(Scheme{"nmm_explicit", "nmm", Integrator::explicit_},
                                         Scheme{"nmm_implicit", "nmm", Integrator::implicit},
                                         Scheme{"dda_explicit", "dda", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(EdgeSupports, change_of_method_keeps_what_holds_a_block_at_rest) {
  // A block settles under its weight in the NMM, then continues in dynamic steps by the DDA and again by the NMM: its
  // position must not jump.
  Scene scene(1e9, 0.2, 2600.0);
  const BlockId block = scene.add("block", rectangle(0, 0, 2, 2));
  scene.model.edge_supports = {held(block, 0, Mat2::Identity())};
  at_rest(scene, "nmm", 0.25);
  scene.stage("dda", Integrator::implicit, 0.05, 5e-4);
  scene.stage("nmm", Integrator::explicit_, 0.02, std::nullopt, 0.25);
  scene.plan.output.every = scene.plan.output.history_every = ticks(5e-4);
  Driver run(scene.model, scene.plan, methods());
  const double settlement = 2600.0 * 9.81 * 2.0 * 1.0 / scene.model.elasticity_of(block).p_modulus();
  double before = 0.0, moved = 0.0, closure = 0.0;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    const double y = centre_of(run, block).y();
    closure = std::max(closure, view.state->ledger.relative_closure());
    if (view.stage == 0)
      before = y;
    else
      moved = std::max(moved, std::abs(y - before));
  };
  run.add_sink(watch);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  std::printf("hand-over: moved %.2e of a settlement of about %.2e, closure %.1e\n", moved, settlement, closure);
  EXPECT_LT(moved, 0.03 * settlement);
  EXPECT_LT(closure, 1e-9);
}

}  // namespace
}  // namespace scree::test::edge_support_test
