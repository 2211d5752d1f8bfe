#include "app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <memory>
#include <sstream>

#include "app/commands.h"
#include "app/completion.h"
#include "app/libraries.h"
#include "app/output.h"
#include "io/case/suggest.h"
#include "io/pictures/snapshot.h"

namespace scree::app {
namespace {

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

/// Message about a word that is not a command where one is expected, with the probable intention; empty: no such word.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  const CLI::App* at = &app;
  std::string path = "scree";
  for (int i = 1; i < argc; ++i) {
    const std::vector<std::string> known = commands_of(*at);
    const std::string word = argv[i];
    if (known.empty() || word.starts_with('-')) return {};
    if (std::find(known.begin(), known.end(), word) == known.end())
      return fmt::format("error: {} has no command \"{}\"\n  allowed: {}\n  hint: {}\n", path, word,
                         fmt::join(known, ", "), io::did_you_mean(word, known, path + " --help explains them"));
    at = at->get_subcommand(word);
    path += " " + word;
  }
  return {};
}

/// ". Did you mean --overwrite?" for a message that ends in an option that is not known.
std::string nearest_option(const CLI::App& app, const std::string& message) {
  const std::size_t from = message.rfind("--");
  if (from == std::string::npos) return {};
  const std::string given = message.substr(from, message.find_first_of(" =", from) - from);
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  std::vector<std::string> known;
  for (const CLI::Option* o : at->get_options())
    for (const std::string& name : o->get_lnames()) known.push_back("--" + name);
  const std::string near = io::nearest(given, known);
  return near.empty() ? std::string() : ". Did you mean " + near + "?";
}

/// Words that options and arguments take, for completions.
Choices choices() {
  return {{"scree snapshot --field", io::field_names()},
          {"scree snapshot --arrows", {"displacement", "velocity"}},
          {"scree snapshot --at", {"start", "end", "handover"}},
          {"scree cases verify", case_names()},
          {"scree control", {"pause", "resume", "step", "checkpoint", "stop", "rate", "field"}},
          {"scree gallery", case_names()},
          {"scree sweep --on", {"local", "slurm"}},
          {"scree slope --unit", {"g", "m/s2", "cm/s2"}},
          {"scree fos --method", {"nmm", "dda"}},
          {"scree fos --integrator", {"explicit", "implicit"}},
          {"scree fos --strength", {"peak", "as-is"}},
          {"scree fos --back-analysis", {"phi", "c"}},
          {"scree sweep --emit", {"snakemake", "gnu-parallel"}},
          {"scree completion", {"bash", "zsh", "fish"}}};
}

/// Action of the given command, called after the whole line has been read.
using Action = std::function<int()>;

/// Options that live as long as the parser: `act` is called with them where `command` is given.
template <class Options, class Act>
void carries_out(CLI::App* command, const std::shared_ptr<Options>& options, Action& action, Act act) {
  command->final_callback([options, &action, act] { action = [options, act] { return act(*options); }; });
}

/// As carries_out(), for a command that prints and ends: its output is written in few pieces.
template <class Options, class Act>
void prints(CLI::App* command, const std::shared_ptr<Options>& options, Action& action, Act act) {
  carries_out(command, options, action, [act](Options& o) {
    const CollectedOutput at_once;
    return act(o);
  });
}

/// The messages of CLI11's own validators name the largest representable number.
const CLI::Validator kPositive(
    [](const std::string& text) {
      double value = 0.0;
      return CLI::detail::lexical_cast(text, value) && value > 0.0 ? std::string()
                                                                   : "it takes a number above 0, not " + text;
    },
    "POSITIVE");
const CLI::Validator kNotNegative(
    [](const std::string& text) {
      double value = 0.0;
      return CLI::detail::lexical_cast(text, value) && value >= 0.0 ? std::string()
                                                                    : "it takes 0 or a number above, not " + text;
    },
    "NONNEGATIVE");

void add_set(CLI::App* command, std::vector<std::string>& set) {
  command->add_option("--set", set, "override a key of the case: key=value")->take_all()->type_name("KEY=VALUE");
}

void add_load(CLI::App* command, std::vector<std::string>& libraries) {
  command->add_option("--load", libraries, "shared library with methods and laws of your own, before the case is read")
      ->take_all()
      ->type_name("LIBRARY");
}

void add_threads(CLI::App* command, int& threads) {
  command->add_option("--threads", threads, "threads (results do not depend on it)")->check(CLI::Range(1, 1024));
}

void add_until(CLI::App* command, std::optional<double>& until, const std::string& without) {
  command->add_option("--until", until, "stop after the first step at or past this simulated time [s]" + without)
      ->check(kPositive);
}

/// --live [URL]: an empty text keeps the URL of the case.
CLI::Option* add_live(CLI::App* command, std::optional<std::string>& live,
                      const std::string& what = "stream over LCM, to URL if one is given") {
  return command
      ->add_option_function<std::vector<std::string>>(
          "--live", [&live](const std::vector<std::string>& url) { live = url.empty() ? std::string() : url.front(); },
          what)
      ->expected(0, 1)
      ->type_name("[URL]");
}

/// Result of reading the command line, for dispatch().
struct Line {
  std::string text;                    // as it was typed
  std::vector<std::string> words;      // of the text
  Action action;                       // of the command
  std::vector<std::string> libraries;  // to be loaded before the action
};

void add_run(CLI::App& app, Line& line) {
  const auto o = std::make_shared<RunOptions>();
  o->command_line = line.text;
  CLI::App* command = app.add_subcommand("run", "run a case");
  command->add_option("case", o->case_file, "case file (TOML)")->required();
  command->add_option("--out", o->out, "run folder (default runs/<case folder>)");
  command->add_flag("--overwrite", o->overwrite, "replace an earlier run in that folder");
  command->add_option("--name", o->name, "name of the run in the stream (default: its folder)");
  add_live(command, o->live);
  command->add_flag(
      "--control", o->control,
      "take commands over LCM (scree control); anyone who can send to the group of the URL can then give them");
  add_threads(command, o->threads);
  add_until(command, o->until, "");
  add_set(command, o->set);
  command
      ->add_option("--start-from", o->start_from,
                   "begin with the stage after the end of another run of the case, which may have fewer stages")
      ->type_name("RUN");
  command->add_flag("--audit", o->audit,
                    "check every step: contact laws and geometry, balance, energy; end where one is wrong");
  command->add_flag("--quiet", o->quiet, "print nothing but errors and warnings");
  add_load(command, line.libraries);
  carries_out(command, o, line.action, run);
}

void add_resume(CLI::App& app, Line& line) {
  const auto o = std::make_shared<ResumeOptions>();
  CLI::App* command = app.add_subcommand("resume", "continue a run that was stopped, from its last checkpoint");
  command->add_option("run", o->run, "run folder")->required();
  add_live(command, o->live);
  command->add_option("--name", o->name, "name of the run in the stream (default: its previous name)");
  add_threads(command, o->threads);
  add_until(command, o->until, " (default: that of the run)");
  command->add_flag("--quiet", o->quiet, "print nothing but errors and warnings");
  add_load(command, line.libraries);
  carries_out(command, o, line.action, resume);
}

void add_check(CLI::App& app, Line& line) {
  const auto o = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "validate a case and print its contents");
  command->add_option("case", o->case_file, "case file (TOML)")->required();
  add_set(command, o->set);
  command->add_flag("--blocks", o->blocks, "a line for each block: name, material, area, centre");
  command->add_option("--picture", o->picture, "draw the model: FILE.png, .pdf or .svg");
  command->add_flag("--names", o->names, "names of the blocks in the picture");
  add_load(command, line.libraries);
  prints(command, o, line.action, check);
}

