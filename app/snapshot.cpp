#include "io/pictures/snapshot.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/commands.h"
#include "app/output.h"
#include "io/pictures/picture_format.h"
#include "io/results/run_reader.h"

namespace scree::app {
namespace {

/// First frame of a stage, by its place in the run; nothing where the run did not reach it.
std::optional<std::size_t> first_frame(const io::RunReader& run, std::size_t stage) {
  const std::vector<io::StoredStage> stages = run.stages();
  std::size_t low = 0, high = run.times().size();
  while (low < high) {  // stages follow one another: bisection
    const std::size_t middle = (low + high) / 2;
    const std::string name = run.frame(middle).stage;
    const auto at = std::find_if(stages.begin(), stages.end(), [&](const auto& s) { return s.name == name; });
    (static_cast<std::size_t>(at - stages.begin()) < stage ? low = middle + 1 : high = middle);
  }
  return low < run.times().size() ? std::optional(low) : std::nullopt;
}

/// Says what is wrong with an option's value.   @return the exit code
int refuse(const std::string& option, const std::string& value, const std::string& fault, const std::string& allowed) {
  complain("error: --{} {}: {}\n  allowed: {}\n", option, value, fault, allowed);
  return kUsage;
}

/// The instant that --at names.   @return kDone, or what to exit with
int choose_instant(const std::string& at, const io::RunReader& run, io::SnapshotOptions& options) {
  if (at == "end") return kDone;
  if (at == "start") {
    options.frame = 0;
    return kDone;
  }
  const std::vector<io::StoredStage> stages = run.stages();
  std::size_t stage = 0;
  while (stage < stages.size() && stages[stage].name != at) ++stage;
  if (at == "handover" && stage == stages.size()) {
    if (stages.size() < 2) return refuse("at", at, "the run has one stage only", "a run with several stages");
    stage = stages.size() - 1;
  }
  if (stage < stages.size()) {
    options.frame = first_frame(run, stage);
    if (options.frame) return kDone;
    return refuse("at", at, "the run did not reach that stage", "a stage that has begun");
  }
  const bool is_time = !at.empty() && at.back() == 's';
  double number = 0.0;
  const char* last = at.data() + at.size() - (is_time ? 1 : 0);
  const auto [end, fault] = std::from_chars(at.data(), last, number);
  if (fault != std::errc() || end != last || !(number >= 0.0))
    return refuse("at", at, "not a place in a run",
                  "start, end, handover, a stage, a frame number, or a time such as 1.5s");
  if (is_time) {
    options.time = number;
    return kDone;
  }
  if (run.times().empty()) return kDone;  // drawing reports that there are no frames
  if (number >= static_cast<double>(run.times().size()) || number != std::floor(number))
    return refuse("at", at, "no such frame", fmt::format("0 to {}", run.times().size() - 1));
  options.frame = static_cast<std::size_t>(number);
  return kDone;
}

/// Options other than the instant.   @return kDone, or what to exit with
int choose_looks(const SnapshotCommand& command, io::SnapshotOptions& options) {
  const auto field = io::field_named(command.field);
  if (!field) return refuse("field", command.field, "unknown", fmt::format("{}", fmt::join(io::field_names(), ", ")));
  options.field = *field;
  if (command.arrows == "displacement")
    options.arrows = io::Arrows::displacement;
  else if (command.arrows == "velocity")
    options.arrows = io::Arrows::velocity;
  else if (command.arrows != "none")
    return refuse("arrows", command.arrows, "unknown", "none, displacement, velocity");
  options.width = command.width;
  options.labels = command.labels;
  options.smooth = !command.elements;
  const auto shown = [](const std::vector<double>& numbers) { return fmt::format("{}", fmt::join(numbers, " ")); };
  const auto rising = [](double low, double high) { return std::isfinite(low) && std::isfinite(high) && low < high; };
  if (const std::vector<double>& r = command.range; !r.empty()) {
    if (!rising(r[0], r[1])) return refuse("range", shown(r), "is empty", "two numbers, the smaller one first");
    options.range = {r[0], r[1]};
  }
  if (const std::vector<double>& w = command.window; !w.empty()) {
    if (!rising(w[0], w[2]) || !rising(w[1], w[3]))
      return refuse("window", shown(w), "is empty", "x0 y0 x1 y1 with x0 < x1 and y0 < y1");
    options.window = Box{{w[0], w[1]}, {w[2], w[3]}};
  }
  return kDone;
}

}  // namespace

int snapshot(const SnapshotCommand& command) {
  const std::string name = command.ledger ? "ledger" : command.history ? "history" : command.field;
  const std::filesystem::path out = command.out.empty() ? command.run / (name + ".png") : command.out;
  if (!io::picture_format(out))
    return refuse("out", out.string(), "is not the name of a picture", "names that end in .png, .pdf or .svg");
  io::SnapshotOptions options;
  if (const int code = choose_looks(command, options); code != kDone) return code;
  if (command.ledger) {
    io::plot_ledger(command.run, out);
  } else if (command.history) {
    io::plot_history(command.run, command.monitors, out);
  } else {
    const io::RunReader run(command.run);
    if (const int code = choose_instant(command.at, run, options); code != kDone) return code;
    io::snapshot(command.run, options, out);
  }
  say("{}\n", out.string());
  return kDone;
}

}  // namespace scree::app
