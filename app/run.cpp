#include <fmt/format.h>
#include <omp.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <numbers>
#include <optional>

#include "app/built_from.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/progress.h"
#include "app/session.h"
#include "app/signals.h"
#include "coupling/bodies/partition.h"
#include "coupling/stages/bending_note.h"
#include "coupling/stages/driver.h"
#include "coupling/stages/implicit_damping.h"
#include "coupling/stages/mesh_estimate.h"
#include "coupling/stages/plan_warnings.h"
#include "io/case/read_case.h"
#include "io/live/control_server.h"
#include "io/live/live_sink.h"
#include "io/pictures/model_picture.h"
#include "io/results/results_sink.h"
#include "io/text/printable.h"
#include "model/free_field.h"

namespace scree::app {
namespace {

/// Origin of the coordinates of a model, as text; empty for (0, 0).
std::string origin_text(const Model& model) {
  if (model.origin == Vec2(0.0, 0.0)) return {};
  return fmt::format("coordinates are counted from ({}, {}) m", model.origin.x(), model.origin.y());
}

/// run.log: every event of the run.
class Log final : public coupling::Sink {
 public:
  /// @param from  place from which the run and its log continue; empty: from the start
  Log(const std::filesystem::path& file, const std::string& from)
      : log_(spdlog::basic_logger_st("run:" + file.string(), file.string(), from.empty())) {
    log_->set_pattern("%Y-%m-%d %H:%M:%S.%e [%l] %v");
    log_->set_error_handler([](const std::string& why) { complain("warning: run.log: {}\n", why); });
    if (!from.empty()) note("goes on from " + from);
  }
  ~Log() override { spdlog::drop(log_->name()); }
  void begin(const Model& model, const coupling::Plan&) override {
    if (const std::string text = origin_text(model); !text.empty()) note(text);
  }
  void event(const coupling::Event& e) override {
    const bool warn = e.kind == coupling::EventKind::warning || e.kind == coupling::EventKind::not_converged;
    put(warn ? spdlog::level::warn : spdlog::level::info,
        fmt::format("t = {:.6g} s  {}  {}", e.time, coupling::name(e.kind), e.text));
  }
  void warn(const std::string& text) { put(spdlog::level::warn, text); }
  void note(const std::string& text) { put(spdlog::level::info, text); }
  void end(const coupling::RunEnd&, const coupling::FrameView&) override { log_->flush(); }

 private:
  void put(spdlog::level::level_enum level, const std::string& text) { log_->log(level, io::printable_line(text)); }

