// The result of `scree fos` as text, JSON, CSV and pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/fos/fos_run.h"
#include "model/model.h"

namespace scree::app {

/// The inputs of a search, as the report states them.
struct FosTitle {
  std::string title, case_file;
  std::string strength = "peak";   // or as-is
  std::string what = "all";        // strengths that are divided: all, friction, cohesion
  std::string method, integrator;  // of the runs
  std::vector<JointLaw> laws;      // laws whose strengths are divided
  double tolerance = 0.01, least = 0.1, most = 10.0;
  double limit = 0.0, hold = 0.0, k_h = 0.0;  // displacement limit [m], longest dynamic stage [s], k_h [g]
};

/// The report that is printed.
[[nodiscard]] std::string fos_text(const FosTitle& title, const FosAnswer& answer);
/// The report as JSON; its keys are listed in docs/fos.md.
[[nodiscard]] std::string fos_json(const FosTitle& title, const FosAnswer& answer);
/// One row per run: factor, verdict, displacement, acceleration, time, mode.
[[nodiscard]] std::string fos_csv(const FosAnswer& answer);
/// Draws the displacement over F, and the last frame of the runs at both ends of the bracket.   @throws FileError
void draw_fos(const FosFolder& folder, const FosTitle& title, const FosAnswer& answer);

}  // namespace scree::app
