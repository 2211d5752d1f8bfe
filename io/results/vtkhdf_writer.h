// The frames of a run in the VTKHDF 2.0 layout: one part per mesh, stored once; points and fields per frame.
#pragma once

#include <map>
#include <optional>

#include "coupling/sink.h"
#include "io/results/h5_series.h"
#include "io/results/results_mark.h"
#include "io/results/results_size.h"

namespace scree::io {

/// Where a frame is stored: rows of the datasets below /VTKHDF.
struct FrameRows {
  std::int64_t mesh = 0, points = 0, cells = 0;       // number of its part; sizes
  std::int64_t first_point = 0, first_value = 0;      // of datasets per frame, at points and at cells
  std::int64_t first_cell = 0, first_integrator = 0;  // of datasets per mesh, per mesh and integrators
};

/// Values stored for the last frame, in these rows.
struct FrameValues {
  std::vector<double> points, displacement, velocity;            // three numbers per point
  std::vector<double> cell_displacement, cell_velocity, stress;  // three numbers per cell
  std::vector<double> principal_stress;                          // two numbers per cell
};

/// /VTKHDF     Points, Connectivity, Offsets, Types, NumberOf..., PointData, CellData, Steps (offsets of every frame)
/// /frames     step, tick, stage, integrator, state_hash, points, cells: one entry per frame
/// /methods    names of the methods, in the order of the numbers in CellData/method
/// Types are doubles for lengths, velocities and stress, int32 for ids. Points have z = 0.
/// @source [VTKHDF] 2.0: frame k reads part PartOffsets[k]; its Offsets begin at CellOffsets[k] + PartOffsets[k], which
///         holds for shared meshes only because there is one part per mesh
class VtkhdfWriter {
 public:
  /// Makes the groups, empty.   @throws FileError, as every member
  VtkhdfWriter(const h5::File& file, const ResultsSize& size);

  /// Stores a mesh unless it is the one stored last.
  void topology(const coupling::MeshView& mesh);
  /// Adds a frame.   @pre frame.mesh is set, in partitioned stages frame.state too, and spans have the sizes stated in
  /// sink.h
  /// @return its rows, written or still buffered
  FrameRows frame(const coupling::FrameView& frame);
  /// Values that the last frame() stored.
  [[nodiscard]] const FrameValues& values() const { return values_; }
  /// Frees values() of a large frame: between frames steps need the memory.
  void forget_values() {
    constexpr std::size_t kLarge = 10'000;
    if (values_.points.size() > kLarge) values_ = {};
  }
  /// Records in `mark` how much is stored now.
  void mark(ResultsMark& mark);
  /// Starts with the frames that another file had at the mark.   @pre nothing has been added yet
  void take(const h5::File& from, const ResultsMark& mark);
  /// Rows of a frame of a file; frames are counted from 0.
  [[nodiscard]] static FrameRows rows_of(const h5::File& file, std::int64_t frame);
  /// Writes what is buffered (the file itself is flushed by its owner).
  void flush();
  void close();

 private:
  /// Mesh of the present frames: its part, sizes, and first rows of the datasets stored once per mesh.
  struct Mesh {
    std::int64_t part = 0, points = 0, cells = 0, first_cell = 0, first_id = 0, first_integrator = 0;
  };
  template <class Visitor>
  void each(Visitor&& see);
  std::int32_t method_number(const std::string& name);

  const h5::File* file_;
  std::optional<std::uint32_t> mesh_;  // id of the mesh stored last
  std::vector<std::int32_t>
      schemes_;  // time integrator per cell, as last written for the present mesh; empty: none yet
  std::map<std::string, std::int32_t> methods_;
  Mesh at_;
  FrameValues values_;
  std::int64_t frames_ = 0, told_ = 0;  // told_: NSteps as stored in the file

  h5::Series<double> points_, displacement_, velocity_, cell_displacement_, cell_velocity_, stress_, principal_, time_;
  h5::Series<std::int64_t> connectivity_, offsets_, count_points_, count_cells_, count_ids_;
  h5::Series<std::uint8_t> types_;
  h5::Series<std::int32_t> block_, element_, material_, method_, integrator_cell_;
  h5::Series<std::int64_t> part_offset_, part_count_, point_offset_, cell_offset_, id_offset_;
  std::map<std::string, h5::Series<std::int64_t>> point_field_, cell_field_;
  h5::Series<std::int64_t> frame_step_, frame_tick_, frame_points_, frame_cells_;
  h5::Series<std::int32_t> frame_stage_, frame_integrator_;
  h5::Series<std::uint64_t> frame_hash_;
  h5::TextSeries method_name_;
};

}  // namespace scree::io
