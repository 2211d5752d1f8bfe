#include "io/live/control_server.h"

#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "io/live/channel.h"
#include "io/live/signals_blocked.h"

namespace scree::io {
namespace {

using namespace std::chrono_literals;

double clock_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

constexpr std::size_t kMaxWaiting = 1000;  // commands that may wait during a long step

}  // namespace

struct ControlServer::Impl {
  Impl(std::string its_url, std::string its_run, coupling::Control& its_inner, ControlHooks its_hooks,
       std::shared_ptr<LiveBus> its_bus)
      : url(std::move(its_url)),
        run(std::move(its_run)),
        inner(its_inner),
        hooks(std::move(its_hooks)),
        bus(std::move(its_bus)) {}

  // --- used by the receiving thread
  void serve();
  void receive(std::span<const std::uint8_t> bytes);
  void send(const ControlAnswer& answer);
  void send_outbox();
  [[nodiscard]] bool connected();

  // --- used by the run
  void carry_out(const ControlCommand& command);
  void answer(const ControlCommand& command, std::string result, std::string reason);
  void set_paused(bool now);
  void pass_warning();

  const std::string url, run;
  coupling::Control& inner;
  const ControlHooks hooks;

  std::mutex mutex;
  std::condition_variable news;
  std::unique_ptr<ControlGate> gate;   // guarded
  std::deque<ControlCommand> waiting;  // guarded
  std::vector<ControlAnswer> outbox;   // guarded
  header_v1_t at{};                    // guarded: time, step and stage of the run
  std::string state = "running";       // guarded
  std::string warning;                 // guarded
  bool last = false;                   // guarded: answer the waiting commands, then end

  // Used by the run only.
  bool paused = false, stopping = false;
  std::int64_t steps_left = 0;  // to be made for `stepping`
  std::optional<ControlCommand> stepping;
  std::int64_t carried_out = 0;

  // Used by the thread only.
  std::shared_ptr<LiveBus> bus;
  bool subscribed = false, complained = false;
  std::chrono::steady_clock::time_point retry_at{};
  std::thread thread;
};

std::string control_url_error(std::string_view url) {
  if (const auto wrong = check_live_url(url, LiveSide::sender)) return *wrong;
  if (parse_live_url(url, LiveSide::sender).kind != LiveUrl::Kind::udpm)
    return "commands come over udpm:// only: nothing can be received from a log or a queue of this program";
  return {};
}

ControlServer::ControlServer(const std::string& url, std::string run, coupling::Control& inner, ControlHooks hooks,
                             std::shared_ptr<LiveBus> bus)
    : impl_(std::make_unique<Impl>(url, std::move(run), inner, std::move(hooks), std::move(bus))) {
  if (impl_->bus) return;
  if (const std::string wrong = control_url_error(url); !wrong.empty()) throw std::invalid_argument(wrong);
}

ControlServer::~ControlServer() {
  if (!impl_->thread.joinable()) return;
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->last = true;
  }
  impl_->thread.join();
}

// --- the thread ---------------------------------------------------------------------------------------------------

bool ControlServer::Impl::connected() {
  if (subscribed) return true;
  if (std::chrono::steady_clock::now() < retry_at) return false;
  retry_at = std::chrono::steady_clock::now() + 5s;
  std::string why;
  if (!bus) bus = LiveBus::open(url, LiveSide::sender, why);
  subscribed = bus != nullptr &&
               bus->subscribe(channel_name(run, LiveKind::ctrl),
                              [this](std::string_view, std::span<const std::uint8_t> bytes) { receive(bytes); });
  if (!subscribed && !std::exchange(complained, true)) {
    if (why.empty()) why = "cannot listen on " + url;
    const std::lock_guard lock(mutex);
    warning = fmt::format("control over {} is off: {}; the run goes on", url, why);
  }
  return subscribed;
}

