// The `scree` command: reads the command line, calls the libraries, turns errors into exit codes.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <sstream>

#include "app/commands.h"
#include "app/completion.h"
#include "app/output.h"
#include "app/signals.h"
#include "coupling/stages/driver.h"
#include "io/case/case_error.h"
#include "io/case/suggest.h"
#include "io/results/file_error.h"
#include "io/results/snapshot.h"
#include "model/mesh_error.h"

namespace {

using namespace scree::app;

std::vector<std::string> commands_of(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  return names;
}

/// Says which word is no command where one should stand, and what was probably meant; empty where all is well.
std::string unknown_command(const CLI::App& app, int argc, char** argv) {
  const CLI::App* at = &app;
  std::string path = "scree";
  for (int i = 1; i < argc; ++i) {
    const std::vector<std::string> known = commands_of(*at);
    const std::string word = argv[i];
    if (known.empty() || word.starts_with('-')) return {};
    if (std::find(known.begin(), known.end(), word) == known.end())
      return fmt::format("error: {} has no command \"{}\"\n  allowed: {}\n  hint: {}\n", path, word,
                         fmt::join(known, ", "),
                         scree::io::did_you_mean(word, known, path + " --help says what they do"));
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
  const std::string near = scree::io::nearest(given, known);
  return near.empty() ? std::string() : ". Did you mean " + near + "?";
}

/// Words that options and arguments take, for completions.
Choices choices() {
  return {{"scree snapshot --field", scree::io::field_names()},
          {"scree snapshot --arrows", {"displacement", "velocity"}},
          {"scree snapshot --at", {"start", "end", "handover"}},
          {"scree cases verify", case_names()},
          {"scree control", {"pause", "resume", "step", "checkpoint", "stop", "rate"}},
          {"scree completion", {"bash", "zsh", "fish"}}};
}

int dispatch(int argc, char** argv) {
  CLI::App app{"Scree: coupled block and continuum simulation of rock slopes in two dimensions", "scree"};
  app.require_subcommand(1);
  app.set_version_flag("--version", SCREE_VERSION);

  RunOptions options;
  for (int i = 0; i < argc; ++i) options.command_line += (i > 0 ? " " : "") + std::string(argv[i]);
  CLI::App* run_command = app.add_subcommand("run", "run a case");
  run_command->add_option("case", options.case_file, "case file (TOML)")->required();
  run_command->add_option("--out", options.out, "run folder (default runs/<case folder>)");
  run_command->add_flag("--overwrite", options.overwrite, "replace an earlier run in that folder");
  run_command->add_option("--name", options.name, "name of the run in the stream (default: its folder)");
  std::string live;
  CLI::Option* live_option = run_command->add_option("--live", live, "stream over LCM, to URL if one is given")
                                 ->expected(0, 1)
                                 ->type_name("[URL]");
  run_command->add_flag(
      "--control", options.control,
      "take commands over LCM (scree control); whoever may send to the group of the URL may then give them");
  run_command->add_option("--threads", options.threads, "threads (results do not depend on it)")
      ->check(CLI::Range(1, 1024));
  double until = 0.0;
  CLI::Option* until_option =
      run_command->add_option("--until", until, "stop after the first step at or past this simulated time [s]")
          ->check(CLI::PositiveNumber);
  run_command->add_option("--set", options.set, "override a key of the case: key=value")
      ->take_all()
      ->type_name("KEY=VALUE");
  run_command->add_flag("--audit", options.audit,
                        "check every step: contact laws and geometry, balance, energy; end where one is wrong");
  run_command->add_flag("--quiet", options.quiet, "print nothing but errors and warnings");

  ResumeOptions again;
  CLI::App* resume_command =
      app.add_subcommand("resume", "go on with a run that was stopped, from its last checkpoint");
  resume_command->add_option("run", again.run, "run folder")->required();
  std::string again_live;
  CLI::Option* again_live_option =
      resume_command->add_option("--live", again_live, "stream over LCM, to URL if one is given")
          ->expected(0, 1)
          ->type_name("[URL]");
  resume_command->add_option("--name", again.name, "name of the run in the stream (default: as it had)");
  resume_command->add_option("--threads", again.threads, "threads (results do not depend on it)")
      ->check(CLI::Range(1, 1024));
  double again_until = 0.0;
  CLI::Option* again_until_option =
      resume_command
          ->add_option("--until", again_until,
                       "stop after the first step at or past this simulated time [s] (default: as the run was told)")
          ->check(CLI::PositiveNumber);
  resume_command->add_flag("--quiet", again.quiet, "print nothing but errors and warnings");

  CheckOptions looked;
  CLI::App* check_command = app.add_subcommand("check", "validate a case and say what it holds");
  check_command->add_option("case", looked.case_file, "case file (TOML)")->required();
  check_command->add_option("--set", looked.set, "override a key of the case: key=value")
      ->take_all()
      ->type_name("KEY=VALUE");
  check_command->add_flag("--blocks", looked.blocks, "a line for each block: name, material, area, centre");

  DigestOptions digested;
  CLI::App* digest_command =
      app.add_subcommand("digest", "run a case and print its motion in numbers, a line for each frame");
  digest_command->add_option("case", digested.case_file, "case file (TOML)")->required();
  digest_command->add_option("--set", digested.set, "override a key of the case: key=value")
      ->take_all()
      ->type_name("KEY=VALUE");
  digest_command->add_option("--threads", digested.threads, "threads")->check(CLI::Range(1, 1024));
  digest_command->add_option("--until", digested.until, "stop after the first step at or past this simulated time [s]")
      ->check(CLI::PositiveNumber);

  CLI::App* cases_command = app.add_subcommand("cases", "the case library");
  cases_command->require_subcommand(1);
  CLI::App* list_command = cases_command->add_subcommand("list", "the cases there are");
  CLI::App* verify_command = cases_command->add_subcommand("verify", "run cases and compare with what they must show");
  VerifyCommand verify;
  bool quick = false;
  verify_command->add_option("names", verify.names, "cases (default: all)");
  verify_command->add_flag("--quick", quick, "the quick tier (default)");
  verify_command->add_flag("--full", verify.full, "the quick and the full tier")->excludes("--quick");
  verify_command->add_option("--threads", verify.threads, "threads")->check(CLI::Range(1, 1024));
  verify_command->add_option("--table", verify.table, "write the table to a file")
      ->check(CLI::Validator(
          [](const std::string& name) {
            const bool known = name.ends_with(".md") || name.ends_with(".html");
            return known ? std::string() : "the name of a table ends in .md or .html";
          },
          "FILE.md|FILE.html"));
  verify_command->add_option("--report", verify.report, "write tables and plots into a folder")->type_name("DIR");

  SnapshotCommand picture;
  CLI::App* snapshot_command = app.add_subcommand("snapshot", "draw a stored run");
  snapshot_command->add_option("run", picture.run, "run folder")->required();
  snapshot_command->add_option("--out", picture.out, "file; .png, .pdf or .svg (default: a PNG in the run folder)");
  snapshot_command->add_option(
      "--at", picture.at,
      "start, end, handover (first frame of the last stage), a stage by name, a frame number, or a time such as 1.5s");
  snapshot_command->add_option("--field", picture.field,
                               "displacement, speed, sxx, syy, sxy, s1, s3, block, method, material");
  snapshot_command->add_option("--range", picture.range, "ends of the colours, in SI units (default: of the values)")
      ->expected(2)
      ->type_name("LOW HIGH");
  snapshot_command
      ->add_option("--window", picture.window, "what to show, in m, as the axes count (default: everything)")
      ->expected(4)
      ->type_name("X0 Y0 X1 Y1");
  CLI::Option* arrows_option =
      snapshot_command->add_option("--arrows", picture.arrows, "arrows on the blocks: displacement or velocity");
  snapshot_command->add_flag("--labels", picture.labels, "names on all blocks; small ones read better with --window")
      ->excludes(arrows_option);
  snapshot_command->add_flag("--elements", picture.elements, "stress as it is stored, one colour an element");
  snapshot_command->add_option("--width", picture.width, "width of a PNG in pixels")->check(CLI::Range(200, 20000));
  CLI::Option* ledger_flag =
      snapshot_command->add_flag("--ledger", picture.ledger, "draw the energy ledger over time instead");
  CLI::Option* history_option =
      snapshot_command->add_option("--history", picture.monitors, "draw monitors over time instead (default: all)")
          ->expected(0, -1)
          ->type_name("[MONITOR ...]")
          ->excludes(ledger_flag);

  WatchOptions look;
  double look_for = 0.0;
  CLI::App* watch_command = app.add_subcommand("watch", "watch a run that streams (run --live), or see a stored one");
  watch_command
      ->add_option("source", look.source,
                   "run folder, name of a run, or URL: udpm://GROUP:PORT, file://LOG (default: any run on the "
                   "default URL)")
      ->type_name("RUN|URL");
  watch_command->add_option("--run", look.run, "of the runs on that URL the one with this name")->type_name("NAME");
  watch_command->add_flag("--once", look.once, "print one screen and end");
  watch_command->add_option("--timeout", look.timeout, "give up after so many seconds of silence; 0: never")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  CLI::Option* for_option =
      watch_command->add_option("--for", look_for, "end after so many seconds")->check(CLI::PositiveNumber);

  ControlOptions ask;
  double ask_value = 0.0;
  CLI::App* control_command = app.add_subcommand("control", "steer a run that was started with --live --control");
  control_command->add_option("run", ask.target, "name of the run, or URL")->required()->type_name("RUN|URL");
  control_command
      ->add_option("command", ask.command,
                   "pause; resume; step N: make N steps (1), then pause; checkpoint; stop; rate HZ: frames a second")
      ->required()
      ->check(CLI::IsMember({"pause", "resume", "step", "checkpoint", "stop", "rate"}));
  CLI::Option* ask_value_option =
      control_command->add_option("value", ask_value, "N of step, HZ of rate")->type_name("[N|HZ]");
  control_command->add_option("--run", ask.run, "of the runs on that URL the one with this name")->type_name("NAME");
  control_command->add_option("--timeout", ask.timeout, "seconds to wait for the answer")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();

  ReplayOptions shown;
  CLI::App* replay_command = app.add_subcommand("replay", "stream a stored run as if it were running");
  replay_command->add_option("run", shown.run, "run folder")->required();
  replay_command
      ->add_option("--speed", shown.speed, "simulated seconds a second; 0: as fast as frames can be read and sent")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  replay_command->add_option("--live", shown.live, "URL to stream to (default: that of run --live)")->type_name("URL");
  replay_command->add_option("--run", shown.name, "name of the run in the stream (default: its folder)")
      ->type_name("NAME");

  bool markdown = false;
  CLI::App* schema_command = app.add_subcommand("schema", "every key of a case file");
  schema_command->add_flag("--markdown", markdown, "as Markdown");

  std::string shell;
  CLI::App* completion_command = app.add_subcommand("completion", "a script that completes this command line");
  completion_command->add_option("shell", shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));

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
  if (*live_option) options.live = live;
  picture.history = history_option->count() > 0;
  std::erase(picture.monitors, "");  // what CLI11 gives for the option alone
  if (*until_option) options.until = until;
  if (*run_command) return run(options);
  if (*again_live_option) again.live = again_live;
  if (*again_until_option) again.until = again_until;
  if (*resume_command) return resume(again);
  if (*verify_command) return cases_verify(verify);
  if (*for_option) look.seconds = look_for;
  if (*watch_command) return watch(look);
  if (*ask_value_option) ask.value = ask_value;
  if (*control_command) return control(ask);
  if (*replay_command) return replay(shown);
  const CollectedOutput at_once;
  if (*digest_command) return digest(digested);
  if (*check_command) return check(looked);
  if (*list_command) return cases_list();
  if (*snapshot_command) return snapshot(picture);
  if (*schema_command) return schema(markdown);
  if (*completion_command) {
    say("{}", completion(app, shell, choices()));
    return kDone;
  }
  return kUsage;
}

}  // namespace

