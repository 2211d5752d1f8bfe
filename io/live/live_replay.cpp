#include "io/live/live_replay.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <scree/energy_v1_t.hpp>
#include <scree/event_v1_t.hpp>
#include <thread>
#include <utility>

#include "io/live/live_model.h"
#include "io/live/live_publisher.h"
#include "io/results/file_error.h"
#include "io/results/run_reader.h"

namespace scree::io {
namespace {

using Clock = std::chrono::steady_clock;

Clock::duration wall(double seconds) {
  constexpr double kLongest = 1e8;  // [s]; a clock can add this without overflow
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::min(seconds, kLongest)));
}

std::string folder_name(const std::filesystem::path& run_folder) {
  const std::filesystem::path full = std::filesystem::absolute(run_folder).lexically_normal();
  return (full.has_filename() ? full : full.parent_path()).filename().string();
}

std::vector<std::int32_t> narrow(const std::vector<std::int64_t>& wide) {
  std::vector<std::int32_t> out;
  out.reserve(wide.size());
  for (const std::int64_t i : wide) out.push_back(static_cast<std::int32_t>(i));  // checked by the reader
  return out;
}

}  // namespace

struct LiveReplay::Impl {
  explicit Impl(const std::filesystem::path& folder) : reader(folder) {}

  [[nodiscard]] header_v1_t header(double time, std::int64_t& sequence) const {
    return publisher->header({time, progress.stats.steps, stage, mesh}, sequence);
  }
  void offer_mesh(const StoredFrame& frame);
  void offer_frame(const StoredFrame& frame);
  void offer_histories(double until);
  void offer_events(double until, std::size_t most);
  void take_progress(const StoredFrame& frame);

  RunReader reader;
  std::string name;
  LiveUrl url;
  std::shared_ptr<LiveBus> bus;
  StoredLedger ledger;
  std::vector<StoredMonitor> monitors;
  std::vector<StoredEvent> events;
  std::vector<StoredProgress> known;  // per frame
  std::vector<std::string> stages;

  LiveProgress progress;
  std::shared_ptr<const LiveMesh> mesh;
  std::int32_t stage = 0;
  std::size_t next_event = 0, next_row = 0;  // next to be sent
  std::int64_t frames = 0, details = 0, histories = 0, ledgers = 0, events_sent = 0;
  Clock::time_point detail_at{};  // earliest time of the next detail
  bool new_mesh = true;           // no detail of this mesh was sent
  std::unique_ptr<LivePublisher> publisher;
};

void LiveReplay::Impl::offer_mesh(const StoredFrame& frame) {
  const std::int64_t id = frame.mesh + 1;
  if (mesh && mesh->id == id) return;
  std::vector<double> origin(frame.position.size());
  for (std::size_t i = 0; i < origin.size(); ++i) origin[i] = frame.position[i] - frame.displacement[i];
  const std::vector<std::int32_t> offsets = narrow(frame.offsets), connectivity = narrow(frame.connectivity);
  coupling::MeshView view;
  view.id = static_cast<std::uint32_t>(id);
  view.offsets = offsets;
  view.connectivity = connectivity;
  view.cell_block = frame.block;
  view.cell_material = frame.material;
  view.cell_method = frame.method;
  view.origin = origin;
  view.methods = reader.methods();
  mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(view, frame.position));
  publisher->offer(mesh);
  new_mesh = true;
}

void LiveReplay::Impl::offer_frame(const StoredFrame& frame) {
  RawFrame raw;
  raw.header = header(frame.time, frames);
  raw.mesh = mesh;
  raw.position = frame.position;
  raw.source = frame.velocity;
  publisher->offer(raw);
  // As in a run, only so often that detail takes no more than its share of the network.
  if (Clock::now() < detail_at && !new_mesh) return;
  new_mesh = false;
  LiveDetail detail{header(frame.time, details), live_detail(reader, frame, mesh->base)};
  detail_at = Clock::now() + wall(size_of(detail.data) / kDetailRate);
  publisher->offer(std::move(detail));
}

