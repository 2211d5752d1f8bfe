#include "io/results/snapshot.h"

#include <fmt/format.h>

#include <charconv>

#include "app/commands.h"
#include "io/results/run_reader.h"

namespace scree::app {
namespace {

/// First frame of the second stage; nothing where the run has one stage.
std::optional<std::size_t> handover(const io::RunReader& run) {
  const std::string first = run.frame(0).stage;
  std::size_t low = 0, high = run.times().size();
  while (high - low > 1) {  // stages follow one another: halve
    const std::size_t middle = (low + high) / 2;
    (run.frame(middle).stage == first ? low : high) = middle;
  }
  return high < run.times().size() ? std::optional(high) : std::nullopt;
}

}  // namespace

int snapshot(const SnapshotCommand& command) {
  const std::filesystem::path out =
      command.out.empty() ? command.run / (command.ledger ? "ledger.png" : command.field + ".png") : command.out;
  if (command.ledger) {
    io::plot_ledger(command.run, out);
    fmt::print("{}\n", out.string());
    return kDone;
  }
  io::SnapshotOptions options;
  const auto field = io::field_named(command.field);
  if (!field) {
    fmt::print(stderr, "error: --field {}: unknown\n  allowed: {}\n", command.field,
               fmt::join(io::field_names(), ", "));
    return kUsage;
  }
  options.field = *field;
  const io::RunReader run(command.run);
  const std::string& at = command.at;
  if (at == "start") {
    options.frame = 0;
  } else if (at == "handover") {
    options.frame = handover(run);
    if (!options.frame) {
      fmt::print(stderr, "error: --at handover: the run has one stage only\n");
      return kUsage;
    }
  } else if (at != "end") {
    const bool is_time = !at.empty() && at.back() == 's';
    double number = 0.0;
    const char* last = at.data() + at.size() - (is_time ? 1 : 0);
    const auto [end, fault] = std::from_chars(at.data(), last, number);
    if (fault != std::errc() || end != last || number < 0.0) {
      fmt::print(stderr,
                 "error: --at {}: not a place in a run\n  allowed: start, handover, end, a frame number, or a time "
                 "such as 1.5s\n",
                 at);
      return kUsage;
    }
    if (is_time)
      options.time = number;
    else
      options.frame = static_cast<std::size_t>(number);
  }
  io::snapshot(command.run, options, out);
  fmt::print("{}\n", out.string());
  return kDone;
}

}  // namespace scree::app
