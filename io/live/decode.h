// From messages back to whole things. Knows nothing of networks or threads: feed it bytes.
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

/// What became of the messages.
struct LiveCounts {
  std::int64_t messages = 0;    // all that came
  std::int64_t malformed = 0;   // wrong channel, size, CRC, type, length or range: dropped
  std::int64_t other = 0;       // of an earlier session: dropped
  std::int64_t early = 0;       // STATE before its mesh: dropped
  std::int64_t incomplete = 0;  // frames that a newer one replaced before all chunks had come
  std::int64_t frames = 0;      // complete frames
  std::int64_t events = 0;      // events, also those no longer kept
};

/// Follows one session, the latest of those that talk: a message of a later session makes it forget everything but its
/// counts; so does one of an earlier session when nothing has come of the one it follows for kSilence and that has not
/// ended: a forged message must not make a viewer deaf.
class LiveAssembly {
 public:
  static constexpr std::size_t kMaxMesh = std::size_t{1} << 28U;  // bytes of an encoded mesh; more is malformed
  static constexpr std::size_t kMaxEvents = 1000;                 // kept until taken; the oldest go first

  static constexpr std::int64_t kAhead = 60'000'000;  // microseconds that the clocks of two machines may differ by

  static constexpr std::int64_t kSilence = 3'000'000;  // microseconds; INFO comes every second

  /// Takes one message; anything that is not right is counted and dropped. So is a session that begins in the future,
  /// and a number that no run can have come to since it began: either would shut out all that is right after it.
  /// @param utime  now, microseconds since 1970   @return true if it was taken
  bool take(std::string_view channel, std::span<const std::uint8_t> bytes, std::int64_t utime = utime_now());

  /// The newest of each; empty until there is one.
  [[nodiscard]] const std::optional<info_v1_t>& info() const { return info_; }
  [[nodiscard]] const std::optional<energy_v1_t>& energy() const { return energy_; }
  [[nodiscard]] std::shared_ptr<const LiveHistory> history() const { return history_; }
  [[nodiscard]] std::shared_ptr<const LiveMesh> mesh() const { return mesh_; }
  [[nodiscard]] std::shared_ptr<const LiveFrame> frame() const { return frame_; }
  [[nodiscard]] std::shared_ptr<const model_v1_t> model() const { return model_; }
  /// Of the present mesh.
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

  /// A frame that is still coming: maps and displacements of the loose points.
  struct FrameParts {
    std::vector<std::int32_t> body;
    std::vector<AffineMap> map;
    std::vector<double> loose;  // x, y per point [m]
    std::vector<float> scalar;
  };
  /// Null when maps and loose points do not make up the mesh.
  [[nodiscard]] std::shared_ptr<const LiveFrame> decode(FrameParts&& parts, const header_v1_t& header) const;

  /// A thing whose pieces are still coming.
  struct Pieces {
    std::int64_t key = -1;  // sequence or mesh
    std::vector<char> have;
    std::int32_t missing = 0;
    /// True for a piece that is new. A new key or another number of pieces begins again.
    bool add(std::int64_t its_key, std::int32_t piece, std::int32_t pieces);
  };

  std::int64_t session_ = -1, heard_ = 0;  // heard_: when the last message of it came
  std::optional<info_v1_t> info_;
  std::optional<energy_v1_t> energy_;
  std::deque<event_v1_t> events_;
  std::set<std::int64_t> events_known_;  // numbers, the newest kMaxEvents
  std::int64_t events_floor_ = -1;       // this and all below count as known
  std::shared_ptr<const LiveMesh> mesh_;
  std::shared_ptr<const LiveFrame> frame_;
  std::shared_ptr<const LiveHistory> history_;
  std::shared_ptr<const model_v1_t> model_;
  std::shared_ptr<const LiveDetail> detail_;
  PartAssembly model_parts_, detail_parts_;
  Pieces mesh_pieces_, frame_pieces_, history_pieces_;
  std::vector<Bytes> mesh_bytes_;  // a piece
  std::unique_ptr<FrameParts> next_frame_;
  std::shared_ptr<LiveHistory> next_history_;
  LiveCounts counts_;
};

/// Decodes an encoded mesh and checks every index in it; empty when anything is wrong.
[[nodiscard]] std::optional<LiveMesh> decode_mesh(std::span<const std::uint8_t> bytes, std::size_t most);

}  // namespace scree::io
