#include "app/sweep/run_results.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/results/file_error.h"
#include "io/results/run_reader.h"

namespace scree::app {
namespace {

using Json = nlohmann::json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Json summary_of(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "summary.json";
  std::ifstream in(file, std::ios::binary);
  if (!in.is_open()) throw io::FileError(file, "cannot read the summary of the run");
  Json json = Json::parse(in, nullptr, false);
  if (!json.is_object()) throw io::FileError(file, "the summary of the run is damaged");
  return json;
}

/// A number below some keys; none where it is missing or was not finite (null).
double number(const Json& json, const std::vector<std::string>& keys) {
  const Json* at = &json;
  for (const std::string& key : keys) {
    if (!at->is_object() || !at->contains(key)) return kNone;
    at = &at->at(key);
  }
  return at->is_number() ? at->get<double>() : kNone;
}

void add_summary(const Json& s, RunResults& out) {
  const auto add = [&](const char* name, const char* units, const char* meaning, const std::vector<std::string>& keys) {
    out.numbers.push_back({name, units, meaning, number(s, keys)});
  };
  add("final_time", "s", "simulated time at the end of the run", {"final_time"});
  add("steps", "1", "steps made", {"steps"});
  add("cuts", "1", "steps that were cut", {"cuts"});
  add("contacts", "1", "closed contact points at the end", {"contacts"});
  add("kinetic", "J", "kinetic energy at the end", {"ledger", "columns", "energy", "kinetic"});
  add("friction_work", "J", "energy dissipated by friction", {"ledger", "columns", "dissipated", "friction"});
  add("energy_moved", "J", "energy moved between the columns of the ledger", {"ledger", "moved"});
  add("relative_closure", "1", "what the ledger leaves over, of the energy moved", {"ledger", "relative_closure"});
  add("passed_closure", "1", "what the ledger leaves over, of the energy passed", {"ledger", "passed_closure"});
  add("gain", "J", "energy held beyond what was given", {"ledger", "gain"});
  add("friction_worst_ratio", "1", "impulse of friction over that of its limit, at worst", {"friction", "worst_ratio"});
}

void add_blocks(const Json& s, const std::vector<std::string>& wanted, RunResults& out) {
  double largest = kNone;
  std::vector<double> displacement(wanted.size(), kNone);
  for (const Json& block : s.value("blocks", Json::array())) {
    const double moved = number(block, {"displacement"});
    const std::string name = block.value("name", "");
    if (!(moved <= largest) && std::isfinite(moved)) largest = moved, out.farthest_block = name;
    for (std::size_t b = 0; b < wanted.size(); ++b)
      if (wanted[b] == name) displacement[b] = moved;
  }
  out.numbers.push_back({"largest_displacement", "m", "mean displacement of the block that went farthest", largest});
  for (std::size_t b = 0; b < wanted.size(); ++b)
    out.numbers.push_back(
        {"displacement." + wanted[b], "m", "mean displacement of block " + wanted[b], displacement[b]});
  for (const Json& stage : s.value("stages", Json::array())) {
    const std::string name = stage.value("name", "");
    out.numbers.push_back({"stage." + name + ".farthest_displacement", "m",
                           "displacement in stage " + name + " of the block that went farthest in it",
                           number(stage, {"farthest_displacement"})});
  }
}

double last(const std::vector<double>& pairs, std::size_t which) {
  return pairs.size() < 2 ? kNone : pairs[pairs.size() - 2 + which];
}

/// Largest magnitude of a history, and its sample; none where there are no samples.
std::pair<double, std::size_t> peak(const std::vector<double>& pairs) {
  std::pair<double, std::size_t> best{kNone, 0};
  for (std::size_t i = 0; 2 * i + 1 < pairs.size(); ++i)
    if (const double size = std::hypot(pairs[2 * i], pairs[2 * i + 1]); std::isfinite(size) && !(size <= best.first))
      best = {size, i};
  return best;
}

void add_monitors(const std::filesystem::path& folder, RunResults& out) {
  std::vector<io::StoredMonitor> monitors;
  try {
    monitors = io::RunReader(folder).monitors();
  } catch (const io::FileError&) {
    return;  // a run that ended before its results: the table has empty fields
  }
  for (const io::StoredMonitor& m : monitors) {
    const auto add = [&](const char* what, const char* units, const char* meaning, double value) {
      out.numbers.push_back({m.name + what, units, std::string(meaning) + " of monitor " + m.name, value});
    };
    const double ux = last(m.displacement, 0), uy = last(m.displacement, 1);
    const auto [u_peak, u_sample] = peak(m.displacement);
    const auto [v_peak, v_sample] = peak(m.velocity);
    add(".ux", "m", "last displacement along x", ux);
    add(".uy", "m", "last displacement along y", uy);
    add(".u", "m", "size of the last displacement", std::hypot(ux, uy));
    add(".u_peak", "m", "size of the largest displacement", u_peak);
    add(".v", "m/s", "last speed", std::hypot(last(m.velocity, 0), last(m.velocity, 1)));
    add(".v_peak", "m/s", "largest speed", v_peak);
    add(".v_peak_time", "s", "time of the largest speed", v_sample < m.time.size() ? m.time[v_sample] : kNone);
  }
}

}  // namespace

RunResults run_results(const std::filesystem::path& folder, const std::vector<std::string>& blocks) {
  const Json summary = summary_of(folder);
  RunResults out;
  out.state_hash = summary.value("state_hash", "");
  add_summary(summary, out);
  add_blocks(summary, blocks, out);
  add_monitors(folder, out);
  return out;
}

RunCosts run_costs(const std::filesystem::path& folder) {
  const Json s = summary_of(folder);
  const double threads = number(s, {"threads"});
  return {number(s, {"wall_seconds", "total"}), number(s, {"cpu_seconds"}), number(s, {"peak_memory_bytes"}),
          std::isfinite(threads) ? static_cast<int>(threads) : 0};
}

}  // namespace scree::app
