#include <algorithm>
#include <cmath>
#include <limits>

#include "io/pictures/colour_map.h"
#include "io/pictures/plot_curves.h"
#include "io/pictures/snapshot.h"
#include "io/results/run_reader.h"

namespace scree::io {

namespace {

constexpr double kLedgerWidth = 504.0, kUpper = 200.0, kLower = 90.0;             // page, panels [pt]
constexpr double kLedgerTop = 52.0, kLedgerBetween = 14.0, kLedgerBottom = 38.0;  // [pt]
constexpr double kLegendGap = 10.0, kLedgerSample = 20.0, kLedgerLine = 12.0;     // [pt]
constexpr int kLedgerPixels = 1680;

struct Curve {
  std::string side, name;
  std::vector<double> value;  // [J]
  Colour colour;
};

/// The dashes of a side: energy solid, work dashed, dissipation dash-dotted.
void use_dashes(cairo_t* c, const std::string& side) {
  const double work[] = {4.0, 2.0}, dissipated[] = {5.0, 1.8, 1.2, 1.8};
  if (side == "work")
    cairo_set_dash(c, work, 2, 0.0);
  else if (side == "dissipated")
    cairo_set_dash(c, dissipated, 4, 0.0);
  else
    cairo_set_dash(c, nullptr, 0, 0.0);
}

/// Columns that are visible: a thousandth of the largest is less than the width of a line.
std::vector<Curve> curves_of(StoredLedger& ledger) {
  constexpr double kShown = 1e-3;
  double most = 0.0;
  const auto largest = [](const std::vector<double>& values) {
    double out = 0.0;
    for (const double v : values) out = std::isfinite(v) ? std::max(out, std::abs(v)) : out;
    return out;
  };
  for (const StoredLedger::Column& c : ledger.columns)
    if (c.side != "scheme") most = std::max(most, largest(c.value));
  std::vector<Curve> curves;
  for (const char* side : {"energy", "work", "dissipated"})
    for (StoredLedger::Column& c : ledger.columns) {
      if (c.side != side || !(largest(c.value) > kShown * most)) continue;
      std::string name = c.name;
      std::replace(name.begin(), name.end(), '_', ' ');
      curves.push_back({side, name, std::move(c.value), distinct_colour(curves.size())});
    }
  return curves;
}

void draw_legend(const Canvas& canvas, double x, double y, const std::vector<Curve>& curves) {
  TextStyle head = kTickText, text = kTickText;
  head.bold = true, head.up = 0.5, text.up = 0.5;
  std::string side;
  for (const Curve& curve : curves) {
    if (curve.side != side) {
      y += side.empty() ? 0.5 * kLedgerLine : 1.3 * kLedgerLine;
      side = curve.side;
      canvas.text(x, y, side == "dissipated" ? "dissipation" : side, head);
    }
    y += kLedgerLine;
    use_dashes(canvas.get(), curve.side);
    canvas.line(x, y, x + kLedgerSample, y, 1.2, curve.colour);
    use_dashes(canvas.get(), "");
    canvas.text(x + kLedgerSample + 4.0, y, curve.name, text);
  }
}

/// log10 of |closure| / moved; not a number where it is zero or nothing has moved.
std::vector<double> closure_decades(const StoredLedger& ledger) {
  std::vector<double> decades;
  for (std::size_t i = 0; i < ledger.time.size(); ++i) {
    const double share = ledger.moved[i] > 0.0 ? std::abs(ledger.closure[i]) / ledger.moved[i] : 0.0;
    decades.push_back(share > 0.0 ? std::log10(share) : std::numeric_limits<double>::quiet_NaN());
  }
  return decades;
}

void draw_closure(const Canvas& canvas, PlotArea area, const StoredLedger& ledger, const Ticks& time,
                  const std::vector<StoredStage>& stages) {
  const std::vector<double> decades = closure_decades(ledger);
  Range range;
  range.add(decades);
  const bool none = range.empty();
  // At least three decades, down from the one above the largest.
  const int high = none ? -12 : static_cast<int>(std::floor(range.high)) + 1;
  const int low = none ? -18 : std::min(static_cast<int>(std::floor(range.low)), high - 3);
  area.y0 = low, area.y1 = high;
  draw_axes(canvas, area, time, power_ticks(low, high, 6), "time [s]", "|closure| / moved", true);
  draw_stages(canvas, area, stages, false);
  const Clip clip(canvas, area);
  canvas.ink({0.0, 0.27, 0.48});
  cairo_set_line_width(canvas.get(), 0.9);
  draw_curve(canvas, area, ledger.time, decades);
  if (none) {
    TextStyle middle = kTickText;
    middle.across = 0.5, middle.up = 0.5;
    canvas.text(area.x + 0.5 * area.w, area.y + 0.5 * area.h, "zero at every stored time", middle);
  }
}

}  // namespace

void plot_ledger(const std::filesystem::path& run_folder, const std::filesystem::path& file) {
  const PictureFormat format = format_or_error(file);
  const RunReader run(run_folder);
  const std::vector<StoredStage> stages = run.stages();
  StoredLedger ledger = run.ledger();
  if (ledger.time.empty()) throw FileError(run_folder, "has no ledger yet");
  const std::vector<Curve> curves = curves_of(ledger);

  Range energy, time;
  time.add(ledger.time);
  for (const Curve& c : curves) energy.add(c.value);
  energy.widen(0.05);
  if (!(time.low < time.high)) time.widen(0.0);
  const Unit unit = prefixed("J", std::max(std::abs(energy.low), std::abs(energy.high)));

  const Canvas ruler(kLedgerWidth, 10.0, 64);
  const auto first = time.low, last = time.high;
  const double low = energy.low / unit.factor, high = energy.high / unit.factor;
  const Ticks joules = round_ticks(low, high, 6);
  const double numbers = std::max(widest(ruler, joules), widest(ruler, power_ticks(-17, -16, 2)));
  double names = 0.0;
  for (const Curve& c : curves) names = std::max(names, ruler.text_width(c.name, kTickText));
  const double left = 8.0 + 22.0 + numbers, right = kLegendGap + kLedgerSample + 4.0 + names + 8.0;
  const double w = kLedgerWidth - left - right;
  std::size_t sides = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) sides += i == 0 || curves[i].side != curves[i - 1].side;
  const double legend = kLedgerLine * (static_cast<double>(curves.size()) + 1.3 * static_cast<double>(sides));
  const double upper_height = std::max(kUpper, legend - kLower);  // the legend may reach down beside the lower panel
  const PlotArea upper{left, kLedgerTop, w, upper_height, first, last, low, high, numbers};
  const PlotArea lower{left, kLedgerTop + upper_height + kLedgerBetween, w, kLower, first, last, 0.0, 1.0, numbers};

  const Canvas canvas(kLedgerWidth, lower.y + lower.h + kLedgerBottom, kLedgerPixels, format);
  TextStyle title{10.5};
  title.bold = true;
  const double room = kLedgerWidth - left - 8.0;
  canvas.text(left, kLedgerTop - 33.0, canvas.fitted(run.title(), room, title), title);
  canvas.text(left, kLedgerTop - 20.0, "Energy ledger; columns below a thousandth of the largest are left out", {8.5});
  const Ticks seconds = round_ticks(first, last, 7);
  draw_axes(canvas, upper, seconds, joules, "", "energy [" + unit.name + "]", true);
  draw_stages(canvas, upper, stages, true);
  for (const Curve& c : curves) {
    const Clip clip(canvas, upper);
    std::vector<double> shown;
    for (const double v : c.value) shown.push_back(v / unit.factor);
    canvas.ink(c.colour);
    cairo_set_line_width(canvas.get(), 1.1);
    use_dashes(canvas.get(), c.side);
    draw_curve(canvas, upper, ledger.time, shown);
  }
  draw_legend(canvas, left + w + kLegendGap, upper.y, curves);
  draw_closure(canvas, lower, ledger, seconds, stages);
  canvas.save(file);
}

}  // namespace scree::io
