#include "app/sweep/sweep_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <system_error>

#include "io/results/file_error.h"

namespace scree::app {
namespace {

constexpr std::size_t kMostCurves = 12;

std::size_t distinct(const std::vector<double>& values) {
  return std::set<double>(values.begin(), values.end()).size();
}

/// The parameters that vary, the one with most values first; none where one of them is no number.
std::vector<const ParameterColumn*> varying(const ResultTable& table) {
  std::vector<const ParameterColumn*> out;
  for (const ParameterColumn& p : table.parameters) {
    if (!p.is_number()) {
      if (std::set<std::string>(p.texts.begin(), p.texts.end()).size() > 1) return {};
    } else if (distinct(p.numbers) > 1) {
      out.push_back(&p);
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const ParameterColumn* a, const ParameterColumn* b) {
    return distinct(a->numbers) > distinct(b->numbers);
  });
  return out;
}

std::string label(const std::string& name, const std::string& units) {
  return units.empty() || units == "1" ? name : name + " [" + units + "]";
}

/// The curves of a result, by value of the second parameter; one without a name where there is none.
std::vector<io::PlotSeries> curves(const ResultTable& table, const ResultColumn& result,
                                   const std::vector<const ParameterColumn*>& over) {
  std::map<double, std::vector<std::pair<double, double>>> points;
  for (std::size_t i = 0; i < table.runs(); ++i)
    if (table.outcomes[i].state == RunOutcome::State::done && std::isfinite(result.values[i]))
      points[over.size() > 1 ? over[1]->numbers[i] : 0.0].emplace_back(over[0]->numbers[i], result.values[i]);
  std::vector<io::PlotSeries> out;
  for (auto& [second, pairs] : points) {
    std::sort(pairs.begin(), pairs.end());
    io::PlotSeries& series = out.emplace_back();
    series.name = over.size() > 1 ? fmt::format("{:g}", second) : "runs";
    series.points = over.size() == 1;
    for (const auto& [x, y] : pairs) series.x.push_back(x), series.y.push_back(y);
  }
  return out;
}

bool differs(const std::vector<io::PlotSeries>& series) {
  std::set<double> values;
  for (const io::PlotSeries& s : series) values.insert(s.y.begin(), s.y.end());
  return values.size() > 1;
}

std::string file_name(std::string name) {
  for (char& c : name)
    if (c == '/' || c == '\\' || c == ' ') c = '_';
  return name + ".svg";
}

}  // namespace

std::vector<NamedPlot> sweep_plots(const ResultTable& table) {
  const std::vector<const ParameterColumn*> over = varying(table);
  if (over.empty() || over.size() > 2 || (over.size() == 2 && distinct(over[1]->numbers) > kMostCurves)) return {};
  std::vector<NamedPlot> plots;
  for (const ResultColumn& result : table.results) {
    std::vector<io::PlotSeries> series = curves(table, result, over);
    if (!differs(series)) continue;
    std::string title = result.meaning;
    if (over.size() == 2) title += ", by " + label(over[1]->key, over[1]->units);
    plots.push_back(
        {result.name,
         {title, label(over[0]->key, over[0]->units), label(result.name, result.units), std::move(series)}});
  }
  return plots;
}

std::size_t draw_sweep_plots(const ResultTable& table, const std::filesystem::path& folder) {
  const std::vector<NamedPlot> plots = sweep_plots(table);
  if (plots.empty()) return 0;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw io::FileError(folder, "cannot make the folder: " + error.message());
  for (const NamedPlot& p : plots) io::draw_line_plot(p.plot, folder / file_name(p.name));
  return plots.size();
}

}  // namespace scree::app
