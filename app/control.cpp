#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "app/commands.h"
#include "app/output.h"
#include "coupling/plan.h"
#include "io/live/channel.h"
#include "io/live/control_client.h"
#include "io/live/control_server.h"
#include "io/live/live_field.h"
#include "io/watch/dashboard.h"

namespace scree::app {
namespace {

/// The run to command if none is named: the only one that streams.
std::optional<std::string> only_run(io::ControlClient& client, const std::string& url) {
  constexpr auto kListen = std::chrono::milliseconds(1500);  // INFO is sent once per second
  const std::vector<std::string> runs = client.heard(kListen);
  if (runs.size() == 1) return runs.front();
  if (runs.empty()) {
    complain("error: no run was received on {}\n  does it stream? scree run CASE --live --control\n", url);
    return std::nullopt;
  }
  complain("error: several runs stream on {}: {}\n  name one with --run\n", url, fmt::join(runs, ", "));
  return std::nullopt;
}

/// The value of a command as it is sent.   @param wrong  set where the text is no value for this verb
double value_of(io::ControlVerb verb, const std::string& text, std::string& wrong) {
  using io::ControlVerb;
  if (verb == ControlVerb::field) {
    const auto field = io::live_field(text);
    if (!field) {
      wrong = fmt::format("field needs one of:");
      for (std::size_t i = 0; i < io::kLiveFields; ++i)
        wrong += fmt::format(" {}", io::name(static_cast<io::LiveField>(i)));
    }
    return field ? static_cast<double>(*field) : 0.0;
  }
  if (text.empty() && verb == ControlVerb::rate) {
    wrong = "rate needs frames per second: scree control RUN rate HZ";
    return 0.0;
  }
  if (text.empty()) return verb == ControlVerb::step ? 1.0 : 0.0;
  if (verb != ControlVerb::step && verb != ControlVerb::rate) {
    wrong = fmt::format("{} takes no value", io::name(verb));
    return 0.0;
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end == nullptr || *end != '\0')
    wrong = fmt::format("'{}' is no number", text);
  else
    wrong = io::control_value_error(verb, value);
  return value;
}

}  // namespace

int control(const ControlOptions& options) {
  const io::ControlVerb verb = *io::control_verb(options.command);
  std::string wrong_value;
  const double value = value_of(verb, options.value, wrong_value);
  if (!wrong_value.empty()) {
    complain("error: {}\n", wrong_value);
    return kUsage;
  }
  const bool is_url = options.target.find("://") != std::string::npos;
  const std::string url = is_url ? options.target : coupling::LivePlan{}.url;
  if (const std::string wrong = io::control_url_error(url); !wrong.empty()) {
    complain("error: {}: {}\n", url, wrong);
    return kUsage;
  }

  std::string why;
  const auto client = io::ControlClient::open(url, why);
  if (!client) {
    complain("error: {}\n", why);
    return kFiles;
  }
  std::string run = options.run;
  if (run.empty() && !is_url) {
    const std::filesystem::path folder = std::filesystem::path(options.target).lexically_normal();
    run = (folder.has_filename() ? folder : folder.parent_path()).filename().string();
  }
  if (run.empty()) {
    const auto only = only_run(*client, url);
    if (!only) return kFiles;
    run = *only;
  }
  const auto most = std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * options.timeout));
  const io::ControlReply reply = client->ask(run, verb, value, most);
  const std::string where =
      fmt::format("step {}, {:.6g} s", reply.ack.header.step, reply.ack.header.time);  // of an answer
  switch (reply.kind) {
    case io::ControlReply::Kind::silence:
      complain("error: {} does not answer on {}\n", run, url);
      if (const std::vector<std::string> runs = client->heard(std::chrono::milliseconds(1500));
          std::find(runs.begin(), runs.end(), io::channel_run(run)) != runs.end())
        complain("  it streams, but takes no commands: scree run CASE --live --control\n");
      else if (!runs.empty())
        complain("  what streams there: {}\n", fmt::join(runs, ", "));
      return kFiles;
    case io::ControlReply::Kind::no_end:
      complain("error: {} has received \"{}\", but has not executed it within {:g} s\n", run, options.command,
               options.timeout);
      return kFailed;
    case io::ControlReply::Kind::answered:
      break;
  }
  // Text from the network cannot control the terminal.
  constexpr std::size_t kMost = 1000;
  const bool done = reply.ack.result == "done";
  const std::string reason = reply.ack.reason.empty() ? "" : ": " + io::shown(reply.ack.reason, kMost);
  const std::string told =
      fmt::format("{}: {} {}, {} at {}{}\n", run, options.command, io::shown(reply.ack.result, kMost),
                  io::shown(reply.ack.state, kMost), where, reason);
  if (done)
    say("{}", told);
  else
    complain("error: {}", told);
  return done ? kDone : kFailed;
}

}  // namespace scree::app
