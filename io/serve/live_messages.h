// The messages of a stream to the page over a WebSocket.
#pragma once

#include <array>
#include <scree/energy_v1_t.hpp>
#include <scree/event_v1_t.hpp>
#include <scree/info_v1_t.hpp>
#include <scree/model_v1_t.hpp>
#include <string>
#include <vector>

#include "io/live/live_data.h"
#include "io/live/live_detail.h"
#include "io/serve/site.h"

namespace scree::io {

// A message is a u32 (little endian), so many bytes of JSON {"kind": ..., "session": ..., ...}, and the bytes of a
// Chunk (meshes, frames and details only; else there are none). Positions are relative to `base`, in addition to the
// origin of the run [m].

/// "run": what does not change while a session lasts.   @param control  pages that know the token may give commands
[[nodiscard]] SharedBytes run_message(const info_v1_t& info, const std::array<double, 2>& base, std::size_t blocks,
                                      std::size_t materials, bool control);
/// "mesh": arrays as in a report.
[[nodiscard]] SharedBytes mesh_message(std::int64_t session, const LiveMesh& mesh, const std::array<double, 2>& base);
/// "frame": displacements of the points from the model, and the scalar of the cells.   @pre frame.mesh
[[nodiscard]] SharedBytes frame_message(const LiveFrame& frame, const std::string& stage,
                                        const std::string& integrator);
/// "model": names, and what is drawn over blocks, as run.json of a stored run has them (RunText).
[[nodiscard]] SharedBytes model_message(std::int64_t session, const model_v1_t& model,
                                        const std::array<double, 2>& base);
/// "detail": contacts, stress of the points and bolts of an instant, arrays as in a frame of a report.
/// @pre the stress is that of the mesh
[[nodiscard]] SharedBytes detail_message(const LiveDetail& detail, const LiveMesh& mesh,
                                         const std::array<double, 2>& base);
/// "rows": monitors and the ledger at their newest instants.   @param history,energy  null: not known
[[nodiscard]] SharedBytes rows_message(std::int64_t session, const LiveHistory* history, const energy_v1_t* energy,
                                       const std::array<double, 2>& base);
/// "status": progress of the run, once there is one.   @param silent  time since its last message [s]
[[nodiscard]] SharedBytes status_message(const info_v1_t& info, double silent);
/// "status" before the first message of a run.   @param trouble  why nothing can be received; empty: nothing streams
[[nodiscard]] SharedBytes waiting_message(const std::string& url, const std::string& run, const std::string& trouble);
/// "answer": the result of a command that a page gave, whatever the session.
[[nodiscard]] SharedBytes answer_message(const std::string& command, const std::string& result,
                                         const std::string& reason, const std::string& state);
/// "events": all that are kept, oldest first.
[[nodiscard]] SharedBytes events_message(std::int64_t session, const std::vector<event_v1_t>& events);

}  // namespace scree::io
