// Wrong case files: one error each, with place, value, allowed values and remedy.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_faults_test {
namespace {

struct Wrong {
  const char* file;
  int line, column;
  const char *key, *value, *problem, *allowed, *hint;  // the key is compared whole, the others in part
};

std::ostream& operator<<(std::ostream& out, const Wrong& wrong) { return out << wrong.file; }
class WrongFile : public testing::TestWithParam<Wrong> {};

TEST_P(WrongFile, gives_place_value_allowed_and_hint) {
  const Wrong& w = GetParam();
  const std::string path = kFaults + w.file;
  const CaseError e = error_of_file(path);
  EXPECT_EQ(e.file, path);
  expect_told(e, w);
  EXPECT_TRUE(std::string(e.what()).starts_with(fmt::format("{}:{}:{}: error: ", path, w.line, w.column))) << e.what();
}

INSTANTIATE_TEST_SUITE_P(
    Files, WrongFile,
    testing::Values(
        Wrong{"missing_key.toml", 3, 1, "material.rock.poisson", "", "\"poisson\" is missing", "0 <= value < 0.5",
              "add poisson"},
        Wrong{"unknown_key.toml", 4, 1, "material.rock.densty", "2600.0", "unknown key \"densty\"",
              "\"density\", \"young\"", "did you mean \"density\"?"},
        Wrong{"wrong_type.toml", 27, 12, "stage.0.duration", "true", "wrong type", "number [s]",
              "true or false was given here"},
        Wrong{"negative_density.toml", 4, 11, "material.rock.density", "-2600.0", "out of range", "number [kg/m3], > 0",
              "density"},
        Wrong{"nan.toml", 15, 32, "block.1.polygon.2.1", "nan", "not finite", "[m]", "finite"},
        Wrong{"self_crossing.toml", 15, 11, "block.1.polygon", "[[1.0, 1.0]", "\"slider\"", "simple polygon",
              "without crossing"},
        Wrong{"overlap.toml", 15, 11, "block.1.polygon", "[[1.0, 0.5]", "overlaps block", "overlaps no other",
              "only touch"},
        Wrong{"unknown_material.toml", 16, 12, "block.1.material", "\"rok\"", "no material of that name", "\"rock\"",
              "did you mean \"rock\"?"},
        Wrong{"domain_open_outline.toml", 9, 11, "domain.outline", "[[0.0, 0.0]", "is open: it ends at (0, 0.0005)",
              "simple polygon", "remove the last corner"},
        Wrong{"domain_two_points.toml", 9, 11, "domain.outline", "[[0.0, 0.0]", "2 points encloses nothing",
              "at least 3 points", "Corners in order"},
        Wrong{"domain_self_crossing.toml", 9, 11, "domain.outline", "[[0.0, 0.0]",
              "crosses or touches itself: Self-intersection[5 5]", "simple polygon", "without crossing"},
        Wrong{"domain_no_area.toml", 9, 11, "domain.outline", "[[0.0, 0.0]", "the outline", "simple polygon",
              "corners"},
        Wrong{"domain_repeated_corner.toml", 9, 11, "domain.outline", "[[0.0, 0.0]", "corner (0, 0) twice",
              "simple polygon", "remove the repeated corner"},
        Wrong{"domain_hole_outside.toml", 11, 10, "domain.holes.0", "[[12.0, 1.0]", "outside the outline",
              "inside the outline", "move it"},
        Wrong{"domain_hole_across.toml", 11, 10, "domain.holes.0", "[[9.0, 1.0]", "crosses the outline",
              "inside the outline", "part of the outline"},
        Wrong{"domain_holes_overlap.toml", 12, 10, "domain.holes.1", "[[2.0, 2.0]", "overlaps hole 0",
              "apart from other holes", "make one hole"},
        Wrong{"domain_regions_overlap.toml", 18, 11, "domain.region.1.polygon", "[[0.0, 4.0]",
              "region 'cap' overlaps region 'base' by 10 m2", "overlaps no other region", "only touch"},
        Wrong{"domain_regions_coincide.toml", 18, 11, "domain.region.1.polygon", "[[10.0, 0.0]",
              "covers the same area as region 'base'", "overlaps no other region", "remove one"},
        Wrong{"domain_zero_spacing.toml", 15, 11, "domain.joint_set.0.spacing", "0.0", "out of range",
              "number [m], > 0", "spacing"},
        Wrong{"domain_unknown_joint.toml", 13, 9, "domain.joint_set.0.joint", "\"ruogh\"", "no joint of that name",
              "\"rough\"", "did you mean \"rough\"?"},
        Wrong{"domain_too_many_lines.toml", 15, 11, "domain.joint_set.0.spacing", "1e-06", "lines", "at most", "units"},
        Wrong{"domain_too_many_crossings.toml", 20, 11, "domain.joint_set.1.spacing", "0.001",
              "cross about 1e+08 times", "at most 1e+07", "units"},
        Wrong{"domain_overlaps_block.toml", 20, 11, "block.0.polygon", "[[9.0, 0.0]", "overlaps block",
              "overlaps no other", "only touch"},
        Wrong{"joint_tension_beyond_coulomb.toml", 11, 20, "joint.plane.tensile_strength", "20000", "would slip first",
              "<= cohesion / tan(friction_deg) = 10000", "at least 20000 Pa"},
        Wrong{"joint_tension_without_cohesion.toml", 10, 20, "joint.plane.tensile_strength", "1000", "would slip first",
              "\"unlimited\" or 0", "at least 577.35 Pa"},
        Wrong{"joint_tension_word.toml", 10, 20, "joint.plane.tensile_strength", "\"infinite\"", "",
              "\"unlimited\" or number [Pa], >= 0", "or \"unlimited\""},
        Wrong{"joint_tension_negative.toml", 10, 20, "joint.plane.tensile_strength", "-1", "out of range",
              "\"unlimited\" or number [Pa], >= 0", "larger value"},
        Wrong{"joint_friction_grows.toml", 10, 25, "joint.plane.residual_friction_deg", "35", "would grow",
              "0 <= value <= 30", "the one after it"},
        Wrong{"joint_cohesion_grows.toml", 11, 21, "joint.plane.residual_cohesion", "20000", "would grow",
              "0 <= value <= 10000", "the one after it"},
        Wrong{"joint_weakening_alone.toml", 10, 18, "joint.plane.weakening_slip", "0.01",
              "without a residual_friction_deg", "beside residual_friction_deg", "add residual_friction_deg"},
        Wrong{"joint_dilation_beyond_friction.toml", 10, 16, "joint.plane.dilation_deg", "35", "more than its friction",
              "0 <= value <= 30", "smaller one"},
        Wrong{"joint_dilation_beyond_residual.toml", 11, 16, "joint.plane.dilation_deg", "15", "more than its friction",
              "0 <= value <= 10", "a dilation_slip that ends dilation"},
        Wrong{"joint_dilation_slip_alone.toml", 10, 17, "joint.plane.dilation_slip", "0.01", "without a dilation_deg",
              "beside dilation_deg", "add dilation_deg"},
        Wrong{"water_backwards.toml", 26, 27, "water.0.line.2", "[2.0, 1.0]", "x = 2 m comes after x = 3 m", "x > 3 m",
              "left to right"},
        Wrong{"water_twice.toml", 30, 11, "water.1.joints.0", "\"plane\"", "has a piezometric line already",
              "one [[water]] section", "remove one"},
        Wrong{"water_unknown_joint.toml", 27, 11, "water.0.joints.0", "\"plain\"", "joint", "\"plane\"",
              "define the joint"},
        Wrong{"water_weightless.toml", 27, 15, "water.0.unit_weight", "0", "out of range", "number [N/m3], > 0", ""},
        Wrong{"empty.toml", 1, 1, "", "", "empty", "[[block]]", "scree schema"},
        Wrong{"not_toml.toml", 14, 8, "", "", "not TOML", "TOML 1.0", "quotation marks"}),
    [](const auto& test) {
      const std::string name = test.param.file;
      return name.substr(0, name.find('.'));
    });

// The fault is in the file of the outline: the error must state the place in that file.
TEST(WrongFiles, open_outline_in_a_file_is_refused_where_it_ends) {
  const CaseError e = error_of_file(kFaults + "domain_open_outline_file.toml");
  EXPECT_TRUE(e.file.ends_with("domain_open_outline.csv")) << e.what();
  EXPECT_EQ(e.line, 5) << e.what();
  EXPECT_EQ(e.key, "domain.outline_file");
  EXPECT_TRUE(holds(e.problem, "is open: it ends at (0, 10), 10 m from its first point (0, 0)")) << e.what();
  EXPECT_TRUE(holds(e.hint, "repeat the first point")) << e.what();
  EXPECT_FALSE(e.allowed.empty());
}

TEST(WrongFiles, folder_holds_no_file_without_a_test) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFaults)) {
    const std::string name = entry.path().filename().string();
    const bool elsewhere =  // tested in record_faults_test.cpp, load_faults_test.cpp
        name.starts_with("record_") || name.starts_with("load_") || name.starts_with("stage_") ||
        name.starts_with("time_");
    count += entry.path().extension() == ".toml" && !elsewhere;
  }
  EXPECT_EQ(count, 40u);
}

