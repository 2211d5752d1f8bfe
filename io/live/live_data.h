// What travels in STATE, TOPO and HIST, whole: the sink takes it apart into messages, the reader puts it together.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <scree/header_v1_t.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/sink.h"

namespace scree::io {

/// The scalar a cell that a stream carries.
enum class LiveField {
  speed,       // mean speed of the cell's corners [m/s]
  mean_stress  // (xx + yy) / 2, Cauchy, tension positive [Pa]
};
[[nodiscard]] std::string_view name(LiveField field);  // "speed", "mean stress"

/// A MeshView with storage of its own. Origins are rounded as float32 about the middle of the mesh: sender and viewer
/// add displacements to the very same numbers, so that only quantisation is left between their positions.
struct LiveMesh {
  std::int64_t id = -1;
  std::array<double, 2> base{0.0, 0.0};                // [m]
  std::vector<float> origin_x, origin_y;               // from base, a point [m]
  std::vector<std::int32_t> offsets{0}, connectivity;  // polygon cells of points; cells + 1 offsets
  std::vector<std::int32_t> block, material, method;   // a cell
  std::vector<std::string> methods;                    // names that method counts

  [[nodiscard]] static LiveMesh copy(const coupling::MeshView& view);
  [[nodiscard]] std::size_t points() const { return origin_x.size(); }
  [[nodiscard]] std::size_t cells() const { return offsets.size() - 1; }
  [[nodiscard]] double x(std::size_t point) const { return base[0] + double{origin_x[point]}; }
  [[nodiscard]] double y(std::size_t point) const { return base[1] + double{origin_y[point]}; }
};

/// One instant.
struct LiveFrame {
  header_v1_t header{};
  std::shared_ptr<const LiveMesh> mesh;
  std::vector<double> position;  // x, y a point [m]; not a number where it is not finite
  std::vector<float> scalar;     // a cell
};

/// All monitors at one instant; x, y a monitor.
struct LiveHistory {
  header_v1_t header{};
  std::vector<std::string> names;
  std::vector<double> position, displacement, velocity;
};

}  // namespace scree::io
