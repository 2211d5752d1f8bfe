// A picture in typographic points, y down, on Cairo; saved as PNG, PDF or SVG.
#pragma once

#include <cairo.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include "io/pictures/picture_format.h"

namespace scree::io {

struct Colour {
  double r = 0.0, g = 0.0, b = 0.0, a = 1.0;  // 0 to 1
};

inline constexpr Colour kInk{0.13, 0.13, 0.13};    // text and frames
inline constexpr Colour kFaint{0.86, 0.86, 0.86};  // grids
inline constexpr Colour kHeld{0.905, 0.9, 0.89};   // below hatching

struct TextStyle {
  double size = 8.0;  // [pt]
  double across = 0.0,
         up = 0.0;  // anchor in the text's box: 0 left, 0.5 middle, 1 right; 0 base line, 0.5 middle, 1 top
  bool bold = false;
  bool turned = false;  // reads upwards; across then runs up the page
  Colour colour = kInk;
};

class Canvas {
 public:
  /// A white page.   @param width,height [pt]   @param pixels  width of a PNG in pixels; PDF and SVG have none
  Canvas(double width, double height, int pixels, PictureFormat format = PictureFormat::png);

  /// PDF and SVG keep lines and letters as such; the program that shows them makes the pixels.
  [[nodiscard]] bool is_vector() const { return format_ != PictureFormat::png; }
  [[nodiscard]] cairo_t* get() const { return cairo_.get(); }
  [[nodiscard]] double width() const { return width_; }
  [[nodiscard]] double height() const { return height_; }

  void ink(const Colour& c) const { cairo_set_source_rgba(get(), c.r, c.g, c.b, c.a); }
  void line(double x0, double y0, double x1, double y1, double width, const Colour& colour) const;
  void box(double x, double y, double w, double h, const Colour& fill) const;
  void frame(double x, double y, double w, double h, double width, const Colour& colour) const;
  /// Fills the current path, which it ends, with the current ink: one of many pieces that lie side by side.
  void fill_piece() const;
  /// Grey with hatching over the current path, which it ends.
  void hatch_path() const;

  void text(double x, double y, const std::string& text, const TextStyle& style = {}) const;
  [[nodiscard]] double text_width(const std::string& text, const TextStyle& style = {}) const;
  /// The text, cut with an ellipsis where it is longer than `width` [pt].
  [[nodiscard]] std::string fitted(const std::string& text, double width, const TextStyle& style = {}) const;

  /// Ends the picture. Written to a temporary name and renamed.   @throws FileError
  void save(const std::filesystem::path& file) const;

 private:
  struct Destroy {
    void operator()(cairo_t* c) const { cairo_destroy(c); }
    void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
  };
  void use(const TextStyle& style) const;

  double width_, height_;
  PictureFormat format_;
  std::unique_ptr<std::string> bytes_;  // of PDF and SVG so far; the surface writes into it until it is destroyed
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> cairo_;
};

}  // namespace scree::io
