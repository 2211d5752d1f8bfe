// Audits of random models, many of which hardly move or fly freely without gravity: no false alarm, and a fault planted
// in such a model is found.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "coupling/stages/round_off.h"
#include "tests/support/schemes.h"

namespace scree::test::random_audit_test {
namespace {

using coupling::Integrator;

constexpr std::uint32_t kModels = 200;

/// One to three blocks in a heap or apart, on a floor or in the air, with or without gravity and motion, near the
/// origin or a thousand sizes away, in one or two stages of any scheme.
Scene random_scene(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto number = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  const auto one_of = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
  const double size = std::pow(10.0, number(-1.0, 2.0)), density = number(500.0, 5000.0);
  // Stiff enough not to fold under the weight or at an impact.
  const double young = 300.0 * density * (9.81 * size + 20.0) * std::pow(10.0, number(0.0, 4.0));
  Scene scene(young, number(0.0, 0.45), density, number(0.0, 60.0));
  scene.model.gravity = Vec2(0.0, std::array{0.0, -1e-9, -9.81, -9.81}[one_of(4)]);
  const Vec2 place = one_of(2) == 0 ? Vec2(0.0, 0.0) : size * Vec2(number(-1e3, 1e3), number(-1e3, 1e3));
  const bool floor = one_of(3) > 0, moves = one_of(2) == 0, apart = one_of(2) == 0;
  if (floor) scene.add("floor", transformed(rectangle(-size, -size, 7 * size, 0), place, rotation(0.0)), true);
  double top = 0.0;
  for (std::uint32_t i = 0, blocks = 1 + one_of(3); i < blocks; ++i) {
    const double w = size * number(0.3, 1.0), h = size * number(0.3, 1.0), tilt = apart ? number(-1.0, 1.0) : 0.0;
    const Vec2 at = place + (apart ? size * Vec2(2.5 * i, 1.3) : Vec2(0.0, top));
    const BlockId id = scene.add("b" + std::to_string(i), transformed(rectangle(0, 0, w, h), at, rotation(tilt)));
    top += h;
    const double spin = one_of(2) == 0 ? 0.0 : number(-2.0, 2.0);
    if (moves) scene.model.initial_velocities.push_back({id, Vec2(number(-3.0, 3.0), number(-3.0, 3.0)), spin});
  }
  const double step = 0.02 * size * std::sqrt(density / young);
  for (std::uint32_t s = 0, stages = 1 + one_of(2); s < stages; ++s) {
    const char* method = one_of(2) == 0 ? "dda" : "nmm";
    const Integrator integrator =
        std::array{Integrator::explicit_, Integrator::implicit, Integrator::partitioned}[one_of(3)];
    const bool is_explicit = integrator == Integrator::explicit_;
    const double dt = is_explicit ? step : step * std::pow(10.0, number(0.0, 2.0));
    coupling::Stage& stage =
        scene.stage(method, integrator, 40 * dt, is_explicit ? std::nullopt : std::optional(dt), 0.5 * size);
    stage.partition.speed = {1.0, 0.5};
    if (one_of(4) == 0) stage.damping = 0.1 / step;
  }
  scene.plan.audit = true;
  scene.plan.max_closure = 1e-9;
  return scene;
}

TEST(RandomAudit, blocks_at_rest_and_in_flight_give_no_alarm) {
  int of_nothing = 0, flying = 0;
  for (std::uint32_t seed = 1; seed <= kModels; ++seed) {
    const Scene scene = random_scene(seed);
    coupling::Driver run(scene.model, scene.plan, methods());
    const coupling::RunEnd end = run.run();
    const coupling::Ledger& ledger = run.state().ledger;
    EXPECT_EQ(end.status, coupling::RunEnd::Status::done) << "model " << seed << ": " << end.reason;
    const bool nothing = ledger.next_to_nothing(ledger.moved());
    of_nothing += nothing ? 1 : 0;
    flying += scene.model.gravity.y() == 0.0 && !scene.model.initial_velocities.empty() ? 1 : 0;
    EXPECT_LE(std::abs(ledger.closure()), coupling::kCloses * ledger.moved() + ledger.last_places()) << seed;
    EXPECT_LE(ledger.relative_closure(), coupling::kCloses) << "model " << seed;
  }
  std::printf("%d of %u models moved next to nothing, %d fly without gravity\n", of_nothing, kModels, flying);
  EXPECT_GE(of_nothing, 10);
  EXPECT_GE(flying, 10);
}

/// Changes the velocities of a run once, without booking the change in the ledger.
struct Push final : coupling::Sink {
  double by = 0.0;  // relative change
  bool done = false;
  void frame(const coupling::FrameView& view) override {
    if (done || view.time == 0.0) return;
    done = true;
    for (double& v : const_cast<coupling::State*>(view.state)->v) v *= 1.0 + by;  // NOLINT: a fault, planted
  }
};

class PlantedFault : public testing::TestWithParam<Scheme> {};

TEST_P(PlantedFault, energy_from_nowhere_is_found_in_free_flight) {
  const Scheme& s = GetParam();
  for (const double by : {0.0, 1e-8, -1e-6}) {
    Scene scene;
    scene.model.gravity = Vec2(0.0, 0.0);
    const BlockId id = scene.add("b", rectangle(0, 0, 1, 1));
    scene.model.initial_velocities.push_back({id, Vec2(2.0, 1.0), 0.5});
    scene.stage(s.method, s.integrator, 0.01, s.implicit() ? std::optional(1e-4) : std::nullopt);
    scene.plan.audit = true;
    coupling::Driver run(scene.model, scene.plan, methods());
    Push push;
    push.by = by;
    run.add_sink(push);
    const coupling::RunEnd end = run.run();
    ASSERT_TRUE(push.done);
    EXPECT_EQ(end.status == coupling::RunEnd::Status::done, by == 0.0) << by << ": " << end.reason;
    EXPECT_EQ(end.reason.find("the energy ledger is open") != std::string::npos, by != 0.0) << end.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(Schemes, PlantedFault, testing::ValuesIn(kAllSchemes),
                         [](const auto& p) { return p.param.name; });

TEST(LastPlaces, are_far_below_what_an_audit_allows_where_something_moves) {
  // A block of 1 m that falls by a metre in 1000 steps: round-off of positions is less than 1e-9 of its energy.
  Scene scene(1e10);
  scene.add("b", rectangle(0, 0, 1, 1));
  coupling::State state;
  state.q = {1.0, 1.0};
  state.step = 1000;
  state.time = ticks(0.45);
  state.ledger.book(coupling::Column::gravity, 2600.0 * 9.81);
  state.ledger.pass();
  const double found = coupling::energy_of_last_places(scene.model, state);
  EXPECT_LT(found, 1e-9 * state.ledger.moved());
  EXPECT_GT(found, 1e-16 * state.ledger.moved());
}

}  // namespace
}  // namespace scree::test::random_audit_test