// Each text would overflow the stack in the parser or its tables if it were parsed.
TEST(DeepText, two_hundred_thousand_dotted_parts_are_refused_at_their_place) {
  std::string parts = "a";
  for (int i = 1; i < 200000; ++i) parts += ".a";
  struct {
    std::string text;
    int line, column;
  } const texts[] = {{"\n[" + parts + "]\n", 2, 129},
                     {"[[" + parts + "]]\n", 1, 128},
                     {parts + " = 1\n", 1, 130},
                     {"x = { " + parts + " = 1 }\n", 1, 134},
                     {"x = " + std::string(200000, '['), 1, 69}};
  for (const auto& t : texts) {
    const CaseError e = error_of_text(t.text);
    EXPECT_TRUE(holds(e.problem, "deeper than 64")) << e.what();
    EXPECT_EQ(e.line, t.line) << e.what();
    EXPECT_EQ(e.column, t.column) << t.text.substr(0, 20) << e.what();
    EXPECT_FALSE(e.allowed.empty() || e.hint.empty());
  }
}

TEST(DeepText, depth_adds_up_over_inline_tables) {
  std::string text = "x = ";
  for (int i = 0; i < 100; ++i) text += "{ a.a.a = ";
  EXPECT_TRUE(holds(error_of_text(text).problem, "deeper than 64"));
}

