#include "io/live/live_publisher.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <scree/info_v1_t.hpp>
#include <scree/part_v1_t.hpp>
#include <utility>

#include "io/live/encode.h"
#include "io/live/send_pieces.h"
#include "io/live/signals_blocked.h"

namespace scree::io {
namespace {

constexpr std::size_t kLarge = 8192;  // bytes; smaller messages need no pacing

double seconds_between(LivePublisher::Clock::time_point from, LivePublisher::Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

LivePublisher::LivePublisher(LiveUrl url, LiveIdentity identity, std::shared_ptr<LiveBus> bus)
    : session_(utime_now()),
      url_(std::move(url)),
      identity_(std::move(identity)),
      bus_(std::move(bus)),
      field_(identity_.field) {
  now_.session = session_;
  now_.topology_id = -1;
}

void LivePublisher::start() {
  if (thread_.joinable() || stopped_) return;
  const SignalsBlocked inherited_by_the_thread;
  thread_ = std::thread([this] { run(); });
}

void LivePublisher::finish() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    waiting_.last = fresh_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

// --- called by the run --------------------------------------------------------------------------------------------

void LivePublisher::offer(std::shared_ptr<const LiveMesh> mesh) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.mesh = std::move(mesh);
    if (std::exchange(waiting_.has_frame, false)) ++frames_skipped_;  // of the previous mesh
    fresh_ = true;
  }
  wake_.notify_one();
}

void LivePublisher::offer(RawFrame& frame) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.has_frame) ++frames_skipped_;
    std::swap(waiting_.frame, frame);
    waiting_.has_frame = fresh_ = true;
  }
  wake_.notify_one();
}

void LivePublisher::offer(LiveDetail detail) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.detail = std::move(detail);
    fresh_ = true;
  }
  wake_.notify_one();
}

void LivePublisher::offer(LiveHistory history) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.history = std::move(history);
    fresh_ = true;
  }
  wake_.notify_one();
}

void LivePublisher::offer(const header_v1_t& header, const coupling::Ledger& ledger) {
  offer_energy(encode_energy(header, ledger));
}

void LivePublisher::offer_energy(Bytes energy) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.energy = std::move(energy);
    fresh_ = true;
  }
  wake_.notify_one();
}

void LivePublisher::offer(LiveProgress progress) {
  bool news = false;
  {
    const std::lock_guard lock(mutex_);
    news = progress.status != waiting_.progress.status;
    waiting_.progress = std::move(progress);
    fresh_ = fresh_ || news;
  }
  if (news) wake_.notify_one();
}

void LivePublisher::offer(Bytes event, bool milestone) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.events.size() >= kMaxEvents || stopped_) {
      ++events_lost_;
      return;
    }
    waiting_.events.push_back({std::move(event), milestone});
    fresh_ = true;
  }
  wake_.notify_one();
}

bool LivePublisher::idle() {
  const std::lock_guard lock(mutex_);
  return !waiting_.has_frame && !waiting_.detail && !waiting_.history && !waiting_.energy && waiting_.events.empty();
}

std::optional<std::string> LivePublisher::take_warning() {
  if (!has_warning_.exchange(false)) return std::nullopt;
  const std::lock_guard lock(mutex_);
  return warning_;
}

// --- the thread ---------------------------------------------------------------------------------------------------

void LivePublisher::run() {
  try {
    rate_from_ = Clock::now();
    Waiting work;
    while (!work.last) {
      {
        std::unique_lock lock(mutex_);
        wake_.wait_until(lock, std::min(info_at_, keyframe_at_), [this] { return fresh_; });
        fresh_ = false;
        work.mesh = waiting_.mesh;
        std::swap(work.frame, waiting_.frame);
        work.has_frame = std::exchange(waiting_.has_frame, false);
        work.detail = std::exchange(waiting_.detail, std::nullopt);
        work.history = std::exchange(waiting_.history, std::nullopt);
        work.energy = std::exchange(waiting_.energy, std::nullopt);
        work.events.clear();
        std::swap(work.events, waiting_.events);
        work.progress = waiting_.progress;
        work.last = waiting_.last;
      }
      send_all(work);
    }
  } catch (const std::exception& error) {  // out of memory: the run goes on without its stream
    complain(error.what());
  }
  bus_ = nullptr;
  stopped_ = true;
}