void add_digest(CLI::App& app, Line& line) {
  const auto o = std::make_shared<DigestOptions>();
  CLI::App* command = app.add_subcommand("digest", "run a case and print its motion in numbers, a line for each frame");
  command->add_option("case", o->case_file, "case file (TOML)")->required();
  add_set(command, o->set);
  add_threads(command, o->threads);
  add_until(command, o->until, "");
  add_load(command, line.libraries);
  prints(command, o, line.action, digest);
}

void add_cases(CLI::App& app, Line& line) {
  CLI::App* cases = app.add_subcommand("cases", "the case library");
  cases->require_subcommand(1);
  const auto nothing = std::make_shared<int>();
  prints(cases->add_subcommand("list", "list the cases"), nothing, line.action, [](int) { return cases_list(); });

  const auto o = std::make_shared<VerifyCommand>();
  CLI::App* command = cases->add_subcommand("verify", "run cases and compare with the expected results");
  command->add_option("names", o->names, "cases (default: all)");
  command->add_flag_callback(
      "--quick", [] {}, "the quick tier (default)");
  command
      ->add_flag_callback(
          "--full", [o] { o->tier = Tier::full; }, "the quick and the full tier")
      ->excludes("--quick");
  command
      ->add_flag_callback(
          "--exhaustive", [o] { o->tier = Tier::exhaustive; }, "everything: the whole of long tables too")
      ->excludes("--quick")
      ->excludes("--full");
  add_threads(command, o->threads);
  command
      ->add_option("--jobs", o->jobs,
                   "cases at a time, which share the threads; those that time several threads come last, one by one")
      ->check(CLI::Range(1, 1024));
  command->add_option("--table", o->table, "write the table to a file")
      ->check(CLI::Validator(
          [](const std::string& name) {
            const bool known =
                name.ends_with(".md") || name.ends_with(".html") || name.ends_with(".csv") || name.ends_with(".json");
            return known ? std::string() : "the name of a table ends in .md, .html, .csv or .json";
          },
          "FILE.md|FILE.html|FILE.csv|FILE.json"));
  command->add_option("--report", o->report, "write tables and plots into a folder")->type_name("DIR");
  carries_out(command, o, line.action, cases_verify);
}