TEST(DeepText, dots_in_strings_comments_and_numbers_do_not_count) {
  const std::string dots(300, '.'), text = bytes_of(kFolder + "good_case.toml");
  EXPECT_NO_THROW(read_text("# " + dots + "[[[[\n" + replaced(text, "One block", dots + "[[[[")));
  EXPECT_NO_THROW(
      read_text(replaced(text, "\"One block on a base\"", "'''" + dots + "\n" + std::string(100, '[') + "'''")));
  std::string ring;
  for (int i = 0; i < 200; ++i) ring += fmt::format("[{}.5, 0.5],\n", i);
  EXPECT_FALSE(holds(error_of_text(replaced(text, "polygon = [", "polygon = [" + ring)).problem, "deeper"));
}

TEST(DeepText, quotes_at_the_end_of_a_long_string_hide_nothing) {
  for (const char* quotes : {"\"\"\"", "\"\"\"\"", "\"\"\"\"\""})
    EXPECT_TRUE(
        holds(error_of_text(fmt::format("x = [\"\"\"a{}, {}", quotes, std::string(100, '['))).problem, "deeper"))
        << quotes;
}

TEST(DeepText, unclosed_headers_are_reported_where_they_are) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += "[a\n";
  EXPECT_EQ(error_of_text(text).line, 1);
}

