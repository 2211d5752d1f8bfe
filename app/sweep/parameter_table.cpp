#include "app/sweep/parameter_table.h"

#include <fmt/format.h>

#include "app/sweep/csv_text.h"
#include "io/case/case_error.h"
#include "io/case/text_file.h"

namespace scree::app {
namespace {

constexpr std::size_t kMostBytes = std::size_t{64} << 20;
constexpr const char* kTableForm = "a row of keys, then one row a run, separated by commas";

[[noreturn]] void fail(const std::string& name, const CsvField& at, std::string problem, std::string allowed,
                       std::string hint) {
  throw io::CaseError(
      name, {at.line, at.column},
      {std::move(problem), "", at.text.empty() ? "" : io::in_quotes(at.text), std::move(allowed), std::move(hint)});
}

}  // namespace

Parameters parameter_table(std::string_view text, const std::string& name) {
  const std::vector<std::vector<CsvField>> records = csv_records(text, name);
  if (records.size() < 2)
    throw io::CaseError(
        name, {1, 1},
        {records.empty() ? "the table is empty" : "the table has keys and no runs", "", "", kTableForm, "add a row"});
  Parameters table;
  for (const CsvField& key : records.front()) {
    if (key.text.empty()) fail(name, key, "a key is missing in the heading", kTableForm, "take the empty column out");
    table.keys.push_back({key.text, {name, key.line, key.column}});
  }
  require_distinct(table.keys);
  if (records.size() - 1 > kMostRuns)
    fail(name, records[kMostRuns + 1].front(), fmt::format("the table has {} runs", records.size() - 1),
         fmt::format("at most {} runs", kMostRuns), "make several sweeps of it");
  for (std::size_t r = 1; r < records.size(); ++r) {
    const std::vector<CsvField>& record = records[r];
    const std::size_t keys = table.keys.size();
    if (record.size() != keys)
      fail(name, record.size() < keys ? record.front() : record[keys],
           fmt::format("the row has {} fields", record.size()), fmt::format("{} fields, as the heading has", keys),
           "put values that hold commas in quotation marks; decimals have a point");
    std::vector<ParameterValue>& run = table.runs.emplace_back();
    for (const CsvField& field : record) {
      if (field.text.empty())
        fail(name, field, "the value is missing", "a value in each field", "write what the case has there");
      run.push_back({toml_of(field.text), {name, field.line, field.column}});
    }
  }
  return table;
}

Parameters read_parameter_table(const std::filesystem::path& file) {
  return parameter_table(io::read_text_file(file, "table of parameters", kMostBytes), file.string());
}

}  // namespace scree::app
