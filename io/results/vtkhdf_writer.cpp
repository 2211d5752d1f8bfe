#include "io/results/vtkhdf_writer.h"

#include <array>
#include <cmath>
#include <utility>

#include "io/results/cell_mean.h"
#include "io/results/h5_read.h"
#include "model/check.h"

namespace scree::io {

namespace {

constexpr std::uint8_t kPolygon = 7;  // VTK_POLYGON

/// From two numbers per point to three, z = 0.
void in_space(std::span<const double> xy, std::vector<double>& xyz) {
  xyz.clear();
  for (std::size_t i = 0; i + 1 < xy.size(); i += 2) xyz.insert(xyz.end(), {xy[i], xy[i + 1], 0.0});
}

/// s1 >= s2 per cell from (xx, yy, xy):  s = m +- r,  m = (xx + yy)/2,  r = |((xx - yy)/2, xy)|.
void principal(std::span<const double> stress, std::vector<double>& s) {
  s.clear();
  for (std::size_t i = 0; i + 2 < stress.size(); i += 3) {
    const double m = 0.5 * (stress[i] + stress[i + 1]);
    const double r = std::hypot(0.5 * (stress[i] - stress[i + 1]), stress[i + 2]);
    s.insert(s.end(), {m + r, m - r});
  }
}

/// Time integrator per cell, 0 explicit or 1 implicit: in a partitioned stage that of its block, or of its part of a
/// divided block.
std::vector<std::int32_t> schemes_of_cells(const coupling::FrameView& frame) {
  using coupling::Integrator;
  const std::span<const std::int32_t> block = frame.mesh->cell_block;
  if (frame.integrator != Integrator::partitioned)
    return std::vector<std::int32_t>(block.size(), frame.integrator == Integrator::explicit_ ? 0 : 1);
  SCREE_ASSERT(frame.state != nullptr);
  std::vector<std::int32_t> schemes;
  schemes.reserve(block.size());
  for (std::size_t c = 0; c < block.size(); ++c) {
    const char side = frame.state->explicit_side[static_cast<std::size_t>(block[c])];
    schemes.push_back(side == 1 || (side == coupling::kDivided && frame.mesh->cell_explicit[c] != 0) ? 0 : 1);
  }
  return schemes;
}

std::vector<std::int64_t> widened(std::span<const std::int32_t> numbers) { return {numbers.begin(), numbers.end()}; }

}  // namespace

VtkhdfWriter::VtkhdfWriter(const h5::File& file, const ResultsSize& size) : file_(&file) {
  file.group("/VTKHDF");
  file.attribute_ascii("/VTKHDF", "Type", "UnstructuredGrid");
  file.attribute_pair("/VTKHDF", "Version", 2, 0);
  const std::string vtk = "/VTKHDF/", steps = "/VTKHDF/Steps/", frames = "/frames/";
  const h5::Growing points(file, size.frames * size.points), cells(file, size.frames * size.cells);
  const h5::Growing of_mesh(file, size.cells), of_frames(file, size.frames);

  points_ = {points, vtk + "Points", 3, {"m", "position, frame after frame"}};
  displacement_ = {points, vtk + "PointData/displacement", 3, {"m", "position less the position in the model"}};
  velocity_ = {points, vtk + "PointData/velocity", 3, {"m/s", "velocity"}};
  cell_displacement_ = {cells, vtk + "CellData/displacement", 3, {"m", "displacement, mean over the cell"}};
  cell_velocity_ = {cells, vtk + "CellData/velocity", 3, {"m/s", "velocity, mean over the cell"}};
  stress_ = {cells, vtk + "CellData/stress", 3, {"Pa", "Cauchy stress xx, yy, xy; tension positive"}};
  principal_ = {
      cells, vtk + "CellData/principal_stress", 2, {"Pa", "principal stresses, the larger first; tension positive"}};

  connectivity_ = {{file, size.points}, vtk + "Connectivity", 1, {"1", "points of the cells, mesh after mesh"}};
  offsets_ = {of_mesh, vtk + "Offsets", 1, {"1", "where the cells begin in their mesh's part of Connectivity"}};
  types_ = {of_mesh, vtk + "Types", 1, {"1", "VTK cell type; 7 is a polygon"}};
  count_points_ = {file, vtk + "NumberOfPoints", 1, {"1", "points of each mesh"}};
  count_cells_ = {file, vtk + "NumberOfCells", 1, {"1", "cells of each mesh"}};
  count_ids_ = {file, vtk + "NumberOfConnectivityIds", 1, {"1", "length of each mesh's part of Connectivity"}};

  block_ = {of_mesh, vtk + "CellData/block_id", 1, {"1", "block, counted from 0 in /blocks"}};
  element_ = {of_mesh, vtk + "CellData/element_id", 1, {"1", "cell, counted from 0 in its mesh"}};
  material_ = {of_mesh, vtk + "CellData/material_id", 1, {"1", "material, counted from 0 in /materials"}};
  method_ = {of_mesh, vtk + "CellData/method", 1, {"1", "discretisation, counted from 0 in /methods"}};
  integrator_cell_ = {of_mesh, vtk + "CellData/integrator", 1, {"1", "time scheme: 0 explicit, 1 implicit"}};

  time_ = {of_frames, steps + "Values", 1, {"s", "time of each frame"}};
  part_offset_ = {of_frames, steps + "PartOffsets", 1, {"1", "mesh of each frame"}};
  part_count_ = {of_frames, steps + "NumberOfParts", 1, {"1", "meshes of each frame: one"}};
  point_offset_ = {of_frames, steps + "PointOffsets", 1, {"1", "first row of Points of each frame"}};
  cell_offset_ = {of_frames, steps + "CellOffsets", 1, {"1", "first cell of each frame's mesh"}};
  id_offset_ = {
      of_frames, steps + "ConnectivityIdOffsets", 1, {"1", "first entry of Connectivity of each frame's mesh"}};
  for (const char* name : {"displacement", "velocity"})
    point_field_[name] = {
        of_frames, steps + "PointDataOffsets/" + name, 1, {"1", "first row of the field of each frame"}};
  for (const char* name : {"block_id", "element_id", "material_id", "method", "integrator", "displacement", "velocity",
                           "stress", "principal_stress"})
    cell_field_[name] = {
        of_frames, steps + "CellDataOffsets/" + name, 1, {"1", "first row of the field of each frame"}};
  file.attribute("/VTKHDF/Steps", "NSteps", std::int64_t{0});

  frame_step_ = {of_frames, frames + "step", 1, {"1", "steps made since the start"}};
  frame_tick_ = {of_frames, frames + "tick", 1, {"ps", "time as a whole number of picoseconds"}};
  frame_stage_ = {of_frames, frames + "stage", 1, {"1", "stage, counted from 0 in /stages"}};
  frame_integrator_ = {of_frames,
                       frames + "integrator",
                       1,
                       {"1", "time scheme: 0 explicit, 1 implicit, 2 partitioned: that of each block"}};
  frame_hash_ = {
      of_frames, frames + "state_hash", 1, {"1", "hash of every bit of the state; 0 where there is no state"}};
  frame_points_ = {of_frames, frames + "points", 1, {"1", "points of the frame"}};
  frame_cells_ = {of_frames, frames + "cells", 1, {"1", "cells of the frame"}};
  method_name_ = {file, "/methods/name", {"none", "names of the discretisations"}};
}

template <class Visitor>
void VtkhdfWriter::each(Visitor&& see) {
  // Fields before the offsets that refer to them: a run that is killed leaves no frame that refers to missing rows.
  see(points_), see(displacement_), see(velocity_), see(cell_displacement_), see(cell_velocity_);
  see(stress_), see(principal_);
  see(connectivity_), see(offsets_), see(types_), see(block_), see(element_), see(material_), see(method_);
  see(integrator_cell_), see(method_name_), see(count_points_), see(count_cells_), see(count_ids_);
  see(part_offset_), see(part_count_), see(point_offset_), see(cell_offset_), see(id_offset_);
  for (auto& [name, series] : point_field_) see(series);
  for (auto& [name, series] : cell_field_) see(series);
  see(frame_step_), see(frame_tick_), see(frame_stage_), see(frame_integrator_), see(frame_hash_);
  see(frame_points_), see(frame_cells_), see(time_);
}

std::int32_t VtkhdfWriter::method_number(const std::string& name) {
  const auto [it, is_new] = methods_.try_emplace(name, static_cast<std::int32_t>(methods_.size()));
  if (is_new) method_name_.append(name);
  return it->second;
}

void VtkhdfWriter::topology(const coupling::MeshView& mesh) {
  if (mesh_ == mesh.id) return;
  mesh_ = mesh.id;
  schemes_.clear();
  at_.part = count_points_.rows();
  at_.first_cell = types_.rows();
  at_.first_id = connectivity_.rows();
  at_.points = static_cast<std::int64_t>(mesh.origin.size() / 2);
  at_.cells = static_cast<std::int64_t>(mesh.cell_block.size());
  SCREE_ASSERT(mesh.offsets.size() == mesh.cell_block.size() + 1);

  count_points_.append(at_.points);
  count_cells_.append(at_.cells);
  count_ids_.append(static_cast<std::int64_t>(mesh.connectivity.size()));
  connectivity_.append(widened(mesh.connectivity));
  offsets_.append(widened(mesh.offsets));
  types_.append(std::vector<std::uint8_t>(mesh.cell_block.size(), kPolygon));
  block_.append(mesh.cell_block);
  material_.append(mesh.cell_material);
  std::vector<std::int32_t> number;  // number in /methods of each method of this mesh
  for (const std::string& name : mesh.methods) number.push_back(method_number(name));
  for (std::size_t c = 0; c < mesh.cell_block.size(); ++c) {
    element_.append(static_cast<std::int32_t>(c));
    method_.append(number[static_cast<std::size_t>(mesh.cell_method[c])]);
  }
}

FrameRows VtkhdfWriter::frame(const coupling::FrameView& frame) {
  SCREE_ASSERT(frame.mesh != nullptr && frame.position.size() == frame.mesh->origin.size());
  topology(*frame.mesh);
  if (std::vector<std::int32_t> schemes = schemes_of_cells(frame); schemes != schemes_) {
    schemes_ = std::move(schemes);
    at_.first_integrator = integrator_cell_.rows();
    integrator_cell_.append(schemes_);
  }
  const std::int64_t first_point = points_.rows(), first_value = stress_.rows();

  std::vector<double> moved(frame.position.begin(), frame.position.end());
  for (std::size_t i = 0; i < moved.size(); ++i) moved[i] -= frame.mesh->origin[i];
  const auto of_cells = [&](std::span<const double> value, std::vector<double>& xyz) {
    in_space(cell_mean(frame.mesh->origin, value, frame.mesh->offsets, frame.mesh->connectivity), xyz);
  };
  in_space(frame.position, values_.points);
  in_space(moved, values_.displacement);
  in_space(frame.velocity, values_.velocity);
  of_cells(moved, values_.cell_displacement);
  of_cells(frame.velocity, values_.cell_velocity);
  values_.stress.assign(frame.stress.begin(), frame.stress.end());
  principal(frame.stress, values_.principal_stress);
  points_.append(values_.points);
  displacement_.append(values_.displacement);
  velocity_.append(values_.velocity);
  cell_displacement_.append(values_.cell_displacement);
  cell_velocity_.append(values_.cell_velocity);
  stress_.append(values_.stress);
  principal_.append(values_.principal_stress);

  time_.append(frame.time);
  part_offset_.append(at_.part);
  part_count_.append(1);
  point_offset_.append(first_point);
  cell_offset_.append(at_.first_cell);
  id_offset_.append(at_.first_id);
  for (auto& [name, series] : point_field_) series.append(first_point);
  for (auto& [name, series] : cell_field_) {
    const bool of_mesh = name.ends_with("_id") || name == "method";  // stored once per mesh
    series.append(of_mesh ? at_.first_cell : name == "integrator" ? at_.first_integrator : first_value);
  }
  frame_step_.append(frame.step);
  frame_tick_.append(frame.tick);
  frame_stage_.append(frame.stage);
  frame_integrator_.append(static_cast<std::int32_t>(frame.integrator));
  frame_hash_.append(frame.state ? coupling::state_hash(*frame.state) : 0);
  frame_points_.append(at_.points);
  frame_cells_.append(at_.cells);
  ++frames_;
  return {at_.part, at_.points, at_.cells, first_point, first_value, at_.first_cell, at_.first_integrator};
}

void VtkhdfWriter::mark(ResultsMark& mark) {
  mark.frames.clear();
  each([&](auto& series) { mark.frames.push_back(series.mark()); });
  mark.frame_count = frames_;
  mark.mesh = mesh_ ? static_cast<std::int64_t>(*mesh_) : -1;
  mark.schemes = schemes_.empty() ? 0 : 1;
  mark.mesh_rows = {at_.part, at_.points, at_.cells, at_.first_cell, at_.first_id, at_.first_integrator};
}

void VtkhdfWriter::take(const h5::File& from, const ResultsMark& mark) {
  SCREE_ASSERT(frames_ == 0);
  std::size_t at = 0;
  each([&](auto& series) { series.take(from, mark.frames.at(at++)); });
  std::vector<std::string> names;
  if (method_name_.rows() > 0) names = h5::from_whole([&] { return h5::read_texts(from, method_name_.name()); });
  for (std::int32_t m = 0; m < method_name_.rows(); ++m) methods_[names[static_cast<std::size_t>(m)]] = m;
  frames_ = mark.frame_count;
  if (mark.mesh >= 0) mesh_ = static_cast<std::uint32_t>(mark.mesh);
  const auto& r = mark.mesh_rows;
  at_ = {r[0], r[1], r[2], r[3], r[4], r[5]};
  if (mark.schemes != 0)
    schemes_ = h5::from_whole(
        [&] { return h5::read<std::int32_t>(from, integrator_cell_.name(), at_.first_integrator, at_.cells); });
}

FrameRows VtkhdfWriter::rows_of(const h5::File& file, std::int64_t frame) {
  const auto at = [&](const std::string& name) {
    return h5::from_whole([&] { return h5::read<std::int64_t>(file, name, frame, 1).front(); });
  };
  const std::string steps = "/VTKHDF/Steps/", of_cells = steps + "CellDataOffsets/";
  return {at(steps + "PartOffsets"), at("/frames/points"),      at("/frames/cells"),        at(steps + "PointOffsets"),
          at(of_cells + "stress"),   at(of_cells + "block_id"), at(of_cells + "integrator")};
}

void VtkhdfWriter::flush() {
  each([](auto& series) { series.flush(); });
  if (told_ != frames_) file_->attribute("/VTKHDF/Steps", "NSteps", frames_);
  told_ = frames_;
}

void VtkhdfWriter::close() {
  each([](auto& series) { series.close(); });
  file_->attribute("/VTKHDF/Steps", "NSteps", frames_);
}

}  // namespace scree::io