void LivePublisher::send_all(Waiting& work) {
  const Clock::time_point now = Clock::now();
  const bool up = connected();
  if (work.mesh != mesh_) {
    mesh_ = work.mesh;
    encoded_mesh_.clear();
    last_frame_.clear(), last_detail_.clear();  // of the previous mesh
    keyframe_at_ = now;
  }
  now_.time = work.progress.time;
  now_.step = work.progress.stats.steps;
  if (work.has_frame) now_.stage = work.frame.header.stage;
  const bool keyframe_due = now >= keyframe_at_, new_stage = work.progress.stage_name != info_stage_,
             new_status = work.progress.status != info_status_;
  const bool info_due = now >= info_at_ || new_stage || new_status || work.last;
  if (keyframe_due) keyframe_at_ = now + kKeyframeEvery;
  if (info_due) info_at_ = now + kInfoEvery;
  if (!up) {
    if (work.has_frame) ++frames_skipped_;
    events_lost_ += static_cast<std::int64_t>(work.events.size());
    return;
  }

  if (keyframe_due) send_topology();
  if (work.has_frame) last_frame_.clear();
  if (work.detail) last_detail_.clear();
  if (work.history) last_history_.clear();
  if (work.energy) last_energy_.clear();
  if (keyframe_due) {
    send_again();  // data replaced below are not sent twice
    const Clock::time_point sent = Clock::now();
    keyframe_at_ = std::max(keyframe_at_, sent + 3 * (sent - now));
  }
  for (Event& event : work.events) {
    send(LiveKind::event, event.bytes);
    std::deque<Bytes>& kept = event.milestone ? last_milestones_ : last_events_;
    kept.push_back(std::move(event.bytes));
    if (kept.size() > kEventsAgain) kept.pop_front();
  }
  if (work.has_frame) {
    // The INFO before a frame defines its scalar for viewers.
    if (std::exchange(field_, work.frame.field) != work.frame.field) send_info(work.progress);
    LiveFrame frame{work.frame.header, work.frame.mesh, {}, cell_values(work.frame), {}};
    frame.header.utime = utime_now();
    std::swap(frame.position, work.frame.position);
    send_frame(frame, [this](Bytes bytes) {
      send(LiveKind::state, bytes);
      last_frame_.push_back(std::move(bytes));
    });
    std::swap(frame.position, work.frame.position);  // the buffer is reused
    if (bus_) ++frames_sent_;
  }
  if (work.detail)
    send_pieces<part_v1_t>(work.detail->header, seal(work.detail->data), [this](Bytes bytes) {
      send(LiveKind::detail, bytes);
      last_detail_.push_back(std::move(bytes));
    });
  if (work.history)
    send_history(*work.history, [this](Bytes bytes) {
      send(LiveKind::hist, bytes);
      last_history_.push_back(std::move(bytes));
    });
  if (work.energy) {
    send(LiveKind::energy, *work.energy);
    last_energy_ = std::move(*work.energy);
  }
  if (info_due) send_info(work.progress);
}

void LivePublisher::send_again() {
  const auto again = [this](LiveKind kind, Bytes& bytes) {
    stamp(bytes, utime_now());
    send(kind, bytes);
  };
  for (Bytes& bytes : last_frame_) again(LiveKind::state, bytes);
  for (Bytes& bytes : last_detail_) again(LiveKind::detail, bytes);
  for (Bytes& bytes : last_history_) again(LiveKind::hist, bytes);
  if (!last_energy_.empty()) again(LiveKind::energy, last_energy_);
  for (Bytes& bytes : last_milestones_) again(LiveKind::event, bytes);
  for (Bytes& bytes : last_events_) again(LiveKind::event, bytes);
}

void LivePublisher::send_topology() {
  if (!model_.empty()) {
    std::int64_t number = 0;  // always 0: the model does not change
    send_pieces<part_v1_t>(header_now(number), model_, [this](const Bytes& bytes) { send(LiveKind::model, bytes); });
  }
  if (!mesh_) return;
  if (encoded_mesh_.empty()) encoded_mesh_ = encode_mesh(*mesh_);
  send_mesh(header_now(topology_sequence_), encoded_mesh_, [this](const Bytes& bytes) { send(LiveKind::topo, bytes); });
}