  std::shared_ptr<spdlog::logger> log_;
};

/// What --quiet leaves: warnings, on the error stream.
class Warnings final : public coupling::Sink {
 public:
  void event(const coupling::Event& e) override {
    if (e.kind == coupling::EventKind::warning) complain("warning: {}\n", e.text);
  }
};

/// Which blocks of a partitioned stage take explicit steps.
std::string sides_text(const Model& model, const coupling::Stage& stage) {
  const coupling::Partition& partition = stage.partition;
  const std::vector<char> sides = coupling::first_sides(model, partition, stage.construction),
                          absent = stage.construction.flags(model.blocks.size());
  std::string names;
  std::size_t free = 0, explicit_ones = 0;
  for (std::size_t b = 0; b < sides.size(); ++b) {
    if (absent[b] != 0 || model.support_of(BlockId{static_cast<std::int32_t>(b)})) continue;
    ++free;
    if (sides[b] != 0 && ++explicit_ones <= 5)
      names += fmt::format("{}'{}'{}", names.empty() ? "" : ", ", model.blocks[b].name,
                           sides[b] == coupling::kDivided ? " in part" : "");
  }
  if (explicit_ones > 5) names += fmt::format(" and {} more", explicit_ones - 5);
  std::string text = fmt::format("{} of {} free blocks {} as it begins{}{}", explicit_ones, free,
                                 partition.slow_explicit ? "fast" : "explicit", names.empty() ? "" : ": ", names);
  std::string limits;
  if (partition.speed.used())
    limits = fmt::format("{:g} m/s until they are below {:g} m/s", partition.speed.up, partition.speed.down);
  if (partition.strain_rate.used())
    limits += fmt::format("{}{:g} 1/s until they are below {:g} 1/s", limits.empty() ? "" : ", or above ",
                          partition.strain_rate.up, partition.strain_rate.down);
  return limits.empty() ? text : text + "; others above " + limits;
}

/// What a stage excavates, fills and releases, one line each.   @param before  the stage before; nullptr: none
void print_construction(const Model& model, const coupling::Stage* before, const coupling::Stage& stage) {
  const coupling::Construction& c = stage.construction;
  const std::size_t n = model.blocks.size();
  const std::vector<char> now = c.flags(n),
                          was = before == nullptr ? std::vector<char>(n, 0) : before->construction.flags(n);
  std::vector<BlockId> left, came;
  for (std::size_t b = 0; b < n; ++b)
    if (now[b] != was[b]) (now[b] != 0 ? left : came).emplace_back(static_cast<std::int32_t>(b));
  const auto told = [&](const std::vector<BlockId>& blocks) {
    double area = 0.0;
    for (const BlockId b : blocks) area += moments(model.blocks[b.index()].polygon).area;
    return fmt::format("{} {} of {:.6g} m2: {}", blocks.size(), blocks.size() == 1 ? "block" : "blocks", area,
                       coupling::named_blocks(model, blocks));
  };
  if (before == nullptr && !left.empty()) say("    not there yet: {}\n", told(left));
  if (before != nullptr && !left.empty()) say("    excavates {}\n", told(left));
  if (!came.empty()) say("    fills {}\n", told(came));
  if (c.release)
    say("    releases {:g} of the forces of what has been excavated {}\n", *c.release,
        c.release_time > 0 ? fmt::format("within {:g} s", seconds(c.release_time)) : std::string("at once"));
}

/// Prints the functions, loads, viscous edges and cracks of a model.
void print_loads(const Model& m) {
  std::string line;
  const auto add = [&line](std::size_t count, std::string_view one, std::string_view many) {
    if (count > 0) line += fmt::format("{}{} {}", line.empty() ? "" : ", ", count, count == 1 ? one : many);
  };
  add(static_cast<std::size_t>(
          std::count_if(m.functions.begin(), m.functions.end(), [](const TimeFunction& f) { return !f.of_load; })),
      "function", "functions");
  add(m.point_loads.size(), "point load", "point loads");
  add(static_cast<std::size_t>(std::count_if(m.tractions.begin(), m.tractions.end(),
                                             [&](const EdgeTraction& t) { return !of_free_field(m, t.function); })),
      "edge with a traction", "edges with a traction");
  add(m.body_accelerations.size(), "body acceleration", "body accelerations");
  add(m.edge_supports.size(), "held edge", "held edges");
  add(m.viscous_edges.size(), "viscous edge", "viscous edges");
  add(m.cracks.size(), "straight piece of cracks", "straight pieces of cracks");
  if (!line.empty()) say("  {}\n", line);
}

/// Names of the blocks, those that are numbered from one to the last: "base-1, rock-1 to rock-76".
std::string names_text(const Model& model) {
  struct Run {
    std::string stem;
    std::int64_t first = 0, last = 0;  // stem + number; stem alone where first is negative
  };
  std::vector<Run> runs;
  for (const Block& b : model.blocks) {
    std::size_t digits = b.name.size();
    while (digits > 0 && b.name[digits - 1] >= '0' && b.name[digits - 1] <= '9') --digits;
    const std::string number = b.name.substr(digits);
    if (number.empty() || number.size() > 9 || (number.size() > 1 && number[0] == '0')) {
      runs.push_back({b.name, -1, -1});
      continue;
    }
    const std::int64_t n = std::stoll(number);
    if (!runs.empty() && runs.back().first >= 0 && runs.back().stem == b.name.substr(0, digits) &&
        n == runs.back().last + 1)
      runs.back().last = n;
    else
      runs.push_back({b.name.substr(0, digits), n, n});
  }
  constexpr std::size_t kMost = 60;
  std::string out;
  for (std::size_t i = 0; i < runs.size() && i < kMost; ++i) {
    const Run& r = runs[i];
    out += i == 0 ? "" : ", ";
    out += r.first < 0 ? r.stem : fmt::format("{}{}", r.stem, r.first);
    if (r.last > r.first) out += fmt::format("{}{}{}", r.last == r.first + 1 ? ", " : " to ", r.stem, r.last);
  }
  if (runs.size() > kMost) out += ", ... (--blocks lists all)";
  return out;
}

/// One line per block; positions in the coordinates of the case.
void print_blocks(const Model& model) {
  std::size_t width = 5;
  for (const Block& b : model.blocks) width = std::max(width, b.name.size());
  say("  {:<{}}  {:>12} {:>14} {:>14}  {:<6} {}\n", "block", width, "area [m2]", "centre x [m]", "y [m]", "held",
      "material");
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Block& b = model.blocks[i];
    const Moments m = moments(b.polygon);
    const Vec2 at = m.centroid + model.origin;
    say("  {:<{}}  {:>12.6g} {:>14.10g} {:>14.10g}  {:<6} {}\n", b.name, width, m.area, at.x(), at.y(),
        model.support_of(BlockId(static_cast<std::int32_t>(i))) != nullptr ? "held" : "",
        model.materials[b.material.index()].name);
  }
}

/// Prints what was read from a drawing, and what was left out.
void print(const io::DrawingReport& d) {
  say("  drawing {}: {}, unit {:g} m by {}, curves to {:.3g} m, from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) m\n", d.file,
      d.form, d.unit, d.unit_from, d.tolerance, d.box.lo.x(), d.box.lo.y(), d.box.hi.x(), d.box.hi.y());
  std::size_t layer = 5, entity = 6;
  for (const io::DrawingRow& r : d.rows) {
    layer = std::max(layer, r.layer.size());
    entity = std::max(entity, r.entity.size());
  }
  say("    {:<{}}  {:<{}} {:>7}  {}\n", "layer", layer, "entity", entity, "number", "becomes");
  for (const io::DrawingRow& r : d.rows)
    say("    {:<{}}  {:<{}} {:>7}  {}\n", io::printable_line(r.layer), layer, io::printable_line(r.entity), entity,
        r.count, r.fate);
}

void print(const coupling::Plan& plan, const GroundMotion& m) {
  const MotionFacts f = m.facts();
  const GroundMotion::Setting& how = m.setting();
  const std::string stage =
      how.stage.valid() ? fmt::format(" of stage '{}'", plan.stages[how.stage.index()].name) : std::string();
  say("  motion '{}': {} samples, {:.6g} s from {:g} s{} on, PGA {:.4g} m/s2 ({:.3g} g), PGV {:.4g} m/s, final "
      "velocity {:.2g} m/s, final displacement {:.3g} m, Arias {:.3g} m/s\n",
      how.name, m.times().size(), f.duration, how.start, stage, f.pga, f.pga / kStandardGravity, f.pgv,
      f.final_velocity, f.final_displacement, f.arias);
}

/// Prints the requested statistics of joint sets against those of the drawn samples; a mean that deviates by more than
/// 2.58 standard errors, as one in a hundred does by chance, is marked.
void print(const Model& model, const SetStatistics& s) {
  const auto told = [](const Sample& drawn, const Moments1& asked, const char* unit) {
    const double error = asked.deviation / std::sqrt(static_cast<double>(std::max<std::int64_t>(drawn.n, 1)));
    const bool off = drawn.n > 0 && std::abs(drawn.mean() - asked.mean) > 2.58 * error + 1e-9 * std::abs(asked.mean);
    return fmt::format("{:.4g} +- {:.3g} {} specified, {:.4g} +- {:.3g} in {} draws{}", asked.mean, asked.deviation,
                       unit, drawn.mean(), drawn.deviation(), drawn.n,
                       off ? " (off by more than 99 % of samples)" : "");
  };
  say("  joint set of '{}': {} lines, {:.4g} m; {:.4g} m/m2 specified, {:.4g} m/m2 drawn\n",
      model.joints[s.joint.index()].name, s.lines, s.total_length, s.asked_density(), s.density());
  const Moments1 dip =
      s.fisher_k > 0.0 ? Moments1{s.dip_deg.mean, fisher_deviation_deg(s.fisher_k)} : drawn_moments(s.dip_deg, false);
  if (dip.deviation > 0.0) say("    dip {}\n", told(s.drawn_dip, dip, "deg"));
  if (s.spacing.varies()) say("    spacing {}\n", told(s.drawn_spacing, drawn_moments(s.spacing, true), "m"));
  if (!s.through && s.drawn_length.n > 0)
    say("    length {}\n", told(s.drawn_length, drawn_moments(s.length, true), "m"));
  if (s.drawn_gap.n > 0) say("    gap {}\n", told(s.drawn_gap, drawn_moments(s.gap, true), "m"));
  if (!s.through)
    say("    persistence {:.3g}: rock bridges are {:.3g} of a line\n", s.persistence(), 1.0 - s.persistence());
}

void print(const CuttingReport& r) {
  say("  cutting: {} blocks of {:.6g} m2 from {} lines, snapped to {:g} m\n", r.blocks, r.area, r.lines, r.snap);
  say("    dead ends: {} kept as cracks ({:.4g} m), {} shorter than {:g} m trimmed ({:.4g} m)\n", r.cracks_kept,
      r.crack_length, r.cracks_trimmed, r.least_width, r.trimmed_length);
  if (r.ends_extended > 0)
    say("    rock bridges: {} dead ends extended to the next line ({:.4g} m)\n", r.ends_extended, r.extended_length);
  say("    slivers: {} joined to a neighbour{}\n", r.slivers_joined,
      r.slivers_left > 0 ? fmt::format(", {} without a neighbour kept", r.slivers_left) : "");
  say("    least area {:.4g} m2, least edge {:.4g} m, least angle {:.4g} deg\n", r.least_area, r.least_edge,
      r.least_angle * 180.0 / std::numbers::pi);
}

/// Prints the damping by implicit steps of a stage.   @return 1 if that is a warning
std::size_t print_damping(const io::Case& c, std::size_t stage) {
  const auto damping =
      coupling::stage_damping(c.model, c.plan.stages[stage], coupling::acts_in(c.model, c.plan, stage));
  if (!damping) return 0;
  const bool much = coupling::damps_much(*damping);
  say("    {}{}\n", much ? "warning: " : "", coupling::text(*damping));
  return much ? 1 : 0;
}

/// Announces the large meshes that will be made, before a user waits for them.
void tell_meshes(const Model& model, const coupling::Plan& plan) {
  constexpr double kLarge = 1e5;  // elements; about as many are made per second
  for (const coupling::Stage& s : plan.stages)
    if (const coupling::MeshEstimate e = coupling::mesh_estimate(model, s); e.elements > kLarge) {
      say("stage '{}': about {:.2g} elements, {:.2g} GB of memory\n", s.name, e.elements, 1e-9 * e.bytes);
    }
  for (const coupling::Stage& s : plan.stages)
    if (const auto note = coupling::bending_note(model, s)) say("{}\n", *note);
}

/// Text about the ledger in the last line.
std::string closing_words(const coupling::Ledger& ledger) {
  const double moved = ledger.moved(), passed = ledger.passed();
  if (ledger.next_to_nothing(moved))
    return fmt::format("ledger open by {:.1e} J, with almost no energy moved: {:.4g} J, round-off {:.1e} J",
                       ledger.closure(), moved, ledger.last_places());
  return fmt::format("ledger closes to {:.1e} of {:.4g} J moved, {:.1e} of {:.4g} J passed", ledger.relative_closure(),
                     moved, ledger.passed_closure(), passed);
}

/// Sets up the stream as the command line requires; prints the reason and returns false if that is impossible.
bool take_stream(coupling::LivePlan& live, const RunOptions& options) {
  if (options.live) {
    live.enabled = true;
    if (!options.live->empty()) live.url = *options.live;
  }
  if (live.enabled)
    if (const auto wrong = io::check_live_url(live.url)) {
      complain("error: --live={}: {}\n", live.url, *wrong);
      return false;
    }
  if (!options.control) return true;
  if (!live.enabled) {
    complain("error: --control takes commands over the stream: it needs --live\n");
    return false;
  }
  const std::string wrong = io::control_url_error(live.url);
  if (!wrong.empty()) complain("error: --control with --live={}: {}\n", live.url, wrong);
  return wrong.empty();
}

/// What commands over the stream act on.   @pre all outlive the server
io::ControlHooks hooks(coupling::Driver& driver, const io::Checkpoints& checkpoints, io::LiveSink& live, Log& log,
                       std::function<void(const std::string&)> warn) {
  io::ControlHooks hooks;
  hooks.session = [&live] { return live.session(); };
  hooks.on_checkpoint = [&driver, &checkpoints] {
    driver.keep_checkpoint();
    return checkpoints.last().filename().string();
  };
  hooks.on_rate = [&live](double rate) { live.set_rate(rate); };
  hooks.on_field = [&live](io::LiveField field) { live.set_field(field); };
  hooks.on_pause = [&live](bool paused) { live.set_paused(paused); };
  hooks.note = [&log](const std::string& text) { log.note(text); };
  hooks.warn = std::move(warn);
  return hooks;
}

/// The last lines of a run.
void tell_end(const coupling::Driver& driver, bool audit, const io::RunFolder& folder) {
  say("state {:016x}  {}\n", coupling::state_hash(driver.state()), closing_words(driver.state().ledger));
  if (audit)
    say("audit: {} checks of {} steps, the worst at {:.2g} of what is allowed{}{}\n", driver.stats().audit_checks,
        driver.stats().steps, driver.stats().audit_worst, driver.audit().text().empty() ? "" : ": ",
        driver.audit().text());
  if (const std::size_t n = driver.warnings().size(); n > 0)
    say("{} {}: see run.log, or \"warnings\" in summary.json\n", n, n == 1 ? "warning" : "warnings");
  say("results in {}\n", folder.path().string());
}

}  // namespace

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const coupling::Method& m : coupling::registered_methods()) names.push_back(m.name);
  return names;
}

