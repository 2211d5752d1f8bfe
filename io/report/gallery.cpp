#include "io/report/gallery.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/pictures/snapshot.h"
#include "io/report/chunk.h"
#include "io/report/page.h"
#include "io/results/run_folder.h"
#include "io/results/run_reader.h"

namespace scree::io {
namespace {

using Json = nlohmann::json;

constexpr int kPictureWidth = 640;  // [pixels], twice that of a card for fine screens

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --ground: #f6f6f3; --paper: #fff; --ink: #1e2226; --quiet: #5b636b; --line: #dcdedb;
  --accent: #0b5c8a; --warn: #8f3b00; }
@media (prefers-color-scheme: dark) { :root { --ground: #14171a; --paper: #1c2024; --ink: #e6e8e8; --quiet: #a7b0b7;
  --line: #363c42; --accent: #6cb8e6; --warn: #ffb27a; } }
body { margin: 0; padding: 16px 20px; background: var(--ground); color: var(--ink);
  font: 14px/1.45 system-ui, "DejaVu Sans", sans-serif; font-variant-numeric: tabular-nums; }
h1 { font-size: 22px; margin: 0 0 4px; } h2 { font-size: 15px; margin: 8px 0 2px; }
p { margin: 2px 0; color: var(--quiet); } a { color: var(--accent); }
ul { list-style: none; margin: 14px 0 0; padding: 0; display: grid; gap: 14px;
  grid-template-columns: repeat(auto-fill, minmax(300px, 1fr)); }
li { background: var(--paper); border: 1px solid var(--line); border-radius: 6px; padding: 10px 12px; }
img { display: block; width: 100%; height: 200px; object-fit: contain; background: #fff; border-radius: 4px; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 1px 12px; margin: 6px 0 0; font-size: 13px; }
dt { color: var(--quiet); } dd { margin: 0; overflow-wrap: anywhere; } .trouble { color: var(--warn); }
)";

std::string file_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw FileError(file, "cannot be read");
  return text.str();
}

/// summary.json; no object where there is none that can be read, as in a run that was killed.
Json summary_of(const std::filesystem::path& run_folder) {
  std::ifstream in(RunFolder::open(run_folder).summary(), std::ios::binary);
  return in ? Json::parse(in, nullptr, false) : Json();
}

std::string status_words(const Json& found) {
  const auto status = found.find("status");
  if (!found.is_object() || status == found.end() || !status->is_string()) return "has not ended";
  const auto text = status->get<std::string>();
  const auto reason = found.find("reason");
  return reason != found.end() && reason->is_string() && !reason->get<std::string>().empty()
             ? text + ": " + reason->get<std::string>()
             : text;
}

}  // namespace

GalleryCard gallery_card(const std::filesystem::path& run_folder, const std::filesystem::path& picture,
                         const std::string& link) {
  const RunReader run(run_folder);
  if (run.times().empty()) throw FileError(run_folder, "has no frame yet; there is nothing to show");
  GalleryCard card;
  card.title = run.title();
  card.link = link;
  SnapshotOptions options;
  options.width = kPictureWidth;
  snapshot(run_folder, options, picture);
  const std::string png = file_bytes(picture);
  card.picture = base64({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});

  const Json found = summary_of(run_folder);
  card.facts.emplace_back("Status", status_words(found));
  const auto number = [](const Json& from, const char* key) -> std::optional<double> {
    if (!from.is_object()) return {};
    const auto at = from.find(key);
    return at != from.end() && at->is_number() ? std::optional(at->get<double>()) : std::nullopt;
  };
  const auto inside = [&](const char* key) { return found.is_object() && found.contains(key) ? found[key] : Json(); };
  const auto say = [&](const char* name, const std::optional<double>& value, auto&& text) {
    if (value) card.facts.emplace_back(name, text(*value));
  };
  card.facts.emplace_back("Simulated", fmt::format("{:.4g} s", run.times().back()));
  card.facts.emplace_back("Blocks", fmt::format("{}", run.blocks().size()));
  say("Steps", number(found, "steps"), [](double v) { return fmt::format("{:.0f}", v); });
  say("Ledger closure", number(inside("ledger"), "relative_closure"),
      [](double v) { return fmt::format("{:.1e}", v); });
  say("Wall time", number(inside("wall_seconds"), "total"), [](double v) { return fmt::format("{:.3g} s", v); });
  return card;
}

std::string gallery_page(const std::vector<GalleryCard>& cards, const std::string& version) {
  std::string out = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  out += "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src " +
         policy_hash(kStyle) + "; base-uri 'none'; form-action 'none'\">\n";
  out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>Scree: runs</title>\n";
  out += "<style>" + std::string(kStyle) + "</style>\n</head>\n<body>\n<header>\n<h1>Runs of Scree</h1>\n";
  out += "<p>" + html_text(fmt::format("{} runs, Scree {}. Colours: displacement at the end.", cards.size(), version)) +
         "</p>\n</header>\n<main>\n<ul>\n";
  for (const GalleryCard& c : cards) {
    const std::string title = html_text(c.title.empty() ? c.name : c.title);
    out += "<li>\n";
    if (!c.picture.empty())
      out += "<img src=\"data:image/png;base64," + c.picture + "\" alt=\"The blocks of " + html_text(c.name) +
             " at the end, coloured by displacement\">\n";
    out += "<h2>" + (c.link.empty() ? title : "<a href=\"" + html_text(c.link) + "\">" + title + "</a>") + "</h2>\n";
    out += "<p>" + html_text(c.name) + "</p>\n";
    if (!c.trouble.empty()) out += "<p class=\"trouble\">" + html_text(c.trouble) + "</p>\n";
    if (!c.facts.empty()) {
      out += "<dl>";
      for (const auto& [name, value] : c.facts)
        out += "<dt>" + html_text(name) + "</dt><dd>" + html_text(value) + "</dd>";
      out += "</dl>\n";
    }
    out += "</li>\n";
  }
  out += "</ul>\n</main>\n</body>\n</html>\n";
  return out;
}

}  // namespace scree::io
