// Data that `scree watch` shows of a run, and their rendering as text. Independent of networks, files and terminals.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace scree::io {

struct DashboardTerm {
  std::string name, side;  // side: energy, work, dissipated, scheme
  double value = 0.0;      // [J]
};

struct DashboardLedger {
  double time = 0.0;                 // [s]
  std::vector<DashboardTerm> terms;  // in the order of the ledger
  double closure = 0.0;              // [J]
  double moved = 0.0;                // [J]
  double relative_closure = 0.0;     // |closure| / moved
  double passed = 0.0;               // energy passed [J]
  /// |closure| / passed
  [[nodiscard]] double passed_closure() const { return passed > 0.0 ? std::abs(closure) / passed : 0.0; }
};

struct DashboardContact {
  double depth = 0.0;  // deepest penetration [m]
  double force = 0.0;  // largest force [N]
  std::string depth_at, force_at;
};

struct DashboardMonitor {
  std::string name;
  double x = 0.0, y = 0.0;    // position [m]
  double ux = 0.0, uy = 0.0;  // displacement [m]
  double vx = 0.0, vy = 0.0;  // velocity [m/s]
};

struct DashboardEvent {
  double time = 0.0;  // [s]
  std::string kind, text;
};

/// Statistics of the messages received over LCM.
struct DashboardReceived {
  std::int64_t messages = 0, malformed = 0, other = 0, incomplete = 0, events_lost = 0, frames = 0;
  double waited = 0.0;               // since the watcher began to listen [s]
  double silent = 0.0;               // since the last message [s]
  std::optional<double> mesh_after;  // from the start of the watcher to the complete mesh [s]
};

/// The data of a run that a watcher has. Texts may contain anything: the screen shows them cut and without control
/// characters.
struct Dashboard {
  using Term = DashboardTerm;
  using Ledger = DashboardLedger;
  using Contact = DashboardContact;
  using Monitor = DashboardMonitor;
  using Event = DashboardEvent;
  using Received = DashboardReceived;

  std::string source;  // URL or folder
  std::string run;     // name; empty: nothing has been received yet
  std::string title, version, status, reason, stage, integrator;
  double time = 0.0, end_time = 0.0;  // simulated [s]
  std::optional<double> rate;         // simulated seconds per second
  std::optional<double> step_rate;    // steps per second
  std::optional<double> time_left;    // wall time [s]
  std::optional<std::int64_t> steps, cuts, passes, contacts, blocks, cells, unknowns;
  std::optional<double> frame_time;  // of the newest complete frame [s]
  std::optional<Contact> contact;    // empty: not known
  std::optional<Ledger> ledger;
  double monitors_time = 0.0;  // [s]
  std::vector<Monitor> monitors;
  std::vector<Event> events;         // oldest first
  std::optional<Received> received;  // empty: a stored run
};

/// False while a run continues, also one that is paused.
[[nodiscard]] bool has_ended(const Dashboard& run);

/// The whole screen: at most `height` lines of at most `width` columns, without line ends or control characters.
/// Sections that do not fit are shortened and marked as such; the last line is the foot.
/// @pre width >= 40, height >= 10
[[nodiscard]] std::vector<std::string> render(const Dashboard& run, int width, int height);

/// One line for logs: time, stage, rate, energy, closure.
[[nodiscard]] std::string render_line(const Dashboard& run);

/// A text as it may be shown: at most so many characters, the last one '~' where something was cut; what
/// plain_length refuses becomes '?'. (Every character counts as one column.)
[[nodiscard]] std::string shown(std::string_view text, std::size_t most);

}  // namespace scree::io
