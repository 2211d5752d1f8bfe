#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <memory>

#include "app/built_from.h"
#include "app/commands.h"
#include "app/output.h"
#include "app/own_folder.h"
#include "app/session.h"
#include "app/signals.h"
#include "coupling/plan.h"
#include "coupling/stages/driver.h"
#include "io/case/read_case.h"
#include "io/live/control_server.h"
#include "io/live/live_url.h"
#include "io/results/results_sink.h"
#include "io/serve/control_bridge.h"
#include "io/serve/live_site.h"
#include "io/serve/pair_site.h"
#include "io/serve/server.h"
#include "io/serve/stored_site.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX has it declared by the program

namespace scree::app {
namespace {

/// The model of a case as its run would begin: the results of a run that takes no step. The file that was read stays
/// open after its folder is removed.
std::unique_ptr<io::StoredSite> model_site(const ViewOptions& options) {
  const std::vector<std::string> names = method_names();
  const io::Case c = io::read_case(options.source, options.set, names, complain_line);
  const OwnFolder scratch("view");
  // The title of the page names the folder of the case, as a run of it would be named.
  const std::filesystem::path folder =
      scratch.path() / std::filesystem::absolute(options.source).parent_path().filename();
  {
    io::Provenance provenance;
    provenance.version = SCREE_VERSION;
    provenance.commit = built_from();
    provenance.case_text = c.text;
    provenance.overrides = options.set;
    io::ResultsSink sink(io::RunFolder::create(folder, false), provenance);
    const coupling::Methods methods = coupling::methods_with(c.plan.constants);
    coupling::Driver driver(c.model, c.plan, methods);
    driver.add_sink(sink);
    driver.run(0.0);
  }
  return std::make_unique<io::StoredSite>(folder, SCREE_VERSION, io::StoredSite::Kind::model);
}

/// Opens a page in the browser of the desktop; without a desktop the user still has the printed address.
void open_browser(const std::string& address) {
  std::signal(SIGCHLD, SIG_IGN);  // nobody waits for it
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  std::string program = "xdg-open", page = address;
  char* arguments[] = {program.data(), page.data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) complain("warning: xdg-open cannot be started; open the address above in a browser\n");
}

/// @param token  of pages that may give commands: behind the '#' of the address, which browsers send to nobody
int serve(io::Site& site, const ViewOptions& options, const std::string& token = {}) {
  std::unique_ptr<io::Server> server;
  try {
    server = std::make_unique<io::Server>(site, static_cast<std::uint16_t>(options.port));
  } catch (const std::runtime_error& e) {
    complain("error: {}\n", e.what());
    return kFiles;
  }
  take_signals_of_loops({SIGINT, SIGTERM, SIGHUP});
  const std::string address = server->address() + (token.empty() ? "" : "#token=" + token);
  say("{}\n", address);
  if (options.open) open_browser(address);
  server->run(loop_is_to_end);
  return kDone;
}

}  // namespace

int view(const ViewOptions& options) {
  if (options.live) {
    const std::string url = options.live->empty() ? coupling::LivePlan{}.url : *options.live;
    auto wrong = io::check_live_url(url, io::LiveSide::receiver);
    if (!wrong && url.starts_with("memq:")) wrong = "memq:// reaches no other program; use udpm:// or file://";
    if (wrong) {
      complain("error: --live={}: {}\n", url, *wrong);
      return kUsage;
    }
    if (options.control)
      if (const std::string no = io::control_url_error(url); !no.empty()) {
        complain("error: --control: {}: {}\n", url, no);
        return kUsage;
      }
    const std::string token = options.control ? io::new_token() : std::string();
    io::LiveSite site(url, options.run, token);
    return serve(site, options, token);
  }
  if (options.source.empty()) {
    complain("error: nothing to show\n  allowed: a run folder, a case file (.toml), --live\n");
    return kUsage;
  }
  const bool is_case = std::filesystem::path(options.source).extension() == ".toml";
  if (is_case && !options.compare.empty()) {
    complain("error: --compare takes two stored runs, not a case\n");
    return kUsage;
  }
  if (is_case) {
    const std::unique_ptr<io::StoredSite> site = model_site(options);
    return serve(*site, options);
  }
  io::StoredSite site(options.source, SCREE_VERSION);
  say("{}: {} frames\n", options.source, site.frames());
  if (options.compare.empty()) return serve(site, options);
  io::StoredSite other(options.compare, SCREE_VERSION);
  say("{}: {} frames\n", options.compare, other.frames());
  io::PairSite pair(site, other);
  return serve(pair, options);
}

}  // namespace scree::app