void add_snapshot(CLI::App& app, Line& line) {
  const auto o = std::make_shared<SnapshotCommand>();
  CLI::App* command = app.add_subcommand("snapshot", "draw a stored run");
  command->add_option("run", o->run, "run folder")->required();
  command->add_option("--out", o->out, "file; .png, .pdf or .svg (default: a PNG in the run folder)");
  command->add_option(
      "--at", o->at,
      "start, end, handover (first frame of the last stage), a stage by name, a frame number, or a time such as 1.5s");
  command->add_option("--field", o->field,
                      "displacement, speed, sxx, syy, sxy, s1, s3, block, method, material, utilisation");
  command->add_option("--range", o->range, "limits of the colour scale, in SI units (default: those of the values)")
      ->expected(2)
      ->type_name("LOW HIGH");
  command->add_option("--window", o->window, "what to show, in m, as the axes count (default: everything)")
      ->expected(4)
      ->type_name("X0 Y0 X1 Y1");
  CLI::Option* arrows = command->add_option("--arrows", o->arrows, "arrows on the blocks: displacement or velocity");
  command->add_flag("--labels", o->labels, "names on all blocks; small ones read better with --window")
      ->excludes(arrows);
  command->add_flag("--elements", o->elements, "stress as it is stored, one colour per element");
  command->add_option("--width", o->width, "width of a PNG in pixels")->check(CLI::Range(200, 20000));
  CLI::Option* ledger = command->add_flag("--ledger", o->ledger, "draw the energy ledger over time instead");
  const CLI::Option* history =
      command->add_option("--history", o->monitors, "draw monitors over time instead (default: all)")
          ->expected(0, -1)
          ->type_name("[MONITOR ...]")
          ->excludes(ledger);
  prints(command, o, line.action, [history](SnapshotCommand& picture) {
    picture.history = history->count() > 0;
    std::erase(picture.monitors, "");  // CLI11 gives this for the option without a value
    return snapshot(picture);
  });
}