std::string case_name(const std::filesystem::path& case_file) {
  const std::filesystem::path full = std::filesystem::absolute(case_file);
  return full.stem() == "case" ? full.parent_path().filename().string() : full.stem().string();
}

int run(const RunOptions& options) {
  take_signals_of_runs();
  const std::vector<std::string> methods = method_names();
  io::Case c = io::read_case(options.case_file, options.set, methods, complain_line);
  const std::string name = case_name(options.case_file);
  const std::filesystem::path out = options.out.empty() ? std::filesystem::path("runs") / name : options.out;
  const auto open_folder = [&] {
    std::unique_ptr<io::FolderLock> lock;  // before an earlier run is cleared: it may not have ended
    if (std::filesystem::is_directory(out)) lock = std::make_unique<io::FolderLock>(out);
    io::RunFolder folder = io::RunFolder::create(out, options.overwrite);
    if (!lock) lock = std::make_unique<io::FolderLock>(out);
    return OpenFolder{std::move(folder), std::move(lock)};
  };
  const std::filesystem::path folder = std::filesystem::absolute(out).lexically_normal();
  const std::string folder_name = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  std::optional<coupling::Checkpoint> begin;
  if (!options.start_from.empty()) begin = end_of_run(options.start_from, c, options);
  return carry_out(c, options, options.name.empty() ? folder_name : options.name, open_folder,
                   {nullptr, begin ? &*begin : nullptr});
}

