// Excess bending stiffness of coarse covers: the note against computed cantilevers, and the blocks it is given for.
#include "coupling/stages/bending_note.h"

#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::bending_note_test {
namespace {

using namespace coupling;

/// A cantilever of 10 x 1 m, rotated by an angle, under a small transverse weight.
struct Cantilever {
  static constexpr double kLength = 10.0, kYoung = 1e9, kDensity = 20.0;
  Scene scene{kYoung, 0.0, kDensity};
  Vec2 along, across;

  Cantilever(double angle, double cover) {
    along = Vec2(std::cos(angle), std::sin(angle));
    across = Vec2(-along.y(), along.x());
    scene.model.gravity = -9.81 * across;
    scene.model.plane = Plane::stress;
    const auto at = [&](double x, double y) -> Vec2 { return x * along + y * across; };
    const BlockId beam = scene.add("beam", {{at(0, 0), at(kLength, 0), at(kLength, 1), at(0, 1)}, {}});
    scene.model.edge_supports.push_back({{beam, {0, 3}, 0.0, 1.0}, Mat2::Identity(), {}});
    scene.stage("nmm", Integrator::implicit, 400.0, 2.0, cover).rest = true;
  }
  /// Deflection of the tip over that of the beam with bending and shear [Timoshenko].
  [[nodiscard]] double deflection() const {
    Driver run(scene.model, scene.plan, methods());
    EXPECT_EQ(run.run().status, RunEnd::Status::done);
    const Setup& setup = run.setup();
    const Body& b = setup.bodies()[0];
    const Vec2 tip = kLength * along + 0.5 * across;
    const Row row = setup.global(b, setup.pool_of(b).row_at(b.index, tip - b.centre));
    const double moved = (position(row, run.state().q) - tip).dot(-across);
    const double q = kDensity * 9.81;
    return moved / (q * std::pow(kLength, 4) / (8.0 * kYoung / 12.0) + q * kLength * kLength / (kYoung * 5.0 / 6.0));
  }
};

TEST(BendingNote, excess_is_that_of_cantilevers_and_falls_with_order_two) {
  for (const double angle : {0.0, 0.5}) {
    const double coarse = 1.0 / Cantilever(angle, 0.5).deflection() - 1.0,
                 fine = 1.0 / Cantilever(angle, 0.25).deflection() - 1.0;
    std::printf("at %.1f rad: too stiff by %.3f (%.3f), %.3f (%.3f)\n", angle, coarse, bending_excess(0.5, 1.0), fine,
                bending_excess(0.25, 1.0));
    EXPECT_NEAR(coarse / bending_excess(0.5, 1.0), 1.0, 0.3);
    EXPECT_NEAR(fine / bending_excess(0.25, 1.0), 1.0, 0.15);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.25);
  }
}

TEST(BendingNote, names_the_worst_and_counts_the_others) {
  Scene scene;
  scene.add("bench", rectangle(0, 0, 10, 2));
  scene.add("slab", rectangle(0, 2, 10, 3));
  scene.add("cube", rectangle(0, 3, 1, 4));
  scene.add("held", rectangle(0, -0.2, 10, 0), true);
  const Stage stage = scene.stage("nmm", Integrator::implicit, 1.0, 1e-3, 0.5);
  const std::optional<std::string> note = bending_note(scene.model, stage);
  ASSERT_TRUE(note);
  EXPECT_NE(note->find("make block 'slab', 1 m thick, bend about 45 % too stiffly, and 1 more"), std::string::npos)
      << *note;
  EXPECT_NE(note->find("covers of 0.24 m do so by 10 %"), std::string::npos) << *note;
  Stage coarse = stage, fine = stage, dda = stage;
  coarse.cover_size = 2.0;
  EXPECT_NE(bending_note(scene.model, coarse)->find("bend more than twice too stiffly, or not at all, and 1 more"),
            std::string::npos)
      << *bending_note(scene.model, coarse);
  fine.cover_size = 0.2;
  EXPECT_FALSE(bending_note(scene.model, fine));
  dda.method = "dda";
  EXPECT_FALSE(bending_note(scene.model, dda));
}

}  // namespace
}  // namespace scree::test::bending_note_test