void ControlServer::Impl::serve() {
  for (;;) {
    bool end = false;
    {
      const std::lock_guard lock(mutex);
      end = last;
    }
    if (connected()) {
      send_outbox();
      if (end) {
        // Commands received at the last moment are answered: too late.
        for (std::size_t i = 0; i < kMaxWaiting && bus->handle(0) == LiveBus::Got::message; ++i) {
        }
        break;
      }
      // 10 ms: also the longest delay of an answer of the run.
      if (bus->handle(10) == LiveBus::Got::end) break;
    } else {
      if (end) break;
      std::this_thread::sleep_for(20ms);
    }
  }
  if (bus) bus->unsubscribe();
}

void ControlServer::Impl::receive(std::span<const std::uint8_t> bytes) {
  std::optional<ControlAnswer> now;
  {
    const std::lock_guard lock(mutex);
    ControlGate::Verdict verdict = gate->take(bytes, utime_now(), clock_now());
    now = std::move(verdict.answer);
    if (verdict.command) {
      const bool ended = state == "ended";
      if (!ended && waiting.size() < kMaxWaiting) {
        waiting.push_back(*verdict.command);
      } else {
        now = ControlAnswer{*verdict.command, "refused",
                            ended ? "the run has ended" : fmt::format("{} commands are waiting", kMaxWaiting)};
        gate->remember(*now);
      }
    }
  }
  news.notify_all();
  if (now) send(*now);
}

void ControlServer::Impl::send(const ControlAnswer& answer) {
  ack_v1_t ack{};
  {
    const std::lock_guard lock(mutex);
    ack.header = at;
    ack.state = state;
  }
  ack.header.utime = utime_now();
  ack.header.sequence = answer.command.sequence;
  ack.sender = answer.command.sender;
  ack.command = name(answer.command.verb);
  ack.result = answer.result;
  ack.reason = wire_text(answer.reason, 2000);
  (void)bus->publish(channel_name(run, LiveKind::ack), seal(ack));  // a lost answer is requested again by the sender
}

void ControlServer::Impl::send_outbox() {
  std::vector<ControlAnswer> out;
  {
    const std::lock_guard lock(mutex);
    std::swap(out, outbox);
  }
  for (const ControlAnswer& a : out) send(a);
}

// --- called by the run --------------------------------------------------------------------------------------------

void ControlServer::Impl::answer(const ControlCommand& command, std::string result, std::string reason) {
  if (hooks.note)
    hooks.note(fmt::format("control: {}{}: {}{}", name(command.verb),
                           command.value != 0.0 ? fmt::format(" {:g}", command.value) : "", result,
                           reason.empty() ? "" : ", " + reason));
  const std::lock_guard lock(mutex);
  if (result == "done") ++carried_out;
  outbox.push_back({command, std::move(result), std::move(reason)});
  gate->remember(outbox.back());
}

void ControlServer::Impl::set_paused(bool now) {
  if (paused == now) return;
  paused = now;
  {
    const std::lock_guard lock(mutex);
    state = paused ? "paused" : "running";
  }
  if (hooks.on_pause) hooks.on_pause(paused);
}

void ControlServer::Impl::carry_out(const ControlCommand& command) {
  const auto give_up_stepping = [this](const char* why) {
    if (!stepping) return;
    const std::int64_t left = std::exchange(steps_left, 0);
    answer(*std::exchange(stepping, std::nullopt), "refused", fmt::format("{}, {} steps before its end", why, left));
  };
  switch (command.verb) {
    case ControlVerb::who:
      return;  // the gate answers it
    case ControlVerb::pause:
      give_up_stepping("paused");
      set_paused(true);
      break;
    case ControlVerb::resume:
      give_up_stepping("resumed");
      set_paused(false);
      break;
    case ControlVerb::step:
      give_up_stepping("another one came");
      stepping = command;
      steps_left = static_cast<std::int64_t>(command.value);
      set_paused(false);
      return;  // answered when the steps are made
    case ControlVerb::rate:
      if (!hooks.on_rate) return answer(command, "not available", "this run streams nothing");
      hooks.on_rate(command.value);
      break;
    case ControlVerb::field:
      if (!hooks.on_field) return answer(command, "not available", "this run streams nothing");
      hooks.on_field(live_field(command.value).value_or(LiveField::speed));  // the gate accepts no other number
      break;
    case ControlVerb::checkpoint:
      if (!hooks.on_checkpoint) return answer(command, "not available", "this version writes no checkpoints");
      try {
        const std::string written = hooks.on_checkpoint();
        return answer(command, "done", written);
      } catch (const std::exception& error) {
        return answer(command, "failed", error.what());
      }
    case ControlVerb::stop:
      give_up_stepping("stopped");
      set_paused(false);
      stopping = true;
      break;
  }
  answer(command, "done", {});
}