/// What a run folder states about the program, the case and the command that made it. Takes over the text of the case.
static io::Provenance provenance_of(io::Case& c, const RunOptions& options, int threads) {
  io::Provenance provenance;
  provenance.version = SCREE_VERSION;
  provenance.commit = built_from();
  provenance.case_text = std::move(c.text);
  provenance.command_line = options.command_line;
  provenance.overrides = options.set;
  provenance.threads = threads;
  return provenance;
}

int carry_out(io::Case& c, const RunOptions& options, const std::string& name,
              const std::function<OpenFolder()>& open_folder, const Beginning& beginning) {
  const io::FoundCheckpoint* from = beginning.resumed;
  if (!options.quiet) tell_meshes(c.model, c.plan);
  c.plan.audit = options.audit;
  if (!take_stream(c.plan.live, options)) return kUsage;
  const int threads =
      options.threads > 0 ? options.threads : (c.plan.threads > 0 ? c.plan.threads : omp_get_num_procs());
  omp_set_num_threads(threads);

  io::RunRecord record = record_of(c, options, name);
  std::string().swap(c.resolved);  // as long as the case; assignment would keep its memory
  const OpenFolder open = open_folder();
  const io::RunFolder& folder = open.folder;
  double end_time = 0.0;
  for (const coupling::Stage& s : c.plan.stages) end_time += seconds(s.duration);
  if (options.until) end_time = std::min(end_time, *options.until);

  io::Provenance provenance = provenance_of(c, options, threads);
  const std::string case_hash = c.plan.live.enabled ? io::case_hash(provenance) : "";
  const coupling::Methods methods = coupling::methods_with(c.plan.constants);
  coupling::Driver driver(c.model, c.plan, methods);
  Signals signals(!options.quiet);
  driver.set_control(signals);
  Log log(folder.log(), from == nullptr ? "" : place_of(from->stored.checkpoint.state));
  const auto warn = [&log](const std::string& text) {
    complain("warning: {}\n", text);
    log.warn(text);
  };
  std::optional<io::ResultsSink::GoOn> go_on;
  if (from != nullptr)
    go_on = {from->stored.results,
             from->stored.checkpoint.transfers,
             from->stored.checkpoint.travels,
             from->stored.checkpoint.warnings,
             place_of(from->stored.checkpoint.state),
             warn};
  io::ResultsSink results(folder, std::move(provenance), std::move(go_on));
  io::Checkpoints checkpoints(folder, std::move(record), results,
                              {c.plan.output.checkpoint_every, c.plan.output.checkpoint_steps}, from);
  driver.set_keeper(checkpoints);
  if (from != nullptr) driver.continue_from(from->stored.checkpoint);
  if (beginning.after != nullptr) driver.continue_from(*beginning.after);
  driver.add_sink(results);
  driver.add_sink(log);
  std::unique_ptr<Progress> progress;
  if (!options.quiet) {
    progress = std::make_unique<Progress>(isatty(STDOUT_FILENO) != 0, end_time,
                                          from != nullptr ? &from->stored.checkpoint : nullptr);
    driver.add_sink(*progress);
  }
  Warnings warnings;
  if (options.quiet) driver.add_sink(warnings);
  std::unique_ptr<io::LiveSink> live;
  if (c.plan.live.enabled) {
    live = std::make_unique<io::LiveSink>(
        c.plan.live,
        io::LiveRun{name, SCREE_VERSION, case_hash, io::live_field(c.live_field).value_or(io::LiveField::speed),
                    options.until},
        warn);
    driver.add_sink(*live);
  }
  std::unique_ptr<io::ControlServer> control;
  if (options.control) {
    control = std::make_unique<io::ControlServer>(c.plan.live.url, name, signals,
                                                  hooks(driver, checkpoints, *live, log, warn));
    driver.set_control(*control);
    driver.add_sink(*control);  // after the stream, whose session it uses
  }

  coupling::RunEnd end;
  try {
    (void)driver.run(options.until);
    end = results.outcome();
  } catch (const coupling::PlanError& e) {
    complain("error: {}\n  what was computed is in {}\n", e.what(), folder.path().string());
    return kBadCase;
  } catch (const io::FileError& e) {
    complain("error: {}\n", e.what());
    if (!checkpoints.last().empty())
      complain("  the last good checkpoint is {}; go on with: scree resume {}\n", checkpoints.last().string(),
               folder.path().string());
    return kFiles;
  }
  if (!options.quiet) tell_end(driver, options.audit, folder);
  switch (end.status) {
    case coupling::RunEnd::Status::done:
      return kDone;
    case coupling::RunEnd::Status::interrupted:
      complain("interrupted at {:.6g} s; what was computed is in {}; go on with: scree resume {}\n",
               seconds(driver.state().time), folder.path().string(), folder.path().string());
      return kInterrupted;
    default:
      break;
  }
  complain("error: {}\n  what was computed is in {}\n", end.reason, folder.path().string());
  return kNotConverged;
}

