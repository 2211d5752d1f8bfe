#include "io/results/xdmf_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/results/h5_read.h"
#include "io/results/h5_series.h"
#include "io/results/h5_window.h"
#include "io/results/run_folder.h"

namespace scree::io {

namespace {

constexpr std::int32_t kPolygon = 3;  // XDMF's number for it in a mixed topology
constexpr std::chrono::seconds kBetween{1};
constexpr int kShare = 50;  // a text may take 1/50 of the time

/// Time before `time` by a tick, or by what a double can still tell apart.
double just_before(double time) {
  const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * std::abs(time);
  return time - std::max(seconds(Tick{1}), rounding);
}

std::string grid(const std::string& text, double time) {
  return fmt::format("{}<Time Value=\"{:.17g}\"/>\n</Grid>\n", text, time);
}

}  // namespace

XdmfWriter::XdmfWriter(const h5::File& file, std::filesystem::path xmf) : file_(&file), xmf_(std::move(xmf)) {
  const std::string points = "/VTKHDF/PointData/", cells = "/VTKHDF/CellData/";
  fields_ = {
      {"Points", "", "XYZ", "/VTKHDF/Points", 3, false, &FrameRows::first_point, {}},
      {"displacement", "Node", "Vector", points + "displacement", 3, false, &FrameRows::first_point, {}},
      {"velocity", "Node", "Vector", points + "velocity", 3, false, &FrameRows::first_point, {}},
      {"block_id", "Cell", "Scalar", cells + "block_id", 1, true, &FrameRows::first_cell, {}},
      {"element_id", "Cell", "Scalar", cells + "element_id", 1, true, &FrameRows::first_cell, {}},
      {"material_id", "Cell", "Scalar", cells + "material_id", 1, true, &FrameRows::first_cell, {}},
      {"method", "Cell", "Scalar", cells + "method", 1, true, &FrameRows::first_cell, {}},
      {"integrator", "Cell", "Scalar", cells + "integrator", 1, true, &FrameRows::first_integrator, {}},
      {"stress", "Cell", "Vector", cells + "stress", 3, false, &FrameRows::first_stress, {}},
      {"principal_stress", "Cell", "Matrix", cells + "principal_stress", 2, false, &FrameRows::first_stress, {}},
  };
  for (Field& field : fields_)
    field.label = {h5::text_attribute(file, field.source, "units"),
                   h5::text_attribute(file, field.source, "long_name")};
  file.group("/xdmf");
}

std::string XdmfWriter::topology(const coupling::MeshView& mesh, std::int64_t number) {
  const std::size_t cells = mesh.cell_block.size();
  std::vector<std::int32_t> mixed;
  mixed.reserve(mesh.connectivity.size() + 2 * cells);
  for (std::size_t c = 0; c < cells; ++c) {
    const auto first = static_cast<std::size_t>(mesh.offsets[c]), end = static_cast<std::size_t>(mesh.offsets[c + 1]);
    mixed.insert(mixed.end(), {kPolygon, static_cast<std::int32_t>(end - first)});
    mixed.insert(mixed.end(), mesh.connectivity.begin() + static_cast<std::ptrdiff_t>(first),
                 mesh.connectivity.begin() + static_cast<std::ptrdiff_t>(end));
  }
  const std::string name = fmt::format("/xdmf/topology/{}", number);
  h5::write<std::int32_t>(*file_, name, 1, mixed, {"1", "a cell: 3 for polygon, number of points, points"});
  return fmt::format(
      "<Topology TopologyType=\"Mixed\" NumberOfElements=\"{}\">\n"
      "<DataItem Format=\"HDF\" NumberType=\"Int\" Precision=\"4\" Dimensions=\"{}\">run.vtkhdf:{}</DataItem>\n"
      "</Topology>\n",
      cells, mixed.size(), name);
}

std::string XdmfWriter::item(Field& field, const FrameRows& rows) {
  const bool of_cells = std::string_view(field.center) == "Cell";
  const std::int64_t first = rows.*field.first, count = of_cells ? rows.cells : rows.points;
  if (field.shown != first) {
    h5::window(*file_, fmt::format("/xdmf/{}/{}", field.name, field.made), {field.source, first, count}, field.label);
    field.shown = first;
    ++field.made;
  }
  return fmt::format(
      "<DataItem Format=\"HDF\" NumberType=\"{}\" Precision=\"{}\" Dimensions=\"{}{}\">run.vtkhdf:/xdmf/{}/{}"
      "</DataItem>\n",
      field.whole ? "Int" : "Float", field.whole ? 4 : 8, count, field.width > 1 ? fmt::format(" {}", field.width) : "",
      field.name, field.made - 1);
}

void XdmfWriter::frame(const coupling::FrameView& frame, const FrameRows& rows) {
  if (mesh_ != rows.mesh) {
    topology_ = topology(*frame.mesh, rows.mesh);
    mesh_ = rows.mesh;
  }
  std::string text = fmt::format("<Grid Name=\"frame {}\">\n{}", frames_++, topology_);
  for (Field& field : fields_) {
    if (*field.center == '\0')
      text += fmt::format("<Geometry GeometryType=\"{}\">\n{}</Geometry>\n", field.type, item(field, rows));
    else
      text += fmt::format("<Attribute Name=\"{}\" Center=\"{}\" AttributeType=\"{}\">\n{}</Attribute>\n", field.name,
                          field.center, field.type, item(field, rows));
  }
  if (!waiting_.empty() && waiting_.back().time < frame.time) {
    settled_ += waiting();
    waiting_.clear();
  }
  waiting_.push_back({frame.time, std::move(text)});
}

std::string XdmfWriter::waiting() const {
  std::vector<double> time;
  for (const Waiting& w : waiting_) time.push_back(w.time);
  for (std::size_t i = time.size(); i-- > 1;) time[i - 1] = std::min(time[i - 1], just_before(time[i]));
  std::string text;
  for (std::size_t i = 0; i < time.size(); ++i) text += grid(waiting_[i].text, time[i]);
  return text;
}

void XdmfWriter::write() {
  const Clock::time_point start = Clock::now();
  write_atomically(xmf_, fmt::format("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
                                     "<!-- Frames of run.vtkhdf for ParaView. Made by Scree. -->\n"
                                     "<Xdmf Version=\"3.0\">\n<Domain>\n"
                                     "<Grid Name=\"run\" GridType=\"Collection\" CollectionType=\"Temporal\">\n"
                                     "{}{}</Grid>\n</Domain>\n</Xdmf>\n",
                                     settled_, waiting()));
  const Clock::time_point end = Clock::now();
  next_ = end + std::max<Clock::duration>(kBetween, kShare * (end - start));
}

void XdmfWriter::flush() {
  if (Clock::now() >= next_) write();
}

void XdmfWriter::close() { write(); }

}  // namespace scree::io
