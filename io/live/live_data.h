// Complete data of STATE, TOPO and HIST: the sink divides them into messages, the reader assembles them.
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

/// A MeshView with storage of its own. Sender and viewer add displacements to identical start positions, so that their
/// positions differ only by the rounding of displacements. The positions of the points in the model are used for
/// pictures only, and are rounded as float32 about the middle of the mesh.
struct LiveMesh {
  std::int64_t id = -1;
  std::array<double, 2> base{0.0, 0.0};                // [m]
  std::vector<float> origin_x, origin_y;               // in the model, relative to base, per point [m]
  std::vector<double> start_x, start_y;                // when this mesh began, per point [m]
  std::vector<std::int32_t> offsets{0}, connectivity;  // polygon cells of points; cells + 1 offsets
  std::vector<std::int32_t> block, material, method;   // per cell
  std::vector<std::string> methods;                    // names, indexed by method

  /// Set by find_bodies(): the blocks of the mesh in the order of their first cells.
  std::vector<std::int32_t> body_first;  // first entry of each body in body_points; bodies + 1
  std::vector<std::int32_t> body_points;

  /// @param position  x, y per point when the mesh began; empty: positions in the model
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
  std::vector<double> position;  // x, y per point [m]; NaN where it is not finite
  std::vector<float> scalar;     // per cell
  std::string field;             // name of the scalar (live_field.h); empty: not received yet
};

/// All monitors at one instant; x, y per monitor.
struct LiveHistory {
  header_v1_t header{};
  std::vector<std::string> names;
  std::vector<double> position, displacement, velocity;
};

}  // namespace scree::io
