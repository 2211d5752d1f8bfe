// Pictures of a stored run.
#include "io/pictures/snapshot.h"

#include <cairo/cairo.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "io/pictures/ticks.h"
#include "io/results/h5_read.h"
#include "io/results/results_sink.h"
#include "io/results/run_reader.h"
#include "io/results/sha256.h"
#include "tests/unit/io/results_run.h"

#if defined(__SANITIZE_ADDRESS__)
/// The font library does not free its cache at the end of the process and does not document this.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig"; }
#endif

namespace scree::io::snapshot_test {
namespace {

using namespace test;

// --- pictures -----------------------------------------------------------------------------------------------------

struct Picture {
  int width = 0, height = 0;
  std::vector<std::array<int, 3>> pixel;

  explicit Picture(const fs::path& png) {
    cairo_surface_t* surface = cairo_image_surface_create_from_png(png.c_str());
    width = cairo_image_surface_get_width(surface), height = cairo_image_surface_get_height(surface);
    const unsigned char* data = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const unsigned char* p = data + y * stride + 4 * x;
        pixel.push_back({p[2], p[1], p[0]});
      }
    cairo_surface_destroy(surface);
  }
  /// Fraction of pixels within 3 of a colour.
  [[nodiscard]] double share(const std::array<int, 3>& rgb) const {
    const auto near = [&](const auto& p) {
      return std::abs(p[0] - rgb[0]) <= 3 && std::abs(p[1] - rgb[1]) <= 3 && std::abs(p[2] - rgb[2]) <= 3;
    };
    return static_cast<double>(std::count_if(pixel.begin(), pixel.end(), near)) / static_cast<double>(pixel.size());
  }
};

TEST_F(Results, snapshot_has_width_asked_and_colours_of_the_field) {
  const fs::path png = scratch->path() / "u.png";
  SnapshotOptions options;
  options.width = 840;
  snapshot(run, options, png);
  const Picture picture(png);
  EXPECT_EQ(picture.width, 840);
  EXPECT_GT(picture.height, 250);
  EXPECT_GT(picture.share({253, 231, 37}), 0.015);  // the block: the largest displacement, viridis at 1
  EXPECT_GT(picture.share({231, 230, 227}), 0.1);   // the held base: grey
  EXPECT_LT(picture.share({68, 1, 84}), 0.01);      // viridis at 0 only in the colour bar
}

TEST_F(Results, snapshot_of_signed_stress_has_blue_for_compression) {
  SnapshotOptions options;
  options.field = Field::sxx;
  snapshot(run, options, scratch->path() / "compression.png");  // last frame: -4 MPa
  options.time = 0.5;
  snapshot(run, options, scratch->path() / "tension.png");  // 0.5 MPa
  const Picture compression(scratch->path() / "compression.png"), tension(scratch->path() / "tension.png");
  const std::array<int, 3> blue{5, 48, 97}, red{103, 0, 31};
  EXPECT_GT(compression.share(blue), 10.0 * compression.share(red));
  EXPECT_GT(tension.share(red), 10.0 * tension.share(blue));
}

TEST_F(Results, snapshot_of_every_field_is_drawn) {
  for (const std::string& name : field_names()) {
    SnapshotOptions options;
    options.field = field_named(name).value();
    options.frame = 1;
    options.width = 420;
    const fs::path png = scratch->path() / (name + ".png");
    snapshot(run, options, png);
    EXPECT_EQ(Picture(png).width, 420) << name;
  }
  EXPECT_FALSE(field_named("temperature"));
}

TEST_F(Results, snapshot_of_frame_that_is_not_there_gives_file_error_and_no_picture) {
  SnapshotOptions options;
  options.frame = 7;
  EXPECT_THROW(snapshot(run, options, scratch->path() / "none.png"), FileError);
  EXPECT_FALSE(fs::exists(scratch->path() / "none.png"));
  EXPECT_THROW(snapshot(run, {}, scratch->path() / "no/such/folder.png"), FileError);
}

TEST_F(Results, ledger_plot_draws_a_line_a_column_that_is_not_zero) {
  const fs::path png = scratch->path() / "ledger.png";
  plot_ledger(run, png);
  const Picture picture(png);
  EXPECT_EQ(picture.width, 1680);
  for (const std::array<int, 3>& colour : {std::array{0, 114, 178}, {230, 159, 0}, {0, 158, 115}})
    EXPECT_GT(picture.share(colour), 5e-4);
  EXPECT_LT(picture.share({204, 121, 167}), 1e-5);  // colour of a fourth column
}

TEST_F(Results, snapshot_as_pdf_and_svg_is_of_that_kind_and_keeps_the_letters) {
  SnapshotOptions options;
  options.arrows = Arrows::displacement;
  snapshot(run, options, scratch->path() / "u.pdf");
  snapshot(run, options, scratch->path() / "u.svg");
  plot_ledger(run, scratch->path() / "ledger.pdf");
  const std::string pdf = text_of(scratch->path() / "u.pdf"), svg = text_of(scratch->path() / "u.svg");
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
  EXPECT_NE(pdf.find("/FontFile"), std::string::npos);        // text is stored as text
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos);  // nothing is rasterised
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("width=\"504pt\""), std::string::npos);  // 7 inches
  EXPECT_EQ(svg.find("<image"), std::string::npos);
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_TRUE(text_of(scratch->path() / "ledger.pdf").starts_with("%PDF-"));
  EXPECT_THROW(snapshot(run, options, scratch->path() / "u.jpg"), FileError);
  EXPECT_FALSE(fs::exists(scratch->path() / "u.jpg"));
}

