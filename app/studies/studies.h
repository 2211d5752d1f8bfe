// Studies: cases that are no runs of a case file, but numbers computed with Scree's own classes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/studies/tier.h"
#include "io/pictures/line_plot.h"

namespace scree::app {

struct StudyResult {
  std::map<std::string, double> numbers;  // by the names that expected.toml uses
  std::vector<io::LinePlot> plots;
  std::vector<std::string> notes;  // lines for the report
};

using Study = StudyResult (*)(Tier tier);
/// All studies by name. A new study needs a file in this folder and an entry.
[[nodiscard]] const std::map<std::string, Study>& studies();

/// One oscillator: theory of Newmark's schemes against the measured steps of Scree ([Qu2013] 2.5.1).
[[nodiscard]] StudyResult sdof(Tier tier);
/// Blocks on onefold covers: conditions of an implicit step in the stars of a model-wide triangle and in centroidal
/// form, and that both are the same step (docs/theory/kinematics-and-nmm.md, "Onefold covers").
[[nodiscard]] StudyResult onefold(Tier tier);
/// Blocks that slide on steep planes, by every scheme, against a rigid block.
[[nodiscard]] StudyResult sliding(Tier tier);
/// Chains of masses and springs, explicit against implicit ([Qu2013] 2.5.2).
[[nodiscard]] StudyResult spring_chain(Tier tier);

}  // namespace scree::app
