// The HTML of a report: one file that needs nothing else. What comes from a run is data and is never run.
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

/// Text for HTML: & < > " ' as entities.
[[nodiscard]] std::string html_text(std::string_view text);
/// JSON that cannot end or open an element of HTML: '<', '>', '&' as \u003c, \u003e, \u0026 (they stand in strings
/// only).
[[nodiscard]] std::string json_in_html(std::string_view json);

}  // namespace scree::io
