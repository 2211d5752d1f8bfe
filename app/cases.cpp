#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cstdlib>

#include "app/commands.h"
#include "app/output.h"
#include "app/verify/report.h"
#include "app/verify_jobs.h"
#include "io/case/schema.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& library) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(library))
    if (fs::exists(entry.path() / "expected.toml")) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

fs::path case_library() {
  if (const char* named = std::getenv("SCREE_CASES")) return named;
  if (fs::exists("cases")) return "cases";
  std::error_code none;
  const fs::path program = fs::read_symlink("/proc/self/exe", none);
  const fs::path installed = program.parent_path().parent_path() / "share/scree/cases";
  return !none && fs::exists(installed) ? installed : fs::path(SCREE_SOURCE_CASES);
}

std::vector<std::string> case_names() {
  std::error_code none;
  const fs::path library = case_library();
  return fs::is_directory(library, none) ? names_in(library) : std::vector<std::string>();
}

int cases_list() {
  const fs::path library = case_library();
  for (const std::string& name : names_in(library)) say("{:<20} {}\n", name, case_title(library / name));
  return kDone;
}

int cases_verify(const VerifyCommand& command) {
  if (command.threads > 0) omp_set_num_threads(command.threads);
  const fs::path library = case_library();
  const std::vector<std::string> known = names_in(library);
  const std::vector<std::string> names = command.names.empty() ? known : command.names;
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      complain("error: there is no case '{}' in {}; there are: {}\n", name, library.string(), fmt::join(known, ", "));
      return kUsage;
    }
  std::vector<CaseReport> reports;
  int failed = 0, skipped = 0;
  const auto see = [&](const CaseReport& report) {
    failed += report.failed();
    skipped += report.skipped();
    say("{}", terminal_text(report));
  };
  if (command.jobs > 1) {
    auto all = evaluate_in_processes(command, names, library, see);
    if (!all) return kInterrupted;
    reports = std::move(*all);
  } else {
    for (const std::string& name : names) {
      reports.push_back(evaluate_case(library / name, command.tier));
      see(reports.back());
    }
  }
  say("{} cases, {} quantities failed{}\n", names.size(), failed,
      skipped > 0 ? fmt::format(", {} skipped", skipped) : "");
  if (!command.table.empty()) write_table(reports, command.table);
  if (!command.report.empty()) write_report(reports, command.report);
  return failed == 0 ? kDone : kFailed;
}

int schema(bool markdown) {
  say("{}", markdown ? io::schema_markdown() : io::schema_text());
  return kDone;
}

}  // namespace scree::app