// A debug build with header-only toml++ would abort at these texts in the parser.
TEST(CaseText, brackets_without_key_or_value_are_errors_at_their_place) {
  for (const char* wrong : {"[=a]", "[[=a]]", "[ .a]", "[\n", "[,", "[[[a]]]", "x=[}]", "x=[1,=]"}) {
    const CaseError e = error_of_text(fmt::format("title = \"a\"\n  {}\n", wrong));
    EXPECT_TRUE(holds(e.problem, "not TOML")) << wrong << ": " << e.what();
    EXPECT_GE(e.line, 2) << e.what();
    EXPECT_GE(e.column, 1) << e.what();
  }
}

TEST(CaseText, other_letters_stand_in_quotes_and_comments_only) {
  const std::string text = bytes_of(kFolder + "good_case.toml");
  EXPECT_NO_THROW(read_text("# \u00e9\n" + replaced(text, "One block", "H\u00f6he \u00e9")));
  for (const char* wrong : {"\u00e9 = 1", "[ \u00e9]", "x = \u3000 1", "\u00a0"}) {
    const CaseError e = error_of_text(fmt::format("a = 1\n{}\n", wrong));
    EXPECT_TRUE(holds(e.problem, "outside quotation marks")) << wrong << ": " << e.what();
    EXPECT_EQ(e.line, 2);
  }
  EXPECT_EQ(error_of_text("a = 1\nxy\u00e9 = 1").column, 3);
}

TEST(CaseText, larger_than_the_bound_is_refused) {
  const CaseError e = error_of_text(std::string((std::size_t{16} << 20) + 1, '#'));
  EXPECT_TRUE(holds(e.allowed, "16777216 bytes")) << e.what();
}

TEST(CaseText, that_is_not_utf8_gives_the_byte) {
  const CaseError e = error_of_text("title = \"a\"\nx = \"\xC3\xA9\xFF\"\n");
  EXPECT_EQ(e.line, 2);
  EXPECT_EQ(e.column, 7);  // columns count characters
  EXPECT_EQ(e.value, "byte 0xFF");
  EXPECT_TRUE(holds(error_of_text("x = \"\xED\xA0\x80\"").problem, "UTF-8"));  // a surrogate
  EXPECT_TRUE(holds(error_of_text("x = \"\xC0\xAF\"").problem, "UTF-8"));      // overlong
}

TEST(CaseFile, that_is_missing_or_a_folder_says_so) {
  EXPECT_TRUE(holds(error_of_file(kFolder + "nowhere.toml").problem, "does not exist"));
  EXPECT_TRUE(holds(error_of_file(kFolder).problem, "folder"));
  EXPECT_EQ(error_of_file(kFolder).line, 0);
}

TEST(CaseText, line_ends_of_windows_and_byte_order_mark_are_fine) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : bytes_of(kFolder + "good_case.toml")) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(dump(read_text(text)), dump(read("good_case.toml")));
}

/// Changes of one line of the full case, and the error expected for each.
struct Change {
  const char *from, *to;      // replaced in the text
  const char *key, *problem;  // the key is compared whole, the problem in part
};
std::ostream& operator<<(std::ostream& out, const Change& change) {
  return out << change.key << ": " << change.problem;
}
class WrongChange : public testing::TestWithParam<Change> {};

