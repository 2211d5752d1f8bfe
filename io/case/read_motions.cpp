#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "io/case/data_file.h"
#include "io/case/read_parts.h"
#include "io/case/record.h"
#include "model/record_processing.h"

namespace scree::io {
namespace {

/// A file that cannot be read is a fault of the key that names it; wrong rows are faults of the file.
Record record_of(const Section& s, const std::filesystem::path& folder) {
  const std::filesystem::path file = data_path(s, "file", folder, "the recorded motion");
  try {
    return read_record(file, s.has("resample") ? Gaps::accept : Gaps::refuse);
  } catch (const CaseError& e) {
    if (e.line > 0) throw;
    throw s.error("file", e.problem + ": " + in_quotes(file.string(), 400),
                  "path of a PEER .AT2 file, or of a text file with two columns",
                  "paths start from the folder of the case file; " + e.hint);
  }
}

/// Factor from the numbers of the file to m/s2.
double unit_factor(const Section& s, const Record& record) {
  if (!record.unit.empty()) {
    if (!s.has("unit")) s.settle("unit", record.unit);
    if (s.text("unit") != record.unit)
      throw s.error("unit", fmt::format("the file states that its accelerations are in {}", record.unit),
                    fmt::format("\"{}\"", record.unit), "remove the unit here, or correct the header of the file");
  } else if (!s.has("unit")) {
    throw s.error("unit", "the file does not state its unit, and no unit is given", "\"m/s2\", \"g\" or \"cm/s2\"",
                  "add unit = \"g\" if the accelerations are in g");
  }
  const std::string& unit = s.text("unit");
  return unit == "g" ? kStandardGravity : unit == "cm/s2" ? 0.01 : 1.0;
}

RecordProcessing processing_of(const Section& s) {
  const auto optional = [&s](const char* key) {
    return s.has(key) ? std::optional<double>(s.number(key)) : std::nullopt;
  };
  if (s.has("pga") && s.has("scale"))
    throw s.error("pga", "the size of the motion is given twice", "pga or scale", "remove one of the two");
  if (!s.has("pga") && !s.has("scale")) s.settle("scale", 1.0);
  RecordProcessing how;
  how.from = optional("from");
  how.until = optional("until");
  how.resample = optional("resample");
  const std::string& baseline = s.text("baseline");
  how.baseline = baseline == "constant"    ? Baseline::constant
                 : baseline == "linear"    ? Baseline::linear
                 : baseline == "quadratic" ? Baseline::quadratic
                                           : Baseline::none;
  how.taper = s.number("taper");
  how.pga = optional("pga");
  how.scale = optional("scale").value_or(1.0);
  how.between = s.text("integration") == "constant" ? Between::constant : Between::linear;
  return how;
}

/// The record processed with the settings of the case, in m/s2.
Samples samples_of(const Section& s, Record record, const RecordProcessing& how) {
  const double factor = unit_factor(s, record);
  for (double& a : record.acceleration) a *= factor;
  try {
    return process({std::move(record.time), std::move(record.acceleration)}, how);
  } catch (const ProcessingError& e) {  // settings are named like their keys
    throw s.error(e.setting, e.problem, e.allowed, e.hint);
  }
}

Vec2 direction_of(const Section& s) {
  if (s.has("direction_deg")) {
    if (s.has("direction"))
      throw s.error("direction_deg", "the direction is given twice", "direction or direction_deg",
                    "remove one of the two");
    const double angle = s.number("direction_deg");
    // Multiples of a right angle without rounding, so that 90 gives no motion along x.
    const double quarter = angle / 90.0;
    if (quarter == std::floor(quarter)) {
      const Vec2 axes[] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
      return axes[(static_cast<int>(quarter) % 4 + 4) % 4];
    }
    return rotation(angle * std::numbers::pi / 180.0).col(0);
  }
  if (!s.has("direction")) return {1.0, 0.0};
  const Vec2 direction = s.point("direction");
  const double length = direction.stableNorm();
  if (!(length > 0.0) || !std::isfinite(length))
    throw s.error("direction", "the direction has no length", "[x, y], not both zero",
                  "write [1, 0] for a motion along x");
  return direction / length;
}

/// Without a start of its own a motion begins with the first stage after those that bring the model to rest,
/// at whatever time these end.
void settle_start(const Section& s, const Section& root) {
  const std::vector<Section> stages = root.list("stage");
  double end = 0.0;
  for (const Section& stage : stages) {
    if (!stage.boolean("rest")) {
      if (end > 0.0) return s.settle("start", stage.text("name"));
      break;
    }
    end += stage.number("duration");
  }
  s.settle("start", end);  // all stages are stages to rest: it begins in none
}

}  // namespace

void read_motions(const Section& root, const std::filesystem::path& folder, Model& model) {
  for (const Section::Named& named : root.named("motion")) {
    const Section& s = named.section;
    const Vec2 direction = direction_of(s);
    const RecordProcessing how = processing_of(s);
    Samples samples = samples_of(s, record_of(s, folder), how);
    if (!s.has("start")) settle_start(s, root);
    const Start start = read_start(s, root);
    GroundMotion motion(std::move(samples.time), std::move(samples.acceleration), direction,
                        {start.time, how.between, named.name, start.stage});
    const MotionFacts facts = motion.facts();
    for (const double fact : {facts.pga, facts.pgv, facts.final_displacement, facts.arias})
      if (!std::isfinite(fact))
        throw s.error("file", "the motion is not finite after integration", "accelerations of an earthquake",
                      "check unit, scale and pga");
    model.motions.push_back(std::move(motion));
  }
}

}  // namespace scree::io