void ControlServer::Impl::pass_warning() {
  std::string text;
  {
    const std::lock_guard lock(mutex);
    std::swap(text, warning);
  }
  if (!text.empty() && hooks.warn) hooks.warn(text);
}

void ControlServer::begin(const Model&, const coupling::Plan&) {
  Impl& impl = *impl_;
  if (impl.thread.joinable()) return;
  impl.at.session = impl.hooks.session ? impl.hooks.session() : 0;
  impl.at.topology_id = -1;
  impl.gate = std::make_unique<ControlGate>(impl.at.session);
  const SignalsBlocked inherited_by_the_thread;
  impl.thread = std::thread([&impl] { impl.serve(); });
}

void ControlServer::frame(const coupling::FrameView& frame) {
  const std::lock_guard lock(impl_->mutex);
  impl_->at.stage = frame.stage;
  impl_->at.step = frame.step;
  impl_->at.time = frame.time;
}

void ControlServer::step(double time, const coupling::RunStats& stats, const coupling::Ledger&) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->at.step = stats.steps;
    impl_->at.time = time;
  }
  if (impl_->stepping && --impl_->steps_left == 0) {
    impl_->set_paused(true);
    impl_->answer(*std::exchange(impl_->stepping, std::nullopt), "done", {});
  }
}

bool ControlServer::stop_requested() {
  Impl& impl = *impl_;
  impl.pass_warning();
  for (;;) {
    if (impl.inner.stop_requested() || impl.stopping) return true;
    std::optional<ControlCommand> next;
    {
      std::unique_lock lock(impl.mutex);
      if (impl.paused && impl.waiting.empty()) impl.news.wait_for(lock, 50ms);  // then check for signals again
      if (!impl.waiting.empty()) {
        next = impl.waiting.front();
        impl.waiting.pop_front();
      }
    }
    if (next)
      impl.carry_out(*next);
    else if (!impl.paused)
      return false;
  }
}

void ControlServer::end(const coupling::RunEnd&, const coupling::FrameView& last) {
  Impl& impl = *impl_;
  if (!impl.gate) return;
  frame(last);
  std::deque<ControlCommand> waiting;
  {
    const std::lock_guard lock(impl.mutex);
    impl.state = "ended";
    std::swap(waiting, impl.waiting);
  }
  if (impl.stepping) impl.answer(*std::exchange(impl.stepping, std::nullopt), "refused", "the run ended before");
  for (const ControlCommand& command : waiting) impl.answer(command, "refused", "the run has ended");
  impl.pass_warning();
  if (impl.thread.joinable()) {
    {
      const std::lock_guard lock(impl.mutex);
      impl.last = true;
    }
    impl.thread.join();
  }
  const ControlCounts c = counts();
  if (c.received > 0 && impl.hooks.note)
    impl.hooks.note(
        fmt::format("control: {} messages, {} carried out, {} malformed, {} of other sessions, {} not new, "
                    "{} too frequent",
                    c.received, impl.carried_out, c.malformed, c.other_session, c.replayed, c.too_frequent));
}

ControlCounts ControlServer::counts() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->gate ? impl_->gate->counts() : ControlCounts{};
}

}  // namespace scree::io
