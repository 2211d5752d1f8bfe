#include "io/live/put_together.h"

#include <algorithm>
#include <cmath>
#include <scree/mesh_v1_t.hpp>

#include "io/live/quantise.h"
#include "io/live/split.h"

namespace scree::io {
namespace {

constexpr std::int32_t kMaxMonitors = 100000;

bool all_in(const std::vector<std::int32_t>& values, std::int32_t low, std::int32_t high) {
  return std::all_of(values.begin(), values.end(), [&](std::int32_t v) { return v >= low && v < high; });
}

}  // namespace

std::optional<LiveMesh> decode_mesh(std::span<const std::uint8_t> bytes, std::size_t most) {
  std::optional<mesh_v1_t> in = unseal<mesh_v1_t>(bytes, most);
  if (!in || !std::isfinite(in->base[0]) || !std::isfinite(in->base[1])) return std::nullopt;
  LiveMesh mesh;
  std::int64_t sum = 0;
  for (const std::int32_t corners : in->corners) {
    sum += corners;
    if (corners < 0 || sum > in->links) return std::nullopt;
    mesh.offsets.push_back(static_cast<std::int32_t>(sum));
  }
  if (sum != in->links || !all_in(in->connectivity, 0, in->points) || !all_in(in->method, 0, in->kinds))
    return std::nullopt;
  mesh.id = in->id;
  mesh.base = {in->base[0], in->base[1]};
  mesh.origin_x = std::move(in->origin_x);
  mesh.origin_y = std::move(in->origin_y);
  mesh.connectivity = std::move(in->connectivity);
  mesh.block = std::move(in->block);
  mesh.material = std::move(in->material);
  mesh.method = std::move(in->method);
  mesh.methods = std::move(in->methods);
  return mesh;
}

bool LiveAssembly::Pieces::add(std::int64_t its_key, std::int32_t piece, std::int32_t pieces) {
  if (key != its_key || have.size() != static_cast<std::size_t>(pieces)) {
    key = its_key;
    have.assign(static_cast<std::size_t>(pieces), 0);
    missing = pieces;
  }
  char& seen = have[static_cast<std::size_t>(piece)];
  if (seen != 0) return false;
  seen = 1;
  --missing;
  return true;
}

void LiveAssembly::forget() {
  const LiveCounts counts = counts_;
  *this = LiveAssembly{};
  counts_ = counts;
}

template <class Message>
bool LiveAssembly::take_as(std::span<const std::uint8_t> bytes) {
  std::optional<Message> message = unseal<Message>(bytes);
  if (!message || message->header.session < 0) {
    ++counts_.malformed;
    return false;
  }
  const std::int64_t session = message->header.session;
  if (session < session_) {
    ++counts_.other;
    return false;
  }
  if (session > session_) forget();
  session_ = session;
  const Verdict verdict = put(std::move(*message));
  if (verdict == Verdict::malformed) ++counts_.malformed;
  if (verdict == Verdict::early) ++counts_.early;
  return verdict == Verdict::taken;
}

bool LiveAssembly::take(std::string_view channel, std::span<const std::uint8_t> bytes) {
  ++counts_.messages;
  switch (const auto kind = channel_kind(channel); kind.value_or(LiveKind::info)) {
    case LiveKind::info:
      if (kind) return take_as<info_v1_t>(bytes);
      break;  // a channel of somebody else
    case LiveKind::topo:
      return take_as<topo_v1_t>(bytes);
    case LiveKind::state:
      return take_as<state_v1_t>(bytes);
    case LiveKind::hist:
      return take_as<hist_v1_t>(bytes);
    case LiveKind::energy:
      return take_as<energy_v1_t>(bytes);
    case LiveKind::event:
      return take_as<event_v1_t>(bytes);
  }
  ++counts_.malformed;
  return false;
}

std::vector<event_v1_t> LiveAssembly::take_events() {
  std::vector<event_v1_t> events(events_.begin(), events_.end());
  events_.clear();
  return events;
}

LiveAssembly::Verdict LiveAssembly::put(info_v1_t&& message) {
  info_ = std::move(message);
  return Verdict::taken;
}

LiveAssembly::Verdict LiveAssembly::put(energy_v1_t&& message) {
  energy_ = std::move(message);
  return Verdict::taken;
}

LiveAssembly::Verdict LiveAssembly::put(event_v1_t&& message) {
  if (events_.size() == kMaxEvents) events_.pop_front();
  events_.push_back(std::move(message));
  ++counts_.events;
  return Verdict::taken;
}

LiveAssembly::Verdict LiveAssembly::put(topo_v1_t&& in) {
  if (in.total < 0 || static_cast<std::size_t>(in.total) > kMaxMesh || in.chunks != chunks_for(in.total) ||
      in.chunk < 0 || in.chunk >= in.chunks || in.first != split_at(in.total, in.chunk, in.chunks) ||
      in.first + in.size != split_at(in.total, in.chunk + 1, in.chunks) || in.header.topology_id < 0)
    return Verdict::malformed;
  if (mesh_ && mesh_->id == in.header.topology_id) return Verdict::taken;  // sent again for those who came late
  // Chunks of one mesh are the same bytes each time it is sent, so what one sending lost the next one fills in.
  if (!mesh_pieces_.add(in.header.topology_id, in.chunk, in.chunks)) return Verdict::taken;
  mesh_bytes_.resize(static_cast<std::size_t>(in.chunks));
  mesh_bytes_[static_cast<std::size_t>(in.chunk)] = std::move(in.data);
  if (mesh_pieces_.missing > 0) return Verdict::taken;

  Bytes whole;
  for (const Bytes& piece : mesh_bytes_) whole.insert(whole.end(), piece.begin(), piece.end());
  mesh_bytes_.clear();
  mesh_pieces_ = {};
  std::optional<LiveMesh> mesh = decode_mesh(whole, kMaxMesh);
  if (!mesh || mesh->id != in.header.topology_id) return Verdict::malformed;
  mesh_ = std::make_shared<const LiveMesh>(std::move(*mesh));
  next_frame_ = nullptr;
  frame_pieces_ = {};
  return Verdict::taken;
}

LiveAssembly::Verdict LiveAssembly::put(state_v1_t&& in) {
  if (!mesh_ || mesh_->id != in.header.topology_id) return Verdict::early;
  const std::int64_t total_points = in.total_points, total_cells = in.total_cells;
  if (total_points != static_cast<std::int64_t>(mesh_->points()) ||
      total_cells != static_cast<std::int64_t>(mesh_->cells()) || in.header.sequence < 0 ||
      in.chunks != chunks_for(4 * (total_points + total_cells)) || in.chunk < 0 || in.chunk >= in.chunks ||
      in.first_point != split_at(total_points, in.chunk, in.chunks) ||
      in.points != split_at(total_points, in.chunk + 1, in.chunks) - in.first_point ||
      in.first_cell != split_at(total_cells, in.chunk, in.chunks) ||
      in.cells != split_at(total_cells, in.chunk + 1, in.chunks) - in.first_cell || !std::isfinite(in.base[0]) ||
      !std::isfinite(in.base[1]) || !std::isfinite(in.scale) || in.scale < 0.0)
    return Verdict::malformed;
  if (in.header.sequence < frame_pieces_.key || (frame_ && in.header.sequence <= frame_->header.sequence))
    return Verdict::taken;  // late or twice: a newer frame is there
  if (in.header.sequence > frame_pieces_.key) {
    if (next_frame_) ++counts_.incomplete;
    next_frame_ = std::make_shared<LiveFrame>();
    next_frame_->mesh = mesh_;
    next_frame_->position.resize(2 * mesh_->points());
    next_frame_->scalar.resize(mesh_->cells());
  }
  if (!frame_pieces_.add(in.header.sequence, in.chunk, in.chunks)) return Verdict::taken;
  for (std::size_t i = 0; i < in.dx.size(); ++i) {
    const std::size_t p = static_cast<std::size_t>(in.first_point) + i;
    next_frame_->position[2 * p] = mesh_->x(p) + restore(in.base[0], in.scale, in.dx[i]);
    next_frame_->position[2 * p + 1] = mesh_->y(p) + restore(in.base[1], in.scale, in.dy[i]);
  }
  std::copy(in.scalar.begin(), in.scalar.end(), next_frame_->scalar.begin() + in.first_cell);
  if (frame_pieces_.missing > 0) return Verdict::taken;
  next_frame_->header = in.header;
  frame_ = std::move(next_frame_);
  next_frame_ = nullptr;
  ++counts_.frames;
  return Verdict::taken;
}

LiveAssembly::Verdict LiveAssembly::put(hist_v1_t&& in) {
  if (in.total < 1 || in.total > kMaxMonitors || in.first < 0 || in.first >= in.total ||
      in.first % kMonitorsPerMessage != 0 || in.monitors != std::min(kMonitorsPerMessage, in.total - in.first) ||
      in.header.sequence < 0)
    return Verdict::malformed;
  if (in.header.sequence < history_pieces_.key) return Verdict::taken;  // late
  const auto total = static_cast<std::size_t>(in.total);
  if (in.header.sequence > history_pieces_.key || !next_history_ || next_history_->names.size() != total) {
    next_history_ = std::make_shared<LiveHistory>();
    next_history_->names.resize(total);
    for (auto* list : {&next_history_->position, &next_history_->displacement, &next_history_->velocity})
      list->resize(2 * total);
  }
  const std::int32_t pieces = (in.total + kMonitorsPerMessage - 1) / kMonitorsPerMessage;
  if (!history_pieces_.add(in.header.sequence, in.first / kMonitorsPerMessage, pieces)) return Verdict::taken;
  for (std::size_t i = 0; i < in.name.size(); ++i) {
    const std::size_t m = static_cast<std::size_t>(in.first) + i;
    next_history_->names[m] = std::move(in.name[i]);
    next_history_->position[2 * m] = in.position_x[i];
    next_history_->position[2 * m + 1] = in.position_y[i];
    next_history_->displacement[2 * m] = in.displacement_x[i];
    next_history_->displacement[2 * m + 1] = in.displacement_y[i];
    next_history_->velocity[2 * m] = in.velocity_x[i];
    next_history_->velocity[2 * m + 1] = in.velocity_y[i];
  }
  if (history_pieces_.missing > 0) return Verdict::taken;
  next_history_->header = in.header;
  history_ = std::move(next_history_);
  next_history_ = nullptr;
  return Verdict::taken;
}

}  // namespace scree::io