TEST_P(WrongChange, is_refused_at_the_key) {
  const Change& c = GetParam();
  const std::string text = bytes_of(kFolder + "full_case.toml");
  const std::size_t at = text.find(c.from);
  ASSERT_NE(at, std::string::npos) << c.from;
  const CaseError e = error_of_text(replaced(text, c.from, c.to));
  EXPECT_EQ(e.key, c.key) << e.what();
  EXPECT_TRUE(holds(e.problem, c.problem)) << e.what();
  EXPECT_FALSE(e.allowed.empty()) << e.what();
  EXPECT_FALSE(e.hint.empty()) << e.what();
  EXPECT_GT(e.line, 0) << e.what();
  EXPECT_GT(e.column, 0) << e.what();
}

INSTANTIATE_TEST_SUITE_P(
    Case, WrongChange,
    testing::Values(
        Change{"young = \"1 GPa\"", "young = \"1 GN\"", "material.rock.young", "does not fit the quantity"},
        Change{"young = \"1 GPa\"", "young = \"1 Gpa\"", "material.rock.young", "not known"},
        Change{"young = \"1 GPa\"", "young = \"1e9\"", "material.rock.young", "no unit"},
        Change{"young = \"1 GPa\"", "young = \"stiff\"", "material.rock.young", "begin with a number"},
        Change{"young = \"1 GPa\"", "young = inf", "material.rock.young", "not finite"},
        Change{"young = \"1 GPa\"", "young = \"inf Pa\"", "material.rock.young", "not finite"},
        Change{"young = \"1 GPa\"", "young = \"1e300 GPa\"", "material.rock.young", "range of double"},
        Change{"young = \"1 GPa\"", "young = 1979-05-27", "material.rock.young", "wrong type"},
        Change{"poisson = 0.25", "poisson = 0.5", "material.rock.poisson", "out of range"},
        Change{"poisson = 0.25", "poisson = \"0.25\"", "material.rock.poisson", "number is expected"},
        Change{"friction_deg = \"12 deg\"", "friction_deg = 90", "joint.plane.friction_deg", "out of range"},
        Change{"contact_length = 0.5", "contact_length = 0", "joint.plane.contact_length", "out of range"},
        Change{"penalty = \"1 GN/m\"", "penalty = \"automatic\"", "joint.plane.penalty", "begin with a number"},
        Change{"penalty = \"1 GN/m\"", "penalty = 1e9\nnormal_stiffness = 1e9", "joint.plane.penalty",
               "a stiffness per area and a penalty"},
        Change{"penalty = \"1 GN/m\"", "", "joint.plane.shear_penalty", "without a penalty"},
        Change{"default_joint = \"plane\"", "default_joint = \"plain\"", "model.default_joint",
               "no joint of that name"},
        Change{"default_joint = \"plane\"", "", "model.default_joint", "none is the default"},
        Change{"plane = \"stress\"", "plane = \"strian\"", "model.plane", "not one of the choices"},
        Change{"gravity = [0.5, -9.81]", "gravity = [-9.81]", "model.gravity", "two coordinates"},
        Change{"gravity = [0.5, -9.81]", "\"model.plane\" = 1", "model.model.plane", "unknown key"},
        Change{"name = \"slider\"", "name = \"base\"", "block.1.name", "same name"},
        Change{"name = \"slider\"", "name = \"a/b\"", "block.1.name", "slash"},
        Change{"name = \"slider\"", "name = \"\"", "block.1.name", "empty"},
        Change{"[[0, 0], [0, 1], [4, 1], [4, 0]]", "[[0, 0], [0, 1]]", "block.0.polygon", "encloses nothing"},
        Change{"[[0, 0], [0, 1], [4, 1], [4, 0]]", "[[0, 0], [0, 1], [4, 1], [1e10, 0]]", "block.0.polygon.3.0",
               "out of range"},
        Change{"[\"rough\", \"plane\", \"\", \"plane\"]", "[\"rough\"]", "block.0.edge_joints", "1 joints for 4 edges"},
        Change{"[\"rough\", \"plane\", \"\", \"plane\"]", "[\"rough\", \"plane\", \"\", \"x\"]",
               "block.0.edge_joints.3", "no joint"},
        Change{"motion = \"pulse\"", "motion = \"puls\"", "support.0.motion", "no motion of that name"},
        Change{"motion = \"pulse\"", "fix = \"y\"", "support.0.fix", "all directions"},
        Change{"blocks = [\"wall\", \"far wall\"]", "blocks = [\"wall\", \"base\"]", "support.1.blocks.1",
               "held twice"},
        Change{"blocks = [\"wall\", \"far wall\"]", "", "support.1.block", "names no block"},
        Change{"blocks = [\"wall\", \"far wall\"]", "blocks = []", "support.1.blocks", "empty"},
        Change{"point = [1.0, 1.0]", "point = [1.0, 0.9]", "support.2.point", "not on block"},
        Change{"fix = \"x\"", "motion = \"pulse\"", "support.2.motion", "cannot follow"},
        Change{"point = [1.5, 1.1]", "point = [1.5, 1.5]", "monitor.0.point", "not on block"},
        Change{"name = \"corner\"", "name = \"slider#1\"", "monitor.2.name", "same name"},
        Change{"file = \"pulse.csv\"", "file = \"nowhere.csv\"", "motion.pulse.file", "does not exist"},
        Change{"file = \"pulse.csv\"", "file = \".\"", "motion.pulse.file", "folder"},
        Change{"file = \"pulse.csv\"", "file = \"$HOME/pulse.csv\"", "motion.pulse.file", "only the variable"},
        Change{"direction = [3.0, 4.0]", "direction = [0, 0]", "motion.pulse.direction", "no length"},
        Change{"direction = [3.0, 4.0]", "direction = [3, 4]\ndirection_deg = 3", "motion.pulse.direction_deg",
               "given twice"},
        Change{"method = \"nmm\"", "method = \"fem\"", "stage.0.method", "no method of that name"},
        Change{"method = \"nmm\"", "method = 1", "stage.0.method", "wrong type"},
        Change{"dt = \"1 ms\"", "dt = \"auto\"", "stage.1.dt", "needs a time step"},
        Change{"dt = \"1 ms\"", "dt = 1e-13", "stage.1.dt", "out of range"},
        Change{"duration = 0.1", "duration = 0", "stage.0.duration", "out of range"},
        Change{"safety = 0.5", "safety = 1.5", "stage.0.safety", "out of range"},
        Change{"blocks = [\"wall\"], method = \"dda\"", "blocks = [\"wall\", \"wall\"], method = \"dda\"",
               "stage.0.method_of.0.blocks.1", "has a method already"},
        Change{"max_passes = 6", "max_passes = 6.5", "stage.1.max_passes", "wrong type"},
        Change{"name = \"settling\"", "name = \"shaking\"", "stage.2.name", "same name"},
        Change{"url = \"memq://\"", "url = \"tcpq://127.0.0.1:7700\"", "live.url", "not supported"},
        Change{"enabled = true", "enabled = \"yes\"", "live.enabled", "wrong type"},
        Change{"[run]", "[[run]]", "run", "wrong type"}));

