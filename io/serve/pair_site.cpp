#include "io/serve/pair_site.h"

#include "io/report/page.h"

namespace scree::io {
namespace {

/// The path inside of a folder, which begins with a slash where it is one that a site may have.
std::string_view inside(std::string_view path, std::string_view folder) {
  return path.starts_with(folder) ? path.substr(folder.size()) : std::string_view();
}

}  // namespace

std::optional<Resource> PairSite::find(std::string_view path) {
  if (path == "/") return Resource{"text/html; charset=utf-8", bytes_of(pair_page(left_->title(), right_->title()))};
  if (path == "/viewer.css") return left_->find(path);
  if (const std::string_view rest = inside(path, "/left"); !rest.empty()) return left_->find(rest);
  if (const std::string_view rest = inside(path, "/right"); !rest.empty()) return right_->find(rest);
  return {};
}

}  // namespace scree::io
