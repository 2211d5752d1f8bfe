#include "app/verify/report_json.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/results/file_error.h"

namespace scree::app {
namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

double number_in(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Json numbers(const std::vector<double>& values) {
  Json out = Json::array();
  for (const double x : values) out.push_back(number(x));
  return out;
}

std::vector<double> numbers_in(const Json& json) {
  std::vector<double> out;
  for (const Json& x : json) out.push_back(number_in(x));
  return out;
}

Json row_json(const Row& r) {
  return {{"name", r.name}, {"reason", r.reason},   {"wanted", r.wanted},  {"found", number(r.found)},
          {"pass", r.pass}, {"trouble", r.trouble}, {"skipped", r.skipped}};
}

Row row_in(const Json& json) {
  return {json.at("name").get<std::string>(),   json.at("reason").get<std::string>(),
          json.at("wanted").get<std::string>(), number_in(json.at("found")),
          json.at("pass").get<bool>(),          json.at("trouble").get<std::string>(),
          json.at("skipped").get<bool>()};
}

Json plot_json(const io::LinePlot& p) {
  Json series = Json::array();
  for (const io::PlotSeries& s : p.series)
    series.push_back(
        {{"name", s.name}, {"x", numbers(s.x)}, {"y", numbers(s.y)}, {"points", s.points}, {"dashed", s.dashed}});
  return {{"title", p.title}, {"x_label", p.x_label}, {"y_label", p.y_label}, {"series", std::move(series)},
          {"log_x", p.log_x}, {"log_y", p.log_y}};
}

io::LinePlot plot_in(const Json& json) {
  io::LinePlot p;
  p.title = json.at("title").get<std::string>();
  p.x_label = json.at("x_label").get<std::string>();
  p.y_label = json.at("y_label").get<std::string>();
  p.log_x = json.at("log_x").get<bool>();
  p.log_y = json.at("log_y").get<bool>();
  for (const Json& s : json.at("series"))
    p.series.push_back({s.at("name").get<std::string>(), numbers_in(s.at("x")), numbers_in(s.at("y")),
                        s.at("points").get<bool>(), s.at("dashed").get<bool>()});
  return p;
}

CaseReport report_in(const Json& json) {
  CaseReport r;
  r.name = json.at("name").get<std::string>();
  r.title = json.at("title").get<std::string>();
  r.notes = json.at("notes").get<std::vector<std::string>>();
  r.wall = json.at("wall").get<double>();
  for (const Json& row : json.at("rows")) r.rows.push_back(row_in(row));
  for (const Json& plot : json.at("plots")) r.plots.push_back(plot_in(plot));
  return r;
}

}  // namespace

std::string json_report(const std::vector<CaseReport>& reports) {
  Json out = Json::array();
  for (const CaseReport& r : reports) {
    Json rows = Json::array(), plots = Json::array();
    for (const Row& row : r.rows) rows.push_back(row_json(row));
    for (const io::LinePlot& plot : r.plots) plots.push_back(plot_json(plot));
    out.push_back({{"name", r.name},
                   {"title", r.title},
                   {"wall", r.wall},
                   {"rows", std::move(rows)},
                   {"notes", r.notes},
                   {"plots", std::move(plots)}});
  }
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<CaseReport> read_json_report(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw io::FileError(file, "cannot be read");
  try {
    std::vector<CaseReport> out;
    for (const Json& report : Json::parse(in)) out.push_back(report_in(report));
    return out;
  } catch (const nlohmann::json::exception& error) {
    throw io::FileError(file, std::string("is no report of verified cases: ") + error.what());
  }
}

}  // namespace scree::app
