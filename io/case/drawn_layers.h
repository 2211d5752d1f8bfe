// The section drawing of a case, and the lines and points that sections of the case take from it by layer name.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/case/section.h"
#include "io/drawing/chains.h"

namespace scree::io {

/// A row of the table that `scree check` prints.
struct DrawingRow {
  std::string layer, entity;
  int count = 0;
  std::string fate;  // its uses, "domain.outline, ...", or why it is left out
};
struct DrawingReport {
  std::string file, form;
  double unit = 1.0, tolerance = 0.0, join = 0.0;  // [m]
  std::string unit_from;
  Box box;  // of all lines and points that are read [m]
  std::vector<DrawingRow> rows;
};

/// Lines and points of [drawing] by layer. Patterns of layer names ignore letter case; `*` stands for any characters.
class DrawnLayers {
 public:
  DrawnLayers() = default;  // the case has no drawing
  /// @param root  with a table `drawing`     @throws CaseError
  DrawnLayers(const Section& root, const std::filesystem::path& folder);

  /// Contents of the layers that match the pattern under a key; their use is recorded for report().
  /// @param use  of the contents: "domain.outline"
  /// @throws CaseError: no drawing, no such layer, nothing of the kind on it, entities that cannot be used, open rings
  [[nodiscard]] std::vector<const DrawnLine*> lines(const Section& s, std::string_view key,
                                                    const std::string& use) const;
  [[nodiscard]] std::vector<Chain> rings(const Section& s, std::string_view key, const std::string& use) const;
  [[nodiscard]] std::vector<Chain> polylines(const Section& s, std::string_view key, const std::string& use) const;
  [[nodiscard]] std::vector<DrawnPoint> points(const Section& s, std::string_view key, const std::string& use) const;

  [[nodiscard]] const std::string& file() const { return drawing_.file; }
  [[nodiscard]] bool empty() const { return drawing_.file.empty(); }
  [[nodiscard]] DrawingReport report() const;

 private:
  [[nodiscard]] CaseError error(int row, std::string problem, std::string allowed, std::string hint) const;
  /// Names of the layers that match the pattern under a key.
  [[nodiscard]] std::vector<std::string> layers(const Section& s, std::string_view key) const;
  [[nodiscard]] std::vector<Chain> chains(const Section& s, std::string_view key, const std::string& use) const;

  Drawing drawing_;
  double join_ = 0.0;                                // [m]
  mutable std::map<std::string, std::string> uses_;  // of each layer: separated by commas
};

}  // namespace scree::io