void LivePublisher::send_info(const LiveProgress& progress) {
  const Clock::time_point now = Clock::now();
  const double wall = seconds_between(rate_from_, now);
  // A pause does not count in the speed of the run.
  if (progress.status == "paused" || info_status_ == "paused") {
    rate_from_ = now;
    rate_time_ = progress.time;
    rate_steps_ = progress.stats.steps;
  }
  // The last INFO may follow immediately after the previous one; a step longer than a second is measured as a whole.
  if (wall > 0.5 && progress.stats.steps > rate_steps_) {
    constexpr double kMemory = 5.0;  // s
    simulated_per_wall_ = (progress.time - rate_time_) / wall;
    steps_per_second_ = static_cast<double>(progress.stats.steps - rate_steps_) / wall;
    const double share = steady_rate_ > 0.0 ? std::min(1.0, wall / kMemory) : 1.0;
    steady_rate_ += share * (simulated_per_wall_ - steady_rate_);
    rate_from_ = now;
    rate_time_ = progress.time;
    rate_steps_ = progress.stats.steps;
  }
  info_v1_t info{};
  info.header = header_now(info_sequence_);
  info.run = wire_text(identity_.run);
  info.title = wire_text(identity_.title);
  info.version = wire_text(identity_.version);
  info.case_hash = wire_text(identity_.case_hash);
  info.units = "SI: m, s, kg, N, Pa, J";
  info.status = wire_text(progress.status);
  info.reason = wire_text(progress.reason, 2000);
  info.stage_name = wire_text(progress.stage_name);
  info.integrator = wire_text(progress.integrator);
  info.field = name(field_);
  if (mesh_ && mesh_->points() > 0) {
    const auto [x0, x1] = std::minmax_element(mesh_->origin_x.begin(), mesh_->origin_x.end());
    const auto [y0, y1] = std::minmax_element(mesh_->origin_y.begin(), mesh_->origin_y.end());
    info.bounds[0] = mesh_->base[0] + double{*x0};
    info.bounds[1] = mesh_->base[1] + double{*y0};
    info.bounds[2] = mesh_->base[0] + double{*x1};
    info.bounds[3] = mesh_->base[1] + double{*y1};
  }
  std::copy(identity_.origin.begin(), identity_.origin.end(), info.origin);
  info.end_time = progress.end_time;
  info.simulated_per_wall = simulated_per_wall_;
  info.steps_per_second = steps_per_second_;
  info.time_left = steady_rate_ > 0.0 ? std::max(0.0, progress.end_time - progress.time) / steady_rate_ : -1.0;
  info.steps = progress.stats.steps;
  info.cuts = progress.stats.cuts;
  info.passes = progress.stats.passes;
  info.contacts = progress.stats.contacts;
  info.blocks = progress.stats.blocks;
  info.elements = progress.stats.elements;
  info.unknowns = progress.stats.unknowns;
  info.frames_sent = frames_sent_;
  info.frames_skipped = frames_skipped_;
  info.events_lost = events_lost_;
  info.contact_time = progress.contact.time;
  info.contact_depth = progress.contact.depth;
  info.contact_force = progress.contact.force;
  info.contact_depth_at = wire_text(progress.contact.depth_at);
  info.contact_force_at = wire_text(progress.contact.force_at);
  send(LiveKind::info, seal(info));
  info_stage_ = progress.stage_name;
  info_status_ = progress.status;
}

void LivePublisher::send(LiveKind kind, const Bytes& bytes) {
  if (!bus_) return;  // sending has just failed
  if (url_.kind == LiveUrl::Kind::udpm && bytes.size() > kLarge) {
    std::this_thread::sleep_until(large_at_ + kPace);
    large_at_ = Clock::now();
  }
  if (bus_->publish(channel_name(identity_.run, kind), bytes)) return;
  complain("the system refused a message");
  bus_ = nullptr;
  retry_at_ = Clock::now() + kRetryAfter;
  gave_up_ = url_.kind != LiveUrl::Kind::udpm;  // opening a log again would empty it
}

bool LivePublisher::connected() {
  if (bus_) return true;
  if (gave_up_ || Clock::now() < retry_at_) return false;
  std::string why;
  bus_ = LiveBus::open(url_.lcm, LiveSide::sender, why);
  if (bus_) {
    keyframe_at_ = info_at_ = {};
    return true;
  }
  complain(why);
  retry_at_ = Clock::now() + kRetryAfter;
  // If there is a route but no connection, LCM has printed the reason, which should not be repeated.
  gave_up_ = url_.kind != LiveUrl::Kind::udpm || multicast_route_error(url_.group, url_.port).empty();
  return false;
}

void LivePublisher::complain(const std::string& why) {
  if (std::exchange(complained_, true)) return;
  const std::lock_guard lock(mutex_);
  warning_ = fmt::format("live streaming to {} is off: {}; the run goes on", url_.lcm, why);
  has_warning_ = true;
}

header_v1_t LivePublisher::header(const LivePlace& at, std::int64_t& sequence) const {
  header_v1_t header{};
  header.utime = utime_now();
  header.session = session_;
  header.topology_id = at.mesh ? at.mesh->id : -1;
  header.sequence = sequence++;
  header.step = at.step;
  header.stage = at.stage;
  header.time = at.time;
  return header;
}

header_v1_t LivePublisher::header_now(std::int64_t& sequence) const {
  header_v1_t header = now_;
  header.utime = utime_now();
  header.topology_id = mesh_ ? mesh_->id : -1;
  header.sequence = sequence++;
  return header;
}

}  // namespace scree::io
