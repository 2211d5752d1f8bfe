#include "io/pictures/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cmath>
#include <numbers>

#include "io/results/atomic_file.h"
#include "io/results/file_error.h"
#include "io/text/printable.h"

namespace scree::io {

namespace {

constexpr double kCapHeight = 0.73;  // of DejaVu Sans, as a fraction of its size
constexpr Colour kHatch{0.8, 0.79, 0.775};

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* make_surface(PictureFormat format, double width, double height, int pixels, std::string* bytes) {
  switch (format) {
    case PictureFormat::pdf:
      return cairo_pdf_surface_create_for_stream(append, bytes, width, height);
    case PictureFormat::svg: {
      cairo_surface_t* svg = cairo_svg_surface_create_for_stream(append, bytes, width, height);
      cairo_svg_surface_set_document_unit(svg, CAIRO_SVG_UNIT_PT);
      return svg;
    }
    case PictureFormat::png:
      break;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels, static_cast<int>(std::lround(height / width * pixels)));
}

}  // namespace

Canvas::Canvas(double width, double height, int pixels, PictureFormat format)
    : width_(width),
      height_(height),
      format_(format),
      bytes_(std::make_unique<std::string>()),
      surface_(make_surface(format, width, height, pixels, bytes_.get())),
      cairo_(cairo_create(surface_.get())) {
  if (!is_vector()) cairo_scale(get(), pixels / width, pixels / width);
  ink({1.0, 1.0, 1.0});
  cairo_paint(get());
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_set_font_options(get(), options);
  cairo_font_options_destroy(options);
}

void Canvas::line(double x0, double y0, double x1, double y1, double width, const Colour& colour) const {
  ink(colour);
  cairo_set_line_width(get(), width);
  cairo_move_to(get(), x0, y0);
  cairo_line_to(get(), x1, y1);
  cairo_stroke(get());
}

void Canvas::box(double x, double y, double w, double h, const Colour& fill) const {
  ink(fill);
  cairo_rectangle(get(), x, y, w, h);
  cairo_fill(get());
}

void Canvas::frame(double x, double y, double w, double h, double width, const Colour& colour) const {
  ink(colour);
  cairo_set_line_width(get(), width);
  cairo_rectangle(get(), x, y, w, h);
  cairo_stroke(get());
}

void Canvas::fill_piece() const {
  if (!is_vector()) {
    cairo_fill(get());
    return;
  }
  cairo_fill_preserve(get());  // viewers smooth regardless of the file: a rim covers the paper between neighbours
  cairo_set_line_width(get(), 0.25);
  cairo_stroke(get());
}

void Canvas::hatch_path() const {
  cairo_save(get());
  ink(kHeld);
  cairo_fill_preserve(get());
  cairo_clip(get());
  const double step = 5.0;                              // [pt]
  cairo_set_antialias(get(), CAIRO_ANTIALIAS_DEFAULT);  // independent of the setting used for the fill
  ink(kHatch);
  cairo_set_line_width(get(), 0.35);
  for (double x = -height_; x < width_; x += step) {
    cairo_move_to(get(), x, height_);
    cairo_line_to(get(), x + height_, 0.0);
  }
  cairo_stroke(get());
  cairo_restore(get());
}

void Canvas::use(const TextStyle& style) const {
  cairo_select_font_face(get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(get(), style.size);
}

double Canvas::text_width(const std::string& text, const TextStyle& style) const {
  use(style);
  cairo_text_extents_t extents{};
  cairo_text_extents(get(), printable_line(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(double x, double y, const std::string& text, const TextStyle& style) const {
  const double width = text_width(text, style);
  cairo_save(get());
  cairo_translate(get(), x, y);
  if (style.turned) cairo_rotate(get(), -0.5 * std::numbers::pi);
  cairo_move_to(get(), -style.across * width, style.up * kCapHeight * style.size);
  ink(style.colour);
  cairo_show_text(get(), printable_line(text).c_str());  // cairo draws nothing more after bytes that are not UTF-8
  cairo_restore(get());
}

std::string Canvas::fitted(const std::string& text, double width, const TextStyle& style) const {
  if (text_width(text, style) <= width) return text;
  std::string cut = text;
  do {  // one character, which may have several bytes
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0) == 0x80) cut.pop_back();
    if (!cut.empty()) cut.pop_back();
  } while (!cut.empty() && text_width(cut + "…", style) > width);
  return cut + "…";
}

void Canvas::save(const std::filesystem::path& file) const {
  std::string png;
  cairo_surface_flush(surface_.get());
  cairo_status_t status = cairo_status(get());
  if (status == CAIRO_STATUS_SUCCESS && is_vector()) {
    cairo_show_page(get());
    cairo_surface_finish(surface_.get());
    status = cairo_surface_status(surface_.get());
  } else if (status == CAIRO_STATUS_SUCCESS) {
    status = cairo_surface_write_to_png_stream(surface_.get(), append, &png);
  }
  if (status != CAIRO_STATUS_SUCCESS)
    throw FileError(file, std::string("cannot draw the picture: ") + cairo_status_to_string(status));
  write_atomically(file, is_vector() ? *bytes_ : png);
}

}  // namespace scree::io
