#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/case/data_file.h"
#include "io/case/read_parts.h"
#include "io/case/record.h"
#include "io/case/suggest.h"

namespace scree::io {
namespace {

using Shape = TimeFunction::Shape;

/// Keys of a shape, except amplitude and start.
struct ShapeKeys {
  std::string_view name;
  Shape shape;
  std::vector<std::string> needed, possible;
};
const std::array<ShapeKeys, 6> kShapes{{{"constant", Shape::constant, {}, {}},
                                        {"ramp", Shape::ramp, {"duration"}, {}},
                                        {"sine", Shape::sine, {"frequency"}, {"duration"}},
                                        {"half_sine", Shape::half_sine, {"duration"}, {}},
                                        {"sine_squared", Shape::sine_squared, {"duration"}, {}},
                                        {"table", Shape::table, {}, {"file", "points"}}}};

/// Checks that each key that the shape needs is present, and none that it does not use.
void check_keys(const Section& s, const ShapeKeys& shape) {
  std::vector<std::string> known{"amplitude", "start", "offset"};
  for (const auto* keys : {&shape.needed, &shape.possible}) known.insert(known.end(), keys->begin(), keys->end());
  for (const char* key : {"duration", "frequency", "file", "points"})
    if (s.has(key) && std::find(known.begin(), known.end(), key) == known.end())
      throw s.error(key, fmt::format("a function of shape {} has no {}", shape.name, key), listed(known),
                    "remove it, or choose another shape");
  for (const std::string& key : shape.needed)
    if (!s.has(key))
      throw s.error(key, fmt::format("a function of shape {} needs a {}", shape.name, key),
                    key == "frequency" ? "number [Hz], > 0" : "number [s], > 0", fmt::format("add {} = ...", key));
}

void read_points(const Section& s, TimeFunction& f) {
  for (const Vec2& p : s.ring("points")) {
    const std::size_t item = f.time.size();
    if (p.x() < 0.0)
      throw s.error("points", item, "the time is negative", "times >= 0 s, counted from start",
                    "shift the table with start");
    if (item > 0 && !(p.x() > f.time.back()))
      throw s.error("points", item,
                    fmt::format("the time does not increase: {} s comes after {} s", p.x(), f.time.back()),
                    fmt::format("a time > {} s", f.time.back()),
                    "sort the points, and keep one of those with equal times; a jump takes two times close together");
    f.time.push_back(p.x());
    f.table.push_back(p.y());
  }
}

void read_file(const Section& s, const std::filesystem::path& folder, TimeFunction& f) {
  const std::filesystem::path file = data_path(s, "file", folder, "the table");
  std::string kind = file.extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  if (kind == ".AT2")
    throw s.error("file", "a recorded ground motion is no table",
                  "path of a text file with two columns: time [s], value",
                  "apply the record with [motion.NAME] and a support that follows it, or write it in two columns");
  try {
    Record record = read_history(file, "value");
    f.time = std::move(record.time);
    f.table = std::move(record.acceleration);
  } catch (const CaseError& e) {  // a file that cannot be read is a fault of the key, wrong rows are faults of the file
    if (e.line > 0) throw;
    throw s.error("file", e.problem + ": " + in_quotes(file.string(), 400),
                  "path of a text file with two columns: time [s], value",
                  "paths start from the folder of the case file; " + e.hint);
  }
  if (f.time.front() < 0.0)
    throw s.error("file", fmt::format("the table begins at {} s", f.time.front()), "times >= 0 s, counted from start",
                  "shift the times in the file, and the table with start");
}

void read_table(const Section& s, const std::filesystem::path& folder, TimeFunction& f) {
  if (s.has("file") == s.has("points"))
    throw s.error(s.has("file") ? "points" : "file",
                  s.has("file") ? "file and points are both given" : "the table has no points", "either file or points",
                  "write points = [[0.0, 0.0], [1.0, 1.0]]");
  s.has("file") ? read_file(s, folder, f) : read_points(s, f);
}

}  // namespace

void read_functions(const Section& root, const std::filesystem::path& folder, Model& model) {
  for (const Section::Named& named : root.named("function")) {
    const Section& s = named.section;
    const std::string& name = s.text("shape");
    const ShapeKeys& shape =
        *std::find_if(kShapes.begin(), kShapes.end(), [&](const ShapeKeys& k) { return k.name == name; });
    check_keys(s, shape);
    TimeFunction f;
    f.name = named.name;
    f.shape = shape.shape;
    f.amplitude = s.number("amplitude");
    if (!s.has("start")) s.settle("start", 0.0);
    const Start start = read_start(s, root);
    f.start = start.time;
    f.stage = start.stage;
    if (s.has("duration")) f.duration = s.number("duration");
    if (s.has("frequency")) f.frequency = s.number("frequency");
    if (f.shape == Shape::table) read_table(s, folder, f);
    model.functions.push_back(std::move(f));
  }
}

}  // namespace scree::io
