// The rows of verified cases as text for a terminal, as Markdown and as HTML, with pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/verify/evaluate.h"

namespace scree::app {

/// One line per row, below one line per case.
[[nodiscard]] std::string terminal_text(const CaseReport& report);

/// Tables of all cases. @param pictures  with links to CASE-N.svg beside the file
[[nodiscard]] std::string markdown_report(const std::vector<CaseReport>& reports, bool pictures);
[[nodiscard]] std::string html_report(const std::vector<CaseReport>& reports, bool pictures);

/// One line per row: case, quantity, wanted, found, verdict (RFC 4180). Found is empty where there is no number.
[[nodiscard]] std::string csv_report(const std::vector<CaseReport>& reports);

/// Writes one table in the format given by the name's ending: .md, .html, .csv or .json (report_json.h).
/// @throws io::FileError
void write_table(const std::vector<CaseReport>& reports, const std::filesystem::path& file);
/// Writes cases.md, cases.html and the plots as CASE-N.svg into a folder, which is made.   @throws io::FileError
void write_report(const std::vector<CaseReport>& reports, const std::filesystem::path& folder);

}  // namespace scree::app
