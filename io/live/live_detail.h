// Data of an instant in addition to its STATE: closed contact points, stress of the cells, bolts.
#pragma once

#include <scree/detail_v1_t.hpp>
#include <scree/header_v1_t.hpp>

#include "coupling/sink.h"
#include "io/live/live_data.h"
#include "io/results/run_reader.h"

namespace scree::io {

/// Bytes per second that DETAIL may take: a large one is sent less often than frames. On a network every 56 kB take
/// 2 ms of the sending thread, and about as much of a receiver.
inline constexpr double kDetailRate = 2e6;

struct LiveDetail {
  header_v1_t header{};  // topology_id: the mesh whose cells have the stress
  detail_v1_t data{};
};

/// Detail of a frame that has its contact points, or none.   @param base  origin of the rounded positions [m]
[[nodiscard]] detail_v1_t live_detail(const coupling::FrameView& frame, const std::array<double, 2>& base);
/// Detail of a frame of a stored run; without contacts if the run stored none.   @throws FileError
[[nodiscard]] detail_v1_t live_detail(const RunReader& run, const StoredFrame& frame,
                                      const std::array<double, 2>& base);

/// Number of bytes of its encoding.
[[nodiscard]] double size_of(const detail_v1_t& detail);
/// True when it may belong to a mesh: its numbers of blocks are possible, and it has a stress for every cell or for
/// none.
[[nodiscard]] bool holds_together(const detail_v1_t& detail, const LiveMesh& mesh);

}  // namespace scree::io
