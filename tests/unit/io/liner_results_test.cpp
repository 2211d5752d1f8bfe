// Liners in results and pictures, beside a bolt.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coupling/stages/driver.h"
#include "tests/unit/io/case_read.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::test::liner_results_test {
namespace {

using namespace coupling;

/// A block that hangs from two held ones by shotcrete along the underside, installed in the second stage.
const char* const kHung = R"(
material.rock = { density = 2600.0, young = "50 GPa", poisson = 0.2 }
joint.smooth = { friction_deg = 0.0 }
model.default_joint = "smooth"
support = [{ block = "left" }, { block = "right" }]
block = [
  { name = "left", material = "rock", polygon = [[-2, 1], [-0.6, 1], [-0.6, 2], [-2, 2]] },
  { name = "key", material = "rock", polygon = [[-0.5, 1], [0.5, 1], [0.5, 2], [-0.5, 2]] },
  { name = "right", material = "rock", polygon = [[0.6, 1], [2, 1], [2, 2], [0.6, 2]] },
]
bolt = [{ name = "bar", head = [-1, 2], toe = [0, 1.5], axial_stiffness = "1 MN" }]
stage = [{ name = "bare", method = "dda", integrator = "implicit", dt = "1 ms", duration = 0.01 },
         { name = "lined", method = "dda", integrator = "implicit", dt = "1 ms", duration = 0.05 }]
[[liner]]
name = "skin"
along = [[-1.05, 1.0], [1.05, 1.0]]
spacing = 0.3
thickness = 0.1
young = "30 GPa"
stage = "lined"
[output]
every = 0.01
history_every = 1e-3
)";

TEST(LinerResults, thrust_and_moment_are_in_the_histories_and_its_nodes_in_frames_and_pictures) {
  const Scratch scratch;
  const fs::path run = scratch.path() / "run";
  const Case c = read_text(kHung);
  ResultsSink sink(RunFolder::create(run, false), provenance());
  const Methods methods = standard_methods();
  Driver driver(c.model, c.plan, methods);
  driver.add_sink(sink);
  const RunEnd end = driver.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const BoltMemory& skin = driver.state().bolts[1];

  const h5::File file = h5::File::open(run / "run.vtkhdf");
  const auto thrust = h5::read<double>(file, "/liners/skin/thrust"),
             moment = h5::read<double>(file, "/liners/skin/moment");
  ASSERT_GT(thrust.size(), 50U);
  EXPECT_EQ(thrust.front(), 0.0);  // not installed yet
  double most = 0.0, bend = 0.0;
  for (const double N : skin.force)
    if (std::abs(N) > std::abs(most)) most = N;
  for (const double M : skin.shear) bend = std::max(bend, std::abs(M));
  EXPECT_GT(bend, 0.0);
  EXPECT_EQ(thrust.back(), most);
  EXPECT_EQ(moment.back(), bend);
  EXPECT_EQ(h5::read<double>(file, "/bolts/bar/force").size(), thrust.size());

  const std::string table = text_of(run / "history.csv"), header = table.substr(0, table.find('\n'));
  EXPECT_NE(header.find("bar.broken [1],skin.thrust [N],skin.moment [N m],skin.plastic_strain [1],skin.broken [1]"),
            std::string::npos)
      << header;
  EXPECT_NE(table.find(fmt::format(",{:.17g},{:.17g},", most, bend)), std::string::npos);

  const RunReader reader(run);
  const StoredBolts first = reader.bolts(0), last = reader.bolts(reader.times().size() - 1);
  EXPECT_EQ(first.bolt.size(), 2U);
  EXPECT_EQ(last.bolt.size(), 2U + c.model.bolts[1].nodes.size());
  snapshot(run, SnapshotOptions{}, scratch.path() / "liner.png");
  EXPECT_GT(fs::file_size(scratch.path() / "liner.png"), 1000U);
}

}  // namespace
}  // namespace scree::io::test::liner_results_test
