#include "io/results/stored_cells.h"

namespace scree::io {

Vec2 cell_middle(const StoredFrame& frame, std::size_t cell) {
  Vec2 sum = Vec2::Zero();
  for (auto i = static_cast<std::size_t>(frame.offsets[cell]); i < static_cast<std::size_t>(frame.offsets[cell + 1]);
       ++i) {
    const auto p = static_cast<std::size_t>(frame.connectivity[i]);
    sum += Vec2(frame.position[2 * p], frame.position[2 * p + 1]);
  }
  return sum / static_cast<double>(frame.offsets[cell + 1] - frame.offsets[cell]);
}

double cell_area(const StoredFrame& frame, std::size_t cell) {
  double twice = 0.0;
  const auto first = static_cast<std::size_t>(frame.offsets[cell]),
             end = static_cast<std::size_t>(frame.offsets[cell + 1]);
  for (std::size_t i = first; i < end; ++i) {
    const auto a = static_cast<std::size_t>(frame.connectivity[i]);
    const auto b = static_cast<std::size_t>(frame.connectivity[i + 1 < end ? i + 1 : first]);
    twice += frame.position[2 * a] * frame.position[2 * b + 1] - frame.position[2 * b] * frame.position[2 * a + 1];
  }
  return 0.5 * twice;
}

}  // namespace scree::io
