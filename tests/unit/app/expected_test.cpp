#include "app/verify/expected.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::app::expected_test {
namespace {

constexpr const char* kGood = R"(title = "A case"
[[variant]]
name = "coarse"
set = ["stage.0.cover_size=0.5", "stage.0.dt=1e-3"]
[[variant]]
name = "fine"
case = "other.toml"
tier = "full"
repeats = 3
[[quantity]]
name = "deflection"
measure = "monitor"
of = "middle"
component = "uy"
reference = -0.5
tolerance = 0.02
reason = "beam theory"
[[quantity]]
name = "order"
measure = "history_error"
of = "middle"
component = "uy"
file = "reference/beam.csv"
variants = ["coarse", "fine"]
sizes = [0.5, 0.25]
at_least = 1.9
reason = "linear elements"
[[quantity]]
name = "cost"
measure = "stepping_time"
variant = "coarse"
over = "fine"
at_most = 1
reason = "fewer elements"
)";

Expected read(const std::string& text) { return read_expected_text(text, "expected.toml"); }

/// kGood with one part replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

io::CaseError fault(const std::string& text) {
  try {
    (void)read(text);
  } catch (const io::CaseError& e) {
    return e;
  }
  ADD_FAILURE() << "accepted:\n" << text;
  return {"", {}, {.problem = ""}};
}

TEST(Expected, good_file_is_read_whole) {
  const Expected e = read(kGood);
  EXPECT_EQ(e.title, "A case");
  ASSERT_EQ(e.variants.size(), 2U);
  EXPECT_EQ(e.variants[0].set, (std::vector<std::string>{"stage.0.cover_size=0.5", "stage.0.dt=1e-3"}));
  EXPECT_EQ(e.variants[0].case_file, "case.toml");
  EXPECT_EQ(e.variants[1].case_file, "other.toml");
  EXPECT_EQ(e.variants[1].tier, Tier::full);
  EXPECT_EQ(e.variants[1].repeats, 3);
  ASSERT_EQ(e.quantities.size(), 3U);
  EXPECT_EQ(e.quantities[0].variants, std::vector<std::string>{"coarse"});
  EXPECT_EQ(e.quantities[0].text("statistic"), "end");
  EXPECT_DOUBLE_EQ(e.quantities[0].low, -0.51);
  EXPECT_DOUBLE_EQ(e.quantities[0].high, -0.49);
  EXPECT_EQ(e.quantities[0].wanted(), "-0.5 +- 0.01");
  EXPECT_TRUE(e.quantities[1].is_order());
  EXPECT_EQ(e.quantities[2].over, "fine");
  EXPECT_TRUE(std::isinf(e.quantities[2].low));
}

TEST(Expected, quantity_of_a_full_variant_is_of_the_full_tier) {
  const Expected e = read(kGood);
  EXPECT_EQ(e.quantities[0].tier, Tier::quick);
  EXPECT_EQ(e.quantities[1].tier, Tier::full);
  EXPECT_EQ(e.quantities[2].tier, Tier::full);
}

TEST(Expected, without_variants_there_is_one_run_of_the_case) {
  const Expected e = read("[[quantity]]\nname=\"a\"\nmeasure=\"ledger_closure\"\nat_most=1\nreason=\"b\"\n");
  ASSERT_EQ(e.variants.size(), 1U);
  EXPECT_EQ(e.variants[0].name, "case");
  EXPECT_EQ(e.quantities[0].variants, std::vector<std::string>{"case"});
}

TEST(Expected, time_and_cores_of_a_case_are_read_and_checked) {
  EXPECT_EQ(read(kGood).cores, 1);
  EXPECT_EQ(read(kGood).minutes, 0.0);
  const std::string text = kGood;
  EXPECT_EQ(read("minutes = 17.5\ncores = 2\n" + text).cores, 2);
  EXPECT_EQ(read("minutes = 17.5\n" + text).minutes, 17.5);
  for (const char* wrong :
       {"cores = 0\n", "cores = 1.5\n", "cores = \"all\"\n", "minutes = -1\n", "minutes = \"long\"\n"}) {
    const io::CaseError e = fault(wrong + text);
    EXPECT_EQ(e.line, 1) << wrong;
    EXPECT_EQ(e.key, std::string(wrong).substr(0, std::string(wrong).find(' ')));
  }
}

TEST(Expected, absolute_tolerance_is_in_the_unit_of_the_quantity) {
  const Expected e = read(changed("tolerance = 0.02", "absolute = 0.02"));
  EXPECT_DOUBLE_EQ(e.quantities[0].low, -0.52);
}

TEST(Expected, unknown_measure_is_refused_with_place_and_hint) {
  const io::CaseError e = fault(changed("measure = \"monitor\"", "measure = \"monitr\""));
  EXPECT_EQ(e.line, 12);
  EXPECT_EQ(e.column, 11);
  EXPECT_NE(e.message.find("monitr"), std::string::npos);
  EXPECT_NE(e.allowed.find("\"history_error\""), std::string::npos);
  EXPECT_NE(e.hint.find("\"monitor\""), std::string::npos);
}

TEST(Expected, key_of_another_measure_is_refused_at_the_key) {
  const io::CaseError e = fault(changed("component = \"uy\"\nreference", "compnent = \"uy\"\nreference"));
  EXPECT_EQ(e.line, 14);
  EXPECT_EQ(e.column, 1);
  EXPECT_EQ(e.key, "compnent");
  EXPECT_NE(e.hint.find("component"), std::string::npos);
}