TEST_F(Results, snapshot_with_fixed_range_colours_by_it) {
  SnapshotOptions options;
  options.field = Field::sxx;
  options.frame = 4;  // -4 MPa
  options.range = {-8e6, 8e6};
  snapshot(run, options, scratch->path() / "half.png");
  EXPECT_GT(Picture(scratch->path() / "half.png").share({106, 172, 208}), 0.005);  // half way to the blue end
  options.range = {-4e6, 1e6};  // white remains zero: the block has the end colour
  snapshot(run, options, scratch->path() / "end.png");
  EXPECT_GT(Picture(scratch->path() / "end.png").share({5, 48, 97}), 0.005);
  EXPECT_LT(Picture(scratch->path() / "end.png").share({103, 0, 31}), 1e-4);  // the red end is not reached
}

TEST_F(Results, arrows_and_names_add_ink_to_the_blocks) {
  SnapshotOptions options;
  options.frame = 2;
  const fs::path png = scratch->path() / "marks.png";
  const auto black = [&] {
    snapshot(run, options, png);
    return Picture(png).share({0, 0, 0});
  };
  const double plain = black();
  options.arrows = Arrows::velocity;
  EXPECT_GT(black(), plain + 5e-5);
  options.arrows = Arrows::none;
  const auto dark = [&] {
    snapshot(run, options, png);
    return Picture(png).share({33, 33, 33});
  };
  const double before = dark();
  options.labels = true;
  EXPECT_GT(dark(), before + 2e-5);
}

TEST_F(Results, history_plot_draws_a_line_a_monitor_and_knows_their_names) {
  const fs::path png = scratch->path() / "history.png";
  plot_history(run, {}, png);
  const Picture all(png);
  EXPECT_EQ(all.width, 1680);
  EXPECT_GT(all.share({230, 159, 0}), 1e-4);  // the second monitor
  plot_history(run, {"crest, left_2"}, png);
  const Picture one(png);
  EXPECT_GT(one.share({0, 114, 178}), 1e-4);
  EXPECT_LT(one.share({230, 159, 0}), 1e-6);
  try {
    plot_history(run, {"toe"}, png);
    FAIL() << "no FileError";
  } catch (const FileError& e) {
    EXPECT_NE(e.reason.find("no monitor toe; there are crest, left"), std::string::npos) << e.reason;
  }
}

TEST(Ticks, round_ticks_lie_inside_and_share_their_digits) {
  const Ticks t = round_ticks(-0.13, 0.42, 5);
  EXPECT_EQ(t.label, (std::vector<std::string>{"−0.1", "0.0", "0.1", "0.2", "0.3", "0.4"}));
  for (const double scale : {1e-9, 3e-4, 1.0, 7.0, 2.5e6})
    for (const double at : {-1.0, 0.0, 10.0}) {
      const Ticks s = round_ticks(at * scale, (at + 1.0) * scale, 5);
      EXPECT_GE(s.at.size(), 3u);
      EXPECT_EQ(std::set<std::string>(s.label.begin(), s.label.end()).size(), s.label.size());
      EXPECT_GE(s.at.front(), at * scale - 1e-8 * scale);
      EXPECT_LE(s.at.back(), (at + 1.0) * scale + 1e-8 * scale);
    }
}

TEST(Ticks, prefix_brings_the_largest_between_one_and_a_thousand) {
  EXPECT_EQ(prefixed("Pa", 2.5e6).name, "MPa");
  EXPECT_EQ(prefixed("Pa", 12.0).name, "Pa");
  EXPECT_EQ(prefixed("m", 0.02).name, "mm");
  EXPECT_EQ(prefixed("m", 4000.0).name, "m");
}

}  // namespace
}  // namespace scree::io::snapshot_test
