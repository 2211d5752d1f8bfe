#include "io/live/decode.h"

#include <algorithm>
#include <cmath>
#include <scree/mesh_v1_t.hpp>

#include "io/live/live_model.h"
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
  mesh.start_x = std::move(in->start_x);
  mesh.start_y = std::move(in->start_y);
  mesh.connectivity = std::move(in->connectivity);
  mesh.block = std::move(in->block);
  mesh.material = std::move(in->material);
  mesh.method = std::move(in->method);
  mesh.methods = std::move(in->methods);
  const auto finite = [](const std::vector<double>& list) {
    return std::all_of(list.begin(), list.end(), [](double x) { return std::isfinite(x); });
  };
  if (!finite(mesh.start_x) || !finite(mesh.start_y)) return std::nullopt;
  mesh.find_bodies();
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

template <class Message, class Put>
bool LiveAssembly::take_by(std::span<const std::uint8_t> bytes, std::int64_t utime, const Put& put) {
  std::optional<Message> message = unseal<Message>(bytes);
  // A run sends at most one message of a kind per microsecond.
  const auto possible = [utime](const header_v1_t& h) {
    return h.session >= 0 && h.session <= utime + kAhead && h.sequence <= utime - h.session + kAhead;
  };
  if (!message || !possible(message->header)) {
    ++counts_.malformed;
    return false;
  }
  const std::int64_t session = message->header.session;
  const bool going_on = !info_ || info_->status == "running" || info_->status == "paused";
  if (session < session_ && !(going_on && utime - heard_ > kSilence)) {
    ++counts_.other;
    return false;
  }
  if (session != session_) forget();
  session_ = session;
  heard_ = utime;
  const Verdict verdict = put(std::move(*message));
  if (verdict == Verdict::malformed) ++counts_.malformed;
  if (verdict == Verdict::early) ++counts_.early;
  return verdict == Verdict::taken;
}

