// The scalar per cell that a stream contains beside displacements: the available fields, and their source data.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <scree/header_v1_t.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "coupling/sink.h"
#include "io/live/live_data.h"

namespace scree::io {

enum class LiveField {
  speed,        // mean speed of the cell's corners [m/s]
  mean_stress,  // (xx + yy)/2 of the Cauchy stress, tension positive [Pa]
  s1,           // the larger principal stress [Pa]
  s3,           // the smaller one [Pa]
  shear,        // (s1 - s3)/2 [Pa]
  sxx,
  syy,
  sxy,
  joint,      // the worst state of the block's contacts: 0 none closed, 1 sticking, 2 slipping, 3 slipping and failed
  integrator  // 0 explicit, 1 implicit
};
inline constexpr std::size_t kLiveFields = 10;

/// Name in INFO, `live.field` and `scree control RUN field`: that of the enumerator.
[[nodiscard]] std::string_view name(LiveField field);
[[nodiscard]] std::optional<LiveField> live_field(std::string_view name);
/// Field of a number in a command, counted from 0 in the order above; empty: there is none.
[[nodiscard]] std::optional<LiveField> live_field(double number);

/// Unprocessed data of a frame: copied by the run, converted into values of cells by the sending thread.
struct RawFrame {
  header_v1_t header{};
  std::shared_ptr<const LiveMesh> mesh;
  std::vector<double> position;  // x, y per point [m]
  LiveField field = LiveField::speed;
  std::vector<double> source;  // speed: velocity (x, y per point); joint: per block; integrator: per cell; else stress
                               // (xx, yy, xy per cell)
};

/// Copies the source data of its field into `frame.source`.   @return false: missing in the frame, or of another mesh
[[nodiscard]] bool take_source(RawFrame& frame, const coupling::FrameView& view);

/// A value per cell.
[[nodiscard]] std::vector<float> cell_values(const RawFrame& frame);

}  // namespace scree::io
