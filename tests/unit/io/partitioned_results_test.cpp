// Results of a run in which some blocks are integrated explicitly and the others implicitly.
#include <gtest/gtest.h>

#include "tests/support/scene.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::test::partitioned_results_test {
namespace {

using scree::test::rectangle;
using scree::test::Scene;

/// A held base, a block on it that is explicit by list, and one thrown upward beside it, which is slow near the top.
///   v = v0 - g t: explicit after the first step, implicit while |v| < 0.4 m/s, explicit again above 0.8 m/s
Scene thrown_block() {
  Scene scene;
  scene.add("base", rectangle(0.0, -1.0, 6.0, 0.0), true);
  const BlockId listed = scene.add("listed", rectangle(1.0, 0.0, 2.0, 1.0)),
                thrown = scene.add("thrown", rectangle(4.0, 2.0, 5.0, 3.0));
  scene.model.initial_velocities.push_back({thrown, Vec2(0.0, 1.5), 0.0});
  coupling::Stage& s = scene.stage("dda", Integrator::partitioned, 0.3, 2e-3, 1.0);
  s.name = "both";
  s.rules = {{{thrown}, "nmm"}};
  s.partition.explicit_blocks = {listed};
  s.partition.speed = {0.8, 0.4};
  scene.plan.output.every = scene.plan.output.history_every = ticks(0.01);
  return scene;
}

TEST(PartitionedResults, cells_show_the_side_of_their_block_before_and_after_it_changes) {
  const Scratch scratch;
  const Scene scene = thrown_block();
  const coupling::Methods methods = coupling::standard_methods();
  {
    coupling::Driver driver(scene.model, scene.plan, methods);
    ResultsSink sink(RunFolder::create(scratch.path() / "run", false), provenance());
    driver.add_sink(sink);
    ASSERT_EQ(driver.run().status, coupling::RunEnd::Status::done);
  }
  const RunReader run(scratch.path() / "run");
  EXPECT_EQ(run.stages().front().integrator, "partitioned");
  int changes = 0;
  std::vector<std::int32_t> before;
  for (std::size_t k = 0; k < run.times().size(); ++k) {
    const StoredFrame f = run.frame(k);
    EXPECT_EQ(f.integrator, "partitioned");
    // The speed in the step before the frame decides; frames with a speed near a limit are skipped.
    const double speed = std::abs(1.5 - 9.81 * f.time), near = 9.81 * 4e-3;
    const bool first = k == 0, falls = 1.5 - 9.81 * f.time < 0.0;
    const double limit = falls ? 0.8 : 0.4;
    if (!first && std::abs(speed - limit) < near) continue;
    const std::int32_t thrown = !first && speed > limit ? 0 : 1;
    for (std::size_t c = 0; c < f.cells(); ++c) {
      const std::int32_t expected = f.block[c] == 0 ? 1 : f.block[c] == 1 ? 0 : thrown;
      ASSERT_EQ(f.cell_integrator[c], expected) << "t = " << f.time << " block " << f.block[c];
    }
    changes += !before.empty() && before != f.cell_integrator;
    before = f.cell_integrator;
    EXPECT_EQ(f.mesh, 0) << "a change of sides needs no new mesh";
  }
  EXPECT_EQ(changes, 3);
  std::size_t told = 0;
  for (const StoredEvent& e : run.events()) told += e.kind == "partition" ? 1 : 0;
  EXPECT_EQ(told, 3U);
  const std::vector<DatasetNote> notes = run.datasets();
  const auto stored = std::find_if(notes.begin(), notes.end(),
                                   [](const DatasetNote& d) { return d.name == "/VTKHDF/CellData/integrator"; });
  ASSERT_NE(stored, notes.end());
  EXPECT_EQ(stored->rows, static_cast<std::int64_t>(4 * before.size())) << "stored once for frames that share it";
}

}  // namespace
}  // namespace scree::io::test::partitioned_results_test
