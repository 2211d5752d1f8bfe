#include "io/live/live_sink.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "io/live/encode.h"
#include "io/live/live_model.h"
#include "io/live/live_publisher.h"

namespace scree::io {
namespace {

constexpr auto kProgressEvery = std::chrono::milliseconds(100);
constexpr int kShare = 100;  // copying frames takes at most 1/kShare of the time

/// Processor time of this thread: waiting for other threads on a busy machine does not count.
std::chrono::nanoseconds cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return std::chrono::seconds(t.tv_sec) + std::chrono::nanoseconds(t.tv_nsec);
}

/// Limits the mean number of items per second. If each interval began at the previous item, step times that do not
/// divide the interval (steps of 29 ms, an interval of 33 ms) would select only every second step.
class Limiter {
 public:
  using Clock = LivePublisher::Clock;
  explicit Limiter(Clock::duration every) : every_(every) {}
  /// @param rate  items per second; 0 or less: never due
  [[nodiscard]] static Limiter at_rate(double rate) {
    constexpr double kDay = 86400.0;
    return Limiter(std::chrono::duration_cast<Clock::duration>(
                       std::chrono::duration<double>(rate > 1.0 / kDay ? 1.0 / rate : kDay)),
                   rate > 0.0);
  }
  [[nodiscard]] bool due() {
    const Clock::time_point now = Clock::now();
    if (!ever_ || now < next_) return false;
    next_ = now - next_ < every_ ? next_ + every_ : now + every_;
    return true;
  }
  /// Nothing is due before this time has passed.
  void rest(Clock::duration time) { next_ = std::max(next_, Clock::now() + time); }

 private:
  Limiter(Clock::duration every, bool ever) : every_(every), ever_(ever) {}
  Clock::duration every_;
  bool ever_ = true;
  Clock::time_point next_{};
};

std::string_view name(coupling::RunEnd::Status status) {
  switch (status) {
    case coupling::RunEnd::Status::done:
      return "done";
    case coupling::RunEnd::Status::interrupted:
      return "interrupted";
    case coupling::RunEnd::Status::not_converged:
      return "not converged";
    case coupling::RunEnd::Status::non_finite:
      return "not finite";
  }
  return "";
}

}  // namespace

struct LiveSink::Impl {
  Impl(const coupling::LivePlan& plan, LiveRun run, Warn its_warn, std::shared_ptr<LiveBus> its_bus)
      : url(its_bus ? its_bus->url() : parse_live_url(plan.url, LiveSide::sender)),
        who{std::move(run.name), {}, std::move(run.version), std::move(run.case_hash), run.field, {}},
        until(run.until),
        warn(std::move(its_warn)),
        bus(std::move(its_bus)),
        frame_limit(Limiter::at_rate(plan.rate)),
        history_limit(Limiter::at_rate(plan.rate)),
        progress_limit(kProgressEvery) {}

  void pass_warning() {
    const auto warning = publisher->take_warning();
    if (warning && warn) warn(*warning);
  }
  [[nodiscard]] header_v1_t header(double time, std::int64_t& sequence) const {
    return publisher->header({time, step, stage, mesh}, sequence);
  }
  /// Offers the mesh of a frame, if it has changed: maps and displacements are relative to its start.
  void take_mesh(const coupling::FrameView& view) {
    if (view.mesh == nullptr || (mesh && mesh->id == std::int64_t{view.mesh->id})) return;
    mesh = std::make_shared<const LiveMesh>(LiveMesh::copy(*view.mesh, view.position));
    publisher->offer(mesh);
  }
  void set_end(double plan_end) { progress.end_time = until ? std::min(*until, plan_end) : plan_end; }
  void take_frame(const coupling::FrameView& view);
  /// Contacts, stress and bolts of a frame that was taken.   @param always  also when it is not due
  void take_detail(const coupling::FrameView& view, bool always);

  LiveUrl url;
  LiveIdentity who;
  std::optional<double> until;  // [s]
  Warn warn;
  std::shared_ptr<LiveBus> bus;
  Limiter frame_limit, history_limit, progress_limit;
  Limiter detail_limit{Limiter::Clock::duration::zero()};
  std::shared_ptr<const LiveMesh> mesh;
  std::vector<std::string> monitors, blocks;  // names
  LiveProgress progress;
  std::pair<double, const coupling::RunStats*> now{0.0, nullptr};  // after the last step
  std::int64_t step = 0;
  std::int32_t stage = 0;
  std::int64_t frames = 0, details = 0, histories = 0, ledgers = 0, events = 0;  // sequences
  std::optional<LiveHistory> last_history;                                       // newer than the one offered last
  RawFrame spare;                                                                // a buffer for the next frame
  std::unique_ptr<LivePublisher> publisher;                                      // last member: its thread ends first
};

void LiveSink::Impl::take_frame(const coupling::FrameView& view) {
  take_mesh(view);
  spare.mesh = mesh;
  spare.field = who.field;
  if (!mesh || view.position.size() != 2 * mesh->points() || !take_source(spare, view)) {
    publisher->skip_frame();  // a frame of another mesh, or without the data of its field
    return;
  }
  spare.header = header(view.time, frames);
  spare.position.assign(view.position.begin(), view.position.end());
  publisher->offer(spare);
}

void LiveSink::Impl::take_detail(const coupling::FrameView& view, bool always) {
  // A frame whose contact points were not computed would appear to have no contacts.
  const bool whole = view.contacts != nullptr || view.state == nullptr || view.state->contacts.empty();
  if (!mesh || !whole || !(always || detail_limit.due())) return;
  LiveDetail detail{header(view.time, details), live_detail(view, mesh->base)};
  detail_limit.rest(std::chrono::duration_cast<Limiter::Clock::duration>(
      std::chrono::duration<double>(size_of(detail.data) / kDetailRate)));
  publisher->offer(std::move(detail));
}

