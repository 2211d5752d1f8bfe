// What an instant has beside its STATE: closed contact points, the stress of the cells, the bolts.
#pragma once

#include <scree/detail_v1_t.hpp>
#include <scree/header_v1_t.hpp>

#include "coupling/sink.h"
#include "io/live/live_data.h"
#include "io/results/run_reader.h"

namespace scree::io {

/// Bytes a second that DETAIL may take: a large one comes more seldom than frames do. On a network they take 2 ms of
/// the sending thread each 56 kB, and about as much of a receiver.
inline constexpr double kDetailRate = 2e6;

struct LiveDetail {
  header_v1_t header{};  // topology_id: the mesh whose cells have the stress
  detail_v1_t data{};
};

/// Of a frame that has its contact points, or none.   @param base  what positions are rounded from [m]
[[nodiscard]] detail_v1_t live_detail(const coupling::FrameView& frame, const std::array<double, 2>& base);
/// Of a frame of a stored run; no contacts where it stored none.   @throws FileError
[[nodiscard]] detail_v1_t live_detail(const RunReader& run, const StoredFrame& frame,
                                      const std::array<double, 2>& base);

/// How many bytes it takes.
[[nodiscard]] double size_of(const detail_v1_t& detail);
/// True when it may belong to a mesh: every block it names is one that can be, and it has a stress for each cell or
/// none.
[[nodiscard]] bool holds_together(const detail_v1_t& detail, const LiveMesh& mesh);

}  // namespace scree::io
