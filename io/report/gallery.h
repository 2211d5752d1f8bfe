// A page of many stored runs: a picture, what was found, and a link to the report of each.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "io/results/file_error.h"

namespace scree::io {

struct GalleryCard {
  std::string name, title;
  std::string link;     // of the report, relative to the page; empty: there is none
  std::string picture;  // PNG in base64; empty: there is none
  std::vector<std::pair<std::string, std::string>> facts;
  std::string trouble;  // why there is no report; empty: there is one
};

/// The card of a run, from its results and its summary.json.
/// @param picture  file to write: displacement at the end (PNG)   @param link  as in GalleryCard
/// @throws FileError where the run cannot be read, has no frame, or the picture cannot be written
[[nodiscard]] GalleryCard gallery_card(const std::filesystem::path& run_folder, const std::filesystem::path& picture,
                                       const std::string& link);

/// The page. It runs no script and makes no request; texts of runs stay text.
[[nodiscard]] std::string gallery_page(const std::vector<GalleryCard>& cards, const std::string& version);

}  // namespace scree::io
