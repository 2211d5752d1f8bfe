#include "io/report/page.h"

#include <cstdint>

#include "io/report/chunk.h"
#include "io/results/sha256.h"
#include "io/viewer/bundle.h"

namespace scree::io {
namespace {

std::string head(const std::string& title, const std::string& more) {
  std::string out = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  out += more;
  out += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  out += "<meta name=\"color-scheme\" content=\"light dark\">\n";
  out += "<title>" + html_text(title) + "</title>\n";
  return out;
}

std::string licences() {
  return "<script type=\"text/plain\" id=\"scree-licences\">" + std::string(viewer_licences()) + "</script>\n";
}

}  // namespace

std::string policy_hash(std::string_view text) {
  const std::string digits = sha256(text);
  const auto value = [](char c) { return static_cast<unsigned>(c <= '9' ? c - '0' : c - 'a' + 10); };
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(16U * value(digits[i]) + value(digits[i + 1])));
  return "'sha256-" + base64(bytes) + "'";
}

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string json_in_html(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      out += "\\u003c";
    else if (c == '>')
      out += "\\u003e";
    else if (c == '&')
      out += "\\u0026";
    else
      out += c;
  }
  return out;
}

std::string served_page(const std::string& title, std::string_view source) {
  std::string out = head(title, "<link rel=\"stylesheet\" href=\"viewer.css\">\n<link rel=\"icon\" href=\"data:,\">\n");
  out += "</head>\n<body data-source=\"" + std::string(source) + "\">\n";
  out += viewer_body();
  out += licences();
  out += "<script src=\"viewer.js\"></script>\n</body>\n</html>\n";
  return out;
}

std::string pair_page(const std::string& left, const std::string& right) {
  std::string out = head(left + " | " + right,
                         "<link rel=\"stylesheet\" href=\"viewer.css\">\n<link rel=\"icon\" href=\"data:,\">\n");
  out += "</head>\n<body class=\"pair\">\n";
  out += "<iframe src=\"left/\" title=\"" + html_text(left) + "\"></iframe>\n";
  out += "<iframe src=\"right/\" title=\"" + html_text(right) + "\"></iframe>\n";
  out += "</body>\n</html>\n";
  return out;
}

std::string report_page(const PageParts& parts) {
  const std::string policy = "default-src 'none'; script-src " + policy_hash(viewer_script()) + "; style-src " +
                             policy_hash(viewer_style()) + "; img-src data: blob:; base-uri 'none'; form-action 'none'";
  std::string out =
      head(parts.title, "<meta http-equiv=\"Content-Security-Policy\" content=\"" + policy + "\">\n") + "<style>";
  out += viewer_style();
  out += "</style>\n</head>\n<body>\n";
  out += viewer_body();
  out += "<script type=\"application/json\" id=\"scree-run\">" + json_in_html(parts.run) + "</script>\n";
  for (const auto& [id, text] : parts.chunks)
    out.append("<script type=\"text/plain\" id=\"scree-").append(id).append("\">").append(text).append("</script>\n");
  out += licences();
  out += "<script>";
  out += viewer_script();
  out += "</script>\n</body>\n</html>\n";
  return out;
}

}  // namespace scree::io
