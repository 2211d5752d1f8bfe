#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "io/case/read_parts.h"
#include "io/case/record.h"

namespace scree::io {
namespace {

constexpr std::string_view kRecords = "$SCREE_RECORDS/";

std::filesystem::path record_path(const Section& s, const std::filesystem::path& folder) {
  const std::string& file = s.text("file");
  if (file.empty())
    throw s.error("file", "the path is empty", "path of a record", "give the file with the recorded motion");
  if (!file.starts_with('$')) return folder / file;  // an absolute path stays one
  if (!file.starts_with(kRecords))
    throw s.error("file", "only the variable SCREE_RECORDS is known", "a path, or \"$SCREE_RECORDS/...\"",
                  "write the path out");
  const char* records = std::getenv("SCREE_RECORDS");
  if (!records || !*records)
    throw s.error("file", "the environment variable SCREE_RECORDS is not set",
                  "a path, or \"$SCREE_RECORDS/...\" with the variable set",
                  "export SCREE_RECORDS=FOLDER, the folder with the recorded motions");
  return std::filesystem::path(records) / file.substr(kRecords.size());
}

double unit_factor(const std::string& unit) {
  constexpr double kStandardGravity = 9.80665;  // [m/s2]
  return unit == "g" ? kStandardGravity : unit == "cm/s2" ? 0.01 : 1.0;
}

/// A file that cannot be read is a fault of the key that names it; wrong rows are faults of the file.
Record record_of(const Section& s, const std::filesystem::path& folder) {
  const std::filesystem::path file = record_path(s, folder);
  try {
    return read_record(file, unit_factor(s.text("unit")) * s.number("scale"));
  } catch (const CaseError& e) {
    if (e.line > 0) throw;
    throw s.error("file", e.problem + ": " + in_quotes(file.string(), 400), "path of a text file with two columns",
                  "paths start from the folder of the case file; " + e.hint);
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

}  // namespace

void read_motions(const Section& root, const std::filesystem::path& folder, Model& model) {
  for (const Section::Named& named : root.named("motion")) {
    const Section& s = named.section;
    const Vec2 direction = direction_of(s);
    Record record = record_of(s, folder);
    GroundMotion motion(std::move(record.time), std::move(record.acceleration), direction);
    if (s.text("baseline") == "constant") motion.correct_baseline();
    const MotionFacts facts = motion.facts();
    if (!std::isfinite(facts.final_displacement) || !std::isfinite(facts.pgv))
      throw s.error("file", "the motion is not finite once integrated", "accelerations of an earthquake",
                    "check unit and scale");
    model.motions.push_back(std::move(motion));
  }
}

}  // namespace scree::io