void add_report(CLI::App& app, Line& line) {
  const auto o = std::make_shared<ReportCommand>();
  CLI::App* command = app.add_subcommand("report", "write a stored run as one page of HTML that needs no network");
  command->add_option("run", o->run, "run folder")->required();
  command->add_option("--out", o->out, "file (default: report.html in the run folder)")->type_name("FILE");
  command
      ->add_option("--size", o->megabytes,
                   "leave out frames until the file has at most this many megabytes; 0: every frame")
      ->check(kNotNegative)
      ->capture_default_str()
      ->type_name("MB");
  prints(command, o, line.action, report);
}

void add_gallery(CLI::App& app, Line& line) {
  const auto o = std::make_shared<GalleryCommand>();
  CLI::App* command = app.add_subcommand("gallery", "write a page of many runs, and the report of each");
  command
      ->add_option("sources", o->sources,
                   "run folders, or names of cases, which are run (default: all cases that are one run)")
      ->type_name("RUN|CASE...");
  command->add_option("--out", o->out, "folder of the page")->capture_default_str()->type_name("DIR");
  command->add_option("--size", o->megabytes, "as --size of report, for each run")
      ->check(kNotNegative)
      ->capture_default_str()
      ->type_name("MB");
  add_threads(command, o->threads);
  prints(command, o, line.action, gallery);
}

void add_view(CLI::App& app, Line& line) {
  const auto o = std::make_shared<ViewOptions>();
  CLI::App* command =
      app.add_subcommand("view", "show a stored run, the model of a case, or a run that streams, in a browser");
  CLI::Option* source =
      command->add_option("source", o->source, "run folder, or case file (.toml): the model before its run")
          ->type_name("RUN|CASE");
  command->add_option("--compare", o->compare, "a second run, to be shown beside the first")
      ->type_name("RUN2")
      ->needs(source);
  CLI::Option* live = add_live(command, o->live, "show a run that streams, on URL if one is given")->excludes(source);
  command->add_option("--run", o->run, "name of the run on that URL")->type_name("NAME");
  command->add_option("--port", o->port, "port of 127.0.0.1 to serve on (default: a free one)")
      ->check(CLI::Range(1, 65535));
  CLI::Option* open = command->add_flag("--open", o->open, "open the page in the browser of the desktop (xdg-open)");
  // Every user of the machine can read the arguments of a browser that is started, and must not read the token.
  command->add_flag("--control", o->control, "let the page steer the run, which was started with --live --control")
      ->needs(live)
      ->excludes(open);
  add_set(command, o->set);
  add_load(command, line.libraries);
  carries_out(command, o, line.action, view);
}

void add_watch(CLI::App& app, Line& line) {
  const auto o = std::make_shared<WatchOptions>();
  CLI::App* command = app.add_subcommand("watch", "watch a run that streams (run --live), or see a stored one");
  command
      ->add_option("source", o->source,
                   "run folder, name of a run, or URL: udpm://GROUP:PORT, file://LOG (default: any run on the "
                   "default URL)")
      ->type_name("RUN|URL");
  command->add_option("--run", o->run, "name of the run on that URL")->type_name("NAME");
  command->add_flag("--once", o->once, "print one screen and end");
  command->add_option("--timeout", o->timeout, "give up after this many seconds without data; 0: never")
      ->check(kNotNegative)
      ->capture_default_str();
  command->add_option("--for", o->seconds, "end after this many seconds")->check(kPositive);
  carries_out(command, o, line.action, watch);
}

void add_control(CLI::App& app, Line& line) {
  const auto o = std::make_shared<ControlOptions>();
  CLI::App* command = app.add_subcommand("control", "steer a run that was started with --live --control");
  command->add_option("run", o->target, "name of the run, or URL")->required()->type_name("RUN|URL");
  command
      ->add_option(
          "command", o->command,
          "pause; resume; step N: make N steps (1), then pause; checkpoint; stop; rate HZ: frames per second; field "
          "NAME: what the frames carry, as live.field")
      ->required()
      ->check(CLI::IsMember({"pause", "resume", "step", "checkpoint", "stop", "rate", "field"}));
  command->add_option("value", o->value, "N of step, HZ of rate, NAME of field")->type_name("[N|HZ|NAME]");
  command->add_option("--run", o->run, "name of the run on that URL")->type_name("NAME");
  command->add_option("--timeout", o->timeout, "seconds to wait for the answer")
      ->check(kPositive)
      ->capture_default_str();
  carries_out(command, o, line.action, control);
}

