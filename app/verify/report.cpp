#include "app/verify/report.h"

#include <fmt/format.h>

#include <fstream>
#include <system_error>

#include "app/verify/report_json.h"
#include "io/results/file_error.h"
#include "io/text/printable.h"

namespace scree::app {
namespace {

std::string found(const Row& r) { return r.trouble.empty() ? fmt::format("{:.6g}", r.found) : "-"; }
const char* verdict(const Row& r) { return r.skipped ? "skipped" : r.pass ? "pass" : "FAIL"; }

std::string picture(const CaseReport& report, std::size_t i) { return fmt::format("{}-{}.png", report.name, i + 1); }

std::string escaped_html(const std::string& text) {
  std::string out;
  for (const char c : io::printable(text)) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string escaped_markdown(const std::string& text) {
  std::string out;
  for (const char c : io::printable(text)) {
    if (c == '|' || c == '<' || c == '\\') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

std::string quoted_csv(const std::string& text) {
  std::string out = "\"";
  for (const char c : io::printable(text)) {
    if (c == '"') out += '"';
    out += c == '\n' ? ' ' : c;
  }
  return out + '"';
}

int skipped(const std::vector<CaseReport>& reports) {
  int rows = 0;
  for (const CaseReport& r : reports) rows += r.skipped();
  return rows;
}

int failures(const std::vector<CaseReport>& reports) {
  int failed = 0;
  for (const CaseReport& r : reports) failed += r.failed();
  return failed;
}

std::string summary(const std::vector<CaseReport>& reports) {
  std::size_t rows = 0;
  for (const CaseReport& r : reports) rows += r.rows.size();
  const int passed_over = skipped(reports);
  return fmt::format("{} cases, {} quantities, {} failed{}", reports.size(), rows, failures(reports),
                     passed_over > 0 ? fmt::format(", {} skipped", passed_over) : "");
}

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw io::FileError(file, "cannot be written");
}

constexpr const char* kStyle =
    "body{font:15px/1.45 sans-serif;max-width:70em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse;width:100%;margin:.6em 0}"
    "td,th{border-bottom:1px solid #ddd;padding:.3em .6em;text-align:left;vertical-align:top}"
    "td.n{font-variant-numeric:tabular-nums;white-space:nowrap}.pass{color:#18702c}.fail{color:#b01515;font-weight:"
    "bold}"
    "small{color:#666}img{max-width:100%}";

}  // namespace

std::string terminal_text(const CaseReport& report) {
  std::string text = fmt::format("{} ({:.1f} s)  {}\n", report.name, report.wall, report.title);
  for (const std::string& note : report.notes) text += fmt::format("  . {}\n", note);
  for (const Row& r : report.rows) {
    text += fmt::format("  {:<58} found {:<12} wanted {:<24} {}\n", r.name, found(r), r.wanted, verdict(r));
    if (!r.trouble.empty()) text += fmt::format("    {}\n", r.trouble);
  }
  return text;
}

std::string markdown_report(const std::vector<CaseReport>& reports, bool pictures) {
  std::string text = fmt::format("# Verified cases\n\n{}.\n", summary(reports));
  for (const CaseReport& report : reports) {
    text += fmt::format("\n## {}\n\n{}\n\n| quantity | wanted | found | | why |\n|---|---|---|---|---|\n", report.name,
                        escaped_markdown(report.title));
    for (const Row& r : report.rows)
      text += fmt::format("| {} | {} | {} | {} | {} |\n", escaped_markdown(r.name), escaped_markdown(r.wanted),
                          r.trouble.empty() ? found(r) : escaped_markdown(r.trouble), verdict(r),
                          escaped_markdown(r.reason));
    if (!report.notes.empty()) text += '\n';
    for (const std::string& note : report.notes) text += fmt::format("- {}\n", escaped_markdown(note));
    for (std::size_t i = 0; pictures && i < report.plots.size(); ++i)
      text += fmt::format("\n![{}]({})\n", escaped_markdown(report.plots[i].title), picture(report, i));
  }
  return text;
}

std::string html_report(const std::vector<CaseReport>& reports, bool pictures) {
  std::string text = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Verified cases</title>"
      "<style>{}</style></head>\n<body><h1>Verified cases</h1>\n<p>{}.</p>\n",
      kStyle, summary(reports));
  for (const CaseReport& report : reports) {
    text += fmt::format(
        "<h2 "
        "id=\"{0}\">{0}</h2>\n<p>{1}</p>\n<table><tr><th>quantity</th><th>wanted</th><th>found</th><th></th></tr>\n",
        escaped_html(report.name), escaped_html(report.title));
    for (const Row& r : report.rows)
      text += fmt::format(
          "<tr><td>{}<br><small>{}</small></td><td class=\"n\">{}</td><td class=\"n\">{}</td>"
          "<td class=\"{}\">{}</td></tr>\n",
          escaped_html(r.name), escaped_html(r.reason), escaped_html(r.wanted),
          r.trouble.empty() ? found(r) : escaped_html(r.trouble), r.pass || r.skipped ? "pass" : "fail", verdict(r));
    text += "</table>\n";
    for (const std::string& note : report.notes) text += fmt::format("<small>{}</small><br>\n", escaped_html(note));
    for (std::size_t i = 0; pictures && i < report.plots.size(); ++i)
      text +=
          fmt::format("<p><img src=\"{}\" alt=\"{}\"></p>\n", picture(report, i), escaped_html(report.plots[i].title));
  }
  return text + "</body></html>\n";
}

std::string csv_report(const std::vector<CaseReport>& reports) {
  std::string text = "case,quantity,wanted,found,verdict\n";
  for (const CaseReport& report : reports)
    for (const Row& r : report.rows)
      text += fmt::format("{},{},{},{},{}\n", report.name, quoted_csv(r.name), quoted_csv(r.wanted),
                          r.trouble.empty() ? found(r) : "", verdict(r));
  return text;
}

void write_table(const std::vector<CaseReport>& reports, const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  if (ending == ".md")
    write(file, markdown_report(reports, false));
  else if (ending == ".html")
    write(file, html_report(reports, false));
  else if (ending == ".csv")
    write(file, csv_report(reports));
  else if (ending == ".json")
    write(file, json_report(reports));
  else
    throw io::FileError(file, "is no name of a table: .md, .html, .csv or .json");
}

void write_report(const std::vector<CaseReport>& reports, const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault) throw io::FileError(folder, "cannot be made: " + fault.message());
  for (const CaseReport& report : reports)
    for (std::size_t i = 0; i < report.plots.size(); ++i)
      io::draw_line_plot(report.plots[i], folder / picture(report, i));
  write(folder / "cases.md", markdown_report(reports, true));
  write(folder / "cases.html", html_report(reports, true));
}

}  // namespace scree::app
