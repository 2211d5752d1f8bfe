#include "io/live/control_client.h"

#include <algorithm>
#include <optional>
#include <random>
#include <scree/info_v1_t.hpp>
#include <utility>

#include "io/live/channel.h"
#include "io/live/signals_blocked.h"

namespace scree::io {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto kAgain = 500ms;  // interval after which a command is sent again: datagrams may be lost

std::int64_t new_sender() {
  std::random_device random;
  return static_cast<std::int64_t>(std::uint64_t{random()} << 31U | random() >> 1U);
}

}  // namespace

struct ControlClient::Impl {
  std::shared_ptr<LiveBus> bus;
  bool listening = false;
  std::int64_t sender = 0, sequence = 0;
  std::int64_t clock_of_run = 0;     // minus our clock [us]; sequence numbers use the clock of the run
  std::string run;                   // name of the run whose answers count
  std::vector<ack_v1_t> answers;     // to our commands, not evaluated yet
  std::vector<std::string> streams;  // runs whose INFO was received

  void take(std::string_view channel, std::span<const std::uint8_t> bytes) {
    if (channel_kind(channel) == LiveKind::ack) {
      if (channel != channel_name(run, LiveKind::ack)) return;
      std::optional<ack_v1_t> ack = unseal<ack_v1_t>(bytes);
      if (ack && ack->sender == sender) answers.push_back(std::move(*ack));
    } else if (const auto info = unseal<info_v1_t>(bytes)) {
      const std::string name = channel_run(info->run);
      if (std::find(streams.begin(), streams.end(), name) == streams.end()) streams.push_back(name);
    }
  }
  std::int64_t send(std::int64_t session, ControlVerb verb, double value) {
    sequence = std::max(sequence + 1, utime_now() + clock_of_run);
    const Bytes bytes = encode_command(session, {verb, value, sequence, sender});
    (void)bus->publish(channel_name(run, LiveKind::ctrl), bytes);
    return sequence;
  }
  /// Handles messages until `done` returns true, at most until the time `most`.
  template <class Done>
  bool wait(Clock::time_point most, Done&& done) {
    while (!done()) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(most - Clock::now());
      if (left <= 0ms || bus->handle(static_cast<int>(left.count())) == LiveBus::Got::end) return done();
    }
    return true;
  }
};

Bytes encode_command(std::int64_t session, const ControlCommand& command) {
  ctrl_v1_t out{};
  out.header.utime = utime_now();
  out.header.session = session;
  out.header.topology_id = -1;
  out.header.sequence = command.sequence;
  out.sender = command.sender;
  out.command = name(command.verb);
  out.value = command.value;
  return seal(out);
}

ControlClient::ControlClient(std::shared_ptr<LiveBus> bus) : impl_(std::make_unique<Impl>()) {
  impl_->bus = std::move(bus);
  impl_->sender = new_sender();
  const SignalsBlocked inherited_by_the_threads;
  const auto take = [impl = impl_.get()](std::string_view channel, std::span<const std::uint8_t> bytes) {
    impl->take(channel, bytes);
  };
  impl_->listening = impl_->bus->subscribe("SCREE_[A-Za-z0-9_-]+_(ACK|INFO)", take);
}

ControlClient::~ControlClient() { impl_->bus->unsubscribe(); }

std::unique_ptr<ControlClient> ControlClient::open(const std::string& url, std::string& why) {
  std::shared_ptr<LiveBus> bus = LiveBus::open(url, LiveSide::receiver, why);
  if (!bus) return nullptr;
  auto client = std::make_unique<ControlClient>(std::move(bus));
  if (client->impl_->listening) return client;
  why = "cannot listen on " + url;
  return nullptr;
}

std::vector<std::string> ControlClient::heard(std::chrono::milliseconds time) {
  impl_->streams.clear();
  impl_->wait(Clock::now() + time, [] { return false; });
  return impl_->streams;
}

ControlReply ControlClient::ask(const std::string& run, ControlVerb verb, double value, std::chrono::milliseconds most,
                                const std::function<void()>& accepted) {
  Impl& impl = *impl_;
  impl.run = channel_run(run);
  impl.clock_of_run = 0;
  impl.answers.clear();
  const Clock::time_point end = Clock::now() + most;
  ControlReply reply;
  // Determine the session: of several runs of one name, the one that started last.
  std::optional<std::int64_t> session;
  const auto look = [&] {
    for (const ack_v1_t& a : impl.answers)
      if (a.command == name(ControlVerb::who) && (!session || a.header.session > *session)) {
        session = a.header.session;
        impl.clock_of_run = a.header.utime - utime_now();
        reply = {ControlReply::Kind::answered, a};
      }
    return session.has_value();
  };
  while (!session && Clock::now() < end) {
    impl.send(0, ControlVerb::who, 0.0);
    impl.wait(std::min(end, Clock::now() + kAgain), look);
  }
  if (!session) return reply;
  impl.wait(std::min(end, Clock::now() + 50ms), [] { return false; });  // answers of other runs of the same name
  look();
  if (verb == ControlVerb::who) return reply;

  reply.kind = ControlReply::Kind::silence;
  impl.answers.clear();
  impl.sender = new_sender();  // a new sender name, whose share of commands is not used up
  const std::int64_t number = impl.send(*session, verb, value);
  const Bytes again = encode_command(*session, {verb, value, number, impl.sender});
  bool told = false;
  const auto ended = [&] {
    for (const ack_v1_t& a : impl.answers) {
      if (a.header.sequence != number || a.header.session != *session || a.command != name(verb)) continue;
      const bool is_last = a.result != "accepted";
      reply = {is_last ? ControlReply::Kind::answered : ControlReply::Kind::no_end, a};
      if (!is_last && !std::exchange(told, true) && accepted) accepted();
      if (is_last) return true;
    }
    impl.answers.clear();
    return false;
  };
  // An answer may be lost as well: when the command is sent again, the run repeats the result.
  while (!impl.wait(std::min(end, Clock::now() + kAgain), ended) && Clock::now() < end)
    (void)impl.bus->publish(channel_name(impl.run, LiveKind::ctrl), again);
  return reply;
}

}  // namespace scree::io