void add_replay(CLI::App& app, Line& line) {
  const auto o = std::make_shared<ReplayOptions>();
  CLI::App* command = app.add_subcommand("replay", "stream a stored run as if it were running");
  command->add_option("run", o->run, "run folder")->required();
  command->add_option("--speed", o->speed, "simulated seconds per second; 0: as fast as frames can be read and sent")
      ->check(kNotNegative)
      ->capture_default_str();
  command->add_option("--live", o->live, "URL to stream to (default: that of run --live)")->type_name("URL");
  command->add_option("--run", o->name, "name of the run in the stream (default: its folder)")->type_name("NAME");
  carries_out(command, o, line.action, replay);
}

/// Modes of `scree sweep` other than making the runs.
void add_sweep_modes(CLI::App* command, SweepCommand& o) {
  CLI::Option* emit =
      command->add_option("--emit", o.emit, "write a workflow for snakemake or gnu-parallel into FILE instead")
          ->expected(2)
          ->type_name("KIND FILE");
  CLI::Option* on = command->add_option("--on", o.on, "where the runs are executed: local, or slurm as a job array")
                        ->check(CLI::IsMember({"local", "slurm"}))
                        ->capture_default_str()
                        ->excludes(emit);
  command->add_flag("--no-wait", o.no_wait, "end once the job is submitted; collect later")->needs(on);
  CLI::Option* collect = command->add_flag("--collect", o.collect, "make no run, only the table of existing runs")
                             ->excludes(emit)
                             ->excludes(on);
  command->add_option("--only", o.only, "make one run by its number, and no table: called by workflows")
      ->type_name("N")
      ->excludes(emit)
      ->excludes(on)
      ->excludes(collect);
}

void add_sweep(CLI::App& app, Line& line) {
  const auto o = std::make_shared<SweepCommand>();
  o->words = line.words;
  CLI::App* command = app.add_subcommand("sweep", "run a case with many values of its keys, and tabulate the results");
  command->add_option("case", o->case_file, "case file (TOML)")->required();
  CLI::Option* param =
      command
          ->add_option("--param", o->params,
                       "values of a key: KEY=A:B:N, N numbers from A to B, or KEY=V1,V2,...; several make a grid")
          ->take_all()
          ->allow_extra_args(false)
          ->type_name("KEY=VALUES");
  command->add_option("--table", o->table, "parameters of the runs: a header row of keys, then one row per run (CSV)")
      ->type_name("FILE")
      ->excludes(param);
  command->add_option("--out", o->out, "folder of the sweep (default runs/<case folder>-sweep)")->type_name("DIR");
  command->add_option("--jobs", o->jobs, "runs at a time (default: cores / threads of a run)")
      ->check(CLI::Range(1, 4096));
  command->add_option("--threads-per-run", o->threads, "threads of a run")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  add_until(command, o->until, "");
  add_set(command, o->set);
  command->add_option("--block", o->blocks, "block whose displacement is to be in the table")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("NAME");
  add_sweep_modes(command, *o);
  command->add_flag("--quiet", o->quiet, "print nothing but errors and warnings");
  add_load(command, line.libraries);
  carries_out(command, o, line.action, [&line](SweepCommand& c) {
    c.load = line.libraries;
    return sweep(c);
  });
}