TEST(FrictionLaw, what_does_not_go_together_is_refused_at_the_key) {
  const std::string law = "joint.{}.velocity_weakening={{fast_friction_deg={}, velocity=1, slip=0.1}}";
  const auto said = [&](const std::vector<std::string>& set) {
    return error_in([&] { (void)read("full_case.toml", set); });
  };
  const CaseError grows = said({fmt::format(fmt::runtime(law), "plane", 80)});
  EXPECT_EQ(grows.key, "joint.plane.velocity_weakening");
  EXPECT_TRUE(holds(grows.problem, "friction would grow")) << grows.what();
  const CaseError two = said({fmt::format(fmt::runtime(law), "rough", 1)});  // this law has a residual friction angle
  EXPECT_TRUE(holds(two.problem, "a law of friction and a residual_friction_deg")) << two.what();
  const CaseError lacks = said({"joint.plane.velocity_weakening={velocity=1, slip=0.1}"});
  EXPECT_TRUE(holds(lacks.problem, "\"fast_friction_deg\" is missing")) << lacks.what();
  const CaseError bound = said({"joint.plane.velocity_weakening={fast_friction_deg=0, velocity=0, slip=0.1}"});
  EXPECT_EQ(bound.key, "joint.plane.velocity_weakening.velocity") << bound.what();
}

