// What monitors report of stress.
#include "coupling/stages/observer.h"

#include <gtest/gtest.h>

#include "dda/dda_pool.h"
#include "tests/support/scene.h"

namespace scree::test {
namespace {

/// Keeps the last frame and the last history.
class Last final : public coupling::Sink {
 public:
  void topology(const coupling::MeshView& mesh) override {
    blocks.assign(mesh.cell_block.begin(), mesh.cell_block.end());
  }
  void frame(const coupling::FrameView& f) override { cells.assign(f.stress.begin(), f.stress.end()); }
  void history(const coupling::HistoryView& h) override { monitors.assign(h.stress.begin(), h.stress.end()); }

  std::vector<std::int32_t> blocks;
  std::vector<double> cells, monitors;
};

// The stress of an affine block is the same everywhere, so that a monitor anywhere on it must report that of its cells,
// bit for bit: a row weighs the stress with one, and with zeros. The blocks live in two pools, the monitors in a random
// order, so that a wrong offset of a pool or a body shows.
TEST(MonitorStress, equals_that_of_the_cell_on_affine_blocks_of_two_pools) {
  Scene scene(1e8, 0.2, 2500.0, 30.0);
  scene.add("base", rectangle(-1, -1, 8, 0), true);
  const BlockId left = scene.add("left", rectangle(0, 0, 1, 1)), on_left = scene.add("on left", rectangle(0, 1, 1, 3)),
                right = scene.add("right", rectangle(3, 0, 5, 1)),
                on_right = scene.add("on right", rectangle(3.5, 1, 5, 4));
  scene.model.monitors = {{"a", on_right, {3.5, 4.0}},
                          {"b", left, {0.25, 0.5}},
                          {"c", right, {5.0, 0.0}},
                          {"d", on_left, {1.0, 3.0}},
                          {"e", right, {3.5, 0.75}}};
  coupling::Stage& stage = scene.stage("dda", coupling::Integrator::implicit, 0.1, 1e-2);
  stage.rules = {{{right, on_right}, "other"}};
  coupling::Methods methods = coupling::standard_methods();
  methods["other"] = [] { return std::make_unique<dda::DdaPool>(); };
  coupling::Driver run(scene.model, scene.plan, methods);
  Last last;
  run.add_sink(last);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  ASSERT_EQ(run.setup().pools(), 2u);
  ASSERT_EQ(last.monitors.size(), 15u);
  for (std::size_t i = 0; i < 5; ++i) {
    const std::int32_t block = scene.model.monitors[i].block.value;
    const auto cell =
        static_cast<std::size_t>(std::find(last.blocks.begin(), last.blocks.end(), block) - last.blocks.begin());
    ASSERT_LT(cell, last.blocks.size());
    EXPECT_LT(last.cells[3 * cell + 1], -1e3) << "the weight above is about 25 kPa a metre";
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(last.monitors[3 * i + c], last.cells[3 * cell + c]) << i << ' ' << c;
  }
  EXPECT_NE(last.monitors[1], last.monitors[4]);
}

TEST(MonitorStress, is_empty_without_monitors) {
  Scene scene;
  scene.add("block", rectangle(0, 0, 1, 1));
  scene.stage("dda", coupling::Integrator::explicit_, 1e-3, std::nullopt);
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  Last last;
  run.add_sink(last);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  EXPECT_TRUE(last.monitors.empty());
}

}  // namespace
}  // namespace scree::test
