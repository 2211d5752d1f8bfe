// The frames of a stored run as chunks, thinned in time where a report would grow too large.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/pictures/snapshot.h"
#include "io/report/chunk.h"
#include "io/results/run_reader.h"

namespace scree::io {

struct ReportFrame {
  std::size_t index = 0;  // in the run
  std::int64_t step = 0;
  std::size_t mesh = 0;  // place in ReportFrames::meshes
  double time = 0.0;     // [s]
  std::string stage, integrator;
  std::string text;  // chunk: displacement, velocity (x, y per point), stress (xx, yy, xy per point), integrator (per
                     // cell); contact points that are closed
};

/// Range of the colours of a field, over all frames shown.
struct ReportRange {
  std::string field;
  double low = 0.0, high = 1.0;
};

struct ReportFrames {
  std::vector<std::string>
      meshes;                      // chunk: origin (x, y per point), offsets, cells, block, material, method (per cell)
  std::vector<std::size_t> first;  // first frame of each mesh, as an index in the run
  std::vector<ReportFrame> frames;
  std::vector<ReportRange> ranges;
  std::array<double, 4> bounds{};  // x0, y0, x1, y1 of all points shown [m], relative to `base`
  std::size_t stored = 0;          // frames of the run
};

/// Reads, packs and thins.
/// @param base   reference point of positions in the chunks [m], in addition to the origin of the run
/// @param bytes  that meshes and frames may take together; the first and the last frame of each mesh and stage stay
///               even where they take more. 0: no limit
/// @throws FileError
[[nodiscard]] ReportFrames pack_frames(const RunReader& run, const Vec2& base, std::size_t bytes);

/// Every frame of the run and every mesh, without their chunks.
/// @param looked  number of frames, spread evenly, that ranges and bounds are taken from, besides the first frame of
///                each mesh and the last of all   @pre looked >= 1   @throws FileError
[[nodiscard]] ReportFrames list_frames(const RunReader& run, const Vec2& base, std::size_t looked);

/// The chunks that ReportFrames describes.   @throws FileError where contacts cannot be read
[[nodiscard]] Chunk mesh_chunk(const StoredFrame& frame, const Vec2& base);
[[nodiscard]] Chunk frame_chunk(const RunReader& run, const StoredFrame& frame, const Vec2& base);

/// Indices of the frames that stay: every `stride`-th and the kept ones, in order.
/// @pre stride >= 1, kept.size() == count
[[nodiscard]] std::vector<std::size_t> thinned(const std::vector<char>& kept, std::size_t stride);

}  // namespace scree::io
