#include "app/fos/trial_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/sweep/run_results.h"
#include "io/results/file_error.h"

namespace scree::app {
namespace {

constexpr double kAccelerates = 1.5;  // least gain in speed times t over the displacement added; constant: 2
constexpr double kGains = 0.02;       // least gain in speed of an accelerating block, over its initial speed
constexpr const char* kDetached =
    "no path of closed contacts";  // in the reason of a run that ended with a detached block: coupling/stages/driver.h
constexpr double kOfMargin = 0.3;  // least acceleration of a failure, over (1 - F_s) g

/// First and last frame of a stage; empty if the run has none.
std::optional<std::pair<std::size_t, std::size_t>> frames_of(const std::vector<io::StoredNote>& notes,
                                                             const std::string& stage) {
  std::optional<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t i = 0; i < notes.size(); ++i) {
    if (notes[i].stage != stage) continue;
    if (!out) out = {i, i};
    out->second = i;
  }
  return out;
}

bool ended_in_balance(const io::RunReader& run) {
  const std::vector<io::StoredEvent> events = run.events();
  return std::any_of(events.begin(), events.end(), [](const io::StoredEvent& e) {
    return e.kind == "stage_rule" && e.text.find("'hold'") != std::string::npos &&
           e.text.find("force_below") != std::string::npos && e.text.find("displacement =") == std::string::npos;
  });
}

double farthest(const std::vector<BlockMotion>& motions) {
  double most = 0.0;
  for (const BlockMotion& m : motions) most = std::max(most, m.displacement.norm());
  return most;
}

void decide(const Decision& d, bool balanced, double seconds, TrialResult& out) {
  const auto fastest = std::max_element(out.motions.begin(), out.motions.end(),
                                        [](const auto& a, const auto& b) { return a.speed < b.speed; });
  if (fastest == out.motions.end() || !(seconds > 0.0)) {
    out.why = "no motion was recorded";
    return;
  }
  out.fastest = fastest->name;
  // After implicit static steps all speeds are zero. After explicit ones a slide that never slowed down keeps its
  // speed; therefore only the gain in speed counts. Steady creep gains no speed.
  const double way = fastest->displacement.norm(), first = fastest->first_speed, gain = fastest->speed - first;
  out.acceleration = std::max(0.0, gain) / seconds;
  const double gone = farthest(out.motions);
  const double least = kOfMargin * (1.0 - 1.0 / (1.0 + d.tolerance / d.factor)) * d.gravity.norm();
  const bool accelerates = gain > kGains * first && gain * seconds >= kAccelerates * (way - first * seconds);
  if (balanced) {
    out.verdict = Verdict::stable;
    out.why = "at rest";
    return;
  }
  if (accelerates && (gone >= d.limit || out.acceleration > least)) {
    out.verdict = Verdict::failed;
    out.why = fmt::format("block '{}' has moved {:.3g} m in {:.3g} s and accelerates at {:.3g} m/s2", fastest->name,
                          way, seconds, out.acceleration);
    return;
  }
  out.why = fmt::format("block '{}' creeps: {:.3g} m in {:.3g} s, {:.2g} m/s at the end", fastest->name, way, seconds,
                        fastest->speed);
  if (accelerates)
    out.needed = (std::sqrt(first * first + 2.0 * d.limit * out.acceleration) - first) / out.acceleration;
  else if (fastest->speed > 0.0)
    out.needed = seconds + (d.limit - way) / fastest->speed;
}

}  // namespace

TrialResult trial_result(const std::filesystem::path& folder, const Decision& d) {
  const io::RunReader run(folder);
  TrialResult out;
  out.cpu = run_costs(folder).cpu_seconds;
  const std::vector<io::StoredNote> notes = run.notes();
  const auto hold = frames_of(notes, "hold"), reduction = frames_of(notes, "reduction");
  const std::size_t last = notes.empty() ? 0 : notes.size() - 1;
  if (reduction) {
    out.motions = block_motions(run, reduction->first, last);
    out.displacement = farthest(out.motions);
  }
  if (hold) {
    out.time = notes[hold->second].time - notes[hold->first].time;
    out.motions = block_motions(run, hold->first, hold->second);
    decide(d, ended_in_balance(run), out.time, out);
    name_modes(out.motions, out.time, d.gravity);
    return out;
  }
  name_modes(out.motions, 0.0, d.gravity);
  const std::string reason = run.provenance("reason");
  if (out.displacement >= d.limit || reason.find(kDetached) != std::string::npos) {
    out.verdict = Verdict::failed;
    out.why = fmt::format("a block moved {:.3g} m while the strengths were reduced: {}", out.displacement, reason);
  } else {
    out.why = "the run could not continue: " + reason;
  }
  return out;
}

TrialResult failure_to_rest(const std::filesystem::path& folder, double limit, const Vec2& gravity) {
  constexpr double kFar = 4.0;  // displacement at which the motion is evaluated, over the limit
  const io::RunReader run(folder);
  TrialResult out;
  out.verdict = Verdict::failed;
  for (std::size_t frame = 1; frame < run.times().size(); ++frame) {
    out.motions = block_motions(run, 0, frame);
    out.displacement = farthest(out.motions);
    if (out.displacement >= kFar * limit) break;
  }
  out.why = run.provenance("reason");
  name_modes(out.motions, 0.0, gravity);
  return out;
}

}  // namespace scree::app
