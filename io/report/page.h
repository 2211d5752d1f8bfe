// The HTML of a report: one file that needs nothing else. The texts of a run are data and are never executed.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scree::io {

struct PageParts {
  std::string title;
  std::string run;                                          // JSON
  std::vector<std::pair<std::string, std::string>> chunks;  // id of the element, base64
};

/// The page. Its security policy lets only the script and the styles of the viewer run (by their SHA-256) and forbids
/// every request.   @pre ids of chunks are letters, digits and '-'; chunks are base64
[[nodiscard]] std::string report_page(const PageParts& parts);

/// The page as a server sends it: script, styles and data come from the same server (viewer.js, viewer.css, run.json,
/// mesh/N, frame/N, history, live), so that its policy needs no hashes.
/// @param source  of the data of the script: stored, case, live
[[nodiscard]] std::string served_page(const std::string& title, std::string_view source);

/// Two served pages side by side, left/ and right/, with their titles.
[[nodiscard]] std::string pair_page(const std::string& left, const std::string& right);

/// The name of a script or a style in a security policy: 'sha256-...' of its bytes.
[[nodiscard]] std::string policy_hash(std::string_view text);
/// Text for HTML: & < > " ' as entities.
[[nodiscard]] std::string html_text(std::string_view text);
/// JSON that cannot end or open an element of HTML: '<', '>', '&' as \u003c, \u003e, \u0026 (they occur in strings
/// only).
[[nodiscard]] std::string json_in_html(std::string_view json);

}  // namespace scree::io
