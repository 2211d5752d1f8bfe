// Bolts in results and pictures, tested with the example of the documentation.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coupling/stages/driver.h"
#include "tests/unit/io/case_read.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::test::bolt_results_test {
namespace {

using namespace coupling;

/// The example, run once.
class BoltResults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scratch = std::make_unique<Scratch>();
    run = scratch->path() / "run";
    example = std::make_unique<Case>(read_case(SCREE_SOURCE_DIR "/docs/examples/bolted-slope.toml", {}, kMethods));
    ResultsSink sink(RunFolder::create(run, false), provenance());
    methods = std::make_unique<Methods>(standard_methods());
    driver = std::make_unique<Driver>(example->model, example->plan, *methods);
    driver->add_sink(sink);
    end = driver->run();
  }
  static void TearDownTestSuite() {
    driver.reset();
    scratch.reset();
  }
  static inline std::unique_ptr<Scratch> scratch;
  static inline fs::path run;
  static inline std::unique_ptr<Case> example;
  static inline std::unique_ptr<Methods> methods;
  static inline std::unique_ptr<Driver> driver;
  static inline RunEnd end;
};

TEST_F(BoltResults, example_holds_and_closes) {
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const Ledger& ledger = driver->state().ledger;
  EXPECT_LT(std::abs(ledger.closure()), 1e-9 * ledger.moved());
  EXPECT_GT(driver->state().bolts[0].force[0], 19e3);  // more than the force that holds the block
  EXPECT_GT(driver->state().bolts[1].installed, 0);
}

TEST_F(BoltResults, histories_hold_forces_and_the_table_too) {
  const h5::File file = h5::File::open(run / "run.vtkhdf");
  const auto time = h5::read<double>(file, "/bolts/anchor/time"), force = h5::read<double>(file, "/bolts/anchor/force");
  ASSERT_EQ(time.size(), force.size());
  ASSERT_GT(time.size(), 100U);
  const std::vector<double>& now = driver->state().bolts[0].force;
  EXPECT_EQ(force.back(), *std::max_element(now.begin(), now.end()));
  EXPECT_EQ(h5::read<double>(file, "/bolts/bar/force").front(), 0.0);  // not installed yet
  const std::string table = text_of(run / "history.csv"), header = table.substr(0, table.find('\n'));
  EXPECT_NE(
      header.find("anchor.force [N],anchor.shear [N],anchor.slip [m],anchor.plastic_strain [1],anchor.broken [1]"),
      std::string::npos)
      << header;
  EXPECT_NE(table.find(fmt::format(",{:.17g},", force.back())), std::string::npos);
}

TEST_F(BoltResults, frames_hold_the_nodes_of_those_that_are_there) {
  const RunReader reader(run);
  const StoredBolts first = reader.bolts(0), last = reader.bolts(reader.times().size() - 1);
  const std::vector<Bolt>& bolts = driver->setup().model().bolts;
  EXPECT_EQ(first.bolt.size(), bolts[0].nodes.size());
  ASSERT_EQ(last.bolt.size(), bolts[0].nodes.size() + bolts[1].nodes.size());
  EXPECT_EQ(last.position.size(), 2 * last.bolt.size());
  EXPECT_NEAR((Vec2(first.position[0], first.position[1]) - bolts[0].head).norm(), 0.0, 1e-3);
  EXPECT_EQ(last.force[0], driver->state().bolts[0].force[0]);
}

TEST_F(BoltResults, pictures_draw_them) {
  const fs::path png = scratch->path() / "bolts.png";
  snapshot(run, SnapshotOptions{}, png);
  cairo_surface_t* surface = cairo_image_surface_create_from_png(png.c_str());
  const int width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const int stride = cairo_image_surface_get_stride(surface);
  int inked = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const unsigned char* p = data + y * stride + 4 * x;
      if (std::abs(p[2] - 191) < 4 && std::abs(p[1] - 26) < 4 && std::abs(p[0] - 115) < 4) ++inked;
    }
  cairo_surface_destroy(surface);
  EXPECT_GT(inked, 200);
}

}  // namespace
}  // namespace scree::io::test::bolt_results_test
