// Cases with wrong records: one error each, with place, value, allowed values and remedy.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/unit/io/case_read.h"

namespace scree::io::test::record_faults_test {
namespace {

/// The case is CASE.toml; the error lies in it or in the record beside it.
struct WrongRecord {
  const char *name, *kind;
  int line, column;
  const char *key, *value, *problem, *allowed, *hint;  // the key is compared whole, the others in part
};

std::ostream& operator<<(std::ostream& out, const WrongRecord& wrong) { return out << wrong.name; }
class WrongRecordFile : public testing::TestWithParam<WrongRecord> {};

TEST_P(WrongRecordFile, gives_place_value_allowed_and_hint) {
  const WrongRecord& w = GetParam();
  const CaseError e = error_of_file(kFaults + w.name + ".toml");
  EXPECT_EQ(e.file, kFaults + w.name + w.kind) << e.what();
  expect_told(e, w);
  EXPECT_TRUE(holds(e.what(), fmt::format("{}:{}:{}: error: ", w.kind, w.line, w.column))) << e.what();
}

const WrongRecord kWrong[] = {
    {"record_backwards", ".csv", 10, 1, "", "0.03", "0.03 s comes after 0.07 s", "> 0.07", "sort the rows"},
    {"record_count", ".AT2", 4, 9, "", "20", "announces 20 values, the file holds 18", "20 values", "get it again"},
    {"record_gap", ".csv", 10, 1, "", "0.11", "from 0.07 s to 0.11 s is not the 0.01 s", "0.08", "resample = 0.01"},
    {"record_header", ".AT2", 1, 1, "", "MADE UP RECORD", "no header", "NPTS, DT", "add the header"},
    {"record_infinite", ".AT2", 6, 30, "", "-1.2E+999", "not finite", "finite number", "get the file again"},
    {"record_missing", ".toml", 9, 8, "motion.shake.file", "record_missing.AT2", "does not exist", ".AT2 file",
     "folder of the case"},
    {"record_number", ".AT2", 7, 28, "", "0.3O12", "not a number", "a sign between", "damaged"},
    {"record_pga_and_scale", ".toml", 12, 7, "motion.shake.pga", "3.0", "given twice", "pga or scale", "remove one"},
    {"record_taper", ".toml", 11, 9, "motion.shake.taper", "0.1", "overlap", "0 to 0.095 s", "a few percent"},
    {"record_unit", ".toml", 10, 8, "motion.shake.unit", "cm/s2", "accelerations are in g", "\"g\"", "remove the unit"},
    {"record_velocities", ".AT2", 3, 34, "", "CM/S", "velocities", "CM/S/S", ".AT2 file"},
    {"record_window", ".toml", 11, 9, "motion.shake.until", "0.5", "nothing of the record ends", "0.19 s", "as in its"},
    {"record_without_unit", ".toml", 8, 1, "motion.shake.unit", "", "no unit is given", "cm/s2", "add unit"}};

INSTANTIATE_TEST_SUITE_P(Files, WrongRecordFile, testing::ValuesIn(kWrong),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(WrongRecords, folder_holds_no_record_case_without_a_test) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFaults))
    count += entry.path().extension() == ".toml" && entry.path().filename().string().starts_with("record_");
  EXPECT_EQ(count, std::size(kWrong));
}

TEST(MotionKeys, unit_of_the_file_needs_no_key_and_is_settled) {
  const std::string text = replaced(bytes_of(kFaults + "record_unit.toml"), "unit = \"cm/s2\"", "");
  const Case c = read_case_text(text, kFaults + "in_memory.toml", {}, kMethods);
  ASSERT_EQ(c.model.motions.size(), 1u);
  EXPECT_EQ(c.model.motions[0].setting().name, "shake");
  EXPECT_DOUBLE_EQ(c.model.motions[0].accelerations()[1], 1.932653e-1 * 9.80665);
  EXPECT_DOUBLE_EQ(c.model.motions[0].times()[1], 0.01);
  EXPECT_TRUE(holds(c.resolved, "unit = \"g\"")) << c.resolved;
}

TEST(MotionKeys, gap_is_bridged_by_resampling) {
  const Case c = read_case(kFaults + "record_gap.toml", {"motion.shake.resample=\"5 ms\""}, kMethods);
  const GroundMotion& m = c.model.motions[0];
  ASSERT_EQ(m.times().size(), 39u);
  // The gap is interpolated linearly from 0.9854 at 0.07 s to 0.8085 at 0.11 s.
  EXPECT_NEAR(m.acceleration(0.09).x(), 0.5 * (0.9854 + 0.8085), 1e-12);
}

TEST(MotionKeys, start_pga_and_integration_reach_the_motion) {
  const std::string path = kFaults + "record_window.toml";
  const GroundMotion m = read_case(path,
                                   {"stage.0.duration=3", "motion.shake.until=0.15", "motion.shake.start=2",
                                    "motion.shake.pga=\"50 cm/s2\"", "motion.shake.integration=\"constant\"",
                                    "motion.shake.from=\"20 ms\""},
                                   kMethods)
                             .model.motions[0];
  EXPECT_DOUBLE_EQ(m.facts().pga, 0.5);
  EXPECT_NEAR(m.facts().duration, 0.13, 1e-15);
  EXPECT_EQ(m.acceleration(1.999).x(), 0.0);
  EXPECT_GT(m.acceleration(2.0).x(), 0.0);
  EXPECT_EQ(m.acceleration(2.001), m.acceleration(2.009));  // constant within a step
}

}  // namespace
}  // namespace scree::io::test::record_faults_test
