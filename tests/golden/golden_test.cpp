// Ten scenes of all kinds of steps: the state after every hundredth step is the same on 1, 2 and 3 threads, and in a
// second run. Compared within one build on one machine: no hash is stored, since other compilers round otherwise.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/stages/driver.h"
#include "io/case/read_case.h"

namespace scree::test::golden_test {
namespace {

struct Golden {
  const char* name;
  const char* file;  // from the project's root
  double until;      // [s]
  std::vector<std::string> set = {};
};
std::ostream& operator<<(std::ostream& out, const Golden& g) { return out << g.name; }

const Golden kScenes[] = {
    {"explicit_nmm", "cases/joint-wave/case.toml", 6e-4},
    {"explicit_dda",
     "cases/staged-slope/case.toml",
     0.1,
     {"stage.0.integrator=\"explicit\"", "stage.0.dt=\"auto\"", "stage.0.rest=false"}},
    {"implicit_nmm", "cases/five-joints/implicit.toml", 6e-4},
    {"implicit_dda", "cases/jinping/case.toml", 1.0, {"stage.0.dt=0.004"}},
    {"partitioned", "cases/slope-ei/case.toml", 0.02},
    {"sides_by_speed", "tests/e2e/resume/sides.toml", 0.352},
    {"divided", "tests/e2e/resume/divided.toml", 0.13},
    {"switch", "tests/e2e/resume/rules.toml", 0.12},
    {"staged", "tests/e2e/resume/staged.toml", 0.48},
    {"kept_factor", "tests/e2e/resume/kept.toml", 0.51},
};

/// Hashes of the state, of every hundredth step and of the last.
struct Hashes final : coupling::Sink {
  static constexpr std::int64_t kEvery = 100;
  const coupling::Driver* run = nullptr;
  std::int64_t steps = 0;
  std::vector<std::uint64_t> seen;
  void step(double /*time*/, const coupling::RunStats& /*stats*/, const coupling::Ledger& /*ledger*/) override {
    if (++steps % kEvery == 0) seen.push_back(coupling::state_hash(run->state()));
  }
};

std::vector<std::uint64_t> hashes(const io::Case& c, const Golden& scene, int threads) {
  omp_set_num_threads(threads);
  static const coupling::Methods kMethods = coupling::standard_methods();
  coupling::Driver run(c.model, c.plan, kMethods);
  Hashes out;
  out.run = &run;
  run.add_sink(out);
  const coupling::RunEnd end = run.run(scene.until);
  EXPECT_TRUE(end.status == coupling::RunEnd::Status::done || end.status == coupling::RunEnd::Status::interrupted)
      << end.reason;
  out.seen.push_back(coupling::state_hash(run.state()));
  return out.seen;
}

class Scenes : public testing::TestWithParam<Golden> {};

TEST_P(Scenes, have_the_same_states_on_one_two_and_three_threads) {
  const Golden& scene = GetParam();
  const std::vector<std::string> methods = {"nmm", "dda"};
  const io::Case c = io::read_case(std::string(SCREE_SOURCE_DIR "/") + scene.file, scene.set, methods);
  const std::vector<std::uint64_t> one = hashes(c, scene, 1);
  EXPECT_GE(one.size(), 2U) << "too few steps to say anything";
  EXPECT_NE(one.front(), one.back());
  for (const int threads : {2, 3}) EXPECT_EQ(hashes(c, scene, threads), one) << threads << " threads";
  omp_set_num_threads(omp_get_num_procs());
}

INSTANTIATE_TEST_SUITE_P(Golden, Scenes, testing::ValuesIn(kScenes),
                         [](const testing::TestParamInfo<Golden>& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace scree::test::golden_test