void LiveReplay::Impl::offer_histories(double until) {
  std::size_t row = next_row;
  while (row < ledger.time.size() && ledger.time[row] <= until) ++row;
  if (row == next_row) return;
  next_row = row--;  // viewers need only the newest row
  energy_v1_t energy{};
  energy.header = header(ledger.time[row], ledgers);
  energy.columns = static_cast<std::int32_t>(ledger.columns.size());
  for (const StoredLedger::Column& c : ledger.columns) {
    energy.name.push_back(wire_text(c.name));
    energy.side.push_back(wire_text(c.side));
    energy.value.push_back(c.value[row]);
  }
  energy.energy = ledger.energy[row];
  energy.closure = ledger.closure[row];
  energy.moved = ledger.moved[row];
  energy.relative_closure = energy.moved > 0.0 ? std::abs(energy.closure) / energy.moved : 0.0;
  energy.passed = ledger.passed[row];
  publisher->offer_energy(seal(energy));
  if (monitors.empty()) return;
  LiveHistory history;
  for (const StoredMonitor& m : monitors) {
    if (m.time.size() <= row) return;  // a run that was killed has fewer rows
    history.names.push_back(m.given);
    for (const auto& [from, to] :
         {std::pair(&m.position, &history.position), std::pair(&m.displacement, &history.displacement),
          std::pair(&m.velocity, &history.velocity)})
      to->insert(to->end(), {(*from)[2 * row], (*from)[2 * row + 1]});
  }
  history.header = header(ledger.time[row], histories);
  publisher->offer(std::move(history));
}

void LiveReplay::Impl::offer_events(double until, std::size_t most) {
  for (; most > 0 && next_event < events.size() && events[next_event].time <= until; ++next_event, --most) {
    const StoredEvent& e = events[next_event];
    event_v1_t out{};
    out.header = header(e.time, events_sent);
    out.kind = wire_text(e.kind);
    out.text = wire_text(e.text, 2000);
    out.block = -1;
    publisher->offer(seal(out), !coupling::comes_often(e.kind));
  }
}

void LiveReplay::Impl::take_progress(const StoredFrame& frame) {
  progress.time = frame.time;
  progress.stage_name = frame.stage;
  progress.integrator = frame.integrator;
  progress.stats.steps = frame.step;
  progress.stats.blocks = static_cast<std::int64_t>(reader.blocks().size());
  progress.stats.elements = static_cast<std::int64_t>(frame.cells());
  const auto found = std::find(stages.begin(), stages.end(), frame.stage);
  if (found != stages.end()) stage = static_cast<std::int32_t>(found - stages.begin());
  const auto k = static_cast<std::size_t>(frame.index);
  if (k >= known.size()) return;
  progress.stats.cuts = known[k].cuts;
  progress.stats.passes = known[k].passes;
  progress.stats.contacts = known[k].contacts;
  progress.stats.unknowns = known[k].unknowns;
  progress.contact = known[k].contact;
}

LiveReplay::LiveReplay(const std::filesystem::path& run_folder, const std::string& url, const std::string& name,
                       std::shared_ptr<LiveBus> bus)
    : impl_(std::make_unique<Impl>(run_folder)) {
  impl_->name = name.empty() ? folder_name(run_folder) : name;
  impl_->url = bus ? bus->url() : parse_live_url(url, LiveSide::sender);
  impl_->bus = std::move(bus);
  impl_->ledger = impl_->reader.ledger();
  impl_->monitors = impl_->reader.monitors();
  impl_->events = impl_->reader.events();
  impl_->known = impl_->reader.progress();
  for (const StoredStage& s : impl_->reader.stages()) impl_->stages.push_back(s.name);
  if (times().empty()) throw FileError(run_folder, "the run has no frames to replay");
}

