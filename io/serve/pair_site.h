// Two stored runs side by side as one site.
#pragma once

#include "io/serve/stored_site.h"

namespace scree::io {

/// Paths: / (a page with both), /viewer.css, /left/... and /right/... with the contents of the two sites.
class PairSite final : public Site {
 public:
  /// @param left,right  must outlive the site
  PairSite(StoredSite& left, StoredSite& right) : left_(&left), right_(&right) {}

  [[nodiscard]] std::optional<Resource> find(std::string_view path) override;

 private:
  StoredSite *left_, *right_;
};

}  // namespace scree::io
