#include "io/serve/live_site.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>

#include "io/live/live_reader.h"
#include "io/serve/control_bridge.h"
#include "io/serve/live_messages.h"
#include "io/serve/stored_site.h"

namespace scree::io {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kRetry = 2s;    // between attempts to listen
constexpr auto kSlow = 200ms;  // between two updates of what people read: rows, status, events
constexpr std::size_t kEvents = 300;

enum Place : std::size_t { kRun, kMesh, kFrame, kRows, kStatus, kEventList, kAnswer, kModel, kDetail, kPlaces };

std::size_t one_more_than_largest(const std::vector<std::int32_t>& values) {
  return values.empty() ? 0
                        : static_cast<std::size_t>(1 + std::max(0, *std::max_element(values.begin(), values.end())));
}

double whole_metres(double value) { return std::isfinite(value) ? std::round(value) : 0.0; }

}  // namespace

struct LiveSite::Data {
  Data() {
    slots[kRun].first = slots[kMesh].first = slots[kModel].first = true;
    slots[kFrame].paced = slots[kDetail].paced = true;
  }

  void publish(Place place, SharedBytes message) {
    if (place != kAnswer && slots[place].message && *slots[place].message == *message) return;
    slots[place].message = std::move(message);
    ++slots[place].version;
    changed = true;
  }

  /// Clears the data of the last session.
  void forget(std::int64_t its_session) {
    session = its_session;
    stages.clear(), events.clear();
    mesh.reset(), frame.reset(), model.reset(), detail.reset();
    blocks = materials = 0;
  }

  void listen() {
    if (reader && !(reader->ended() && retries)) return;
    if (Clock::now() < next_try) return;
    next_try = Clock::now() + kRetry;
    reader.reset();
    reader = LiveReader::open(url, run, trouble);
    if (reader) trouble.clear();
  }

  void take_info(const info_v1_t& info) {
    if (info.header.session != session) forget(info.header.session);
    stages[info.header.stage] = {info.stage_name, info.integrator};
  }

  void take_frame(const info_v1_t& info) {
    const std::shared_ptr<const LiveFrame> newest = reader->frame();
    if (!newest || newest == frame || newest->header.session != session) return;
    frame = newest;
    if (frame->mesh != mesh) {
      // The first INFO of a run comes before its mesh and contains no bounds.
      if (!mesh) base = {whole_metres(frame->mesh->base[0]), whole_metres(frame->mesh->base[1])};
      mesh = frame->mesh;
      blocks = std::max(blocks, one_more_than_largest(mesh->block));
      materials = std::max(materials, one_more_than_largest(mesh->material));
      publish(kRun, run_message(info, base, blocks, materials, bridge != nullptr));
      publish(kMesh, mesh_message(session, *mesh, base));
    }
    const auto known = stages.find(frame->header.stage);
    const auto& [stage, integrator] =
        known != stages.end() ? known->second
                              : std::pair("stage " + std::to_string(frame->header.stage + 1), std::string());
    publish(kFrame, frame_message(*frame, stage, integrator));
  }

  void take_detail() {
    if (!mesh) return;
    if (const auto newest = reader->model(); newest && newest != model) {
      model = newest;
      publish(kModel, model_message(session, *model, base));
    }
    const std::shared_ptr<const LiveDetail> newest = reader->detail();
    if (!newest || newest == detail || newest->header.session != session || newest->header.topology_id != mesh->id)
      return;
    detail = newest;
    publish(kDetail, detail_message(*detail, *mesh, base));
  }

  void take_rest(const info_v1_t& info) {
    const auto history = reader->history();
    const auto energy = reader->energy();
    const bool has_history = history && history->header.session == session,
               has_energy = energy && energy->header.session == session;
    if (mesh && (has_history || has_energy))
      publish(kRows,
              rows_message(session, has_history ? history.get() : nullptr, has_energy ? &*energy : nullptr, base));
    bool news = false;
    for (event_v1_t& e : reader->take_events()) {
      if (e.header.session != session) continue;
      events.push_back(std::move(e));
      news = true;
    }
    if (news) {
      // Events that are sent again for a late viewer arrive after newer ones.
      std::sort(events.begin(), events.end(),
                [](const event_v1_t& a, const event_v1_t& b) { return a.header.sequence < b.header.sequence; });
      if (events.size() > kEvents) events.erase(events.begin(), events.end() - std::ptrdiff_t{kEvents});
      publish(kEventList, events_message(session, events));
    }
    const LiveCounts counts = reader->counts();
    if (const std::int64_t good = counts.messages - counts.malformed - counts.other; good != heard_count) {
      heard_count = good;
      heard = Clock::now();
    }
    const double silent = std::floor(std::chrono::duration<double>(Clock::now() - heard).count());
    publish(kStatus, status_message(info, silent));
  }

  bool refresh() {
    changed = false;
    listen();
    if (bridge)
      if (const auto answer = bridge->answer()) publish(kAnswer, *answer);
    const std::optional<info_v1_t> info = reader ? reader->info() : std::nullopt;
    const bool slow = Clock::now() >= next_slow;
    if (slow) next_slow = Clock::now() + kSlow;
    if (!info) {
      if (slow && session < 0) publish(kStatus, waiting_message(url, run, trouble));
      return changed;
    }
    take_info(*info);
    take_frame(*info);
    take_detail();
    if (slow) take_rest(*info);
    return changed;
  }

  std::string url, run, trouble;
  bool retries = true;
  std::unique_ptr<LiveReader> reader;
  std::unique_ptr<ControlBridge> bridge;  // null: pages give no commands
  std::array<Slot, kPlaces> slots;
  bool changed = false;
  std::int64_t session = -1, heard_count = 0;
  std::array<double, 2> base{0.0, 0.0};  // position of the first mesh; reference point of the page
  std::map<std::int32_t, std::pair<std::string, std::string>> stages;  // name, integrator
  std::vector<event_v1_t> events;                                      // by sequence
  std::shared_ptr<const LiveMesh> mesh;                                // as published
  std::shared_ptr<const LiveFrame> frame;
  std::shared_ptr<const model_v1_t> model;
  std::shared_ptr<const LiveDetail> detail;
  std::size_t blocks = 0, materials = 0;
  Clock::time_point next_try{}, next_slow{}, heard = Clock::now();
};

LiveSite::LiveSite(std::string url, std::string run, const std::string& token) : data_(std::make_unique<Data>()) {
  if (!token.empty()) data_->bridge = std::make_unique<ControlBridge>(url, token);
  data_->retries = !url.starts_with("file:");
  data_->url = std::move(url);
  data_->run = std::move(run);
  data_->listen();
}

LiveSite::LiveSite(std::shared_ptr<LiveBus> bus, std::string run) : data_(std::make_unique<Data>()) {
  data_->retries = false;
  data_->run = std::move(run);
  data_->reader = std::make_unique<LiveReader>(std::move(bus), data_->run);
}

LiveSite::~LiveSite() = default;

std::optional<Resource> LiveSite::find(std::string_view path) {
  return page_resource(path, data_->run.empty() ? "Scree live" : data_->run, "live");
}
bool LiveSite::take(std::string_view text) {
  const std::optional<info_v1_t> info = data_->reader ? data_->reader->info() : std::nullopt;
  return data_->bridge && data_->bridge->take(text, info ? info->run : std::string());
}
bool LiveSite::refresh() { return data_->refresh(); }
std::span<const Slot> LiveSite::slots() const { return data_->slots; }

}  // namespace scree::io
