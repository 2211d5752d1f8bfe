#include "io/results/xdmf_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "io/results/h5_read.h"
#include "io/results/h5_series.h"
#include "io/results/h5_window.h"
#include "io/results/run_folder.h"

namespace scree::io {

namespace {

constexpr const char* kNode = "Node";
constexpr const char* kCell = "Cell";
constexpr std::string_view kFile = "run.vtkhdf:";
constexpr std::chrono::seconds kBetween{1};
constexpr int kShare = 50;  // a text may take 1/50 of the time

}  // namespace

XdmfWriter::XdmfWriter(const h5::File& file, std::filesystem::path xmf) : file_(&file), xmf_(std::move(xmf)) {
  fields_ = {
      {"Points", "", "XYZ", "Points", 3, false, &FrameRows::first_point, {}},
      {"displacement", kNode, "Vector", "PointData/displacement", 3, false, &FrameRows::first_point, {}},
      {"velocity", kNode, "Vector", "PointData/velocity", 3, false, &FrameRows::first_point, {}},
      {"block_id", kCell, "Scalar", "CellData/block_id", 1, true, &FrameRows::first_cell, {}},
      {"element_id", kCell, "Scalar", "CellData/element_id", 1, true, &FrameRows::first_cell, {}},
      {"material_id", kCell, "Scalar", "CellData/material_id", 1, true, &FrameRows::first_cell, {}},
      {"method", kCell, "Scalar", "CellData/method", 1, true, &FrameRows::first_cell, {}},
      {"integrator", kCell, "Scalar", "CellData/integrator", 1, true, &FrameRows::first_integrator, {}},
      {"displacement", kCell, "Vector", "CellData/displacement", 3, false, &FrameRows::first_value, {}},
      {"velocity", kCell, "Vector", "CellData/velocity", 3, false, &FrameRows::first_value, {}},
      {"stress", kCell, "Vector", "CellData/stress", 3, false, &FrameRows::first_value, {}},
      {"principal_stress", kCell, "Matrix", "CellData/principal_stress", 2, false, &FrameRows::first_value, {}},
  };
  for (Field& field : fields_)
    field.label = {h5::text_attribute(file, "/VTKHDF/" + field.path, "units"),
                   h5::text_attribute(file, "/VTKHDF/" + field.path, "long_name")};
  file.group("/xdmf");
}

std::string XdmfWriter::topology(const coupling::MeshView& mesh, std::int64_t number) {
  const std::vector<std::int32_t> mixed = xdmf::mixed_polygons(mesh.offsets, mesh.connectivity);
  const std::string name = fmt::format("/xdmf/topology/{}", number);
  h5::write<std::int32_t>(*file_, name, 1, mixed, {"1", "a cell: 3 for polygon, number of points, points"});
  return xdmf::topology(static_cast<std::int64_t>(mesh.cell_block.size()),
                        {std::string(kFile) + name, static_cast<std::int64_t>(mixed.size()), 1, true});
}

xdmf::Array XdmfWriter::window(Field& field, const FrameRows& rows) {
  const bool of_cells = std::string_view(field.center) == kCell;
  const std::int64_t first = rows.*field.first, count = of_cells ? rows.cells : rows.points;
  if (field.shown != first) {
    h5::window(*file_, fmt::format("/xdmf/{}/{}", field.path, field.made), {"/VTKHDF/" + field.path, first, count},
               field.label);
    field.shown = first;
    ++field.made;
  }
  return {fmt::format("{}/xdmf/{}/{}", kFile, field.path, field.made - 1), count, field.width, field.whole};
}

void XdmfWriter::frame(const coupling::FrameView& frame, const FrameRows& rows) {
  if (mesh_ != rows.mesh) {
    topology_ = topology(*frame.mesh, rows.mesh);
    mesh_ = rows.mesh;
  }
  std::string parts = topology_;
  for (Field& field : fields_) {
    const xdmf::Array array = window(field, rows);
    parts += *field.center == '\0' ? xdmf::geometry(field.type, array)
                                   : xdmf::attribute(field.name, field.center, field.type, array);
  }
  if (!waiting_.empty() && waiting_.back().time < frame.time) {
    settled_ += waiting();
    waiting_.clear();
  }
  waiting_.push_back({frames_++, frame.time, std::move(parts)});
}

std::string XdmfWriter::waiting() const {
  std::vector<double> times;
  for (const Waiting& w : waiting_) times.push_back(w.time);
  times = xdmf::told_apart(std::move(times));
  std::string text;
  for (std::size_t i = 0; i < times.size(); ++i) text += xdmf::grid(waiting_[i].number, waiting_[i].parts, times[i]);
  return text;
}

void XdmfWriter::write() {
  const Clock::time_point start = Clock::now();
  write_atomically(xmf_, xdmf::document(settled_ + waiting()));
  const Clock::time_point end = Clock::now();
  next_ = end + std::max<Clock::duration>(kBetween, kShare * (end - start));
}

void XdmfWriter::flush() {
  if (Clock::now() >= next_) write();
}

void XdmfWriter::close() { write(); }

}  // namespace scree::io
