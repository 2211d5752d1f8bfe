#include "io/live/live_reader.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "io/live/channel.h"
#include "io/live/signals_blocked.h"

namespace scree::io {

struct LiveReader::Impl {
  explicit Impl(std::shared_ptr<LiveBus> its_bus) : bus(std::move(its_bus)) {}

  void take(std::string_view channel, std::span<const std::uint8_t> bytes) {
    {
      const std::lock_guard lock(mutex);
      assembly.take(channel, bytes);
    }
    news.notify_all();
  }
  void drain() {
    constexpr int kLook = 50;  // interval between tests of `stop` [ms]
    while (!stop && bus->handle(kLook) != LiveBus::Got::end) {
    }
    const std::lock_guard lock(mutex);
    ended = true;
    news.notify_all();
  }

  std::shared_ptr<LiveBus> bus;
  mutable std::mutex mutex;
  std::condition_variable news;
  LiveAssembly assembly;  // guarded
  bool ended = false;     // guarded
  std::atomic<bool> stop = false;
  std::thread thread;
};

LiveReader::LiveReader(std::shared_ptr<LiveBus> bus, const std::string& run)
    : impl_(std::make_unique<Impl>(std::move(bus))) {
  Impl* impl = impl_.get();
  const SignalsBlocked inherited_by_the_threads;  // also the library's: a signal would end its wait with an error
  const bool listening = impl->bus->subscribe(
      channel_pattern(run),
      [impl](std::string_view channel, std::span<const std::uint8_t> bytes) { impl->take(channel, bytes); });
  impl->ended = !listening;
  if (listening) impl->thread = std::thread([impl] { impl->drain(); });
}

std::unique_ptr<LiveReader> LiveReader::open(const std::string& url, const std::string& run, std::string& why) {
  std::shared_ptr<LiveBus> bus = LiveBus::open(url, LiveSide::receiver, why);
  if (!bus) return nullptr;
  auto reader = std::make_unique<LiveReader>(std::move(bus), run);
  if (!reader->impl_->thread.joinable()) {
    why = "LCM cannot listen on " + url;
    return nullptr;
  }
  return reader;
}

LiveReader::~LiveReader() {
  impl_->stop = true;
  if (impl_->thread.joinable()) impl_->thread.join();
  impl_->bus->unsubscribe();  // the bus may be shared with a sink and still be used
}

std::optional<info_v1_t> LiveReader::info() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->assembly.info();
}

std::optional<energy_v1_t> LiveReader::energy() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->assembly.energy();
}

std::shared_ptr<const LiveHistory> LiveReader::history() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->assembly.history();
}

std::shared_ptr<const LiveMesh> LiveReader::mesh() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->assembly.mesh();
}

std::shared_ptr<const LiveFrame> LiveReader::frame() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->assembly.frame();
}

std::shared_ptr<const model_v1_t> LiveReader::model() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->assembly.model();
}

std::shared_ptr<const LiveDetail> LiveReader::detail() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->assembly.detail();
}

std::vector<event_v1_t> LiveReader::take_events() {
  const std::lock_guard lock(impl_->mutex);
  return impl_->assembly.take_events();
}

LiveCounts LiveReader::counts() const {
  const UdpCounts udp = impl_->bus->udp_counts();
  const std::lock_guard lock(impl_->mutex);
  LiveCounts counts = impl_->assembly.counts();
  counts.messages += udp.garbage;
  counts.malformed += udp.garbage;
  return counts;
}

bool LiveReader::ended() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->ended;
}

bool LiveReader::wait(std::chrono::milliseconds most, const std::function<bool(const LiveAssembly&)>& enough) {
  std::unique_lock lock(impl_->mutex);
  impl_->news.wait_for(lock, most, [&] { return impl_->ended || enough(impl_->assembly); });
  return enough(impl_->assembly);
}

}  // namespace scree::io
