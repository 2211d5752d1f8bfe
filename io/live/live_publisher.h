// The thread that encodes and sends. The run passes data to it under a lock that is held only to swap buffers, so
// neither encoding nor the network can delay the run. The thread works by wall time, independent of the steps of the
// run: during a step of a minute a viewer still receives INFO, and a viewer that starts then receives all data.
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

/// Time, step, stage and mesh of the run for the header of a message.
struct LivePlace {
  double time = 0.0;  // simulated [s]
  std::int64_t step = 0;
  std::int32_t stage = 0;
  std::shared_ptr<const LiveMesh> mesh;
};

/// Progress of the run, for INFO.
struct LiveProgress {
  double time = 0.0, end_time = 0.0;  // simulated [s]
  std::string stage_name, integrator;
  std::string status = "running", reason;
  coupling::RunStats stats;
  WorstContact contact;
};

/// Data that every INFO repeats from the start of the run.
struct LiveIdentity {
  std::string run, title, version, case_hash;
  LiveField field = LiveField::speed;      // until a frame has another field
  std::array<double, 2> origin{0.0, 0.0};  // of the model [m]
};

class LivePublisher {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMaxEvents = 1000;  // waiting; more are counted as lost
  static constexpr auto kInfoEvery = std::chrono::seconds(1);
  /// Interval of TOPO, and with it the newest STATE, HIST, ENERGY and events, for late viewers. It is well below the
  /// two seconds that such a viewer may wait, since opening its connection also takes time. A mesh whose sending takes
  /// longer than a quarter of this (7 MB, 200,000 points) is sent less often: three quarters of the time are left for
  /// frames.
  static constexpr auto kKeyframeEvery = std::chrono::milliseconds(1000);
  static constexpr std::size_t kEventsAgain = 10;  // number of milestones and of other events in every keyframe
  static constexpr auto kRetryAfter = std::chrono::seconds(5);
  static constexpr auto kPace = std::chrono::milliseconds(2);  // between large messages on a network

  /// @param bus  connection of that URL to use; null: one is opened, and opened again after failures
  LivePublisher(LiveUrl url, LiveIdentity identity, std::shared_ptr<LiveBus> bus);
  /// Sends the waiting data and ends the thread.
  ~LivePublisher() { finish(); }
  LivePublisher(const LivePublisher&) = delete;
  LivePublisher& operator=(const LivePublisher&) = delete;
  /// Sets the content of MODEL.   @param model  an encoded model_v1_t   @pre before start()
  void set_model(Bytes model) { model_ = std::move(model); }
  void start();
  void finish();

  /// Each call replaces the waiting data of its kind.
  void offer(std::shared_ptr<const LiveMesh> mesh);
  void offer(RawFrame& frame);  // swapped: `frame` returns with a buffer for reuse
  void offer(LiveDetail detail);
  void offer(LiveHistory history);
  void offer(const header_v1_t& header, const coupling::Ledger& ledger);
  void offer_energy(Bytes energy);  // an energy_v1_t
  /// Is sent with the next INFO; immediately if the status has changed.
  void offer(LiveProgress progress);
  /// Adds an event to a queue.
  /// @param milestone  a rare event, such as a stage: hundreds of cuts and transfers do not displace it from the
  /// keyframes
  void offer(Bytes event, bool milestone);

  /// The only warning of this publisher, returned once: the reason why nothing can be sent.
  [[nodiscard]] std::optional<std::string> take_warning();

  /// Header of the next message of a kind.   @param sequence  number of the kind; incremented
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

  // Used by the thread only.
  std::shared_ptr<LiveBus> bus_;
  bool gave_up_ = false, complained_ = false;
  std::shared_ptr<const LiveMesh> mesh_;
  Bytes encoded_mesh_;
  Bytes model_;
  std::vector<Bytes> last_frame_, last_detail_, last_history_;  // messages that are sent again
  Bytes last_energy_;
  std::deque<Bytes> last_events_, last_milestones_;
  header_v1_t now_{};                     // of the newest thing sent
  std::string info_stage_, info_status_;  // of the last INFO
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
