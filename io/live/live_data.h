// What travels in STATE, TOPO and HIST, whole: the sink takes it apart into messages, the reader puts it together.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <scree/header_v1_t.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/sink.h"

namespace scree::io {

/// A MeshView with storage of its own. Sender and viewer add displacements to the very same start, so that only the
/// rounding of displacements is left between their positions. Where the model had the points is for pictures alone and
/// rounded as float32 about the middle of the mesh.
struct LiveMesh {
  std::int64_t id = -1;
  std::array<double, 2> base{0.0, 0.0};                // [m]
  std::vector<float> origin_x, origin_y;               // in the model, from base, a point [m]
  std::vector<double> start_x, start_y;                // when this mesh began, a point [m]
  std::vector<std::int32_t> offsets{0}, connectivity;  // polygon cells of points; cells + 1 offsets
  std::vector<std::int32_t> block, material, method;   // per cell
  std::vector<std::string> methods;                    // names that method counts

  /// Found from the cells by find_bodies(): the blocks of the mesh as their first cells come.
  std::vector<std::int32_t> body_first;  // first entry of each in body_points; bodies + 1
  std::vector<std::int32_t> body_points;

  /// @param position  x, y per point when the mesh began; empty: where the model had them
  [[nodiscard]] static LiveMesh copy(const coupling::MeshView& view, std::span<const double> position = {});
  /// @pre cells and points fit together
  void find_bodies();
  [[nodiscard]] std::size_t points() const { return origin_x.size(); }
  [[nodiscard]] std::size_t cells() const { return offsets.size() - 1; }
  [[nodiscard]] std::size_t bodies() const { return body_first.empty() ? 0 : body_first.size() - 1; }
  /// Points of a body, in increasing order.
  [[nodiscard]] std::span<const std::int32_t> points_of(std::size_t body) const {
    const auto first = static_cast<std::size_t>(body_first[body]),
               last = static_cast<std::size_t>(body_first[body + 1]);
    return std::span(body_points).subspan(first, last - first);
  }
};

/// One instant.
struct LiveFrame {
  header_v1_t header{};
  std::shared_ptr<const LiveMesh> mesh;
  std::vector<double> position;  // x, y per point [m]; not a number where it is not finite
  std::vector<float> scalar;     // per cell
  std::string field;             // what that is (live_field.h); empty: not known yet
};

/// All monitors at one instant; x, y a monitor.
struct LiveHistory {
  header_v1_t header{};
  std::vector<std::string> names;
  std::vector<double> position, displacement, velocity;
};

}  // namespace scree::io