/// Nothing of this is reached by an exception that main can catch: globals of libraries, before it, and threads.
[[noreturn]] void end_without_memory() {
  constexpr std::string_view kWhy = "error: out of memory, or an error where none can be handled\n";
  (void)!::write(STDERR_FILENO, kWhy.data(), kWhy.size());
  ::_exit(kFailed);
}
/// HDF5 ends the program by exit(-1) where an allocation for its tables fails.
void end_of_library(int code, void* /*unused*/) {
  if (code != -1) return;
  std::fflush(nullptr);
  end_without_memory();
}
[[gnu::constructor(101)]] void before_globals() {
  std::set_terminate(end_without_memory);
  ::on_exit(end_of_library, nullptr);
}

int main(int argc, char** argv) {
  open_standard_streams();
  take_signals_of_writes();
  try {
    const int code = dispatch(argc, argv);
    if (code != kDone || output_error() == 0 || output_error() == EPIPE) return code;
    complain("error: cannot write to standard output: {}\n", std::strerror(output_error()));
    return kFiles;
  } catch (const scree::io::CaseError& e) {
    complain("{}\n", e.what());
    return kBadCase;
  } catch (const scree::coupling::PlanError& e) {
    complain("error: {}\n", e.what());
    return kBadCase;
  } catch (const scree::MeshError& e) {
    complain("error: {}\n", e.what());
    return kBadCase;
  } catch (const scree::io::FileError& e) {
    complain("error: {}\n", e.what());
    return kFiles;
  } catch (const std::exception& e) {
    complain("error: {}\n", e.what());
    return kFailed;
  }
}
