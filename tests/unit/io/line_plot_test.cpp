// Line plots: pixels in the colour of each series are counted.
#include "io/pictures/line_plot.h"

#include <cairo/cairo.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/pictures/colour_map.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::test::line_plot_test {
namespace {

/// Pixels of a picture that have the colour of a series.
int pixels_of(const fs::path& file, std::size_t series) {
  cairo_surface_t* picture = cairo_image_surface_create_from_png(file.c_str());
  cairo_surface_flush(picture);
  const unsigned char* data = cairo_image_surface_get_data(picture);
  const int width = cairo_image_surface_get_width(picture), height = cairo_image_surface_get_height(picture);
  const int stride = cairo_image_surface_get_stride(picture);
  const Colour c = distinct_colour(series);
  const double wanted[] = {c.b, c.g, c.r};
  int count = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      bool same = true;
      for (int k = 0; k < 3; ++k) same = same && std::abs(data[y * stride + 4 * x + k] - 255.0 * wanted[k]) < 2.0;
      count += same ? 1 : 0;
    }
  cairo_surface_destroy(picture);
  return count;
}

const LinePlot kPlot{"Title",
                     "x [m]",
                     "y [Pa]",
                     {{"a line", {0.0, 1.0, 2.0}, {0.0, 2.0, 1.0}}, {"points", {0.5, 1.5}, {1.0, 1.5}, true}}};

TEST(LinePlot, both_kinds_of_series_are_drawn) {
  const Scratch scratch;
  const fs::path file = scratch.path() / "plot.png";
  draw_line_plot(kPlot, file);
  EXPECT_GT(pixels_of(file, 0), 1000);  // most of the page width, some pixels thick
  EXPECT_GT(pixels_of(file, 1), 200);   // two discs and one in the legend
  EXPECT_EQ(pixels_of(file, 2), 0);
}

TEST(LinePlot, decades_leave_out_what_is_not_positive) {
  const Scratch scratch;
  LinePlot plot = kPlot;
  plot.log_x = plot.log_y = true;
  draw_line_plot(plot, scratch.path() / "a.png");  // the line's first point is (0, 0)
  const int all = pixels_of(scratch.path() / "a.png", 0);
  EXPECT_GT(all, 500);
  plot.series[0].y = {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()};
  draw_line_plot(plot, scratch.path() / "b.png");
  EXPECT_LT(pixels_of(scratch.path() / "b.png", 0), all / 2);  // only the legend remains
}

TEST(LinePlot, plot_without_numbers_is_a_picture_all_the_same) {
  const Scratch scratch;
  draw_line_plot({"Empty", "x", "y", {}, true, true}, scratch.path() / "empty.svg");
  draw_line_plot({"Empty", "x", "y", {}}, scratch.path() / "linear.svg");
  EXPECT_NE(text_of(scratch.path() / "empty.svg").find("<svg"), std::string::npos);
}

TEST(LinePlot, names_of_no_picture_and_folders_that_are_not_there_are_errors) {
  const Scratch scratch;
  EXPECT_THROW(draw_line_plot(kPlot, scratch.path() / "plot.txt"), FileError);
  EXPECT_THROW(draw_line_plot(kPlot, scratch.path() / "none" / "plot.svg"), FileError);
}

}  // namespace
}  // namespace scree::io::test::line_plot_test
