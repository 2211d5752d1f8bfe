// Numbers with units.
#include <gtest/gtest.h>

#include <numbers>

#include "io/case/unit.h"

namespace scree::io::test::case_unit_test {
namespace {

TEST(Unit, numbers_are_exact_as_if_written_in_the_base_unit) {
  struct {
    const char *text, *base;
    double value;
  } const good[] = {{"30 MPa", "Pa", 30e6},
                    {"1 GN/m", "N/m", 1e9},
                    {"2.6 t/m3", "kg/m3", 2600.0},
                    {"2.6 g/cm^3", "kg/m3", 2600.0},
                    {"0.1 ms", "s", 1e-4},
                    {"0.3 us", "s", 3e-7},
                    {"12 deg", "deg", 12.0},
                    {"7 mm", "m", 7e-3},
                    {"1 N/m2", "Pa", 1.0},
                    {"1.5e3 kPa", "Pa", 1.5e6},
                    {" -981 cm/s2 ", "m/s2", -9.81},
                    {"+2min", "s", 120.0},
                    {"1 h", "s", 3600.0},
                    {"25 1/s", "Hz", 25.0},
                    {"3 m*s^-2", "m/s2", 3.0},
                    {"3 m/s/s", "m/s2", 3.0},
                    {"0.05 TPa", "Pa", 5e10},
                    {"2 TN/m", "N/m", 2e12},
                    {"5 \u00b5m", "m", 5e-6}};
  for (const auto& g : good) {
    const auto read = in_unit(g.text, g.base);
    ASSERT_TRUE(std::holds_alternative<double>(read)) << g.text << ": " << std::get<UnitFault>(read).problem;
    EXPECT_EQ(std::get<double>(read), g.value) << g.text;
  }
}

TEST(Unit, angles_convert_both_ways) {
  EXPECT_NEAR(std::get<double>(in_unit("1 rad", "deg")), 180.0 / std::numbers::pi, 1e-13);  // roundings at 57
  EXPECT_NEAR(std::get<double>(in_unit("180 deg/s", "rad/s")), std::numbers::pi, 1e-15);
}

TEST(Unit, wrong_texts_are_refused_with_a_hint) {
  for (const char* text :
       {"",      "MPa",   "1",     "1 Pa",    "1 kg",   "1 mm3", "1 m^",  "1 m/",   "1 /m",  "1 xm",
        "1 m m", "nan m", "inf m", "1e400 m", "0x10 m", "1e m",  "1 m33", "1 Mdeg", "--1 m", "1 m\n"}) {
    const auto read = in_unit(text, "m");
    ASSERT_TRUE(std::holds_alternative<UnitFault>(read)) << text;
    EXPECT_FALSE(std::get<UnitFault>(read).problem.empty()) << text;
    EXPECT_FALSE(std::get<UnitFault>(read).hint.empty()) << text;
  }
  EXPECT_TRUE(std::holds_alternative<UnitFault>(in_unit("0.3", "")));
}

TEST(Unit, a_weight_for_a_mass_and_back_says_what_it_would_be) {
  const UnitFault density = std::get<UnitFault>(in_unit("26 kN/m3", "kg/m3"));
  EXPECT_EQ(density.problem, "the unit \"kN/m3\" is one of weight, and this key holds a mass");
  EXPECT_EQ(density.hint, "divide by g: 26 kN/m3 / 9.81 m/s2 = 2650 kg/m3");
  const UnitFault force = std::get<UnitFault>(in_unit("2 t", "N"));
  EXPECT_EQ(force.hint, "multiply by g: 2 t * 9.81 m/s2 = 1.962e+04 N");
  EXPECT_EQ(std::get<UnitFault>(in_unit("26 kN", "kg/m3")).hint.find("divide"), std::string::npos);
  EXPECT_EQ(std::get<UnitFault>(in_unit("1 m/s", "s/m")).hint.find("by g"), std::string::npos);
  EXPECT_EQ(std::get<UnitFault>(in_unit("3 m2/s2", "m")).hint.find("by g"), std::string::npos);
}

}  // namespace
}  // namespace scree::io::test::case_unit_test
