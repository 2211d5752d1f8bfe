// `scree slope`: the classical numbers of a slope and of records.
#include <fmt/format.h>

#include <numbers>
#include <optional>
#include <string>

#include "app/commands.h"
#include "app/output.h"
#include "app/slope/slope_report.h"
#include "io/results/atomic_file.h"

namespace scree::app {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// What is wrong with the options of the slope; empty: nothing.
std::string slope_error(const SlopeCommand& c) {
  const bool block = c.weight || c.length, face = c.height || c.face;
  if (block && face) return "the slope is given twice: --weight and --length, or --height and --face";
  if (face && !(c.height && c.face && c.dip && c.friction))
    return "a slope with a face needs --height, --face, --dip and --friction";
  if (block && !(c.weight && c.length && c.dip && c.friction))
    return "a block needs --weight, --length, --dip and --friction";
  if (!block && !face && (c.cohesion > 0.0 || c.uplift > 0.0 || c.thrust > 0.0))
    return "cohesion and water need the size of the block: --weight and --length, or --height and --face";
  if (!face && (c.crack > 0.0 || c.water > 0.0))
    return "--crack and --water belong to a slope with --height and --face";
  if (c.dip.has_value() != c.friction.has_value()) return "--dip and --friction go together";
  return {};
}

/// What is wrong with the options as a whole; empty: nothing.
std::string usage_error(const SlopeCommand& c) {
  if (std::string wrong = slope_error(c); !wrong.empty()) return wrong;
  if (c.records.empty() && !c.dip && !c.yield)
    return "no question is given: give --dip and --friction, --yield, or --record";
  if (c.records.empty() && !c.spectrum.empty()) return "--spectrum needs a --record";
  if (!c.records.empty() && c.arias) return "--arias is for regressions without a --record, which has its own";
  if (c.records.empty() && c.scale != 1.0) return "--scale needs a --record";
  return {};
}

std::optional<PlaneSlide> slide_of(const SlopeCommand& c) {
  if (!c.dip) return std::nullopt;
  if (c.height) {
    PlaneSlope s;
    s.height = *c.height;
    s.face = *c.face * kDegree;
    s.dip = *c.dip * kDegree;
    s.unit_weight = c.unit_weight;
    s.friction = *c.friction * kDegree;
    s.cohesion = c.cohesion;
    s.crack = c.crack;
    s.water = c.water;
    return s.slide();
  }
  PlaneSlide s;  // without a size: a unit of weight on a unit of length
  s.dip = *c.dip * kDegree;
  s.friction = *c.friction * kDegree;
  s.weight = c.weight.value_or(1.0);
  s.length = c.length.value_or(1.0);
  s.cohesion = c.cohesion;
  s.uplift = c.uplift;
  s.thrust = c.thrust;
  return s;
}

}  // namespace

int slope(const SlopeCommand& c) {
  if (const std::string wrong = usage_error(c); !wrong.empty()) {
    complain("error: {}\n  hint: scree slope --help, docs/fos.md\n", wrong);
    return kUsage;
  }
  SlopeQuestion q;
  q.k_h = c.k_h;
  q.k_v = c.k_v;
  q.yield = c.yield;
  q.records = c.records;
  q.unit = c.unit;
  q.scale = c.scale;
  q.pga = c.pga;
  q.magnitude = c.magnitude;
  q.arias = c.arias;
  q.damping = c.damping;
  SlopeNumbers numbers;
  try {
    q.slide = slide_of(c);
    numbers = slope_numbers(q);
  } catch (const std::invalid_argument& e) {
    complain("error: {}\n", e.what());
    return kUsage;
  }
  if (!c.json.empty() && c.json != "-") io::write_atomically(c.json, slope_json(q, numbers));
  if (!c.spectrum.empty()) io::write_atomically(c.spectrum, spectrum_csv(numbers));
  say("{}", c.json == "-" ? slope_json(q, numbers) : slope_text(q, numbers));
  return kDone;
}

}  // namespace scree::app
