#include "io/serve/pair_site.h"

#include "io/report/page.h"

namespace scree::io {
namespace {

/// The path inside of a folder, with its first slash; empty where it is not in it.
std::string_view inside(std::string_view path, std::string_view folder) {
  if (!path.starts_with(folder)) return {};
  const std::string_view rest = path.substr(folder.size());
  return rest.starts_with('/') ? rest : std::string_view();
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
