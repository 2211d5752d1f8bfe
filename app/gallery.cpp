#include "io/report/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/built_from.h"
#include "app/commands.h"
#include "app/output.h"
#include "io/case/text_file.h"
#include "io/report/report.h"
#include "io/results/atomic_file.h"
#include "io/results/run_reader.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;

/// An entry of the gallery: a stored run, or a run that is made first.
struct Entry {
  std::string name;
  fs::path case_file;  // empty: the run exists
  fs::path run;        // folder
};

/// Cases of the library that consist of one run; the others are studies of many.
std::vector<std::string> cases_with_runs() {
  std::vector<std::string> names = case_names();
  std::erase_if(names, [](const std::string& name) { return !fs::exists(case_library() / name / "case.toml"); });
  return names;
}

/// Whether the run is done, by this very program and with this case, so that it need not be made again.
bool is_done(const Entry& entry) {
  if (!fs::exists(entry.run / "summary.json")) return false;
  try {
    const io::RunReader run(entry.run);
    const std::vector<std::string> text = run.provenance_list("case");
    return run.provenance("status") == "done" && run.provenance("version") == SCREE_VERSION &&
           run.provenance("commit") == built_from() && !text.empty() &&
           text.front() == io::read_text_file(entry.case_file, "case file", text.front().size() + 1);
  } catch (const std::exception&) {  // damaged, or the case is another one
    return false;
  }
}

std::string unique_name(const std::string& name, const std::vector<Entry>& entries) {
  std::string out = name;
  for (int n = 2; std::any_of(entries.begin(), entries.end(), [&](const Entry& e) { return e.name == out; }); ++n)
    out = fmt::format("{}-{}", name, n);
  return out;
}

}  // namespace

int gallery(const GalleryCommand& command) {
  std::vector<Entry> entries;
  const std::vector<std::string> known = cases_with_runs();
  for (const std::string& source : command.sources.empty() ? known : command.sources) {
    const fs::path path = fs::absolute(source).lexically_normal();
    if (std::find(known.begin(), known.end(), source) != known.end() && !fs::is_directory(source)) {
      entries.push_back({unique_name(source, entries), case_library() / source / "case.toml", {}});
    } else if (fs::is_directory(path)) {
      const std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
      entries.push_back({unique_name(name, entries), {}, path});
    } else {
      complain("error: '{}' is neither a run folder nor a case of the library that is one run\n  allowed: {}\n", source,
               fmt::join(known, ", "));
      return kUsage;
    }
  }
  fs::create_directories(command.out / "runs");
  std::vector<io::GalleryCard> cards;
  int failed = 0;
  for (Entry& e : entries) {
    io::GalleryCard card;
    try {
      if (!e.case_file.empty()) {
        e.run = command.out / "runs" / e.name;
        if (!is_done(e)) {
          say("{}: runs\n", e.name);
          RunOptions options;
          options.case_file = e.case_file;
          options.out = e.run;
          options.overwrite = options.quiet = true;
          options.threads = command.threads;
          options.command_line = fmt::format("scree gallery {}", e.name);
          if (run(options) == kInterrupted) return kInterrupted;
        }
      }
      card = io::gallery_card(e.run, command.out / (e.name + ".png"), e.name + ".html");
      io::write_report(e.run, {command.megabytes, SCREE_VERSION}, command.out / (e.name + ".html"));
    } catch (const std::exception& error) {
      card = {};
      card.trouble = error.what();
      complain("error: {}: {}\n", e.name, error.what());
      ++failed;
    }
    card.name = e.name;
    cards.push_back(std::move(card));
    io::write_atomically(command.out / "index.html", io::gallery_page(cards, SCREE_VERSION));
  }
  say("{}\n{} runs\n", (command.out / "index.html").string(), cards.size());
  return failed == 0 ? kDone : kFailed;
}

}  // namespace scree::app
