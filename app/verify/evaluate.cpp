#include "app/verify/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include "app/studies/studies.h"
#include "app/verify/measures.h"
#include "io/case/read_case.h"
#include "io/case/suggest.h"

namespace scree::app {
namespace {

io::Case read(const std::filesystem::path& file, const std::vector<std::string>& set) {
  std::vector<std::string> methods;
  for (const coupling::Method& m : coupling::registered_methods()) methods.push_back(m.name);
  return io::read_case(file, set, methods);
}

std::vector<const Quantity*> wanted_quantities(const Expected& expected, Tier tier) {
  std::vector<const Quantity*> wanted;
  for (const Quantity& q : expected.quantities)
    if (q.tier <= tier) wanted.push_back(&q);
  return wanted;
}

Row row_of(const Quantity& q, double found) {
  return {q.name, q.reason, q.wanted(), found, found >= q.low && found <= q.high, {}, false};
}

Row failed_row(const Quantity& q, std::string trouble) {
  return {q.name, q.reason, q.wanted(), 0.0, false, std::move(trouble), false};
}

/// The environment variable that a quantity lacks; empty: none.
std::string lacked_by(const Quantity& q, const Expected& expected) {
  for (const std::string& name : q.runs())
    if (expected.variant(name).lacking()) return expected.variant(name).needs;
  return {};
}

/// Runs the variants, those with repeats in turns, so that other load on the machine affects all of them alike.
RunRecords run_variants(const std::map<std::string, io::Case>& cases, const Expected& expected) {
  RunRecords runs;
  int rounds = 0;
  for (const auto& [name, c] : cases) rounds = std::max(rounds, expected.variant(name).repeats);
  for (int round = 0; round < rounds; ++round)
    for (const Variant& v : expected.variants) {
      const auto at = cases.find(v.name);
      if (at == cases.end() || round >= v.repeats) continue;
      RunRecord record = record_run(at->second.model, at->second.plan);
      if (round == 0) {
        runs.emplace(v.name, std::move(record));
        continue;
      }
      RunRecord& first = runs.at(v.name);
      first.stepping = std::min(first.stepping, record.stepping);
      first.stepping_implicit = std::min(first.stepping_implicit, record.stepping_implicit);
      first.wall += record.wall;
      first.least_wall = std::min(first.least_wall, record.wall);
      if (record.hash != first.hash && first.done()) {
        first.end.status = coupling::RunEnd::Status::not_converged;
        first.end.reason = fmt::format("repeat {} ended in another state", round + 1);
      }
    }
  return runs;
}

void evaluate_runs(const std::filesystem::path& folder, const Expected& expected, Tier tier, CaseReport& report) {
  const std::vector<const Quantity*> wanted = wanted_quantities(expected, tier);
  std::map<std::string, io::Case> cases;
  for (const Quantity* q : wanted) {
    if (!lacked_by(*q, expected).empty()) continue;
    for (const std::string& name : q->runs()) {
      const Variant& v = expected.variant(name);
      if (cases.count(name) == 0) cases.emplace(name, read(folder / v.case_file, v.set));
      check_names(*q, cases.at(name).model, cases.at(name).plan);
    }
  }
  const RunRecords runs = run_variants(cases, expected);
  for (const Variant& v : expected.variants) {
    const auto at = runs.find(v.name);
    if (at == runs.end()) continue;
    const RunRecord& run = at->second;
    report.notes.push_back(
        run.done() ? fmt::format("{}: {} steps, {:.1f} s, state {:016x}", v.name, run.stats.steps, run.wall, run.hash)
                   : fmt::format("{}: {}", v.name, run.trouble()));
  }
  for (const Quantity* q : wanted) {
    if (const std::string lacked = lacked_by(*q, expected); !lacked.empty()) {
      report.rows.push_back({q->name, q->reason, q->wanted(), 0.0, false, lacked + " is not set", true});
      continue;
    }
    std::string trouble;
    for (const std::string& name : q->runs()) {
      const RunRecord& run = runs.at(name);
      const bool measurable = run.done() || (q->measure == "refused" && !run.refused.empty());
      if (!measurable && trouble.empty()) trouble = fmt::format("{}: {}", name, run.trouble());
    }
    report.rows.push_back(trouble.empty() ? row_of(*q, measure(*q, runs, report.plots)) : failed_row(*q, trouble));
  }
}

void evaluate_study(const Expected& expected, const std::filesystem::path& file, Tier tier, CaseReport& report) {
  const auto study = studies().find(expected.study);
  if (study == studies().end()) {
    std::vector<std::string> known;
    for (const auto& [name, function] : studies()) known.push_back(name);
    throw io::CaseError(file.string(), {},
                        {.problem = fmt::format("unknown study {}", io::in_quotes(expected.study)),
                         .key = "study",
                         .allowed = io::listed(known),
                         .hint = io::did_you_mean(expected.study, known, "")});
  }
  StudyResult result = study->second(tier);
  std::vector<std::string> known;
  for (const auto& [name, number] : result.numbers) known.push_back(name);
  for (const Quantity* q : wanted_quantities(expected, tier)) {
    const auto number = result.numbers.find(q->text("of"));
    if (number == result.numbers.end())
      throw q->error("of", fmt::format("the study gives no number {}", io::in_quotes(q->text("of"))), io::listed(known),
                     io::did_you_mean(q->text("of"), known, ""));
    report.rows.push_back(row_of(*q, number->second));
  }
  report.plots = std::move(result.plots);
  report.notes = std::move(result.notes);
}

}  // namespace

int CaseReport::failed() const {
  return static_cast<int>(std::count_if(rows.begin(), rows.end(), [](const Row& r) { return !r.pass && !r.skipped; }));
}

int CaseReport::skipped() const {
  return static_cast<int>(std::count_if(rows.begin(), rows.end(), [](const Row& r) { return r.skipped; }));
}

std::string case_title(const std::filesystem::path& folder) {
  const Expected expected = read_expected(folder / "expected.toml");
  if (!expected.title.empty() || !expected.study.empty()) return expected.title;
  return read(folder / "case.toml", {}).model.title;
}

CaseReport evaluate_case(const std::filesystem::path& folder, Tier tier) {
  const std::filesystem::path file = folder / "expected.toml";
  const Expected expected = read_expected(file);
  CaseReport report;
  report.name = folder.filename().string();
  report.title = case_title(folder);
  const auto start = std::chrono::steady_clock::now();
  if (expected.study.empty())
    evaluate_runs(folder, expected, tier, report);
  else
    evaluate_study(expected, file, tier, report);
  report.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace scree::app
