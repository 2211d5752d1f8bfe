// A case file as a model and a plan.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/plan.h"
#include "io/case/case_error.h"
#include "io/case/drawn_layers.h"
#include "io/case/notice.h"
#include "model/model.h"

namespace scree::io {

/// What the user wrote and what it means.
struct Case {
  Model model;
  coupling::Plan plan;
  std::string live_field = "speed";          // the scalar that a stream carries (live_field.h)
  std::string text;                          // of the file, byte for byte
  std::string path;                          // as given by the caller
  std::vector<std::string> overrides;        // the --set options
  std::vector<std::filesystem::path> files;  // named in the text: records, tables, outlines, traces
  std::optional<DrawingReport> drawing;      // on [drawing]
  std::string resolved;  // an equivalent case file with SI numbers, defaults and overrides written out
};

/// Reads a case file. A model that lies far from (0, 0) is given a local origin (model/local_origin.h).
/// @param overrides  `key=value` from --set, applied in order (override.h)
/// @param methods    names of the methods that exist, for example "nmm", "dda"
/// @param notice     called before work that may take more than some seconds: the cutting of a domain by many joints
/// @throws CaseError for the first fault: of the file, its text, keys, values, names, geometry, records
[[nodiscard]] Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                             std::span<const std::string> methods, const Notice& notice = {});

/// Reads a case from a text in memory (of a stored run).
/// @param file  names the file in errors; records are found relative to its folder
[[nodiscard]] Case read_case_text(std::string text, const std::filesystem::path& file,
                                  const std::vector<std::string>& overrides, std::span<const std::string> methods,
                                  const Notice& notice = {});

}  // namespace scree::io
