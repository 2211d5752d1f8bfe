// Stress at monitors and contacts in frames, against uniform stress states and the weight of a block.
#include "coupling/stages/observer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "dda/dda_pool.h"
#include "tests/support/scene.h"

namespace scree::test::observer_test {
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
// bit for bit: the weights of a row are one and zeros. The blocks live in two pools, the monitors in a random
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
  ASSERT_EQ(run.setup().pools(), 3u);  // the base has its own pool
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

/// Keeps the first history.
class First final : public coupling::Sink {
 public:
  void history(const coupling::HistoryView& h) override {
    if (monitors.empty()) monitors.assign(h.stress.begin(), h.stress.end());
  }
  std::vector<double> monitors;
};

// A uniform stress is recovered unchanged, also in cut elements and at corners; rotated blocks of both methods earlier
// in the model must not shift the offsets of pools or bodies.
TEST(MonitorStress, is_the_in_situ_stress_at_the_start_of_an_nmm_block) {
  Scene scene(1e9, 0.2, 2500.0, 30.0);
  scene.model.gravity = {0.0, 0.0};
  InitialStress in_situ;
  in_situ.stress << -2e6, 3e5, 3e5, -1e6;
  scene.add("affine", rectangle(0, 0, 1, 1));
  scene.add("plain", rectangle(2, 0, 3, 1));
  scene.model.materials.push_back(scene.model.materials[0]);
  scene.model.materials[1].initial_stress = in_situ;
  const BlockId block = scene.add("stressed", transformed(rectangle(0, 0, 3, 2), {6.0, 0.0}, rotation(0.4)));
  scene.model.blocks[block.index()].material = MaterialId{1};
  const Ring& corners = scene.model.blocks[block.index()].polygon.outer;
  scene.model.monitors = {{"corner", block, corners[0]},
                          {"edge", block, Vec2(0.5 * (corners[0] + corners[1]))},
                          {"inside", block, Vec2(0.3 * corners[1] + 0.7 * corners[3])},
                          {"plain", BlockId{1}, {2.5, 0.5}}};
  coupling::Stage& stage = scene.stage("nmm", coupling::Integrator::explicit_, 1e-5, std::nullopt, 0.4);
  stage.rules = {{{BlockId{0}}, "dda"}};
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  First first;
  run.add_sink(first);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  ASSERT_EQ(first.monitors.size(), 12u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(first.monitors[3 * i], -2e6, 1e-3) << i;  // rounding of positions (1e-15) times E/h is 1e-5 Pa
    EXPECT_NEAR(first.monitors[3 * i + 1], -1e6, 1e-3) << i;
    EXPECT_NEAR(first.monitors[3 * i + 2], 3e5, 1e-3) << i;
  }
  for (std::size_t c = 9; c < 12; ++c) EXPECT_NEAR(first.monitors[c], 0.0, 1e-3);
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

/// Checks the contacts of every frame.
class Contacts final : public coupling::Sink {
 public:
  void frame(const coupling::FrameView& f) override {
    ++frames;
    if (f.contacts == nullptr) return;
    ++shown;
    weight = 0.0;
    ASSERT_EQ(f.contacts->memory.size(), f.state->contacts.size());
    ASSERT_EQ(f.contacts->position.size(), 2 * f.contacts->memory.size());
    for (std::size_t i = 0; i < f.contacts->memory.size(); ++i) {
      const coupling::ContactMemory& m = f.contacts->memory[i];
      const Vec2 at(f.contacts->position[2 * i], f.contacts->position[2 * i + 1]),
          normal(f.contacts->normal[2 * i], f.contacts->normal[2 * i + 1]);
      EXPECT_NEAR(normal.norm(), 1.0, 1e-15);
      // The joint is the line y = 0: the normal points up at corners of the block, down at corners of the base.
      EXPECT_NEAR(normal.y(), m.key.block_p == 1 ? 1.0 : -1.0, 1e-6);
      EXPECT_NEAR(at.y(), 0.0, 1e-3);
      if (m.key.block_p == 1) {
        EXPECT_NEAR(at.y() - m.gap0, m.gap, 1e-12);  // the base is held
      }
      if (m.key.block_p == 1 && m.key.part == 0) corners += at.x() == 0.0 || at.x() == 2.0 ? 1 : 0;
      weight += m.fn;
    }
  }
  int frames = 0, shown = 0, corners = 0;
  double weight = 0.0;
};

TEST(ContactView, shows_the_points_of_every_frame_where_it_is_asked_for) {
  for (const bool asked : {false, true}) {
    Scene scene(1e8, 0.0, 2500.0, 30.0);
    scene.add("base", rectangle(-1, -1, 3, 0), true);
    scene.add("block", rectangle(0, 0, 2, 1));
    for (const char* method : {"nmm", "dda"}) {
      coupling::Stage& stage = scene.stage(method, coupling::Integrator::implicit, 1.0, 0.05, 0.4);
      stage.rest = true;
    }
    scene.plan.output.contacts = asked;
    const coupling::Methods methods = coupling::standard_methods();
    coupling::Driver run(scene.model, scene.plan, methods);
    Contacts contacts;
    run.add_sink(contacts);
    ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
    EXPECT_GT(contacts.frames, 20);
    EXPECT_EQ(contacts.shown, asked ? contacts.frames : 0);
    if (!asked) continue;
    EXPECT_GE(contacts.corners, 2);  // at the start
    EXPECT_NEAR(contacts.weight, 2.0 * 2500.0 * 9.81, 1.0);
  }
}

}  // namespace
}  // namespace scree::test::observer_test
