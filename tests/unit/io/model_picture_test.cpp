// The picture of a case shows the objects of the model in their colours, and no others.
#include "io/pictures/model_picture.h"

#include <cairo.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "io/pictures/colour_map.h"
#include "io/results/file_error.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::model_picture_test {
namespace {

const std::string kSlope = R"(
title = "a slope"
model = { default_joint = "flat" }
material.rock = { density = 2600.0, young = "5 GPa", poisson = 0.25 }
joint.flat = { friction_deg = 30.0 }
joint.steep = { friction_deg = 25.0, cohesion = "10 kPa" }
[domain]
outline = [[0, 0], [40, 0], [40, 8], [22, 8], [14, 25], [0, 25]]
material = "rock"
[[domain.joint_set]]
joint = "flat"
dip_deg = 10
spacing = 4
[[domain.joint_set]]
joint = "steep"
dip_deg = 75
spacing = 5
[[stage]]
name = "s"
method = "dda"
integrator = "implicit"
dt = 1e-3
duration = 0.01
)";
const std::string kHeld = R"(
[[support]]
on = [[0, 0], [40, 0]]
fix = "both"
[[support]]
on = [[0, 0], [0, 25]]
fix = "normal"
[[traction]]
on = [[0, 25], [14, 25]]
surcharge = "20 kPa"
[[water]]
line = [[0, 12], [40, 9]]
)";

/// Pixels of a PNG whose colour is within 0.06 of one.
class Pixels {
 public:
  explicit Pixels(const std::filesystem::path& file) : surface_(cairo_image_surface_create_from_png(file.c_str())) {}
  Pixels(const Pixels&) = delete;
  Pixels& operator=(const Pixels&) = delete;
  ~Pixels() { cairo_surface_destroy(surface_); }
  [[nodiscard]] int count(const Colour& c) const {
    const unsigned char* data = cairo_image_surface_get_data(surface_);
    const int stride = cairo_image_surface_get_stride(surface_);
    int n = 0;
    for (int y = 0; y < cairo_image_surface_get_height(surface_); ++y)
      for (int x = 0; x < cairo_image_surface_get_width(surface_); ++x) {
        const unsigned char* p = data + y * stride + 4 * x;
        n += std::abs(p[2] / 255.0 - c.r) < 0.06 && std::abs(p[1] / 255.0 - c.g) < 0.06 &&
                     std::abs(p[0] / 255.0 - c.b) < 0.06
                 ? 1
                 : 0;
      }
    return n;
  }

 private:
  cairo_surface_t* surface_;
};

std::filesystem::path temporary(const std::string& ending) {
  return std::filesystem::path(testing::TempDir()) / ("scree_model_picture_" + std::to_string(::getpid()) + ending);
}

TEST(ModelPicture, shows_laws_supports_loads_and_water_in_their_colours) {
  const std::filesystem::path file = temporary(".png");
  const Colour support{0.10, 0.32, 0.18}, load{0.72, 0.10, 0.10}, water{0.10, 0.38, 0.78};
  draw_model(read_text(kSlope).model, {}, file);
  {
    const Pixels bare(file);
    EXPECT_GT(bare.count(distinct_colour(3)), 500);  // colours of laws begin with the third
    EXPECT_GT(bare.count(distinct_colour(4)), 500);
    EXPECT_LT(bare.count(support) + bare.count(load) + bare.count(water), 60);
  }
  draw_model(read_text(kSlope + kHeld).model, {.names = true, .width = 1680, .window = {}}, file);
  const Pixels all(file);
  EXPECT_GT(all.count(support), 800);
  EXPECT_GT(all.count(load), 300);
  EXPECT_GT(all.count(water), 800);
  std::filesystem::remove(file);
}

TEST(ModelPicture, is_drawn_in_every_format_and_refuses_others) {
  const Model model = read_text(kSlope + kHeld).model;
  for (const char* ending : {".pdf", ".svg"}) {
    const std::filesystem::path file = temporary(ending);
    draw_model(model, {.names = true, .width = 1680, .window = {}}, file);
    EXPECT_GT(std::filesystem::file_size(file), 5000u);
    std::filesystem::remove(file);
  }
  EXPECT_THROW(draw_model(model, {}, temporary(".jpg")), FileError);
}

}  // namespace
}  // namespace scree::io::test::model_picture_test
