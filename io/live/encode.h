// Encodes meshes, frames, histories and events as sealed messages of at most kMaxMessage bytes.
#pragma once

#include <functional>
#include <string_view>

#include "io/live/live_data.h"
#include "io/live/wire.h"

namespace scree::io {

using Send = std::function<void(Bytes message)>;

/// An encoded mesh_v1_t.
[[nodiscard]] Bytes encode_mesh(const LiveMesh& mesh);
/// Sends the topo_v1_t messages of an encoded mesh.
void send_mesh(const header_v1_t& header, const Bytes& mesh, const Send& send);
/// Sends the state_v1_t messages of a frame.   @pre position and scalar fit the mesh
void send_frame(const LiveFrame& frame, const Send& send);
/// Sends the hist_v1_t messages of a history.
void send_history(const LiveHistory& history, const Send& send);
/// One energy_v1_t message: every column of the ledger.
[[nodiscard]] Bytes encode_energy(const header_v1_t& header, const coupling::Ledger& ledger);
/// One event_v1_t message.
[[nodiscard]] Bytes encode_event(const header_v1_t& header, const coupling::Event& event);

}  // namespace scree::io
