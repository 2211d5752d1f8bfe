// Liners against closed-form statics: a bar, a beam, a lined hole, a hanging block.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coupling/bolts/bolt_rows.h"
#include "tests/support/circle.h"
#include "tests/support/lined.h"

namespace scree::test::liner_statics_test {
namespace {

using namespace coupling;

constexpr double kPart = 5e-3;  // relative to statics: runs to rest, and rock that is stiff but not rigid

class Liners : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(All, Liners, testing::ValuesIn(kWays), [](const auto& of) { return of.param.name(); });

/// Current position of a node of the liner.
Vec2 node_at(const Driver& run, std::size_t node) {
  return position(bolt_rows(run.setup(), run.state(), 0).row[node], run.state().q);
}

TEST_P(Liners, two_blocks_joined_by_a_liner_part_by_its_stretch) {
  // Pull along the liner: the blocks part by N/(EA/h), the stretch of the one bar between them.
  Lined scene;
  scene.model.gravity = {0.0, 0.0};
  scene.add("wall", rectangle(-2, 0, 0, 1), true);
  const BlockId block = scene.add("block", rectangle(0.5, 0, 2.5, 1));
  const double force = 100e3;
  scene.model.point_loads.push_back({block, {1.5, 1.0}, {force, 0.0}, FunctionId{}});
  const Bolt b = lining({{-1.0, 1.0}, {2.0, 1.0}}, 0.5);
  scene.line(b);
  scene.rest(GetParam(), GetParam().is_explicit() ? 5.0 : 50.0, 1.0);  // the block rocks at 16 rad/s
  const Driver& run = scene.run();
  EXPECT_NEAR(scene.memory().force[2] / force, 1.0, kPart);
  EXPECT_NEAR((node_at(run, 3).x() - 0.5) / (force * 0.5 / b.stiffness), 1.0, kPart);
  scene.expect_closed();
}

TEST_P(Liners, block_hung_from_a_roof_by_shotcrete_sinks_by_the_bending_of_its_bars) {
  // A block hangs in the gap of a roof on a liner along the underside. A bar of length h crosses each of its sides,
  // with rotational springs EI/h at both ends: U = 2 EI/h (s/h)^2 for a settlement s, W = 4 EI s/h^3.
  Lined scene(0.0);
  const BlockId block = scene.add("key", rectangle(-0.5, 1.0, 0.5, 2.0));
  scene.add("left", rectangle(-2.0, 1.0, -0.6, 2.0), true);
  scene.add("right", rectangle(0.6, 1.0, 2.0, 2.0), true);
  const Bolt b = lining({{-1.05, 1.0}, {1.05, 1.0}}, 0.3);
  scene.line(b);
  ASSERT_EQ(scene.model.bolts[0].nodes.size(), 8U);  // at +- 0.15, 0.45 in the block, 0.75, 1.05 in the roof
  scene.rest(GetParam(), 0.5);
  const Driver& run = scene.run();
  const double weight = 2600.0 * 9.81, sinking = weight * 0.027 / (4.0 * b.bending);
  const double sunk = 1.0 - node_at(run, 3).y();
  std::printf("%s: sinks by %.5e m, expected %.5e\n", GetParam().name().c_str(), sunk, sinking);
  EXPECT_NEAR(sunk / sinking, 1.0, 0.02);  // the rock deforms a little, the mesh near the nodes that load it
  // Half of the weight on each side, W/2 = 2 M/h: turn to the right at the roof, to the left at the block.
  EXPECT_NEAR(scene.memory().shear[0] / (0.25 * weight * 0.3), -1.0, kPart);
  EXPECT_NEAR(scene.memory().shear[1] / (0.25 * weight * 0.3), 1.0, kPart);
  EXPECT_LT(std::abs(totals_of(run, block).momentum.y()), 1e-3 * totals_of(run, block).mass);
  scene.expect_closed();
}

// ---- A beam ------------------------------------------------------------------------------------------------------

/// A liner of length 2 on n + 1 small blocks, the outer two held, with a load on the middle one: simply supported.
struct Beam : Lined {
  static constexpr double kSide = 0.01, kSpan = 2.0, kLoad = 10.0;
  Bolt liner;
  Beam(int n, const Way& way) {
    model.gravity = {0.0, 0.0};
    for (int i = 0; i <= n; ++i) {
      const double x = kSpan * i / n;
      const BlockId id =
          add("b" + std::to_string(i), rectangle(x - kSide, -2.0 * kSide, x + kSide, 0.0), i == 0 || i == n);
      if (2 * i == n) model.point_loads.push_back({id, {x, 0.0}, {0.0, -kLoad}, FunctionId{}});
    }
    liner = lining({{0.0, 0.0}, {kSpan, 0.0}}, kSpan / n);
    line(liner);
    this->rest(way, way.is_explicit() ? 0.05 : 20.0, 1.0);
  }
  [[nodiscard]] double sag(int n) const { return -node_at(*driver, static_cast<std::size_t>(n / 2)).y(); }
};

/// Sag of the chain of bars by the unit-load method: sum of M m h/EI over inner nodes, M and m triangular diagrams.
double sag_of_chain(int n, const Bolt& liner) {
  const double h = Beam::kSpan / n;
  double sum = 0.0;
  for (int i = 1; i < n; ++i) {
    const double m = 0.5 * std::min(i * h, Beam::kSpan - i * h);
    sum += Beam::kLoad * m * m * h / liner.bending;
  }
  return sum;
}

TEST(LinerBeam, sag_is_that_of_the_chain_and_comes_to_euler_and_bernoulli_with_order_two) {
  double last = 0.0;
  for (const int n : {4, 8, 16}) {
    Beam beam(n, {"dda", Integrator::implicit});
    beam.run();
    const double chain = sag_of_chain(n, beam.liner),
                 exact = Beam::kLoad * std::pow(Beam::kSpan, 3) / (48.0 * beam.liner.bending), sag = beam.sag(n),
                 error = sag / exact - 1.0;
    std::printf("n %2d: sag %.8e m, chain %.8e, over Euler-Bernoulli less 1: %.4e, order %.3f\n", n, sag, chain, error,
                last > 0.0 ? std::log2(last / error) : 0.0);
    EXPECT_NEAR(sag / chain, 1.0, 1e-4) << n;
    if (last > 0.0) {
      EXPECT_NEAR(std::log2(last / error), 2.0, 0.05) << n;
    }
    last = error;
    // M = P x/2 at every node.
    for (int i = 1; i < n; ++i)
      EXPECT_NEAR(beam.memory().shear[static_cast<std::size_t>(i - 1)] /
                      (0.5 * Beam::kLoad * std::min(i, n - i) * Beam::kSpan / n),
                  1.0, 1e-4)
          << i;
  }
}

TEST_P(Liners, sag_of_a_beam_of_four_bars) {
  Beam beam(4, GetParam());
  beam.run();
  EXPECT_NEAR(beam.sag(4) / sag_of_chain(4, beam.liner), 1.0, kPart);
  beam.expect_closed();
}

// ---- A lined hole ------------------------------------------------------------------------------------------------

constexpr double kIn = 1.0, kOut = 3.0, kStress = 2e6, kYoung = 2e9, kPoisson = 0.25;
constexpr int kCorners = 72;

/// Radial displacement of the wall of a ring under inner and outer pressure: Lame, plane strain.
double wall_moves(double inner, double outer) {
  const double a = kIn * kIn, b = kOut * kOut;
  return (1.0 + kPoisson) / kYoung *
         ((1.0 - 2.0 * kPoisson) * (inner * a - outer * b) / (b - a) * kIn + (inner - outer) * b / (b - a) * kIn);
}

/// Thrust of a liner EA on the wall under the outer pressure and a relief of the wall: u(a) = -p a^2/EA, N = -p a.
double thrust(double relief, double outer, double stiffness) {
  const double free = wall_moves(-relief, outer), unit = wall_moves(1.0, 0.0);
  return free / (unit + kIn * kIn / stiffness) * kIn;  // negative: inward
}

/// A ring of rock with a liner on its wall; its supports only prevent drift.
struct Hole : Lined {
  BlockId rock;
  Hole() : Lined(30.0, kYoung) {
    model.materials[0].poisson = kPoisson;
    model.gravity = {0.0, 0.0};
    rock = add("rock", {circle(kOut, kCorners, false), {circle(kIn, kCorners, true)}});
    model.point_supports.push_back({rock, {-2.0, 0.0}, false, true, 1e9});
    model.point_supports.push_back({rock, {2.0, 0.0}, false, true, 1e9});
    model.point_supports.push_back({rock, {0.0, 2.0}, true, false, 1e9});
  }
  void press(double pressure) {
    for (std::int32_t e = 0; e < kCorners; ++e) {
      const Ring& r = model.blocks[0].polygon.ring(0);
      const auto i = static_cast<std::size_t>(e);
      const Vec2 d = (r[(i + 1) % r.size()] - r[i]).normalized();
      model.tractions.push_back({{rock, {0, e}, 0.0, 1.0}, -pressure * Vec2(d.y(), -d.x()), FunctionId{}});
    }
  }
  /// A closed liner along the wall, with a node at every corner.
  static Bolt ring() {
    Ring along = circle(kIn, kCorners, false);
    along.push_back(along.front());
    return lining(along, 1.0, 0.15);
  }
  /// Checks the mean thrust against the expected one.   @return largest relative difference of a bar from it
  double expect_thrust(double expected) const {
    double mean = 0.0, bend = 0.0, apart = 0.0;
    for (const double N : memory().force) mean += N / static_cast<double>(memory().force.size());
    for (const double M : memory().shear) bend = std::max(bend, std::abs(M));
    for (const double N : memory().force) apart = std::max(apart, std::abs(N / expected - 1.0));
    std::printf("thrust %.5e N/m, expected %.5e: %.4f, bars within %.4f; largest moment %.3e N m\n", mean, expected,
                mean / expected, apart, bend);
    EXPECT_NEAR(mean / expected, 1.0, 0.02);
    return apart;
  }
};

TEST(LinedHole, liner_of_a_ring_under_outer_pressure_has_the_thrust_of_lame) {
  // The thrust of each bar follows the strain of the elements at the wall, which is constant in each element.
  double last = 1.0;
  for (const double cover : {0.24, 0.12, 0.06}) {
    Hole hole;
    hole.press(kStress);
    const Bolt ring = Hole::ring();
    hole.line(ring);
    hole.rest({"nmm", Integrator::implicit}, 3.0, 0.5, cover);
    hole.run();
    const double apart = hole.expect_thrust(thrust(0.0, kStress, ring.stiffness));
    EXPECT_LT(apart, 0.75 * last);
    last = apart;
    hole.expect_closed();
  }
}

TEST(LinedHole, liner_that_comes_when_half_is_released_takes_its_part_of_the_other_half) {
  // In-situ stress -p; the disc is removed and half of its force released, the liner is installed, then the rest is
  // released: only the second half loads the liner.
  Hole hole;
  InitialStress in_situ;
  in_situ.stress = -kStress * Mat2::Identity();
  hole.model.materials[0].initial_stress = in_situ;
  hole.model.joints[0].normal_stiffness = 1000.0 * kYoung / kIn;
  const BlockId disc = hole.add("disc", {circle(kIn, kCorners, false), {}});
  hole.press(kStress);
  Bolt ring = Hole::ring();
  ring.stage = StageId{2};
  const std::vector<char> absent{0, 1};
  ASSERT_EQ(lay_out_liner(hole.model, absent, ring), "");
  hole.model.bolts.push_back(ring);
  for (const double part : {-1.0, 0.5, 1.0}) {
    hole.rest({"nmm", Integrator::implicit}, 3.0, 0.5, 0.12);
    Stage& stage = hole.plan.stages.back();
    if (part < 0.0) continue;
    stage.construction.absent = {disc};
    stage.construction.release = part;
  }
  hole.run();
  EXPECT_LT(hole.expect_thrust(thrust(0.5 * kStress, 0.0, ring.stiffness)), 0.04);
  hole.expect_closed();
}

}  // namespace
}  // namespace scree::test::liner_statics_test