/// Prints the steps of a first stage with explicit steps. The stage begins with the search for its contacts, which may
/// take a minute where tens of thousands of edges lie near each other; in that case only the run prints the steps.
/// @param edges  of the outlines
/// @return warnings   @throws coupling::PlanError where they are refused, or the stage cannot begin
std::size_t print_first_step(const io::Case& c, const coupling::Methods& methods, std::size_t edges) {
  constexpr std::size_t kFewEdges = 4000;
  struct Told final : coupling::Sink {
    std::size_t warnings = 0;
    void event(const coupling::Event& e) override {
      warnings += e.kind == coupling::EventKind::warning ? 1 : 0;
      say("    {}{}\n", e.kind == coupling::EventKind::warning ? "warning: " : "", e.text);
    }
  } told;
  if (c.plan.stages.front().integrator != coupling::Integrator::implicit && edges <= kFewEdges)
    coupling::Driver(c.model, c.plan, methods).begin_only(told);
  return told.warnings;
}

int check(const CheckOptions& options) {
  const std::vector<std::string> names = method_names();
  const io::Case c = io::read_case(options.case_file, options.set, names, complain_line);
  say("{}: {}\n", options.case_file.string(), c.model.title.empty() ? "untitled case" : c.model.title);
  say("  {} blocks, {} materials, {} joints, {} held or driven, {} monitors\n", c.model.blocks.size(),
      c.model.materials.size(), c.model.joints.size(), c.model.block_supports.size(), c.model.monitors.size());
  if (options.blocks)
    print_blocks(c.model);
  else
    say("  blocks: {}\n", names_text(c.model));
  print_loads(c.model);
  if (const std::string text = origin_text(c.model); !text.empty()) say("  {} in the results\n", text);
  if (c.drawing) print(*c.drawing);
  if (c.model.cutting) print(*c.model.cutting);
  for (const SetStatistics& set : c.model.joint_sets) print(c.model, set);
  for (const GroundMotion& m : c.model.motions) print(c.plan, m);
  tell_meshes(c.model, c.plan);
  const coupling::Methods methods = coupling::methods_with(c.plan.constants);
  std::size_t warned = 0;
  for (std::size_t i = 0; i < c.plan.stages.size(); ++i) {
    const coupling::Stage& s = c.plan.stages[i];
    const coupling::Setup setup(c.model, methods,
                                coupling::initial_records(c.model, coupling::body_requests(c.model, s)));
    std::int64_t cells = 0, unknowns = 0;
    for (std::size_t p = 0; p < setup.pools(); ++p) {
      MeshPart part;
      setup.pool(p).topology(part);
      std::vector<char> there;
      for (const coupling::Body& b : setup.bodies())
        if (static_cast<std::size_t>(b.pool) == p) there.push_back(b.absent ? 0 : 1);
      for (const std::int32_t b : part.body) cells += there[static_cast<std::size_t>(b)];
    }
    for (const coupling::Body& b : setup.bodies()) unknowns += b.driven ? 0 : 2 * b.nodes;
    say("  stage '{}': {}, {}, {:g} s, {} elements, {} unknowns\n", s.name, s.method, name(s.integrator),
        seconds(s.duration), cells, unknowns);
    print_construction(c.model, i == 0 ? nullptr : &c.plan.stages[i - 1], s);
    if (s.integrator == coupling::Integrator::partitioned) say("    {}\n", sides_text(c.model, s));
    warned += print_damping(c, i);
    if (i == 0) warned += print_first_step(c, methods, setup.outlines().edges.size());
  }
  std::vector<std::string> warnings = coupling::plan_warnings(c.model, c.plan);
  for (const coupling::TimeFault& f : coupling::time_faults(c.model, c.plan))  // those missed were refused
    warnings.push_back(coupling::text(f, c.model));
  for (const std::string& text : warnings) say("  warning: {}\n", text);
  if (!options.picture.empty()) {
    try {
      io::draw_model(c.model, {.names = options.names, .width = 1680, .window = {}}, options.picture);
    } catch (const io::FileError& e) {
      complain("error: {}\n", e.what());
      return kFiles;
    }
    say("  picture in {}\n", options.picture.string());
  }
  warned += warnings.size();
  say("  {}\n", warned == 0   ? "fine"
                : warned == 1 ? "valid, with a warning"
                              : fmt::format("valid, with {} warnings", warned));
  return kDone;
}

}  // namespace scree::app