TEST(Case, nmm_without_cover_size_asks_for_it) {
  std::string text = replaced(bytes_of(kFolder + "full_case.toml"), "cover_size = 0.5", "");
  const CaseError e = error_of_text(replaced(text, "cover_size = \"20 cm\"", ""));
  EXPECT_EQ(e.key, "stage.0.cover_size") << e.what();
  EXPECT_EQ(e.line, 197) << e.what();
  EXPECT_TRUE(holds(e.problem, "\"far wall\"")) << e.what();  // the other blocks state their own cover size
}

TEST(Case, without_block_or_stage_is_refused) {
  EXPECT_EQ(error_of_text("title = \"a\"").key, "material");
  const std::string text = bytes_of(kFolder + "good_case.toml");
  EXPECT_EQ(error_of_text(text, {"block=[]"}).key, "block");
  const std::size_t first = text.find("[[block]]"), after = text.find("[[support]]");
  EXPECT_EQ(error_of_text(text.substr(0, first) + text.substr(after)).key, "block");
  const CaseError e = error_of_text(text.substr(0, text.find("[[stage]]")));
  EXPECT_EQ(e.key, "stage");
  EXPECT_EQ(e.line, 1);
}

TEST(Override, errors_show_option_and_column) {
  const std::string text = bytes_of(kFolder + "good_case.toml");
  struct {
    const char* option;
    int column;
    const char* problem;
  } const wrong[] = {{"stage.0.duration=-1", 18, "out of range"},
                     {"stage.0.durations=1", 9, "unknown key"},
                     {"stage.3.duration=1", 7, "no item \"3\""},
                     {"stage.rst.duration=1", 7, "no item \"rst\""},
                     {"stage.0.method=dda", 16, "not TOML"},
                     {"stage.0.duration", 17, "equals sign is missing"},
                     {"=1", 1, "part of the key is empty"},
                     {"title.a=1", 7, "nothing within"},
                     {"title=\"a\"\ntitle=\"b\"", 7, "more than one value"},
                     {"\"title=1", 1, "not closed"}};
  for (const auto& w : wrong) {
    const CaseError e = error_of_text(text, {"title=\"x\"", w.option});
    EXPECT_EQ(e.file, "--set") << e.what();
    EXPECT_EQ(e.line, 2) << e.what();
    EXPECT_EQ(e.column, w.column) << e.what();
    EXPECT_TRUE(holds(e.problem, w.problem)) << e.what();
    EXPECT_FALSE(e.allowed.empty() || e.hint.empty()) << e.what();
  }
}

TEST(Override, deep_values_are_refused) {
  EXPECT_TRUE(holds(error_of_text(bytes_of(kFolder + "good_case.toml"), {"title=" + std::string(100000, '[')}).problem,
                    "deeper"));
  std::string key = "a";
  for (int i = 0; i < 100000; ++i) key += ".a";
  EXPECT_TRUE(holds(error_of_text(bytes_of(kFolder + "good_case.toml"), {key + "=1"}).problem, "too many parts"));
}

TEST(CaseErrors, show_control_characters_escaped) {
  const CaseError e = error_of_text("\"\\u001b[31m\" = \"\\u001b[0m\"\n");
  EXPECT_EQ(std::string(e.what()).find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace scree::io::test::case_faults_test
