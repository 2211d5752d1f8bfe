// Parts of pictures: colours, ranges, arrows, file names.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "io/pictures/colour_map.h"
#include "io/pictures/frame_field.h"
#include "io/pictures/frame_marks.h"
#include "io/pictures/plot_curves.h"
#include "io/results/file_error.h"

namespace scree::io::picture_parts_test {
namespace {

// --- colours ------------------------------------------------------------------------------------------------------

/// Lightness L* of CIELAB, 0 to 100, of an sRGB colour.
double perceived(const Colour& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : 24389.0 / 27.0 * y;
}

TEST(ColourMap, sequential_colours_grow_lighter_evenly) {
  // Equal steps of the value give equal steps of lightness, within a fifth of the mean: the table has whole bytes.
  const int n = 16;
  const double mean = (perceived(sequential_colour(1.0)) - perceived(sequential_colour(0.0))) / n;
  EXPECT_GT(mean, 4.0);
  for (int i = 0; i < n; ++i) {
    const double step = perceived(sequential_colour((i + 1.0) / n)) - perceived(sequential_colour(1.0 * i / n));
    EXPECT_NEAR(step, mean, 0.2 * mean) << i;
  }
}

TEST(ColourMap, diverging_colours_are_lightest_at_zero_and_grow_darker_to_both_ends) {
  for (int i = 0; i < 20; ++i) {
    const double near = 0.5 * i / 20.0, far = 0.5 * (i + 1) / 20.0;
    EXPECT_GT(perceived(diverging_colour(0.5 + near)), perceived(diverging_colour(0.5 + far)));
    EXPECT_GT(perceived(diverging_colour(0.5 - near)), perceived(diverging_colour(0.5 - far)));
  }
  EXPECT_GT(diverging_colour(0.0).b, diverging_colour(0.0).r);
  EXPECT_GT(diverging_colour(1.0).r, diverging_colour(1.0).b);
}

TEST(ColourMap, values_beyond_the_ends_have_the_colours_of_the_ends) {
  EXPECT_EQ(sequential_colour(-3.0).r, sequential_colour(0.0).r);
  EXPECT_EQ(sequential_colour(7.0).g, sequential_colour(1.0).g);
}

TEST(ColourMap, first_42_distinct_colours_differ) {
  std::set<std::tuple<double, double, double>> seen;
  for (std::size_t i = 0; i < 42; ++i) {
    const Colour c = distinct_colour(i);
    EXPECT_TRUE(seen.emplace(c.r, c.g, c.b).second) << i;
    for (const double part : {c.r, c.g, c.b}) EXPECT_TRUE(part >= 0.0 && part <= 1.0) << i;
  }
  EXPECT_EQ(distinct_colour(42).r, distinct_colour(0).r);
}

// --- files and numbers --------------------------------------------------------------------------------------------

TEST(PictureFormat, is_told_by_the_ending_whatever_its_case) {
  EXPECT_EQ(picture_format("a/b.png"), PictureFormat::png);
  EXPECT_EQ(picture_format("b.x.PDF"), PictureFormat::pdf);
  EXPECT_EQ(picture_format("b.Svg"), PictureFormat::svg);
  for (const char* name : {"b", "b.jpg", "png", ".png", "b.png.gz"}) EXPECT_FALSE(picture_format(name)) << name;
  EXPECT_THROW((void)format_or_error("b.jpg"), FileError);
}

TEST(RoundBelow, is_one_two_or_five_times_a_power_of_ten_not_above) {
  for (const auto& [x, round] :
       {std::pair{5.9, 5.0}, {5.0, 5.0}, {4.99, 2.0}, {1.0, 1.0}, {0.03, 0.02}, {1999.0, 1000.0}})
    EXPECT_DOUBLE_EQ(round_below(x), round) << x;
}

TEST(AxisLabel, says_what_the_axis_counts_from) {
  EXPECT_EQ(axis_label('x', 0.0), "x [m]");
  EXPECT_EQ(axis_label('x', 500000.0), "x − 500000 [m]");
  EXPECT_EQ(axis_label('y', -4123456.5), "y + 4123456.5 [m]");
}

TEST(Range, leaves_out_what_is_not_finite_and_is_never_without_length_once_widened) {
  Range range;
  EXPECT_TRUE(range.empty());
  range.add({2.0, std::numeric_limits<double>::quiet_NaN(), 6.0, std::numeric_limits<double>::infinity()});
  EXPECT_EQ(range.low, 2.0);
  EXPECT_EQ(range.high, 6.0);
  range.widen(0.25);
  EXPECT_EQ(range.low, 1.0);
  EXPECT_EQ(range.high, 7.0);
  Range none, one;
  none.widen(0.1);
  one.add(5.0);
  one.widen(0.1);
  EXPECT_LT(none.low, none.high);
  EXPECT_LT(one.low, 5.0);
  EXPECT_GT(one.high, 5.0);
}

// --- fields and marks ---------------------------------------------------------------------------------------------

/// Block 0: a row of `n` unit squares from x = 0. Block 1: an L from x = 100. Cells share no points.
StoredFrame row_and_corner(int n) {
  StoredFrame f;
  f.offsets.push_back(0);
  const auto add = [&](std::int32_t block, std::initializer_list<Vec2> points) {
    for (const Vec2& p : points) {
      f.connectivity.push_back(static_cast<std::int64_t>(f.points()));
      f.position.insert(f.position.end(), {p.x(), p.y()});
    }
    f.offsets.push_back(static_cast<std::int64_t>(f.connectivity.size()));
    f.block.push_back(block);
  };
  for (int i = 0; i < n; ++i) {
    const double x = i;
    add(0, {{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}});
  }
  add(1, {{100, 0}, {103, 0}, {103, 1}, {101, 1}, {101, 3}, {100, 3}});
  return f;
}

TEST(CellHolds, point_in_the_notch_of_an_l_is_outside) {
  const StoredFrame f = row_and_corner(1);
  EXPECT_TRUE(cell_holds(f, 1, {100.5, 2.0}));
  EXPECT_TRUE(cell_holds(f, 1, {102.5, 0.5}));
  EXPECT_FALSE(cell_holds(f, 1, {102.0, 2.0}));
  EXPECT_FALSE(cell_holds(f, 1, {99.0, 0.5}));
  EXPECT_FALSE(cell_holds(f, 0, {102.5, 0.5}));
}

TEST(Arrows, small_block_has_one_and_large_block_is_divided_evenly) {
  const StoredFrame f = row_and_corner(12);
  std::vector<double> value;
  for (std::size_t c = 0; c < f.cells(); ++c) value.insert(value.end(), {static_cast<double>(c), 1.0});
  const std::vector<char> all(f.cells(), 0);
  const std::vector<Arrow> one = arrows_of(f, value, all, 50.0);
  ASSERT_EQ(one.size(), 2u);
  EXPECT_TRUE(one[0].at.isApprox(Vec2(6.0, 0.5)));
  EXPECT_TRUE(one[0].vector.isApprox(Vec2(5.5, 1.0)));  // the mean of 0 to 11
  const std::vector<Arrow> three = arrows_of(f, value, all, 4.0);
  ASSERT_EQ(three.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i) {
    const double first = 4.0 * static_cast<double>(i);
    EXPECT_TRUE(three[i].at.isApprox(Vec2(first + 2.0, 0.5))) << three[i].at;
    EXPECT_TRUE(three[i].vector.isApprox(Vec2(first + 1.5, 1.0)));
  }
}

TEST(Arrows, held_cells_and_values_that_are_no_numbers_take_no_part) {
  const StoredFrame f = row_and_corner(3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Arrow> arrows = arrows_of(f, {1, 1, nan, 1, 3, 3, 7, 7}, {0, 0, 0, 1}, 50.0);
  ASSERT_EQ(arrows.size(), 1u);
  EXPECT_TRUE(arrows[0].vector.isApprox(Vec2(2.0, 2.0)));
}

TEST(ColourRange, rounding_alone_gives_a_range_about_one) {
  const StoredFrame f = row_and_corner(2);
  const std::vector<StoredMaterial> rock{{"rock", 5e9}};
  const double noise = rounding_of(Field::sxx, f, rock);
  EXPECT_DOUBLE_EQ(noise, 5e-3);
  const std::vector<char> none(f.cells(), 0);
  EXPECT_EQ(colour_range(f, Field::sxx, {1e-4, -2e-4, 3e-5}, none, noise), std::pair(-1.0, 1.0));
  EXPECT_EQ(colour_range(f, Field::sxx, {1e4, -2e4, 3e3}, none, noise), std::pair(-2e4, 2e4));
  EXPECT_EQ(rounding_of(Field::speed, f, rock), 0.0);
}

}  // namespace
}  // namespace scree::io::picture_parts_test
