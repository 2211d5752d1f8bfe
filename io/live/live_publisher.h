// The thread that encodes and sends. The run hands things over under a lock that is only ever held to swap buffers, so
// neither encoding nor the network can keep it waiting. It goes by the clock on the wall, whatever the run does
// meanwhile: during a step of a minute a viewer still hears that the run lives, and one that comes then sees it all.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "coupling/sink.h"
#include "io/live/channel.h"
#include "io/live/live_bus.h"
#include "io/live/live_data.h"
#include "io/live/live_detail.h"
#include "io/live/live_field.h"
#include "io/live/wire.h"
#include "io/results/worst_contact.h"

namespace scree::io {

/// Where a run is as something is sent of it.
struct LivePlace {
  double time = 0.0;  // simulated [s]
  std::int64_t step = 0;
  std::int32_t stage = 0;
  std::shared_ptr<const LiveMesh> mesh;
};

/// Where the run is, for INFO.
struct LiveProgress {
  double time = 0.0, end_time = 0.0;  // simulated [s]
  std::string stage_name, integrator;
  std::string status = "running", reason;
  coupling::RunStats stats;
  WorstContact contact;
};

/// What one INFO repeats from the start of the run.
struct LiveIdentity {
  std::string run, title, version, case_hash;
  LiveField field = LiveField::speed;      // until a frame has another one
  std::array<double, 2> origin{0.0, 0.0};  // of the model [m]
};

class LivePublisher {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMaxEvents = 1000;  // waiting; more are counted as lost
  static constexpr auto kInfoEvery = std::chrono::seconds(1);
  /// TOPO, and with it the newest STATE, HIST, ENERGY and events, for late viewers: well below the two seconds that
  /// such a viewer may wait, since it also takes time to open its connection. A mesh that takes longer than a quarter
  /// of this to send (7 MB, 200,000 points) comes more seldom: it leaves three quarters of the time to frames.
  static constexpr auto kKeyframeEvery = std::chrono::milliseconds(1000);
  static constexpr std::size_t kEventsAgain = 10;  // newest ones of each weight in every keyframe
  static constexpr auto kRetryAfter = std::chrono::seconds(5);
  static constexpr auto kPace = std::chrono::milliseconds(2);  // between large messages on a network

  /// @param bus  a connection of that URL to use; null: one is opened, and again after failures
  LivePublisher(LiveUrl url, LiveIdentity identity, std::shared_ptr<LiveBus> bus);
  /// Sends what is waiting and ends the thread.
  ~LivePublisher() { finish(); }
  LivePublisher(const LivePublisher&) = delete;
  LivePublisher& operator=(const LivePublisher&) = delete;
  /// What MODEL carries.   @param model  an encoded model_v1_t   @pre before start()
  void set_model(Bytes model) { model_ = std::move(model); }
  void start();
  void finish();

  /// Each replaces what is still waiting of its kind.
  void offer(std::shared_ptr<const LiveMesh> mesh);
  void offer(RawFrame& frame);  // swapped: `frame` comes back with a buffer to use again
  void offer(LiveDetail detail);
  void offer(LiveHistory history);
  void offer(const header_v1_t& header, const coupling::Ledger& ledger);
  void offer_energy(Bytes energy);  // an energy_v1_t
  /// Goes out with the next INFO; with one at once when the status is another one.
  void offer(LiveProgress progress);
  /// Events queue up.
  /// @param milestone  one of few, such as a stage: cuts and transfers by the hundred do not crowd it out of the
  /// keyframes
  void offer(Bytes event, bool milestone);

  /// The one warning of this publisher, once, when there is one: why nothing can be sent.
  [[nodiscard]] std::optional<std::string> take_warning();

  /// Header of the next message of its kind.   @param sequence  of the kind; counted on
  [[nodiscard]] header_v1_t header(const LivePlace& at, std::int64_t& sequence) const;
  [[nodiscard]] std::int64_t session() const { return session_; }
  [[nodiscard]] std::int64_t frames_sent() const { return frames_sent_; }
  [[nodiscard]] std::int64_t frames_skipped() const { return frames_skipped_; }
  [[nodiscard]] std::int64_t events_lost() const { return events_lost_; }
  void skip_frame() { ++frames_skipped_; }
  /// True while nothing but progress is waiting to be sent.
  [[nodiscard]] bool idle();

 private:
  struct Event {
    Bytes bytes;
    bool milestone = false;
  };
  struct Waiting {
    std::shared_ptr<const LiveMesh> mesh;
    RawFrame frame;
    bool has_frame = false;
    std::optional<LiveDetail> detail;
    std::optional<LiveHistory> history;
    std::optional<Bytes> energy;
    std::vector<Event> events;
    LiveProgress progress;
    bool last = false;
  };

  void run();
  void send_all(Waiting& work);
  void send_topology();
  void send_again();
  void send_info(const LiveProgress& progress);
  void send(LiveKind kind, const Bytes& bytes);
  [[nodiscard]] bool connected();
  void complain(const std::string& why);
  [[nodiscard]] header_v1_t header_now(std::int64_t& sequence) const;

  const std::int64_t session_;
  const LiveUrl url_;
  const LiveIdentity identity_;

  std::mutex mutex_;
  std::condition_variable wake_;
  Waiting waiting_;      // guarded
  bool fresh_ = false;   // guarded
  std::string warning_;  // guarded
  std::atomic<bool> has_warning_ = false, stopped_ = false;
  std::atomic<std::int64_t> frames_sent_ = 0, frames_skipped_ = 0, events_lost_ = 0;

  // Of the thread alone.
  std::shared_ptr<LiveBus> bus_;
  bool gave_up_ = false, complained_ = false;
  std::shared_ptr<const LiveMesh> mesh_;
  Bytes encoded_mesh_;
  Bytes model_;
  std::vector<Bytes> last_frame_, last_detail_, last_history_;  // messages, to be sent again
  Bytes last_energy_;
  std::deque<Bytes> last_events_, last_milestones_;
  header_v1_t now_{};                     // of the newest thing sent
  std::string info_stage_, info_status_;  // that the last INFO named
  LiveField field_;                       // of the newest frame sent
  std::int64_t topology_sequence_ = 0, info_sequence_ = 0;
  Clock::time_point retry_at_{}, info_at_{}, keyframe_at_{}, large_at_{};
  Clock::time_point rate_from_{};
  double rate_time_ = 0.0, simulated_per_wall_ = 0.0, steps_per_second_ = 0.0;
  double steady_rate_ = 0.0;  // simulated_per_wall_ smoothed over a few seconds
  std::int64_t rate_steps_ = 0;
  std::thread thread_;
};

}  // namespace scree::io