TEST(Expected, missing_keys_are_named) {
  EXPECT_NE(fault(changed("reason = \"beam theory\"", "")).problem.find("reason"), std::string::npos);
  EXPECT_NE(fault(changed("component = \"uy\"\nreference", "reference")).problem.find("component"), std::string::npos);
  EXPECT_NE(fault(changed("name = \"fine\"\n", "")).problem.find("name"), std::string::npos);
}

TEST(Expected, unknown_variants_are_refused) {
  for (const char* change : {"variant = \"coarse\"\nover", "over = \"fine\"", "variants = [\"coarse\", \"fine\"]"}) {
    std::string wrong = change;
    wrong.replace(wrong.find(wrong.find("coarse") != std::string::npos ? "coarse" : "fine"), 4, "xxxx");
    const io::CaseError e = fault(changed(change, wrong));
    EXPECT_NE(e.problem.find("unknown variant"), std::string::npos) << e.message;
    EXPECT_EQ(e.allowed, "\"coarse\", \"fine\"");
  }
}

TEST(Expected, every_variant_of_a_quantity_is_run_and_sets_its_tier) {
  const std::string harmonic = changed(
      "measure = \"stepping_time\"\nvariant = \"coarse\"\nover = \"fine\"",
      "measure = \"harmonic\"\nof = \"m\"\ncomponent = \"vx\"\nfrequency = 5\nvariant = \"coarse\"\nminus = \"fine\"");
  const Quantity q = read(harmonic).quantities[2];
  EXPECT_EQ(q.runs(), (std::vector<std::string>{"coarse", "fine"}));
  EXPECT_EQ(q.tier, Tier::full);
  std::string wrong = harmonic;
  wrong.replace(wrong.find("minus = \"fine\""), 14, "minus = \"fone\"");
  EXPECT_NE(fault(wrong).problem.find("unknown variant"), std::string::npos);
  EXPECT_NE(fault(changed("measure = \"stepping_time\"", "measure = \"harmonic\"\nof = \"m\"\ncomponent = \"vx\""))
                .problem.find("frequency"),
            std::string::npos);
}

TEST(Expected, bounds_that_say_nothing_or_too_much_are_refused) {
  EXPECT_NE(fault(changed("at_most = 1\n", "")).problem.find("no bound"), std::string::npos);
  EXPECT_NE(fault(changed("tolerance = 0.02\n", "")).problem.find("tolerance"), std::string::npos);
  EXPECT_NE(fault(changed("tolerance = 0.02\n", "tolerance = 0.02\nat_most = 1\n")).problem.find("two kinds"),
            std::string::npos);
  EXPECT_EQ(fault(changed("tolerance = 0.02", "tolerance = -1")).line, 16);
  EXPECT_EQ(fault(changed("reference = -0.5", "reference = nan")).line, 15);
}

TEST(Expected, sizes_go_with_variants) {
  EXPECT_NE(fault(changed("sizes = [0.5, 0.25]\n", "")).problem.find("not as many"), std::string::npos);
  EXPECT_NE(fault(changed("sizes = [0.5, 0.25]", "sizes = [0.5]")).problem.find("not as many"), std::string::npos);
  EXPECT_NE(fault(changed("sizes = [0.5, 0.25]", "sizes = [0.5, 0.0]")).allowed.find("> 0"), std::string::npos);
}

TEST(Expected, wrong_tiers_repeats_and_names_given_twice_are_refused) {
  EXPECT_EQ(fault(changed("tier = \"full\"", "tier = \"slow\"")).line, 8);
  EXPECT_EQ(fault(changed("repeats = 3", "repeats = 0")).line, 9);
  EXPECT_EQ(fault(changed("repeats = 3", "repeats = 1.5")).line, 9);
  EXPECT_NE(fault(changed("name = \"fine\"", "name = \"coarse\"")).problem.find("two variants"), std::string::npos);
}

TEST(Expected, studies_have_numbers_and_nothing_else) {
  const std::string study = "title = \"t\"\nstudy = \"sdof\"\n[[quantity]]\nname=\"a\"\nreason=\"b\"\nat_most=1\n";
  EXPECT_EQ(read(study + "measure=\"study\"\nof=\"x\"\n").study, "sdof");
  EXPECT_NE(fault(study + "measure=\"ledger_closure\"\n").problem.find("does not go with"), std::string::npos);
  EXPECT_NE(fault("[[quantity]]\nname=\"a\"\nreason=\"b\"\nat_most=1\nmeasure=\"study\"\nof=\"x\"\n")
                .problem.find("does not go with"),
            std::string::npos);
  EXPECT_NE(fault("study = \"sdof\"\n[[variant]]\nname = \"a\"\n").problem.find("no variants"), std::string::npos);
}

TEST(Expected, empty_and_broken_files_are_refused) {
  EXPECT_FALSE(fault("title = \"a\"\n").problem.empty());
  EXPECT_EQ(fault("title = \n").line, 1);
  EXPECT_EQ(fault("quantity = 3\n").line, 1);
  EXPECT_EQ(fault("[[quantity]]\nname = 3\n").line, 2);
}

}  // namespace
}  // namespace scree::app::expected_test