LiveSink::LiveSink(const coupling::LivePlan& plan, LiveRun run, Warn warn, std::shared_ptr<LiveBus> bus)
    : impl_(std::make_unique<Impl>(plan, std::move(run), std::move(warn), std::move(bus))) {
  impl_->publisher = std::make_unique<LivePublisher>(impl_->url, impl_->who, impl_->bus);
}

LiveSink::~LiveSink() = default;

void LiveSink::begin(const Model& model, const coupling::Plan& plan) {
  impl_->who.title = model.title;
  impl_->who.origin = {model.origin.x(), model.origin.y()};
  impl_->monitors.clear();
  impl_->blocks.clear();
  for (const Monitor& monitor : model.monitors) impl_->monitors.push_back(monitor.name);
  for (const Block& block : model.blocks) impl_->blocks.push_back(block.name);
  Tick end = 0;
  for (const coupling::Stage& stage : plan.stages) end += stage.duration;
  impl_->set_end(seconds(end));
  impl_->publisher = std::make_unique<LivePublisher>(impl_->url, impl_->who, impl_->bus);
  impl_->publisher->set_model(seal(live_model(model)));
  impl_->publisher->offer(impl_->progress);
  impl_->publisher->start();
}

void LiveSink::frame(const coupling::FrameView& frame) {
  impl_->pass_warning();
  impl_->step = frame.step;
  impl_->stage = frame.stage;
  LiveProgress& progress = impl_->progress;
  const bool new_stage = progress.stage_name != frame.stage_name;
  progress.time = frame.time;
  if (frame.end_time > 0.0) impl_->set_end(frame.end_time);
  progress.stage_name = frame.stage_name;
  progress.integrator = name(frame.integrator);
  if (frame.stats != nullptr) progress.stats = *frame.stats;
  if (new_stage) impl_->publisher->offer(progress);
  impl_->take_mesh(frame);  // also for a frame that is not sent
  if (impl_->frame_limit.due()) {
    const auto before = cpu_time();
    if (frame.state != nullptr) progress.contact = worst_contact(*frame.state, impl_->blocks);
    impl_->publisher->offer(progress);
    impl_->take_frame(frame);
    impl_->take_detail(frame, new_stage);
    impl_->frame_limit.rest(kShare * (cpu_time() - before));
  } else {
    impl_->publisher->skip_frame();
  }
}

void LiveSink::history(const coupling::HistoryView& history) {
  const std::size_t count = impl_->monitors.size();
  const bool due = impl_->history_limit.due();
  if (count > 0 && history.position.size() == 2 * count && history.displacement.size() == 2 * count &&
      history.velocity.size() == 2 * count) {
    const auto copied = [](std::span<const double> xy) { return std::vector<double>(xy.begin(), xy.end()); };
    LiveHistory now{impl_->header(history.time, impl_->histories), impl_->monitors, copied(history.position),
                    copied(history.displacement), copied(history.velocity)};
    if (due)
      impl_->publisher->offer(std::move(now));
    else
      impl_->last_history = std::move(now);  // sent if the run ends here
  }
  if (due) {
    impl_->last_history.reset();
    if (history.ledger != nullptr)
      impl_->publisher->offer(impl_->header(history.time, impl_->ledgers), *history.ledger);
  }
}

void LiveSink::event(const coupling::Event& event) {
  const bool milestone = !coupling::comes_often(coupling::name(event.kind));
  impl_->publisher->offer(encode_event(impl_->header(event.time, impl_->events), event), milestone);
}

void LiveSink::step(double time, const coupling::RunStats& stats, const coupling::Ledger&) {
  impl_->now = {time, &stats};
  if (!impl_->progress_limit.due()) return;
  impl_->pass_warning();
  impl_->step = stats.steps;
  impl_->progress.time = time;
  impl_->progress.stats = stats;
  impl_->publisher->offer(impl_->progress);
}

void LiveSink::end(const coupling::RunEnd& end, const coupling::FrameView& last) {
  impl_->progress.status = name(end.status);
  impl_->progress.reason = end.reason;
  impl_->progress.time = last.time;
  if (last.stats != nullptr) impl_->progress.stats = *last.stats;
  if (last.state != nullptr) impl_->progress.contact = worst_contact(*last.state, impl_->blocks);
  impl_->step = last.step;
  impl_->stage = last.stage;
  impl_->take_frame(last);
  impl_->take_detail(last, true);
  if (impl_->last_history) impl_->publisher->offer(std::move(*impl_->last_history));
  if (last.state != nullptr) impl_->publisher->offer(impl_->header(last.time, impl_->ledgers), last.state->ledger);
  impl_->publisher->offer(impl_->progress);  // last: viewers disconnect when the end is reported
  impl_->publisher->finish();
  impl_->pass_warning();
}

void LiveSink::set_rate(double rate) {
  impl_->frame_limit = Limiter::at_rate(rate);
  impl_->history_limit = Limiter::at_rate(rate);
}

void LiveSink::set_field(LiveField field) { impl_->who.field = field; }

void LiveSink::set_paused(bool paused) {
  LiveProgress& progress = impl_->progress;
  progress.status = paused ? "paused" : "running";
  if (impl_->now.second != nullptr) {
    progress.time = impl_->now.first;
    progress.stats = *impl_->now.second;
  }
  impl_->publisher->offer(progress);
}

std::int64_t LiveSink::session() const { return impl_->publisher->session(); }
std::int64_t LiveSink::frames_sent() const { return impl_->publisher->frames_sent(); }
std::int64_t LiveSink::frames_skipped() const { return impl_->publisher->frames_skipped(); }

}  // namespace scree::io
