// Assembles complete data from messages. Independent of networks and threads: the input is bytes.
#pragma once

#include <deque>
#include <optional>
#include <scree/energy_v1_t.hpp>
#include <scree/event_v1_t.hpp>
#include <scree/hist_v1_t.hpp>
#include <scree/info_v1_t.hpp>
#include <scree/model_v1_t.hpp>
#include <scree/state_v1_t.hpp>
#include <scree/topo_v1_t.hpp>
#include <set>

#include "io/live/affine_map.h"
#include "io/live/channel.h"
#include "io/live/live_data.h"
#include "io/live/live_detail.h"
#include "io/live/parts.h"
#include "io/live/wire.h"

namespace scree::io {

/// Numbers of messages and results.
struct LiveCounts {
  std::int64_t messages = 0;    // all received
  std::int64_t malformed = 0;   // wrong channel, size, CRC, type, length or range: dropped
  std::int64_t other = 0;       // of an earlier session: dropped
  std::int64_t early = 0;       // STATE before its mesh: dropped
  std::int64_t incomplete = 0;  // frames that a newer one replaced before all chunks had arrived
  std::int64_t frames = 0;      // complete frames
  std::int64_t events = 0;      // events, also those no longer kept
};

/// Follows one session, the latest that sends messages. A message of a later session deletes everything except the
/// counts. So does a message of an earlier session if the session followed has not ended but has sent nothing for
/// kSilence: a forged message must not block a viewer.
class LiveAssembly {
 public:
  static constexpr std::size_t kMaxMesh = std::size_t{1} << 28U;  // bytes of an encoded mesh; more is malformed
  static constexpr std::size_t kMaxEvents = 1000;                 // kept until taken; the oldest are dropped first

  static constexpr std::int64_t kAhead = 60'000'000;  // microseconds that the clocks of two machines may differ by

  static constexpr std::int64_t kSilence = 3'000'000;  // microseconds; INFO comes every second

  /// Takes one message; an invalid one is counted and dropped. A session that begins in the future is invalid, and also
  /// a sequence number that no run can have reached since it began: either would block all valid messages after it.
  /// @param utime  present time, microseconds since 1970   @return true if it was taken
  bool take(std::string_view channel, std::span<const std::uint8_t> bytes, std::int64_t utime = utime_now());

  /// The newest message or data of each kind; empty until there is one.
  [[nodiscard]] const std::optional<info_v1_t>& info() const { return info_; }
  [[nodiscard]] const std::optional<energy_v1_t>& energy() const { return energy_; }
  [[nodiscard]] std::shared_ptr<const LiveHistory> history() const { return history_; }
  [[nodiscard]] std::shared_ptr<const LiveMesh> mesh() const { return mesh_; }
  [[nodiscard]] std::shared_ptr<const LiveFrame> frame() const { return frame_; }
  [[nodiscard]] std::shared_ptr<const model_v1_t> model() const { return model_; }
  /// Detail of the present mesh.
  [[nodiscard]] std::shared_ptr<const LiveDetail> detail() const { return detail_; }
  /// Events since the last call, each once, in order of arrival.
  [[nodiscard]] std::vector<event_v1_t> take_events();
  [[nodiscard]] const LiveCounts& counts() const { return counts_; }

 private:
  enum class Verdict { taken, malformed, early };

  template <class Message>
  bool take_as(std::span<const std::uint8_t> bytes, std::int64_t utime) {
    return take_by<Message>(bytes, utime, [this](Message&& message) { return put(std::move(message)); });
  }
  template <class Message, class Put>
  bool take_by(std::span<const std::uint8_t> bytes, std::int64_t utime, const Put& put);
  Verdict put(info_v1_t&& message);
  Verdict put(topo_v1_t&& in);
  Verdict put(state_v1_t&& in);
  Verdict put_model(part_v1_t&& in);
  Verdict put_detail(part_v1_t&& in);
  Verdict put(hist_v1_t&& in);
  Verdict put(energy_v1_t&& message);
  Verdict put(event_v1_t&& message);
  void forget();

  /// An incomplete frame: maps of bodies, and displacements of the loose points.
  struct FrameParts {
    std::vector<std::int32_t> body;
    std::vector<AffineMap> map;
    std::vector<double> loose;  // x, y per point [m]
    std::vector<float> scalar;
  };
  /// Null when maps and loose points together are not the points of the mesh.
  [[nodiscard]] std::shared_ptr<const LiveFrame> decode(FrameParts&& parts, const header_v1_t& header) const;

  /// State of data of which some pieces are still missing.
  struct Pieces {
    std::int64_t key = -1;  // sequence or mesh
    std::vector<char> have;
    std::int32_t missing = 0;
    /// True for a new piece. A new key or another number of pieces starts again.
    bool add(std::int64_t its_key, std::int32_t piece, std::int32_t pieces);
  };

  std::int64_t session_ = -1, heard_ = 0;  // heard_: time of its last message
  std::optional<info_v1_t> info_;
  std::optional<energy_v1_t> energy_;
  std::deque<event_v1_t> events_;
  std::set<std::int64_t> events_known_;  // sequence numbers of the newest kMaxEvents
  std::int64_t events_floor_ = -1;       // this number and all below count as known
  std::shared_ptr<const LiveMesh> mesh_;
  std::shared_ptr<const LiveFrame> frame_;
  std::shared_ptr<const LiveHistory> history_;
  std::shared_ptr<const model_v1_t> model_;
  std::shared_ptr<const LiveDetail> detail_;
  PartAssembly model_parts_, detail_parts_;
  Pieces mesh_pieces_, frame_pieces_, history_pieces_;
  std::vector<Bytes> mesh_bytes_;  // one entry per piece
  std::unique_ptr<FrameParts> next_frame_;
  std::shared_ptr<LiveHistory> next_history_;
  LiveCounts counts_;
};

/// Decodes an encoded mesh and checks every index in it; empty when anything is wrong.
[[nodiscard]] std::optional<LiveMesh> decode_mesh(std::span<const std::uint8_t> bytes, std::size_t most);

}  // namespace scree::io
