#include "io/results/xdmf_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "io/results/h5_read.h"
#include "io/results/h5_series.h"
#include "io/results/h5_window.h"
#include "model/check.h"

namespace scree::io {

namespace {

constexpr const char* kNode = "Node";
constexpr const char* kCell = "Cell";
constexpr std::string_view kFile = "run.vtkhdf:";
constexpr std::chrono::seconds kBetween{1};
constexpr int kShare = 50;          // writing the text may take 1/50 of the time
constexpr int kMost = 64 * 1024;    // bytes that may wait to be written
constexpr int kRoom = 2048 * 1024;  // bytes of text for which memory is reserved
constexpr int kInText = 100;        // largest number of entries of an array in the text
constexpr std::size_t kDue = 8192;  // windows that may wait in take()

/// HDF5 keeps the names of a group in one piece, which is read and written as a whole with each new name: groups must
/// stay small.
std::string window_name(std::string_view field, std::int64_t n) {
  constexpr std::int64_t kOfGroup = 500;
  return fmt::format("/xdmf/{}/{}/{}", field, n / kOfGroup, n);
}

}  // namespace

XdmfWriter::XdmfWriter(const h5::File& file, std::filesystem::path xmf) : file_(&file), xmf_(std::move(xmf)) {
  fields_ = {
      {"Points", "", "XYZ", "Points", 3, false, &FrameRows::first_point, &FrameValues::points, {}},
      {"displacement",
       kNode,
       "Vector",
       "PointData/displacement",
       3,
       false,
       &FrameRows::first_point,
       &FrameValues::displacement,
       {}},
      {"velocity",
       kNode,
       "Vector",
       "PointData/velocity",
       3,
       false,
       &FrameRows::first_point,
       &FrameValues::velocity,
       {}},
      {"block_id", kCell, "Scalar", "CellData/block_id", 1, true, &FrameRows::first_cell, nullptr, {}},
      {"element_id", kCell, "Scalar", "CellData/element_id", 1, true, &FrameRows::first_cell, nullptr, {}},
      {"material_id", kCell, "Scalar", "CellData/material_id", 1, true, &FrameRows::first_cell, nullptr, {}},
      {"method", kCell, "Scalar", "CellData/method", 1, true, &FrameRows::first_cell, nullptr, {}},
      {"integrator", kCell, "Scalar", "CellData/integrator", 1, true, &FrameRows::first_integrator, nullptr, {}},
      {"displacement",
       kCell,
       "Vector",
       "CellData/displacement",
       3,
       false,
       &FrameRows::first_value,
       &FrameValues::cell_displacement,
       {}},
      {"velocity",
       kCell,
       "Vector",
       "CellData/velocity",
       3,
       false,
       &FrameRows::first_value,
       &FrameValues::cell_velocity,
       {}},
      {"stress", kCell, "Vector", "CellData/stress", 3, false, &FrameRows::first_value, &FrameValues::stress, {}},
      {"principal_stress",
       kCell,
       "Matrix",
       "CellData/principal_stress",
       2,
       false,
       &FrameRows::first_value,
       &FrameValues::principal_stress,
       {}},
  };
  for (Field& field : fields_)
    field.label = {h5::text_attribute(file, "/VTKHDF/" + field.path, "units"),
                   h5::text_attribute(file, "/VTKHDF/" + field.path, "long_name")};
  due_.reserve(kDue + fields_.size());
  settled_.assign(kRoom, '\0');  // reserves memory from the start: a second with many frames needs no more
  settled_ = xdmf::opening();
  file.group("/xdmf");
}

std::string XdmfWriter::topology(std::span<const std::int32_t> offsets, std::span<const std::int32_t> connectivity,
                                 std::int64_t number) {
  const std::vector<std::int32_t> mixed = xdmf::mixed_polygons(offsets, connectivity);
  const std::string name = fmt::format("/xdmf/topology/{}", number);
  h5::write<std::int32_t>(*file_, name, 1, mixed, {"1", "a cell: 3 for polygon, number of points, points"});
  return xdmf::topology(static_cast<std::int64_t>(offsets.size()) - 1,
                        {std::string(kFile) + name, static_cast<std::int64_t>(mixed.size()), 1, true, {}});
}

std::int64_t XdmfWriter::count(const Field& field, const FrameRows& rows) {
  return std::string_view(field.center) == kCell ? rows.cells : rows.points;
}

bool XdmfWriter::in_text(const Field& field, const FrameRows& rows) {
  return field.values != nullptr && count(field, rows) * field.width <= kInText;
}

xdmf::Array XdmfWriter::window(std::size_t field, const FrameRows& rows) {
  Field& f = fields_[field];
  const std::int64_t first = rows.*f.first;
  if (f.shown != first) {
    due_.push_back({field, f.made, first, count(f, rows)});
    f.shown = first;
    ++f.made;
  }
  return {std::string(kFile) + window_name(f.path, f.made - 1), count(f, rows), f.width, f.whole, {}};
}

void XdmfWriter::settle() {
  // Field by field: consecutive windows are in one group of the file.
  std::stable_sort(due_.begin(), due_.end(), [](const Due& a, const Due& b) { return a.field < b.field; });
  for (const Due& d : due_) {
    const Field& f = fields_[d.field];
    h5::window(*file_, window_name(f.path, d.number), {"/VTKHDF/" + f.path, d.first, d.count, f.width, f.whole},
               f.label);
  }
  due_.clear();
}

void XdmfWriter::frame(const coupling::FrameView& frame, const FrameRows& rows, const FrameValues& values) {
  if (mesh_ != rows.mesh) {
    topology_ = topology(frame.mesh->offsets, frame.mesh->connectivity, rows.mesh);
    mesh_ = rows.mesh;
  }
  add(frame.time, rows, values);
}

void XdmfWriter::take(const h5::File& from, std::int64_t frames) {
  const std::string vtk = "/VTKHDF/";
  FrameValues values;
  for (std::int64_t k = 0; k < frames; ++k) {
    const FrameRows rows = VtkhdfWriter::rows_of(from, k);
    if (mesh_ != rows.mesh) {
      // The offsets of mesh m begin m rows after its first cell: each mesh has one more offset than cells (VTKHDF 2.0).
      const auto numbers = [&](const std::string& name, std::int64_t first, std::int64_t count) {
        const std::vector<std::int64_t> wide =
            h5::from_whole([&] { return h5::read<std::int64_t>(from, vtk + name, first, count); });
        return std::vector<std::int32_t>(wide.begin(), wide.end());
      };
      topology_ = topology(numbers("Offsets", rows.first_cell + rows.mesh, rows.cells + 1),
                           numbers("Connectivity", numbers("Steps/ConnectivityIdOffsets", k, 1).front(),
                                   numbers("NumberOfConnectivityIds", rows.mesh, 1).front()),
                           rows.mesh);
      mesh_ = rows.mesh;
    }
    for (const Field& f : fields_)
      if (in_text(f, rows))
        values.*f.values =
            h5::from_whole([&] { return h5::read<double>(from, vtk + f.path, rows.*f.first, count(f, rows)); });
    add(h5::from_whole([&] { return h5::read<double>(from, vtk + "Steps/Values", k, 1).front(); }), rows, values);
    if (due_.size() > kDue) settle();
  }
  settle();
}

void XdmfWriter::add(double time, const FrameRows& rows, const FrameValues& values) {
  std::string parts = topology_;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = fields_[i];
    const xdmf::Array array = in_text(field, rows)
                                  ? xdmf::Array{{}, count(field, rows), field.width, field.whole, values.*field.values}
                                  : window(i, rows);
    parts += *field.center == '\0' ? xdmf::geometry(field.type, array)
                                   : xdmf::attribute(field.name, field.center, field.type, array);
  }
  if (!waiting_.empty() && waiting_.back().time < time) {
    settled_ += waiting();
    waiting_.clear();
  }
  waiting_.push_back({frames_++, time, std::move(parts)});
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
  auto file = std::make_unique<AtomicFile>(xmf_);
  if (written_) file->copy(*written_, kept_);
  file->write(settled_);
  file->write(waiting());
  file->write(xdmf::closing());
  file->commit();
  kept_ += std::ssize(settled_);
  settled_.clear();
  written_ = std::move(file);
  const Clock::time_point end = Clock::now();
  next_ = end + std::max<Clock::duration>(kBetween, kShare * (end - start));
}

bool XdmfWriter::full() const { return std::ssize(settled_) > kRoom - kMost; }

void XdmfWriter::flush() {
  if (frames_ == 0) return;  // readers cannot open a run without a frame
  if (Clock::now() >= next_ || std::ssize(settled_) > kMost) write();
}

void XdmfWriter::close() {
  SCREE_ASSERT(due_.empty());
  write();
}

}  // namespace scree::io
