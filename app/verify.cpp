#include "app/verify.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "io/case/case_error.h"

namespace scree::app {
namespace {

constexpr const char* kMeasures =
    "blocks_moved_above, blocks_moved_below, monitor_displacement, kinetic_at_handover, ledger_closure, scheme_share, "
    "transfer_momentum_error, transfer_energy_error, drift_in_stage";

io::CaseError error(const std::filesystem::path& file, const toml::source_region& at, std::string problem,
                    std::string allowed) {
  return {file.string(),
          {static_cast<int>(at.begin.line), static_cast<int>(at.begin.column)},
          {.problem = std::move(problem), .allowed = std::move(allowed)}};
}

double moved(const Model& model, const coupling::Driver& run, std::size_t block) {
  const coupling::Body& b = run.setup().bodies()[block];
  const auto p = static_cast<std::size_t>(b.pool);
  const Vec2 now = run.setup()
                       .pool_of(b)
                       .totals(b.index, run.setup().part(std::span<const double>(run.state().q), p),
                               run.setup().part(std::span<const double>(run.state().v), p))
                       .centre;
  return (now - moments(model.blocks[block].polygon).centroid).norm();
}

}  // namespace

std::vector<Quantity> read_expected(const std::filesystem::path& file) {
  toml::table document;
  try {
    document = toml::parse_file(file.string());
  } catch (const toml::parse_error& e) {
    throw error(file, e.source(), std::string(e.description()), "TOML");
  }
  std::vector<Quantity> out;
  const toml::array* list = document["quantity"].as_array();
  if (list == nullptr || list->empty())
    throw error(file, document.source(), "no [[quantity]]", "at least one [[quantity]]");
  for (const toml::node& node : *list) {
    const toml::table* t = node.as_table();
    if (t == nullptr) throw error(file, node.source(), "quantity is not a table", "[[quantity]]");
    Quantity q;
    q.name = (*t)["name"].value_or(std::string());
    q.measure = (*t)["measure"].value_or(std::string());
    q.reason = (*t)["reason"].value_or(std::string());
    q.full = (*t)["tier"].value_or(std::string("quick")) == "full";
    if (const auto number = (*t)["of"].value<double>()) q.of = *number;
    if (const auto text = (*t)["of"].value<std::string>()) q.text = *text;
    if (q.name.empty() || q.reason.empty() ||
        fmt::format(" {},", kMeasures).find(" " + q.measure + ",") == std::string::npos)
      throw error(file, t->source(), fmt::format("name, reason or measure '{}' is missing or unknown", q.measure),
                  kMeasures);
    const double inf = std::numeric_limits<double>::infinity();
    const auto least = (*t)["at_least"].value<double>(), most = (*t)["at_most"].value<double>(),
               reference = (*t)["reference"].value<double>();
    q.low = least.value_or(-inf);
    q.high = most.value_or(inf);
    if (least) q.wanted = fmt::format(">= {:g}", *least);
    if (most) q.wanted += fmt::format("{}<= {:g}", q.wanted.empty() ? "" : ", ", *most);
    if (reference) {
      const double tolerance = (*t)["tolerance"].value_or(0.0) * std::abs(*reference);
      q.low = *reference - tolerance;
      q.high = *reference + tolerance;
      q.wanted = fmt::format("{:g} +- {:g}", *reference, tolerance);
    }
    if (q.wanted.empty())
      throw error(file, t->source(), "quantity '" + q.name + "' has no bound",
                  "at_least, at_most, or reference with tolerance");
    out.push_back(std::move(q));
  }
  return out;
}

void HandOverWatch::event(const coupling::Event& e) {
  if (e.transfer == nullptr) return;
  if (e.time != time_) kinetic_ = 0.0;  // the latest hand-over counts
  time_ = e.time;
  kinetic_ += e.transfer->after.kinetic;
}

double measure(const Quantity& q, const Model& model, const coupling::Driver& run, const HandOverWatch& watch) {
  const coupling::Ledger& ledger = run.state().ledger;
  if (q.measure == "blocks_moved_above" || q.measure == "blocks_moved_below") {
    int count = 0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
      if (run.setup().bodies()[i].driven) continue;
      const double d = moved(model, run, i);
      count += (q.measure == "blocks_moved_above" ? d > q.of : d < q.of) ? 1 : 0;
    }
    return count;
  }
  if (q.measure == "monitor_displacement") {
    coupling::Observer observer(run.setup(), run.state(), 0);
    const coupling::HistoryView h = observer.history(run.state(), run.stats());
    for (std::size_t i = 0; i < model.monitors.size(); ++i)
      if (model.monitors[i].name == q.text) return std::hypot(h.displacement[2 * i], h.displacement[2 * i + 1]);
    throw std::runtime_error("expected.toml: no monitor '" + q.text + "'");
  }
  if (q.measure == "drift_in_stage") {
    for (const coupling::StageTravel& t : run.travels())
      if (t.stage == q.text) return t.farthest;
    throw std::runtime_error("expected.toml: no stage '" + q.text + "'");
  }
  if (q.measure == "kinetic_at_handover") return watch.kinetic();
  if (q.measure == "ledger_closure") return ledger.relative_closure();
  if (q.measure == "scheme_share") {
    double worst = 0.0;
    for (int i = 0; i < coupling::kColumns; ++i) {
      const auto column = static_cast<coupling::Column>(i);
      if (info(column).side == coupling::Side::scheme) worst = std::max(worst, std::abs(ledger[column]));
    }
    return worst / ledger.moved();
  }
  double worst = 0.0;
  if (q.measure == "transfer_energy_error") {
    // Of a whole hand-over: a block that hardly carries any energy has nothing but round-off of its positions to show.
    std::map<double, std::pair<double, double>> handed;  // time: errors and energies summed [J]
    for (const coupling::TransferRow& row : run.transfers()) {
      const double energy = row.before.kinetic + row.before.elastic;
      handed[row.time].first += row.energy_error * energy;
      handed[row.time].second += energy;
    }
    for (const auto& [time, sums] : handed)
      if (sums.second > 0.0) worst = std::max(worst, sums.first / sums.second);
    return worst;
  }
  for (const coupling::TransferRow& row : run.transfers())
    worst = std::max({worst, row.mass_error, row.momentum_error, row.angular_error});
  return worst;
}

}  // namespace scree::app
