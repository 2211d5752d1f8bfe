#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/pictures/colour_map.h"
#include "io/pictures/plot_curves.h"
#include "io/pictures/snapshot.h"

namespace scree::io {

namespace {

constexpr double kHistoryWidth = 504.0, kHistoryPanel = 105.0;                       // page, a panel [pt]
constexpr double kHistoryTop = 52.0, kHistoryBetween = 14.0, kHistoryBottom = 38.0;  // [pt]
constexpr double kHistoryGap = 10.0, kHistorySample = 20.0, kHistoryLine = 12.0;     // legend [pt]
constexpr double kWidestNames = 130.0;                                               // widest of its names [pt]
constexpr int kHistoryPixels = 1680;

/// One quantity of every monitor.
struct Panel {
  std::string label;
  std::vector<std::vector<double>> value;  // per monitor, in the unit
  double low = 0.0, high = 1.0;
  Ticks ticks;
};

std::vector<double> column(const std::vector<double>& pairs, std::size_t which) {
  std::vector<double> values;
  for (std::size_t i = which; i < pairs.size(); i += 2) values.push_back(pairs[i]);
  return values;
}

std::vector<double> magnitude(const std::vector<double>& pairs) {
  std::vector<double> values;
  for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) values.push_back(std::hypot(pairs[i], pairs[i + 1]));
  return values;
}

Panel panel(const std::string& name, const std::string& si, std::vector<std::vector<double>> values) {
  Range range;
  for (const std::vector<double>& v : values) range.add(v);
  range.widen(0.05);
  const Unit unit = prefixed(si, std::max(std::abs(range.low), std::abs(range.high)));
  for (std::vector<double>& v : values)
    for (double& x : v) x /= unit.factor;
  const double low = range.low / unit.factor, high = range.high / unit.factor;
  return {name + " [" + unit.name + "]", std::move(values), low, high, round_ticks(low, high, 4)};
}

std::vector<Panel> panels_of(const std::vector<StoredMonitor>& monitors) {
  std::vector<std::vector<double>> ux, uy, speed;
  for (const StoredMonitor& m : monitors) {
    ux.push_back(column(m.displacement, 0));
    uy.push_back(column(m.displacement, 1));
    speed.push_back(magnitude(m.velocity));
  }
  return {panel("displacement x", "m", std::move(ux)), panel("displacement y", "m", std::move(uy)),
          panel("speed", "m/s", std::move(speed))};
}

std::vector<StoredMonitor> chosen(const RunReader& run, const std::vector<std::string>& names,
                                  const std::filesystem::path& folder) {
  std::vector<StoredMonitor> all = run.monitors(), chosen;
  if (all.empty()) throw FileError(folder, "has no monitors; add [[monitor]] to its case");
  if (names.empty()) return all;
  std::vector<std::string> known;
  known.reserve(all.size());
  for (const StoredMonitor& m : all) known.push_back(m.name);
  for (const std::string& name : names) {
    const std::size_t before = chosen.size();
    for (std::size_t m = 0; m < all.size(); ++m)
      if (known[m] == name || known[m].starts_with(name + "#")) chosen.push_back(all[m]);
    if (chosen.size() == before)
      throw FileError(folder, fmt::format("has no monitor {}; there are {}", name, fmt::join(known, ", ")));
  }
  return chosen;
}

/// "slide-1#1" as "slide-1" where it is the only monitor of its block.
void shorten_names(std::vector<StoredMonitor>& monitors, const std::vector<StoredMonitor>& all) {
  for (StoredMonitor& m : monitors) {
    const std::size_t mark = m.name.rfind('#');
    if (mark == std::string::npos || mark == 0) continue;
    const std::string block = m.name.substr(0, mark);
    const auto of_block = [&](const StoredMonitor& o) { return o.name == block || o.name.starts_with(block + "#"); };
    if (std::count_if(all.begin(), all.end(), of_block) == 1) m.name = block;
  }
}

void draw_legend(const Canvas& canvas, double x, double y, double room, const std::vector<StoredMonitor>& monitors) {
  TextStyle style = kTickText;
  style.up = 0.5;
  for (std::size_t m = 0; m < monitors.size(); ++m, y += kHistoryLine) {
    canvas.line(x, y, x + kHistorySample, y, 1.2, distinct_colour(m));
    canvas.text(x + kHistorySample + 4.0, y, canvas.fitted(monitors[m].name, room, style), style);
  }
}

}  // namespace

void plot_history(const std::filesystem::path& run_folder, const std::vector<std::string>& names,
                  const std::filesystem::path& file) {
  const PictureFormat format = format_or_error(file);
  const RunReader run(run_folder);
  std::vector<StoredMonitor> monitors = chosen(run, names, run_folder);
  shorten_names(monitors, run.monitors());
  const std::vector<Panel> panels = panels_of(monitors);
  Range time;
  for (const StoredMonitor& m : monitors) time.add(m.time);
  if (time.empty()) throw FileError(run_folder, "has no history yet");
  if (!(time.low < time.high)) time.widen(0.0);

  // Margins come from the widths of what stands in them, so nothing overlaps.
  const Canvas ruler(kHistoryWidth, 10.0, 64);
  double numbers = 0.0, widest_name = 0.0;
  for (const Panel& p : panels) numbers = std::max(numbers, widest(ruler, p.ticks));
  for (const StoredMonitor& m : monitors) widest_name = std::max(widest_name, ruler.text_width(m.name, kTickText));
  widest_name = std::min(widest_name + 1.0, kWidestNames);
  const double left = 8.0 + 22.0 + numbers, right = kHistoryGap + kHistorySample + 4.0 + widest_name + 8.0;
  const auto count = static_cast<double>(panels.size());
  const double legend = kHistoryLine * static_cast<double>(monitors.size());
  const double height = std::max(kHistoryPanel, (legend - (count - 1.0) * kHistoryBetween) / count);

  PlotArea area{left, kHistoryTop, kHistoryWidth - left - right, height, time.low, time.high, 0.0, 1.0, numbers};
  const Canvas canvas(kHistoryWidth, kHistoryTop + count * height + (count - 1.0) * kHistoryBetween + kHistoryBottom,
                      kHistoryPixels, format);
  TextStyle title{10.5};
  title.bold = true;
  canvas.text(left, kHistoryTop - 33.0, canvas.fitted(run.title(), kHistoryWidth - left - 8.0, title), title);
  canvas.text(left, kHistoryTop - 20.0, "Histories of the monitors", {8.5});
  draw_legend(canvas, left + area.w + kHistoryGap, kHistoryTop + 0.5 * kHistoryLine, widest_name, monitors);
  const Ticks seconds = round_ticks(time.low, time.high, 7);
  const std::vector<StoredStage> stages = run.stages();
  for (std::size_t i = 0; i < panels.size(); ++i, area.y += height + kHistoryBetween) {
    area.y0 = panels[i].low, area.y1 = panels[i].high;
    draw_axes(canvas, area, seconds, panels[i].ticks, i + 1 == panels.size() ? "time [s]" : "", panels[i].label, true);
    draw_stages(canvas, area, stages, i == 0);
    const Clip clip(canvas, area);
    cairo_set_line_width(canvas.get(), 1.1);
    for (std::size_t m = 0; m < monitors.size(); ++m) {
      canvas.ink(distinct_colour(m));
      draw_curve(canvas, area, monitors[m].time, panels[i].value[m]);
    }
  }
  canvas.save(file);
}

}  // namespace scree::io
