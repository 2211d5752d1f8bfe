#include "app/sweep/result_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "app/sweep/csv_text.h"
#include "io/case/document.h"
#include "io/case/schema.h"
#include "io/case/unit.h"
#include "io/results/h5.h"
#include "io/results/h5_series.h"

namespace scree::app {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> parts_of(std::string_view key) {
  std::vector<std::string> parts(1);
  char quote = 0;
  for (const char c : key) {
    if (quote != 0 ? c == quote : c == '"' || c == '\'')
      quote = quote != 0 ? '\0' : c;
    else if (c == '.' && quote == 0)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

/// Parts of a path of the schema as users write them: "block[].polygon" has an item's number or name after "block",
/// "material.NAME.density" any name in place of NAME. An empty part stands for either.
std::vector<std::string> pattern_of(std::string_view path) {
  std::vector<std::string> pattern;
  for (std::string& part : parts_of(path)) {
    if (part == "NAME") {
      pattern.emplace_back();
    } else if (part.ends_with("[]")) {
      pattern.push_back(part.substr(0, part.size() - 2));
      pattern.emplace_back();
    } else {
      pattern.push_back(std::move(part));
    }
  }
  return pattern;
}

/// The number that a value of a key is, in the key's unit.
std::optional<double> number_of(const std::string& toml, const std::string& units) {
  const io::Value value = io::parse_set_value(toml, 1, 1);
  if (const auto* whole = value.as<std::int64_t>()) return static_cast<double>(*whole);
  if (const auto* number = value.as<double>()) return *number;
  const auto* text = value.as<std::string>();
  if (text == nullptr || units.empty()) return std::nullopt;
  const auto converted = io::in_unit(*text, units);
  const double* number = std::get_if<double>(&converted);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

std::string text_of(const std::string& toml) {
  const io::Value value = io::parse_set_value(toml, 1, 1);
  const auto* text = value.as<std::string>();
  return text != nullptr ? *text : toml;
}

std::string headed(const std::string& name, const std::string& units) {
  return csv_field(units.empty() ? name : name + " [" + units + "]");
}

std::string number_text(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }

std::string h5_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

}  // namespace

std::string unit_of_key(std::string_view key) {
  const std::vector<std::string> parts = parts_of(key);
  for (const io::Key& known : io::schema()) {
    const std::vector<std::string> pattern = pattern_of(known.path);
    if (std::equal(pattern.begin(), pattern.end(), parts.begin(), parts.end(),
                   [](const std::string& wanted, const std::string& part) { return wanted.empty() || wanted == part; }))
      return std::string(known.unit);
  }
  return {};
}

std::vector<ParameterColumn> parameter_columns(const Parameters& parameters) {
  std::vector<ParameterColumn> columns;
  for (std::size_t k = 0; k < parameters.keys.size(); ++k) {
    ParameterColumn& column = columns.emplace_back();
    column.key = parameters.keys[k].name;
    column.units = unit_of_key(column.key);
    bool all = true;
    for (const std::vector<ParameterValue>& run : parameters.runs) {
      const std::optional<double> number = number_of(run[k].toml, column.units);
      all = all && number;
      column.numbers.push_back(number.value_or(kNoNumber));
      column.texts.push_back(text_of(run[k].toml));
    }
    if (all) continue;
    column.numbers.clear();
    column.units.clear();
  }
  return columns;
}

ResultTable collect(const SweepFolder& folder, const SweepRecord& record, const std::string& title,
                    const std::vector<std::string>& blocks) {
  ResultTable table{title, record.case_sha256, parameter_columns(record.parameters), {}, {}, {}, {}};
  const std::size_t runs = record.runs();
  for (std::size_t run = 1; run <= runs; ++run) {
    table.outcomes.push_back(run_outcome(folder.run(run), folder.log(run), record.overrides(run), record.case_sha256));
    RunResults found;
    if (table.outcomes.back().ended()) found = run_results(folder.run(run), blocks);
    table.state_hashes.push_back(std::move(found.state_hash));
    table.farthest_blocks.push_back(std::move(found.farthest_block));
    for (Result& result : found.numbers) {
      auto column = std::find_if(table.results.begin(), table.results.end(),
                                 [&](const ResultColumn& c) { return c.name == result.name; });
      if (column == table.results.end())
        column = table.results.insert(
            column, {result.name, result.units, result.meaning, std::vector<double>(runs, kNoNumber)});
      column->values[run - 1] = result.value;
    }
  }
  return table;
}

std::string csv_text(const ResultTable& table) {
  std::string out = "run";
  for (const ParameterColumn& p : table.parameters) out += "," + headed(p.key, p.units);
  out += ",outcome,reason";
  for (const ResultColumn& r : table.results) out += "," + headed(r.name, r.units);
  out += ",farthest_block,state_hash\n";
  for (std::size_t i = 0; i < table.runs(); ++i) {
    out += std::to_string(i + 1);
    for (const ParameterColumn& p : table.parameters)
      out += "," + (p.is_number() ? number_text(p.numbers[i]) : csv_field(p.texts[i]));
    out += "," + csv_field(table.outcomes[i].status) + "," + csv_field(table.outcomes[i].reason);
    for (const ResultColumn& r : table.results) out += "," + number_text(r.values[i]);
    out += "," + csv_field(table.farthest_blocks[i]) + "," + csv_field(table.state_hashes[i]) + "\n";
  }
  return out;
}

void write_h5(const ResultTable& table, const std::filesystem::path& to) {
  namespace h5 = io::h5;
  h5::File file = h5::File::create_beside(to);
  file.attribute("/", "title", table.title);
  file.attribute("/", "case_sha256", table.case_sha256);
  std::vector<std::int64_t> numbers(table.runs());
  std::iota(numbers.begin(), numbers.end(), 1);
  h5::write<std::int64_t>(file, "/run", 1, numbers, {"1", "number of the run, from 1"});
  for (const ParameterColumn& p : table.parameters) {
    const std::string name = "/parameters/" + h5_name(p.key);
    if (p.is_number())
      h5::write<double>(file, name, 1, p.numbers, {p.units.empty() ? "1" : p.units, "parameter " + p.key});
    else
      h5::write(file, name, p.texts, {"none", "parameter " + p.key});
  }
  std::vector<std::string> outcome, reason;
  for (const RunOutcome& o : table.outcomes) outcome.push_back(o.status), reason.push_back(o.reason);
  h5::write(file, "/outcome", outcome, {"none", "how the run ended"});
  h5::write(file, "/reason", reason, {"none", "why it did not end well"});
  for (const ResultColumn& r : table.results)
    h5::write<double>(file, "/results/" + h5_name(r.name), 1, r.values, {r.units, r.meaning});
  h5::write(file, "/farthest_block", table.farthest_blocks, {"none", "block that went farthest"});
  h5::write(file, "/state_hash", table.state_hashes, {"none", "hash of the state at the end"});
  file.sync();
  file.put_in_place();
  file.close();
}

std::string costs_text(const SweepFolder& folder, const ResultTable& table) {
  std::string out = "run,wall [s],cpu [s],peak_memory [bytes],threads\n";
  for (std::size_t i = 0; i < table.runs(); ++i) {
    if (!table.outcomes[i].ended()) continue;
    const RunCosts c = run_costs(folder.run(i + 1));
    out += fmt::format("{},{:.3f},{:.3f},{:.0f},{}\n", i + 1, c.wall_seconds, c.cpu_seconds, c.peak_memory_bytes,
                       c.threads);
  }
  return out;
}

}  // namespace scree::app