void add_slope(CLI::App& app, Line& line) {
  const auto o = std::make_shared<SlopeCommand>();
  CLI::App* command = app.add_subcommand(
      "slope", "pseudo-static factor of safety, Newmark's sliding block, regressions, response spectra of records");
  const CLI::Range angle(0.001, 90.0);
  command->add_option("--dip", o->dip, "of the plane [deg]")->check(angle);
  command->add_option("--friction", o->friction, "friction angle of the plane [deg]")->check(CLI::Range(0.0, 89.9));
  command->add_option("--cohesion", o->cohesion, "of the plane [Pa]")->check(kNotNegative);
  command->add_option("--weight", o->weight, "of the block, a metre of thickness [N/m]")->check(kPositive);
  command->add_option("--length", o->length, "of the plane under it [m]")->check(kPositive);
  command->add_option("--uplift", o->uplift, "force of water on the plane [N/m]")->check(kNotNegative);
  command->add_option("--thrust", o->thrust, "horizontal force of water behind the block [N/m]")->check(kNotNegative);
  command->add_option("--height", o->height, "of a slope whose plane leaves at the toe [m]")->check(kPositive);
  command->add_option("--face", o->face, "angle of its face [deg]")->check(angle);
  command->add_option("--unit-weight", o->unit_weight, "of its rock [N/m3]")->check(kPositive)->capture_default_str();
  command->add_option("--crack", o->crack, "depth of its tension crack, in the top [m]")->check(kNotNegative);
  command->add_option("--water", o->water, "depth of the water in the crack [m]")->check(kNotNegative);
  command->add_option("--kh", o->k_h, "horizontal coefficient, of ground that accelerates into the slope")
      ->check(CLI::Range(-10.0, 10.0));
  command->add_option("--kv", o->k_v, "vertical coefficient, of ground that accelerates downwards")
      ->check(CLI::Range(-10.0, 0.999));
  command->add_option("--yield", o->yield, "critical acceleration [g], in place of that of the slope")
      ->check(kPositive);
  command->add_option("--record", o->records, "recorded acceleration: .AT2, or two columns")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("FILE");
  command->add_option("--unit", o->unit, "of records that do not state it: g, m/s2 or cm/s2")
      ->check(CLI::IsMember({"g", "m/s2", "cm/s2"}));
  CLI::Option* scale = command->add_option("--scale", o->scale, "factor on the records")->check(kPositive);
  command
      ->add_option("--pga", o->pga, "peak that the records are scaled to; without records that of the regressions [g]")
      ->check(kPositive)
      ->excludes(scale);
  command->add_option("--magnitude", o->magnitude, "moment magnitude, for the regressions")
      ->check(CLI::Range(0.0, 10.0));
  command->add_option("--arias", o->arias, "Arias intensity, for the regressions without records [m/s]")
      ->check(kPositive);
  command->add_option("--damping", o->damping, "of the response spectra, fraction of critical")
      ->check(CLI::Range(0.0, 0.99))
      ->capture_default_str();
  command->add_option("--spectrum", o->spectrum, "write the response spectra (CSV)")->type_name("FILE");
  command->add_option("--json", o->json, "write all numbers as JSON; -: print them in place of the table")
      ->type_name("FILE");
  prints(command, o, line.action, slope);
}

