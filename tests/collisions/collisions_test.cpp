// Blocks thrown together without friction and damping: nothing takes energy, and no column of the ledger makes any.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

#include "tests/support/schemes.h"

namespace scree::test {
namespace {

using namespace coupling;

/// n x n regular triangles to hexagons, 1.6 m from each other, that fly towards their middle and turn.
Scene thrown(int n, double safety, double duration, unsigned seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double from, double to) { return std::uniform_real_distribution<double>(from, to)(random); };
  Scene scene(1e8, 0.2, 2600.0, 0.0);
  scene.model.gravity.setZero();
  scene.model.joints[0].damping = 0.0;
  for (int i = 0; i < n * n; ++i) {
    const Vec2 at(1.6 * (i % n) - 0.8 * (n - 1), 1.6 * (i / n) - 0.8 * (n - 1));
    const int corners = std::uniform_int_distribution<int>(3, 6)(random);
    const double radius = uniform(0.45, 0.7), turn = uniform(0.0, 2.0 * M_PI);
    Polygon outline;
    for (int c = 0; c < corners; ++c)
      outline.outer.push_back(at + rotation(turn + 2.0 * M_PI * c / corners) * Vec2(radius, 0.0));
    const BlockId block = scene.add("b" + std::to_string(i), outline);
    scene.model.initial_velocities.push_back(
        {block, -6.0 / n * at + Vec2(uniform(-1.0, 1.0), uniform(-1.0, 1.0)), uniform(-3.0, 3.0)});
  }
  scene.stage("dda", Integrator::explicit_, duration, std::nullopt).safety = safety;
  return scene;
}

struct Kept {
  double energy = 0.0, closure = 0.0;  // of that at the start
  double made = 0.0;                   // the largest of columns that may not make any
};
Kept kept(const Scene& scene) {
  struct Sums final : Sink {
    double first = 0.0;
    void history(const HistoryView& view) override {
      if (first == 0.0) first = view.ledger->energy();
    }
  } sums;
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(sums);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const Ledger& ledger = run.state().ledger;
  Kept out;
  out.energy = ledger.energy() / sums.first;
  out.closure = ledger.relative_closure();
  for (int c = 0; c < kColumns; ++c) {
    const auto column = static_cast<Column>(c);
    const double of = ledger[column] / sums.first;
    if (std::abs(of) > 1e-6) std::printf("  %-20s %+.2e of the energy\n", info(column).name.data(), of);
    if (info(column).side == Side::dissipated) out.made = std::max(out.made, -of);
  }
  out.made = std::max({out.made, ledger[Column::contact_share] / sums.first});
  return out;
}

TEST(Collisions, thrown_blocks_keep_their_energy) {
  // SCREE_FULL=1: a hundred blocks, 10 s.
  const bool full = std::getenv("SCREE_FULL") != nullptr;
  for (const auto& [safety, within] : {std::pair(0.8, 0.03), std::pair(0.1, 0.01)}) {
    const Kept run = kept(thrown(std::getenv("NB") ? std::atoi(std::getenv("NB")) : full ? 10 : 4, safety, std::getenv("NT") ? std::atof(std::getenv("NT")) : full ? 10.0 : 1.0, 1));
    std::printf("safety %.1f: %.5f of the energy is kept, columns that may not make any made %.1e, closure %.1e\n", safety,
                run.energy, run.made, run.closure);
    EXPECT_NEAR(run.energy, 1.0, within);
    EXPECT_LT(run.made, 1e-4);
    EXPECT_LT(run.closure, 1e-9);
  }
}

}  // namespace
}  // namespace scree::test