bool LiveAssembly::take(std::string_view channel, std::span<const std::uint8_t> bytes, std::int64_t utime) {
  ++counts_.messages;
  switch (const auto kind = channel_kind(channel); kind.value_or(LiveKind::info)) {
    case LiveKind::info:
      if (kind) return take_as<info_v1_t>(bytes, utime);
      break;  // not a channel of Scree
    case LiveKind::topo:
      return take_as<topo_v1_t>(bytes, utime);
    case LiveKind::state:
      return take_as<state_v1_t>(bytes, utime);
    case LiveKind::hist:
      return take_as<hist_v1_t>(bytes, utime);
    case LiveKind::energy:
      return take_as<energy_v1_t>(bytes, utime);
    case LiveKind::event:
      return take_as<event_v1_t>(bytes, utime);
    case LiveKind::model:
      return take_by<part_v1_t>(bytes, utime, [this](part_v1_t&& in) { return put_model(std::move(in)); });
    case LiveKind::detail:
      return take_by<part_v1_t>(bytes, utime, [this](part_v1_t&& in) { return put_detail(std::move(in)); });
    case LiveKind::ctrl:
    case LiveKind::ack:
      break;  // not for viewers
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
  // The newest events are sent repeatedly for late viewers. Numbers are consecutive, so numbers far below the highest
  // are old.
  const std::int64_t number = message.header.sequence;
  if (number <= events_floor_ || !events_known_.insert(number).second) return Verdict::taken;
  while (events_known_.size() > kMaxEvents) {
    events_floor_ = *events_known_.begin();
    events_known_.erase(events_known_.begin());
  }
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
  if (mesh_ && mesh_->id == in.header.topology_id) return Verdict::taken;  // sent again for late viewers
  // Chunks of a mesh are the same bytes each time it is sent, so a lost chunk is supplied by the next sending.
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

namespace {

/// True for a chunk that is possible in a frame of the mesh.
bool well_formed(const state_v1_t& in, const LiveMesh& mesh) {
  const auto most = [](std::size_t size) { return static_cast<std::int32_t>(size); };  // a decoded count: fits
  if (in.total_maps < 0 || in.total_maps > most(mesh.bodies()) || in.total_points < 0 ||
      in.total_points > most(mesh.points()) || in.total_cells != most(mesh.cells()) || in.header.sequence < 0 ||
      in.chunks != frame_chunks(in.total_maps, in.total_points, in.total_cells) || in.chunk < 0 ||
      in.chunk >= in.chunks)
    return false;
  const auto is_part = [&](std::int32_t total, std::int32_t first, std::int32_t count) {
    return first == split_at(total, in.chunk, in.chunks) && count == split_at(total, in.chunk + 1, in.chunks) - first;
  };
  return is_part(in.total_maps, in.first_map, in.maps) && is_part(in.total_points, in.first_point, in.points) &&
         is_part(in.total_cells, in.first_cell, in.cells) && all_in(in.body, 0, most(mesh.bodies())) &&
         std::isfinite(in.base[0]) && std::isfinite(in.base[1]) && std::isfinite(in.scale) && in.scale >= 0.0;
}

}  // namespace

LiveAssembly::Verdict LiveAssembly::put(state_v1_t&& in) {
  if (!mesh_ || mesh_->id != in.header.topology_id) return Verdict::early;
  if (!well_formed(in, *mesh_)) return Verdict::malformed;
  if (in.header.sequence < frame_pieces_.key || (frame_ && in.header.sequence <= frame_->header.sequence))
    return Verdict::taken;  // late or repeated: there is this frame or a newer one
  if (in.header.sequence > frame_pieces_.key) {
    if (next_frame_) ++counts_.incomplete;
    next_frame_ = std::make_unique<FrameParts>();
    next_frame_->body.resize(static_cast<std::size_t>(in.total_maps));
    next_frame_->map.resize(static_cast<std::size_t>(in.total_maps));
    next_frame_->loose.resize(2 * static_cast<std::size_t>(in.total_points));
    next_frame_->scalar.resize(mesh_->cells());
  }
  FrameParts* next = next_frame_.get();
  if (next == nullptr) return Verdict::taken;  // chunks of a frame that was refused
  if (next->body.size() != static_cast<std::size_t>(in.total_maps) ||
      next->loose.size() != 2 * static_cast<std::size_t>(in.total_points))
    return Verdict::malformed;
  if (!frame_pieces_.add(in.header.sequence, in.chunk, in.chunks)) return Verdict::taken;
  for (std::size_t i = 0; i < in.body.size(); ++i) {
    const std::size_t m = static_cast<std::size_t>(in.first_map) + i;
    next->body[m] = in.body[i];
    next->map[m] = {in.ux[i], in.uy[i], in.xx[i], in.xy[i], in.yx[i], in.yy[i]};
  }
  for (std::size_t i = 0; i < in.dx.size(); ++i) {
    const std::size_t p = static_cast<std::size_t>(in.first_point) + i;
    next->loose[2 * p] = restore(in.base[0], in.scale, in.dx[i]);
    next->loose[2 * p + 1] = restore(in.base[1], in.scale, in.dy[i]);
  }
  std::copy(in.scalar.begin(), in.scalar.end(), next->scalar.begin() + in.first_cell);
  if (frame_pieces_.missing > 0) return Verdict::taken;
  const std::unique_ptr<FrameParts> whole = std::move(next_frame_);
  std::shared_ptr<const LiveFrame> frame = decode(std::move(*whole), in.header);
  if (!frame) return Verdict::malformed;
  frame_ = std::move(frame);
  ++counts_.frames;
  return Verdict::taken;
}

std::shared_ptr<const LiveFrame> LiveAssembly::decode(FrameParts&& parts, const header_v1_t& header) const {
  auto frame = std::make_shared<LiveFrame>();
  frame->header = header;
  frame->mesh = mesh_;
  frame->scalar = std::move(parts.scalar);
  if (info_) frame->field = info_->field;
  frame->position.resize(2 * mesh_->points());
  std::vector<char> done(mesh_->points(), 0);
  for (std::size_t m = 0; m < parts.body.size(); ++m) {
    if (m > 0 && parts.body[m] <= parts.body[m - 1]) return nullptr;  // must increase: no body twice
    const std::span<const std::int32_t> points = mesh_->points_of(static_cast<std::size_t>(parts.body[m]));
    for (const std::int32_t point : points) {
      const auto p = static_cast<std::size_t>(point);
      const auto [x, y] = parts.map[m].place(*mesh_, static_cast<std::size_t>(points.front()), p);
      frame->position[2 * p] = x;
      frame->position[2 * p + 1] = y;
      done[p] = 1;
    }
  }
  std::size_t next = 0;
  for (std::size_t p = 0; p < done.size(); ++p) {
    if (done[p] != 0) continue;
    if (next == parts.loose.size()) return nullptr;
    frame->position[2 * p] = mesh_->start_x[p] + parts.loose[next];
    frame->position[2 * p + 1] = mesh_->start_y[p] + parts.loose[next + 1];
    next += 2;
  }
  return next == parts.loose.size() ? frame : nullptr;
}

LiveAssembly::Verdict LiveAssembly::put_model(part_v1_t&& in) {
  if (!model_parts_.put(std::move(in), kMaxMesh)) return Verdict::malformed;
  const std::optional<Bytes> whole = model_parts_.take();
  if (!whole) return Verdict::taken;
  std::optional<model_v1_t> model = unseal<model_v1_t>(*whole, kMaxMesh);
  if (!model || !holds_together(*model)) return Verdict::malformed;
  model_ = std::make_shared<const model_v1_t>(std::move(*model));
  return Verdict::taken;
}

LiveAssembly::Verdict LiveAssembly::put_detail(part_v1_t&& in) {
  if (!mesh_ || mesh_->id != in.header.topology_id) return Verdict::early;
  const header_v1_t header = in.header;
  if (!detail_parts_.put(std::move(in), kMaxMesh)) return Verdict::malformed;
  const std::optional<Bytes> whole = detail_parts_.take();
  if (!whole) return Verdict::taken;
  std::optional<detail_v1_t> detail = unseal<detail_v1_t>(*whole, kMaxMesh);
  if (!detail || !holds_together(*detail, *mesh_)) return Verdict::malformed;
  detail_ = std::make_shared<const LiveDetail>(LiveDetail{header, std::move(*detail)});
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
