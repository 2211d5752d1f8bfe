// Recorded motions of SCREE_RECORDS, if that folder exists: the computed facts agree with their catalogue.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "io/case/record.h"
#include "model/record_processing.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::shared_records_test {
namespace {

/// A row of the table beside the records. PGA and Arias intensity have three decimals there.
struct Catalogued {
  const char* file;
  std::size_t points;
  double dt, pga_g, arias;
};

std::ostream& operator<<(std::ostream& out, const Catalogued& row) { return out << row.file; }
class SharedRecord : public testing::TestWithParam<Catalogued> {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("SCREE_RECORDS");
    if (!folder || !*folder) GTEST_SKIP() << "SCREE_RECORDS is not set";
    file_ = std::filesystem::path(folder) / GetParam().file;
    if (!std::filesystem::exists(file_)) GTEST_SKIP() << file_ << " does not exist";
  }
  [[nodiscard]] Samples samples() const {
    Record r = read_record(file_, Gaps::refuse);
    for (double& a : r.acceleration) a *= kStandardGravity;
    return {std::move(r.time), std::move(r.acceleration)};
  }
  static MotionFacts facts_of(const Samples& s) { return GroundMotion(s.time, s.acceleration, {1.0, 0.0}).facts(); }
  std::filesystem::path file_;
};

TEST_P(SharedRecord, facts_are_those_of_the_catalogue) {
  const Samples s = samples();
  const MotionFacts f = facts_of(s);
  EXPECT_EQ(s.time.size(), GetParam().points);
  EXPECT_NEAR(f.duration, static_cast<double>(GetParam().points - 1) * GetParam().dt, 1e-9);
  EXPECT_NEAR(f.pga / kStandardGravity, GetParam().pga_g, 0.0005);  // half a unit of the last decimal
  EXPECT_NEAR(f.arias, GetParam().arias, 0.0005);
}

TEST_P(SharedRecord, pga_taper_and_baseline_hold_together) {
  RecordProcessing how;
  how.pga = 3.0;
  how.taper = 0.5;
  how.baseline = Baseline::quadratic;
  const Samples s = process(samples(), how);
  EXPECT_NEAR(peak(s), 3.0, 1e-14);
  EXPECT_NEAR(facts_of(s).final_velocity, 0.0, 1e-13);  // round-off of five thousand steps
}

TEST_P(SharedRecord, resampled_finer_is_the_same_motion) {
  const Samples s = samples(), fine = resample(s, GetParam().dt / 4.0, Between::linear);
  EXPECT_EQ(fine.time.size(), 4 * (s.time.size() - 1) + 1);
  const MotionFacts f = facts_of(s), g = facts_of(fine);
  EXPECT_NEAR(g.pgv, f.pgv, 1e-9);  // times of three decimals give steps of 0.00499999999999989 s
  EXPECT_NEAR(g.final_displacement, f.final_displacement, 1e-9);
}

TEST_P(SharedRecord, with_a_row_missing_is_refused) {
  std::string text = bytes_of(file_.string());
  std::size_t at = text.size() / 2;
  at = text.find('\n', at) + 1;
  text.erase(at, text.find('\n', at) + 1 - at);
  try {
    (void)read_columns(text, "gap.csv", Gaps::refuse);
    FAIL();
  } catch (const CaseError& e) {
    EXPECT_NE(e.problem.find("is not the"), std::string::npos) << e.what();
  }
}

INSTANTIATE_TEST_SUITE_P(Table, SharedRecord,
                         testing::Values(Catalogued{"coyote-lake-1979-gilroy2-140.csv", 5134, 0.005, 0.339, 0.512},
                                         Catalogued{"coyote-lake-1979-gilroy6-230.csv", 5115, 0.005, 0.434, 0.774},
                                         Catalogued{"coyote-lake-1979-coyote-dam-250.csv", 5553, 0.005, 0.279, 0.359},
                                         Catalogued{"imperial-valley-1940-el-centro-180.csv", 3949, 0.01, 0.313,
                                                    1.703}),
                         [](const auto& test) {
                           std::string name = test.param.file;
                           for (char& c : name)
                             if (c == '-' || c == '.') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace scree::io::test::shared_records_test
