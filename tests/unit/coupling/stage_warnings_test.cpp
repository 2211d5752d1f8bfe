// Warnings that a stage derives from its results: each with a case that triggers it, and none without the cause.
#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::stage_warnings_test {
namespace {

using namespace coupling;

struct Warnings final : Sink {
  std::vector<std::string> texts;
  void event(const Event& e) override {
    if (e.kind == EventKind::warning) texts.push_back(e.text);
  }
  /// The warning that contains `what`, or an empty text.
  [[nodiscard]] std::string of(const std::string& what) const {
    for (const std::string& text : texts)
      if (text.find(what) != std::string::npos) return text;
    return {};
  }
};

/// A block that falls onto a held base from `height` [m] in an explicit stage to rest of `duration` [s].
struct Dropped {
  RunEnd end;
  Warnings warnings;

  Dropped(double height, double duration) {
    Scene scene(1e8, 0.2, 2000.0);
    scene.add("base", rectangle(-1.0, -1.0, 2.0, 0.0), true);
    scene.add("stone", rectangle(0.0, height, 1.0, 1.0 + height));
    scene.stage("dda", Integrator::explicit_, duration, std::nullopt).rest = true;
    Driver run(scene.model, scene.plan, methods());
    run.add_sink(warnings);
    end = run.run();
  }
};

TEST(StageWarnings, block_in_flight_at_the_end_of_a_stage_to_rest) {
  const Dropped flies(0.5, 0.05), stands(0.0, 1.0);
  EXPECT_EQ(flies.end.status, RunEnd::Status::done);
  const std::string told = flies.warnings.of("has no chain of contacts to a support at the end of the stage");
  EXPECT_NE(told.find("block 'stone'"), std::string::npos) << told;
  EXPECT_NE(told.find("t = 0.05 s, stage 'dda0'"), std::string::npos) << told;
  EXPECT_EQ(stands.end.status, RunEnd::Status::done);
  EXPECT_EQ(stands.warnings.of("no chain of contacts"), "");
}

TEST(StageWarnings, stage_that_ends_before_it_is_at_rest) {
  const Dropped early(0.0, 0.01), rests(0.0, 1.0);
  EXPECT_EQ(early.end.status, RunEnd::Status::done);
  const std::string told = early.warnings.of("ends before it is at rest");
  EXPECT_NE(told.find("block 'stone' has an unbalanced force of"), std::string::npos) << told;
  EXPECT_NE(told.find("make the stage longer, or give rest_force"), std::string::npos) << told;
  EXPECT_EQ(rests.end.status, RunEnd::Status::done);
  EXPECT_EQ(rests.warnings.of("ends before"), "");
}

}  // namespace
}  // namespace scree::test::stage_warnings_test
