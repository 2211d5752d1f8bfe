// A stored run as a site: the page of `scree report`, with every frame read when it is requested.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "io/results/file_error.h"
#include "io/serve/site.h"

namespace scree::io {

/// Paths: / (the page), /viewer.js, /viewer.css, /run.json (RunText), and chunks (Chunk::packed) /mesh/N, /frame/N,
/// /history. The run is shown as it was when the site was made, even if it continues.
class StoredSite final : public Site {
 public:
  /// Meaning of the frames for the page.
  enum class Kind {
    run,
    model  // one frame, before a run: the page states this, and shows no histories
  };

  /// @param version  of the program
  /// @throws FileError where the run cannot be read, or has no frame
  StoredSite(const std::filesystem::path& run_folder, const std::string& version, Kind kind = Kind::run);
  ~StoredSite() override;

  [[nodiscard]] std::size_t frames() const;
  [[nodiscard]] const std::string& title() const;
  /// @throws FileError where a frame cannot be read
  [[nodiscard]] std::optional<Resource> find(std::string_view path) override;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Resources common to all sites: / (the page), /viewer.js, /viewer.css; empty for other paths.
/// @param source  as in served_page
[[nodiscard]] std::optional<Resource> page_resource(std::string_view path, const std::string& title,
                                                    std::string_view source);

}  // namespace scree::io
