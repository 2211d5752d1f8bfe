#include "io/serve/control_bridge.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "io/live/control_client.h"
#include "io/live/live_field.h"
#include "io/live/signals_blocked.h"
#include "io/serve/live_messages.h"

namespace scree::io {
namespace {

constexpr auto kMost = std::chrono::milliseconds(3000);  // for the answer of a run; can delay the end of the server

struct Command {
  std::string run, text;
  ControlVerb verb = ControlVerb::who;
  double value = 0.0;
};

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t end = text.find(' ');
    words.emplace_back(text.substr(0, end));
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  return words;
}

/// Takes the same time for every text of this length.
bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference |= static_cast<unsigned>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  return difference == 0;
}

/// @param words  without the token   @return empty: they are no command
std::optional<Command> command_of(const std::vector<std::string>& words) {
  if (words.empty() || words.size() > 2) return {};
  const std::optional<ControlVerb> verb = control_verb(words[0]);
  if (!verb || *verb == ControlVerb::who) return {};
  Command out;
  out.verb = *verb;
  out.text = words[0] + (words.size() == 2 ? " " + words[1] : "");
  if (*verb == ControlVerb::field) {
    const auto field = words.size() == 2 ? live_field(words[1]) : std::nullopt;
    if (!field) return {};
    out.value = static_cast<double>(*field);
    return out;
  }
  if (words.size() == 2) {
    char* end = nullptr;
    out.value = std::strtod(words[1].c_str(), &end);
    if (words[1].empty() || *end != '\0') return {};
  } else if (*verb == ControlVerb::step) {
    out.value = 1.0;
  } else if (*verb == ControlVerb::rate) {
    return {};  // 0 would be a rate too
  }
  if (!control_value_error(*verb, out.value).empty()) return {};
  return out;
}

}  // namespace

std::string new_token() {
  std::random_device random;  // of the system (getrandom)
  std::string out;
  for (int word = 0; word < 4; ++word) {
    const unsigned bits = random();
    for (unsigned digit = 0; digit < 8; ++digit) out += "0123456789abcdef"[bits >> 4U * digit & 15U];
  }
  return out;
}

struct ControlBridge::Impl {
  void work() {
    std::unique_lock lock(mutex);
    for (;;) {
      news.wait(lock, [this] { return last || !waiting.empty(); });
      if (last) return;
      const Command command = std::move(waiting.front());
      waiting.pop_front();
      lock.unlock();
      SharedBytes told = ask(command);
      lock.lock();
      newest = std::move(told);
    }
  }

  SharedBytes ask(const Command& command) {
    const auto failed = [&](const std::string& why) { return answer_message(command.text, "failed", why, ""); };
    if (command.run.empty()) return failed("no run is heard yet");
    std::string why;
    if (!client) client = ControlClient::open(url, why);
    if (!client) return failed(why);
    const ControlReply reply = client->ask(command.run, command.verb, command.value, kMost);
    switch (reply.kind) {
      case ControlReply::Kind::silence:
        return failed("the run does not answer; it takes commands if it was started with --live --control");
      case ControlReply::Kind::no_end:
        return answer_message(command.text, "accepted", "not carried out yet", reply.ack.state);
      case ControlReply::Kind::answered:
        break;
    }
    return answer_message(command.text, reply.ack.result, reply.ack.reason, reply.ack.state);
  }

  std::string url, token;
  std::unique_ptr<ControlClient> client;  // of the thread
  std::mutex mutex;
  std::condition_variable news;
  std::deque<Command> waiting;        // guarded
  std::optional<SharedBytes> newest;  // guarded
  bool last = false;                  // guarded
  std::thread thread;
};

ControlBridge::ControlBridge(std::string url, std::string token) : impl_(std::make_unique<Impl>()) {
  impl_->url = std::move(url);
  impl_->token = std::move(token);
  const SignalsBlocked inherited_by_the_thread;
  impl_->thread = std::thread([impl = impl_.get()] { impl->work(); });
}

ControlBridge::~ControlBridge() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->last = true;
  }
  impl_->news.notify_one();
  impl_->thread.join();
}

bool ControlBridge::take(std::string_view text, const std::string& run) {
  const std::size_t end = text.find(' ');
  if (end == std::string_view::npos || !same(text.substr(0, end), impl_->token)) return false;
  std::optional<Command> command = command_of(words_of(text.substr(end + 1)));
  if (!command) return false;
  command->run = run;
  {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->waiting.size() < kMostWaiting)
      impl_->waiting.push_back(std::move(*command));
    else
      impl_->newest = answer_message(command->text, "refused", "too many commands are waiting", "");
  }
  impl_->news.notify_one();
  return true;
}

std::optional<SharedBytes> ControlBridge::answer() {
  const std::lock_guard lock(impl_->mutex);
  return std::exchange(impl_->newest, std::nullopt);
}

}  // namespace scree::io