void add_fos(CLI::App& app, Line& line) {
  const auto o = std::make_shared<FosCommand>();
  o->words = line.words;
  CLI::App* command =
      app.add_subcommand("fos", "factor of safety of a case, by reduction of the strength of its joints");
  command->add_option("case", o->case_file, "case file (TOML)")->required();
  command->add_option("--out", o->out, "folder of the search (default runs/<case folder>-fos)")->type_name("DIR");
  command->add_option("--on", o->joints, "joint laws that are reduced (default: all); * stands for any characters")
      ->delimiter(',')
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("LAW,...");
  command->add_option("--method", o->method,
                      "nmm or dda, after the stage to rest (default: that of the stage to rest)");
  command->add_option("--integrator", o->integrator, "explicit or implicit (default: as the stage to rest)")
      ->check(CLI::IsMember({"explicit", "implicit"}));
  command
      ->add_option(
          "--strength", o->strength,
          "peak: residual strengths are those of the peak; as-is: joints weaken as defined (default: peak, then as-is "
          "where that differs)")
      ->check(CLI::IsMember({"peak", "as-is"}));
  command->add_option("--tolerance", o->tolerance, "width of the bracket")
      ->check(CLI::Range(1e-4, 1.0))
      ->capture_default_str();
  command->add_option("--least", o->least, "smallest factor that is tried")
      ->check(CLI::Range(1e-3, 1.0))
      ->capture_default_str();
  command->add_option("--most", o->most, "largest factor that is tried")
      ->check(CLI::Range(1.0, 1e3))
      ->capture_default_str();
  command->add_option("--time", o->time, "longest simulated time of a run [s]")->check(kPositive);
  command->add_option("--limit", o->limit, "displacement that counts as failure [m]")->check(kPositive);
  command
      ->add_option("--kh", o->k_h, "pseudo-static coefficient: gravity has this fraction of its size along x as well")
      ->check(CLI::Range(-10.0, 10.0));
  command
      ->add_option("--back-analysis", o->back,
                   "phi or c: change it alone, and print the value at which the slope is just stable")
      ->check(CLI::IsMember({"phi", "c"}));
  command->add_option("--jobs", o->jobs, "runs at a time (default: cores / threads of a run)")
      ->check(CLI::Range(1, 4096));
  command->add_option("--threads-per-run", o->threads, "threads of a run")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--json", o->json, "write the answer as JSON; -: print it in place of the table")
      ->type_name("FILE");
  add_set(command, o->set);
  command->add_flag("--quiet", o->quiet, "print nothing but the answer, errors and warnings");
  add_load(command, line.libraries);
  carries_out(command, o, line.action, [&line](FosCommand& c) {
    c.load = line.libraries;
    return fos(c);
  });
}

void add_schema(CLI::App& app, Line& line) {
  const auto markdown = std::make_shared<bool>(false);
  CLI::App* command = app.add_subcommand("schema", "every key of a case file");
  command->add_flag("--markdown", *markdown, "as Markdown");
  add_load(command, line.libraries);
  prints(command, markdown, line.action, schema);
}

void add_completion(CLI::App& app, Line& line) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("completion", "a script that completes this command line");
  command->add_option("shell", *shell, "bash, zsh or fish")->required()->check(CLI::IsMember({"bash", "zsh", "fish"}));
  prints(command, shell, line.action, [&app](const std::string& name) {
    say("{}", completion(app, name, choices()));
    return static_cast<int>(kDone);
  });
}

}  // namespace

int dispatch(int argc, char** argv) {
  CLI::App app{"Scree: coupled block and continuum simulation of rock slopes in two dimensions", "scree"};
  app.require_subcommand(1);
  app.set_version_flag("--version", SCREE_VERSION);
  Line line;
  line.words.assign(argv, argv + argc);
  for (int i = 0; i < argc; ++i) line.text += (i > 0 ? " " : "") + std::string(argv[i]);
  for (const auto add :
       {add_run, add_resume, add_check, add_digest, add_sweep, add_fos, add_slope, add_cases, add_snapshot, add_report,
        add_gallery, add_view, add_watch, add_control, add_replay, add_schema, add_completion})
    add(app, line);

  if (argc == 1) {
    complain("error: no command given\n\n{}", app.help());
    return kUsage;
  }
  if (const std::string wrong = unknown_command(app, argc, argv); !wrong.empty()) {
    complain("{}", wrong);
    return kUsage;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError& e) {
    complain("error: {}{}\n", e.what(), nearest_option(app, e.what()));
    complain("Run with --help for more information.\n");
    return kUsage;
  } catch (const CLI::ParseError& e) {
    std::ostringstream out, err;
    const int code = app.exit(e, out, err);
    say("{}", out.str());
    complain("{}", err.str());
    return code == 0 ? kDone : kUsage;
  }
  if (const std::string wrong = load_libraries(line.libraries); !wrong.empty()) {
    complain("error: {}\n", wrong);
    return kUsage;
  }
  return line.action ? line.action() : static_cast<int>(kUsage);
}

}  // namespace scree::app
