// Contact patch test (docs/theory/contact-geometry.md, "Edge-edge contact"): a uniform pressure passes exactly through
// joints whose vertices do not match. The reference is the series of two layers and three joints; the mean stress is
// compared within 1e-4, since strains are 4e-5.
#include <gtest/gtest.h>

#include <algorithm>

#include "coupling/integrate/central_difference.h"
#include "tests/support/scene.h"

namespace scree::contact_patch_test {
namespace {

using coupling::Integrator;

struct Patch {
  const char* name;
  const char* lower;
  const char* upper;
  Integrator integrator;
};

std::ostream& operator<<(std::ostream& out, const Patch& p) { return out << p.name; }

constexpr double kYoung = 1e9, kSqueeze = 2e-4;  // [Pa], [m]

/// The top plate goes down by kSqueeze in 2 ms and stays: two triangles of acceleration, up and down.
void squeeze(Model& model) {
  constexpr double T = 0x1p-11, a = kSqueeze / (2.0 * T * T);  // powers of two: the velocity ends at zero exactly
  model.motions.emplace_back(std::vector<double>{0.0, T, 2 * T, 3 * T, 4 * T},
                             std::vector<double>{0.0, a, 0.0, -a, 0.0}, Vec2(0.0, -1.0));
}

struct Spread {
  double mean = 0.0, deviation = 0.0, sideways = 0.0;  // of s_yy; largest |s_xx|, |s_xy|
};

/// Stress in all cells of free bodies, in axes turned by Q.
Spread spread_of_stress(const coupling::Setup& setup, const coupling::State& state, const Mat2& Q) {
  std::vector<double> yy;
  Spread out;
  for (std::size_t p = 0; p < setup.pools(); ++p) {
    MeshPart mesh;
    setup.pool(p).topology(mesh);
    std::vector<double> cells(3 * mesh.body.size());
    setup.pool(p).stress(setup.part(std::span<const double>(state.q), p), cells);
    for (std::size_t c = 0; c < mesh.body.size(); ++c) {
      if (setup.counted(p)[static_cast<std::size_t>(mesh.body[c])] == 0) continue;
      Mat2 stress;
      stress << cells[3 * c], cells[3 * c + 2], cells[3 * c + 2], cells[3 * c + 1];
      stress = Q.transpose() * stress * Q;
      yy.push_back(stress(1, 1));
      out.sideways = std::max({out.sideways, std::abs(stress(0, 0)), std::abs(stress(0, 1))});
    }
  }
  for (const double s : yy) out.mean += s / static_cast<double>(yy.size());
  for (const double s : yy) out.deviation = std::max(out.deviation, std::abs(s - out.mean));
  return out;
}

/// Two layers between a fixed and a driven plate, without gravity and without friction on the plates.
test::Scene layers(const Patch& patch, double poisson, const std::vector<Polygon>& lower,
                   const std::vector<Polygon>& upper, double plate_from, double plate_to, double height) {
  test::Scene scene(kYoung, poisson, 2500.0, 0.0);
  scene.model.gravity = {0.0, 0.0};
  squeeze(scene.model);
  scene.add("floor", test::rectangle(plate_from, -1.0, plate_to, 0.0), true);
  scene.add("roof", test::rectangle(plate_from, height, plate_to, height + 1.0));
  scene.model.block_supports.push_back({BlockId{1}, MotionId{0}});
  coupling::MethodRule below{{BlockId{0}, BlockId{1}}, "dda"}, low{{}, patch.lower}, high{{}, patch.upper};
  for (const Polygon& p : lower) low.blocks.push_back(scene.add("low" + std::to_string(low.blocks.size()), p));
  for (const Polygon& p : upper) high.blocks.push_back(scene.add("high" + std::to_string(high.blocks.size()), p));
  const bool implicit = patch.integrator == Integrator::implicit;
  const bool dda = std::string(patch.lower) == "dda" && std::string(patch.upper) == "dda";
  // Long steps reach rest sooner; DDA, which is exact for this stress, reaches it at once.
  const double step = dda ? 1e-3 : 1e-2;
  coupling::Stage& stage = scene.stage("dda", patch.integrator, implicit ? 200.0 * step : 2.0,
                                       implicit ? std::optional(step) : std::nullopt, 0.37);
  stage.rules = {below, low, high};
  stage.rest = true;
  stage.damping = implicit ? 0.0 : 100.0;
  return scene;
}

/// The blocks of a layer touch; without Poisson's effect they exert no lateral forces on each other.
test::Scene three_on_two(const Patch& patch) {
  return layers(patch, 0.0, {test::rectangle(0, 0, 1.7, 1), test::rectangle(1.7, 0, 4, 1)},
                {test::rectangle(0, 1, 1.1, 2.2), test::rectangle(1.1, 1, 2.7, 2.2), test::rectangle(2.7, 1, 4, 2.2)},
                -1.0, 5.0, 2.2);
}

class ContactPatch : public ::testing::TestWithParam<Patch> {};

TEST_P(ContactPatch, layers_of_blocks_carry_a_uniform_pressure) {
  test::Scene scene = three_on_two(GetParam());
  // Without friction a transient may displace the blocks sideways by 1e-7 m, which makes the load eccentric: support
  // them laterally.
  for (std::size_t b = 2; b < scene.model.blocks.size(); ++b)
    scene.model.point_supports.push_back(
        {BlockId{static_cast<std::int32_t>(b)}, moments(scene.model.blocks[b].polygon).centroid, true, false, 1e7});
  coupling::Driver run(scene.model, scene.plan, coupling::standard_methods());
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  const Spread s = spread_of_stress(run.setup(), run.state(), Mat2::Identity());
  // Two layers and three joints in series; auto stiffness E/d with d the narrower side.
  const double kn1 = kYoung / 1.0, kn2 = kYoung / 1.0, kn3 = kYoung / 1.0;
  const double expected = -kSqueeze / (2.2 / kYoung + 1.0 / kn1 + 1.0 / kn2 + 1.0 / kn3);
  EXPECT_LT(s.deviation, 1e-8 * std::abs(s.mean));
  EXPECT_LT(s.sideways, 1e-8 * std::abs(s.mean));
  EXPECT_NEAR(s.mean / expected, 1.0, 1e-4);  // strains are 4e-5
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

TEST_P(ContactPatch, overlap_is_counted_once) {
  test::Scene scene = three_on_two(GetParam());
  scene.plan.stages[0].duration = ticks(0.01);
  coupling::Driver run(scene.model, scene.plan, coupling::standard_methods());
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  double between = 0.0;
  for (const coupling::ContactMemory& m : run.state().contacts)
    if (std::min(m.key.block_p, m.key.block_e) < 4 && std::min(m.key.block_p, m.key.block_e) > 1 &&
        std::max(m.key.block_p, m.key.block_e) > 3)
      between += m.tributary;
  EXPECT_NEAR(between, 4.0, 1e-4);  // the tolerance covers the strain of the run only
}

/// Every block is placed according to the exact solution: the forces on every node must balance.
TEST_P(ContactPatch, exact_solution_is_in_balance_at_any_angle) {
  test::Scene scene = three_on_two(GetParam());
  const Mat2 Q = rotation(37.0 * test::kDegree);
  for (Block& b : scene.model.blocks) b.polygon = transformed(b.polygon, Vec2(0.0, 0.0), Q);
  const coupling::Methods methods = coupling::standard_methods();
  coupling::State state;
  state.bodies = initial_records(scene.model, body_requests(scene.model, scene.plan.stages[0]));
  const coupling::Setup setup(scene.model, methods, state.bodies);
  state.q.assign(2 * static_cast<std::size_t>(setup.nodes()), 0.0);
  state.v = state.q;
  const auto put = [&](double pressure) {
    const double strain = pressure / kYoung, gap = pressure / kYoung;  // auto: E over a width of 1 m
    for (std::size_t i = 0; i < setup.bodies().size(); ++i) {
      const coupling::Body& b = setup.bodies()[i];
      const auto p = static_cast<std::size_t>(b.pool);
      const Vec2 centre = Q.transpose() * b.centre;
      double down = 0.0;  // floor, lower layer, upper layer, roof
      if (i == 1) down = 3.0 * gap + 2.2 * strain;
      if (i == 2 || i == 3) down = gap + centre.y() * strain;
      if (i > 3) down = 2.0 * gap + centre.y() * strain;
      AffineMotion m;
      m.c = b.centre - Q * Vec2(0.0, down);
      if (!b.driven) m.F = Mat2::Identity() - strain * Q.col(1) * Q.col(1).transpose();
      setup.pool_of(b).place(b.index, m, setup.part(std::span<double>(state.q), p),
                             setup.part(std::span<double>(state.v), p));
    }
    coupling::CentralDifference integrator(setup, {}, coupling::auto_detection(scene.model));
    state.a.clear();
    (void)integrator.enter(state);
    ++state.step;
  };
  put(0.0);  // the contacts close here without force
  const double pressure = 4e3;
  put(pressure);
  const Spread s = spread_of_stress(setup, state, Q);
  EXPECT_NEAR(s.mean, -pressure, 1e-4 * pressure);
  // Acceleration of a cover's mass under the pressure on its width: the unbalanced force as a fraction of that pressure
  // gives the acceleration as the same fraction of this scale.
  const double scale = pressure / (2500.0 * scene.plan.stages[0].cover_size);
  double largest = 0.0;
  for (const double a : state.a) largest = std::max(largest, std::abs(a));
  // With the consistent mass of implicit stages, the same forces cause up to four times the acceleration.
  EXPECT_LT(largest, (GetParam().integrator == Integrator::implicit ? 4e-8 : 1e-8) * scale);
}

INSTANTIATE_TEST_SUITE_P(methods, ContactPatch,
                         ::testing::Values(Patch{"nmm_nmm", "nmm", "nmm", Integrator::explicit_},
                                           Patch{"nmm_dda", "nmm", "dda", Integrator::explicit_},
                                           Patch{"dda_nmm", "dda", "nmm", Integrator::explicit_},
                                           Patch{"dda_dda", "dda", "dda", Integrator::explicit_},
                                           Patch{"nmm_nmm_implicit", "nmm", "nmm", Integrator::implicit},
                                           Patch{"nmm_dda_implicit", "nmm", "dda", Integrator::implicit},
                                           Patch{"dda_nmm_implicit", "dda", "nmm", Integrator::implicit},
                                           Patch{"dda_dda_implicit", "dda", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace scree::contact_patch_test