LiveReplay::~LiveReplay() = default;

const std::string& LiveReplay::name() const { return impl_->name; }
const std::vector<double>& LiveReplay::times() const { return impl_->reader.times(); }

ReplayCounts LiveReplay::run(double speed, const std::function<bool()>& stop,
                             const std::function<void(std::string)>& warn) {
  Impl& r = *impl_;
  LiveIdentity who;
  who.run = r.name;
  who.title = r.reader.title();
  who.version = r.reader.provenance("version");
  who.case_hash = r.reader.provenance("case_sha256");
  who.origin = {r.reader.origin().x(), r.reader.origin().y()};
  r.publisher = std::make_unique<LivePublisher>(r.url, who, r.bus);
  r.progress = {};
  r.progress.end_time = r.reader.end_time();
  r.mesh = nullptr;
  r.next_event = r.next_row = 0;
  r.publisher->set_model(seal(live_model(r.reader)));
  r.publisher->offer(r.progress);
  r.publisher->start();

  const auto pass_warning = [&] {
    if (const auto text = r.publisher->take_warning(); text && warn) warn(*text);
  };
  /// True when `ready` returns true; false: stopped.
  const auto wait_until = [&](const auto& ready) {
    while (!ready()) {
      pass_warning();
      if (stop && stop()) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return !(stop && stop());
  };
  ReplayCounts counts;
  const Clock::time_point start = Clock::now();
  Clock::time_point last_sent{};
  const auto due = [&](std::size_t k) {
    return speed > 0.0 ? start + wall((times()[k] - times().front()) / speed) : start;
  };
  bool stopped = false;
  for (std::size_t k = 0; k < times().size() && !stopped; ++k) {
    ++counts.frames;
    const bool is_last = k + 1 == times().size();
    stopped = !wait_until([&] { return Clock::now() >= due(k) && r.publisher->idle(); });
    if (stopped) break;
    // Frames that would exceed the rate of a stream are left out, except at the beginning of a stage.
    const bool too_soon = speed > 0.0 && Clock::now() - last_sent < wall(1.0 / kRate);
    if (too_soon && !is_last && times()[k + 1] > times()[k] && r.mesh && due(k + 1) <= Clock::now() + wall(1.0 / kRate))
      continue;
    const StoredFrame frame = r.reader.frame(k);
    r.take_progress(frame);
    // Between two frames of the same time a stage ends: its events are sent before the second frame.
    constexpr std::size_t kAtOnce = LivePublisher::kMaxEvents / 2;
    do {
      r.offer_events(frame.time, kAtOnce);
      stopped = !wait_until([&] { return r.publisher->idle(); });
    } while (!stopped && r.next_event < r.events.size() && r.events[r.next_event].time <= frame.time);
    if (stopped) break;
    r.offer_mesh(frame);
    r.publisher->offer(r.progress);
    r.offer_frame(frame);
    r.offer_histories(frame.time);
    last_sent = Clock::now();
    ++counts.sent;
  }
  counts.complete = !stopped;
  if (!stopped) {
    r.offer_events(std::numeric_limits<double>::infinity(), LivePublisher::kMaxEvents / 2);
    r.offer_histories(std::numeric_limits<double>::infinity());
    r.progress.status = r.reader.provenance("status");
    std::replace(r.progress.status.begin(), r.progress.status.end(), '_', ' ');
    if (r.progress.status == "non finite") r.progress.status = "not finite";
    r.progress.reason = r.reader.provenance("reason");
    if (r.progress.status.empty()) {
      r.progress.status = "interrupted";
      r.progress.reason = "the stored run did not come to its end";
    }
  } else {
    r.progress.status = "interrupted";
    r.progress.reason = "the replay was stopped";
  }
  r.publisher->offer(r.progress);
  r.publisher->finish();
  pass_warning();
  return counts;
}

}  // namespace scree::io
