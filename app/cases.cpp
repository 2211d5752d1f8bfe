#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "app/commands.h"
#include "app/verify.h"
#include "io/case/case_error.h"
#include "io/case/read_case.h"
#include "io/case/schema.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const fs::path& library) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(library))
    if (fs::exists(entry.path() / "case.toml")) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

io::Case read(const fs::path& folder) {
  std::vector<std::string> methods;
  for (const auto& [name, factory] : coupling::standard_methods()) methods.push_back(name);
  return io::read_case(folder / "case.toml", {}, methods);
}

/// Prints a row a quantity; returns how many failed.
int verify_case(const fs::path& folder, bool full) {
  const std::string name = folder.filename().string();
  const io::Case c = read(folder);
  const std::vector<Quantity> expected = read_expected(folder / "expected.toml");
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(c.model, c.plan, methods);
  HandOverWatch watch;
  run.add_sink(watch);
  const auto start = std::chrono::steady_clock::now();
  const coupling::RunEnd end = run.run();
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  int failed = 0;
  fmt::print("{} ({:.1f} s, state {:016x})\n", name, wall, coupling::state_hash(run.state()));
  if (end.status != coupling::RunEnd::Status::done) {
    fmt::print("  {:<52} {}\n", "the run did not end", end.reason);
    return 1;
  }
  for (const Quantity& q : expected) {
    if (q.full && !full) continue;
    const double found = measure(q, c.model, run, watch);
    const bool pass = found >= q.low && found <= q.high;
    failed += pass ? 0 : 1;
    fmt::print("  {:<52} found {:<12.6g} wanted {:<16} {}\n", q.name, found, q.wanted, pass ? "pass" : "FAIL");
  }
  return failed;
}

}  // namespace

fs::path case_library() {
  if (const char* named = std::getenv("SCREE_CASES")) return named;
  if (fs::exists("cases")) return "cases";
  return SCREE_SOURCE_CASES;
}

int cases_list() {
  const fs::path library = case_library();
  for (const std::string& name : names_in(library)) fmt::print("{:<20} {}\n", name, read(library / name).model.title);
  return kDone;
}

int cases_verify(const std::vector<std::string>& wanted, bool full, int threads) {
  if (threads > 0) omp_set_num_threads(threads);
  const fs::path library = case_library();
  const std::vector<std::string> known = names_in(library);
  const std::vector<std::string> names = wanted.empty() ? known : wanted;
  int failed = 0;
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      fmt::print(stderr, "error: there is no case '{}' in {}; there are: {}\n", name, library.string(),
                 fmt::join(known, ", "));
      return kUsage;
    }
    failed += verify_case(library / name, full);
  }
  fmt::print("{} cases, {} quantities failed\n", names.size(), failed);
  return failed == 0 ? kDone : kFailed;
}

int schema(bool markdown) {
  fmt::print("{}", markdown ? io::schema_markdown() : io::schema_text());
  return kDone;
}

}  // namespace scree::app
