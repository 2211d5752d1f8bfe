#include "io/results/run_reader.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "coupling/sink.h"
#include "io/results/h5_read.h"
#include "io/results/run_folder.h"

namespace scree::io {

struct RunReader::Data {
  h5::File file;
  std::string title;
  Vec2 origin{0.0, 0.0};
  std::vector<double> times;
  std::vector<std::string> methods, stages;
  std::vector<StoredBlock> blocks;
  std::vector<StoredMaterial> materials;
};

namespace {

std::vector<StoredBlock> read_blocks(const h5::File& file) {
  std::vector<StoredBlock> blocks;
  for (const std::string& name : h5::read_texts(file, "/blocks/name")) blocks.push_back({name, false, {}, 0});
  const auto material = h5::read<std::int32_t>(file, "/blocks/material");
  const auto held = h5::read<std::int32_t>(file, "/blocks/held");
  const auto owner = h5::read<std::int32_t>(file, "/blocks/ring_block");
  const auto offset = h5::read<std::int64_t>(file, "/blocks/ring_offset");
  const auto point = h5::read<double>(file, "/blocks/point");
  if (held.size() != blocks.size() || material.size() != blocks.size() || offset.size() != owner.size() + 1)
    throw FileError(file.path(), "/blocks does not fit together");
  for (std::size_t b = 0; b < blocks.size(); ++b) blocks[b].held = held[b] != 0, blocks[b].material = material[b];
  for (std::size_t r = 0; r < owner.size(); ++r) {
    Ring ring;
    for (std::int64_t i = offset[r]; i < offset[r + 1]; ++i)
      ring.emplace_back(point.at(static_cast<std::size_t>(2 * i)), point.at(static_cast<std::size_t>(2 * i + 1)));
    Polygon& polygon = blocks.at(static_cast<std::size_t>(owner[r])).polygon;
    if (polygon.outer.empty())
      polygon.outer = std::move(ring);
    else
      polygon.holes.push_back(std::move(ring));
  }
  return blocks;
}

std::vector<StoredMaterial> read_materials(const h5::File& file) {
  const std::vector<std::string> names = h5::read_texts(file, "/materials/name");
  const auto column = [&](const char* name) {
    return h5::read<double>(file, std::string("/materials/") + name, 0, static_cast<std::int64_t>(names.size()));
  };
  const auto young = column("young"), density = column("density"), poisson = column("poisson");
  std::vector<StoredMaterial> materials;
  for (std::size_t m = 0; m < names.size(); ++m) materials.push_back({names[m], young[m], density[m], poisson[m]});
  if (!file.has("/materials/mohr_coulomb") || !file.has("/materials/hoek_brown")) return materials;
  const auto rows = static_cast<std::int64_t>(names.size());
  const auto mohr = h5::read<double>(file, "/materials/mohr_coulomb", 0, rows),
             hoek = h5::read<double>(file, "/materials/hoek_brown", 0, rows);
  for (std::size_t m = 0; m < names.size(); ++m) {
    if (!std::isnan(mohr[3 * m]))
      materials[m].strength = MohrCoulombStrength{mohr[3 * m], mohr[3 * m + 1], mohr[3 * m + 2]};
    if (!std::isnan(hoek[4 * m]))
      materials[m].strength = HoekBrownStrength{hoek[4 * m], hoek[4 * m + 1], hoek[4 * m + 2], hoek[4 * m + 3]};
  }
  return materials;
}

/// x, y from rows of x, y, z.
std::vector<double> in_plane(const std::vector<double>& xyz) {
  std::vector<double> xy;
  xy.reserve(xyz.size() / 3 * 2);
  for (std::size_t i = 0; i + 2 < xyz.size(); i += 3) xy.insert(xy.end(), {xyz[i], xyz[i + 1]});
  return xy;
}

/// Checks the assumptions of drawings: cells and ids refer to entries inside their arrays.
void check_cells(const h5::File& file, const StoredFrame& f, std::size_t blocks, std::size_t methods,
                 std::size_t materials) {
  const auto inside = [](std::int64_t i, std::size_t size) { return i >= 0 && static_cast<std::size_t>(i) < size; };
  bool good = f.offsets.front() == 0 && f.offsets.back() == static_cast<std::int64_t>(f.connectivity.size()) &&
              std::is_sorted(f.offsets.begin(), f.offsets.end());
  for (const std::int64_t p : f.connectivity) good = good && inside(p, f.points());
  for (const std::int32_t b : f.block) good = good && inside(b, blocks);
  for (const std::int32_t m : f.method) good = good && inside(m, methods);
  for (const std::int32_t m : f.material) good = good && inside(m, materials);
  if (!good)
    throw FileError(file.path(), "frame " + std::to_string(f.index) + " does not fit together; the file is damaged");
}

std::vector<StoredJointLine> read_lines(const h5::File& file, const std::string& group, std::size_t laws) {
  const auto law = h5::read<std::int32_t>(file, group + "/joint");
  const auto ends = [&](const char* name) {
    return h5::read<double>(file, group + name, 0, static_cast<std::int64_t>(law.size()));
  };
  const auto from = ends("/from"), to = ends("/to");
  std::vector<StoredJointLine> lines;
  for (std::size_t i = 0; i < law.size(); ++i) {
    if (law[i] < 0 || static_cast<std::size_t>(law[i]) >= laws)
      throw FileError(file.path(), group + " does not fit together");
    lines.push_back({{from[2 * i], from[2 * i + 1]}, {to[2 * i], to[2 * i + 1]}, law[i]});
  }
  return lines;
}

bool has_child(const h5::File& file, const std::string& group, const std::string& name) {
  const std::vector<std::string> there = h5::children(file, group);
  return std::find(there.begin(), there.end(), name) != there.end();
}

/// Entry of frame, or mesh, k in a list of numbers.
std::int64_t entry(const h5::File& file, const std::string& name, std::int64_t k) {
  return h5::read<std::int64_t>(file, name, k, 1).front();
}

}  // namespace

RunReader::RunReader(const std::filesystem::path& run_folder) : data_(std::make_unique<Data>()) {
  data_->file = h5::File::open(RunFolder::open(run_folder).results());
  const h5::File& file = data_->file;
  data_->title = h5::text_attribute(file, "/", "title");
  const std::array<double, 2> origin = h5::pair_attribute(file, "/", "origin");
  data_->origin = {origin[0], origin[1]};
  data_->times = h5::read<double>(file, "/VTKHDF/Steps/Values");
  // A run that was killed may have times without the count, or the count of the flush before: the smaller number of
  // frames is complete.
  const auto whole =
      static_cast<std::size_t>(std::max<std::int64_t>(0, h5::integer_attribute(file, "/VTKHDF/Steps", "NSteps")));
  data_->times.resize(std::min(data_->times.size(), whole));
  data_->methods = h5::read_texts(file, "/methods/name");
  data_->stages = h5::read_texts(file, "/stages/name");
  data_->blocks = read_blocks(file);
  data_->materials = read_materials(file);
}

RunReader::~RunReader() = default;
RunReader::RunReader(RunReader&&) noexcept = default;

const std::string& RunReader::title() const { return data_->title; }
const Vec2& RunReader::origin() const { return data_->origin; }
const std::vector<double>& RunReader::times() const { return data_->times; }
const std::vector<std::string>& RunReader::methods() const { return data_->methods; }
const std::vector<StoredBlock>& RunReader::blocks() const { return data_->blocks; }
const std::vector<StoredMaterial>& RunReader::materials() const { return data_->materials; }

std::vector<StoredStage> RunReader::stages() const {
  const h5::File& file = data_->file;
  const auto frames = static_cast<std::int64_t>(times().size());
  const auto of_frame = h5::read<std::int32_t>(file, "/frames/stage", 0, frames);
  const std::vector<std::string> integrators = h5::read_texts(file, "/stages/integrator");
  const auto duration = h5::read<double>(file, "/stages/duration", 0, static_cast<std::int64_t>(data_->stages.size()));
  std::vector<StoredStage> stages;
  for (std::size_t i = 0; i < data_->stages.size(); ++i) {
    const auto first = std::find(of_frame.begin(), of_frame.end(), static_cast<std::int32_t>(i));
    StoredStage stage{data_->stages[i], integrators.at(i), {}, duration[i]};
    if (first != of_frame.end()) stage.start = times()[static_cast<std::size_t>(first - of_frame.begin())];
    stages.push_back(std::move(stage));
  }
  return stages;
}

std::string RunReader::provenance(const std::string& key) const {
  return h5::text_attribute(data_->file, "/provenance", key);
}

std::vector<std::string> RunReader::provenance_list(const std::string& key) const {
  if (!has_child(data_->file, "/provenance", key)) return {};
  return h5::read_texts(data_->file, "/provenance/" + key);
}

std::size_t RunReader::at_time(double time) const {
  const double tolerance = 1e-12;  // a tick of the integer time [s]
  const auto after = std::upper_bound(times().begin(), times().end(), time + tolerance);
  return after == times().begin() ? 0 : static_cast<std::size_t>(after - times().begin() - 1);
}

StoredFrame RunReader::frame(std::size_t index) const {
  const h5::File& file = data_->file;
  if (index >= times().size())
    throw FileError(file.path(),
                    "has no frame " + std::to_string(index) + "; there are " + std::to_string(times().size()));
  const std::string vtk = "/VTKHDF/", steps = "/VTKHDF/Steps/";
  StoredFrame f;
  f.index = static_cast<std::int64_t>(index);
  f.time = times()[index];
  const std::int64_t k = f.index;
  f.step = entry(file, "/frames/step", k);
  f.state_hash = h5::read<std::uint64_t>(file, "/frames/state_hash", k, 1).front();
  f.integrator = coupling::name(
      static_cast<coupling::Integrator>(h5::read<std::int32_t>(file, "/frames/integrator", k, 1).front()));
  const auto stage = static_cast<std::size_t>(h5::read<std::int32_t>(file, "/frames/stage", k, 1).front());
  if (stage < data_->stages.size()) f.stage = data_->stages[stage];

  f.mesh = entry(file, steps + "PartOffsets", k);
  const std::int64_t points = entry(file, vtk + "NumberOfPoints", f.mesh),
                     cells = entry(file, vtk + "NumberOfCells", f.mesh);
  const std::int64_t ids = entry(file, vtk + "NumberOfConnectivityIds", f.mesh),
                     first = entry(file, steps + "CellOffsets", k);
  f.connectivity =
      h5::read<std::int64_t>(file, vtk + "Connectivity", entry(file, steps + "ConnectivityIdOffsets", k), ids);
  f.offsets = h5::read<std::int64_t>(file, vtk + "Offsets", first + f.mesh, cells + 1);  // per mesh one more than cells
  f.position = in_plane(h5::read<double>(file, vtk + "Points", entry(file, steps + "PointOffsets", k), points));

  const auto of_points = [&](const std::string& name) {
    return in_plane(
        h5::read<double>(file, vtk + "PointData/" + name, entry(file, steps + "PointDataOffsets/" + name, k), points));
  };
  const auto of_cells = [&]<class T>(const std::string& name, std::vector<T>& out) {
    out = h5::read<T>(file, vtk + "CellData/" + name, entry(file, steps + "CellDataOffsets/" + name, k), cells);
  };
  f.displacement = of_points("displacement");
  f.velocity = of_points("velocity");
  of_cells("block_id", f.block);
  of_cells("element_id", f.element);
  of_cells("material_id", f.material);
  of_cells("method", f.method);
  of_cells("integrator", f.cell_integrator);
  of_cells("displacement", f.cell_displacement);
  of_cells("velocity", f.cell_velocity);
  f.cell_displacement = in_plane(f.cell_displacement);
  f.cell_velocity = in_plane(f.cell_velocity);
  of_cells("stress", f.stress);
  of_cells("principal_stress", f.principal);
  check_cells(file, f, blocks().size(), methods().size(), materials().size());
  return f;
}

std::vector<StoredNote> RunReader::notes() const {
  const h5::File& file = data_->file;
  const auto count = static_cast<std::int64_t>(times().size());
  const auto step = h5::read<std::int64_t>(file, "/frames/step", 0, count),
             mesh = h5::read<std::int64_t>(file, "/VTKHDF/Steps/PartOffsets", 0, count);
  const auto stage = h5::read<std::int32_t>(file, "/frames/stage", 0, count),
             integrator = h5::read<std::int32_t>(file, "/frames/integrator", 0, count);
  std::vector<StoredNote> notes;
  for (std::size_t i = 0; i < times().size(); ++i) {
    StoredNote note{step[i],
                    mesh[i],
                    times()[i],
                    {},
                    std::string(coupling::name(static_cast<coupling::Integrator>(integrator[i])))};
    if (static_cast<std::size_t>(stage[i]) < data_->stages.size())
      note.stage = data_->stages[static_cast<std::size_t>(stage[i])];
    notes.push_back(std::move(note));
  }
  return notes;
}

StoredLedger RunReader::ledger() const {
  const h5::File& file = data_->file;
  StoredLedger ledger;
  ledger.time = h5::read<double>(file, "/energy/time");
  // The times are written last: every column has at least as many complete rows.
  const auto rows = static_cast<std::int64_t>(ledger.time.size());
  const auto column = [&](const std::string& name) { return h5::read<double>(file, "/energy/" + name, 0, rows); };
  ledger.energy = column("energy");
  ledger.closure = column("closure");
  ledger.moved = column("moved");
  const std::vector<std::string> names = h5::children(file, "/energy");
  const bool has_passed = std::find(names.begin(), names.end(), "passed") != names.end();
  ledger.passed = has_passed ? column("passed") : ledger.moved;
  std::vector<std::pair<std::int64_t, StoredLedger::Column>> found;
  for (const std::string& name : names) {
    const std::string path = "/energy/" + name, side = h5::text_attribute(file, path, "side");
    if (side.empty()) continue;
    found.push_back({h5::integer_attribute(file, path, "order"),
                     {name, side, h5::text_attribute(file, path, "long_name"), column(name)}});
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [order, c] : found) ledger.columns.push_back(std::move(c));
  return ledger;
}

std::vector<StoredMonitor> RunReader::monitors() const {
  const h5::File& file = data_->file;
  std::vector<std::pair<std::int64_t, StoredMonitor>> found;
  for (const std::string& name : h5::children(file, "/history")) {
    const std::string group = "/history/" + name + "/";
    const auto time = h5::read<double>(file, group + "time");
    const auto rows = static_cast<std::int64_t>(time.size());
    const auto pairs = [&](const char* what) { return h5::read<double>(file, group + what, 0, rows); };
    const std::string given = h5::text_attribute(file, "/history/" + name, "name");
    StoredMonitor monitor{name, given, time, pairs("position"), pairs("displacement"), pairs("velocity"), {}};
    const std::vector<std::string> there = h5::children(file, "/history/" + name);
    if (std::find(there.begin(), there.end(), "stress") != there.end()) monitor.stress = pairs("stress");
    const bool ordered = h5::has_attribute(file, "/history/" + name, "order");
    found.emplace_back(ordered ? h5::integer_attribute(file, "/history/" + name, "order") : 0, std::move(monitor));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<StoredMonitor> monitors;
  monitors.reserve(found.size());
  for (auto& [order, monitor] : found) monitors.push_back(std::move(monitor));
  return monitors;
}

std::vector<StoredEvent> RunReader::events() const {
  const h5::File& file = data_->file;
  const auto time = h5::read<double>(file, "/events/time");
  const std::vector<std::string> kind = h5::read_texts(file, "/events/kind"),
                                 text = h5::read_texts(file, "/events/text");
  // The times are written last, as in the ledger.
  if (kind.size() < time.size() || text.size() < time.size()) throw FileError(file.path(), "/events is damaged");
  std::vector<StoredEvent> events;
  for (std::size_t i = 0; i < time.size(); ++i) events.push_back({time[i], kind[i], text[i]});
  return events;
}

std::vector<StoredProgress> RunReader::progress() const {
  const h5::File& file = data_->file;
  if (!has_child(file, "/", "progress")) return {};
  const std::string g = "/progress/";
  // The unknowns are written last.
  const auto unknowns = h5::read<std::int64_t>(file, g + "unknowns");
  const std::size_t rows = std::min(unknowns.size(), times().size());
  const auto count = static_cast<std::int64_t>(rows);
  const auto cuts = h5::read<std::int64_t>(file, g + "cuts", 0, count),
             passes = h5::read<std::int64_t>(file, g + "passes", 0, count),
             contacts = h5::read<std::int64_t>(file, g + "contacts", 0, count);
  const auto depth = h5::read<double>(file, g + "contact_depth", 0, count),
             force = h5::read<double>(file, g + "contact_force", 0, count);
  const std::vector<std::string> depth_at = h5::read_texts(file, g + "contact_depth_at"),
                                 force_at = h5::read_texts(file, g + "contact_force_at");
  if (depth_at.size() < rows || force_at.size() < rows) throw FileError(file.path(), "/progress is damaged");
  std::vector<StoredProgress> progress;
  for (std::size_t i = 0; i < rows; ++i)
    progress.push_back(
        {cuts[i], passes[i], contacts[i], unknowns[i], {times()[i], depth[i], force[i], depth_at[i], force_at[i]}});
  return progress;
}

StoredJoints RunReader::joints() const {
  const h5::File& file = data_->file;
  StoredJoints joints;
  const std::vector<std::string> names = h5::read_texts(file, "/joints/name");
  const auto column = [&](const char* name) {
    return h5::read<double>(file, std::string("/joints/") + name, 0, static_cast<std::int64_t>(names.size()));
  };
  const auto friction = column("friction_deg"), cohesion = column("cohesion"), tension = column("tensile_strength");
  for (std::size_t j = 0; j < names.size(); ++j)
    joints.laws.push_back({names[j], friction[j], cohesion[j], tension[j]});
  joints.lines = read_lines(file, "/joints/lines", names.size());
  joints.cracks = read_lines(file, "/joints/cracks", names.size());
  return joints;
}

std::vector<StoredSupport> RunReader::supports() const {
  const h5::File& file = data_->file;
  if (!has_child(file, "/", "supports")) return {};
  const auto fix_x = h5::read<std::int32_t>(file, "/supports/fix_x");
  const auto count = static_cast<std::int64_t>(fix_x.size());
  const auto fix_y = h5::read<std::int32_t>(file, "/supports/fix_y", 0, count);
  const auto point = h5::read<double>(file, "/supports/point", 0, count);
  std::vector<StoredSupport> supports;
  for (std::size_t i = 0; i < fix_x.size(); ++i)
    supports.push_back({{point[2 * i], point[2 * i + 1]}, fix_x[i] != 0, fix_y[i] != 0});
  return supports;
}

std::vector<StoredEdgeSupport> RunReader::edge_supports() const {
  const h5::File& file = data_->file;
  if (!has_child(file, "/", "supports") || !has_child(file, "/supports", "line")) return {};
  const auto line = h5::read<double>(file, "/supports/line");
  const auto count = static_cast<std::int64_t>(line.size() / 4);
  const auto held = h5::read<double>(file, "/supports/line_held", 0, count);
  std::vector<StoredEdgeSupport> out;
  for (std::size_t i = 0; i + 3 < line.size(); i += 4) {
    StoredEdgeSupport s{{line[i], line[i + 1]}, {line[i + 2], line[i + 3]}, Mat2::Identity()};
    const std::size_t k = 3 * (i / 4);
    s.held << held[k], held[k + 2], held[k + 2], held[k + 1];
    out.push_back(s);
  }
  return out;
}

std::vector<StoredWater> RunReader::waters() const {
  const h5::File& file = data_->file;
  if (!has_child(file, "/", "water")) return {};
  std::vector<StoredWater> waters(h5::read<double>(file, "/water/unit_weight").size());
  const auto line_of = [&](std::int32_t line) -> StoredWater& {
    if (line < 0 || static_cast<std::size_t>(line) >= waters.size())
      throw FileError(file.path(), "/water names a line that is not there; the file is damaged");
    return waters[static_cast<std::size_t>(line)];
  };
  const auto point_line = h5::read<std::int32_t>(file, "/water/point_line");
  const auto point = h5::read<double>(file, "/water/point", 0, static_cast<std::int64_t>(point_line.size()));
  for (std::size_t i = 0; i < point_line.size(); ++i)
    line_of(point_line[i]).line.emplace_back(point[2 * i], point[2 * i + 1]);
  const auto joint_line = h5::read<std::int32_t>(file, "/water/joint_line");
  const auto joint = h5::read<std::int32_t>(file, "/water/joint", 0, static_cast<std::int64_t>(joint_line.size()));
  for (std::size_t i = 0; i < joint_line.size(); ++i) line_of(joint_line[i]).joints.push_back(joint[i]);
  return waters;
}

bool RunReader::has_contacts() const { return has_child(data_->file, "/", "contacts"); }

StoredContacts RunReader::contacts(std::size_t frame) const {
  const h5::File& file = data_->file;
  const std::string g = "/contacts/";
  const std::int64_t first = entry(file, g + "frames/first", static_cast<std::int64_t>(frame)),
                     count = entry(file, g + "frames/count", static_cast<std::int64_t>(frame));
  const auto numbers = [&](const char* name) { return h5::read<double>(file, g + name, first, count); };
  const auto ids = [&](const char* name) { return h5::read<std::int32_t>(file, g + name, first, count); };
  StoredContacts c{numbers("position"),
                   numbers("normal"),
                   numbers("fn"),
                   numbers("ft"),
                   numbers("gap"),
                   numbers("slip"),
                   ids("state"),
                   ids("failed"),
                   ids("joint"),
                   {},
                   {}};
  const auto corner = ids("corner"), edge = ids("edge");
  for (std::int64_t i = 0; i < count; ++i) {
    c.corner_block.push_back(corner[static_cast<std::size_t>(4 * i)]);
    c.edge_block.push_back(edge[static_cast<std::size_t>(3 * i)]);
  }
  for (const auto* blocks_of : {&c.corner_block, &c.edge_block})
    for (const std::int32_t b : *blocks_of)
      if (b < 0 || static_cast<std::size_t>(b) >= blocks().size())
        throw FileError(file.path(), "/contacts does not fit together; the file is damaged");
  return c;
}

bool RunReader::has_bolts() const { return has_child(data_->file, "/", "bolt_nodes"); }

StoredBolts RunReader::bolts(std::size_t frame) const {
  if (!has_bolts()) return {};
  const h5::File& file = data_->file;
  const std::string g = "/bolt_nodes/";
  const std::int64_t first = entry(file, g + "frames/first", static_cast<std::int64_t>(frame)),
                     count = entry(file, g + "frames/count", static_cast<std::int64_t>(frame));
  return {h5::read<std::int32_t>(file, g + "bolt", first, count), h5::read<double>(file, g + "position", first, count),
          h5::read<double>(file, g + "force", first, count)};
}

double RunReader::end_time() const {
  const auto durations = h5::read<double>(data_->file, "/stages/duration");
  double end = 0.0;
  std::size_t over = 0;  // number of stages that are over; they may have been shorter than planned
  for (const StoredEvent& e : events()) {
    if (e.kind != "stage_end" || over == durations.size()) continue;
    end = e.time;
    ++over;
  }
  return std::accumulate(durations.begin() + static_cast<std::ptrdiff_t>(over), durations.end(), end);
}

std::vector<DatasetNote> RunReader::datasets() const {
  std::vector<DatasetNote> notes;
  for (const std::string& name : h5::datasets(data_->file))
    notes.push_back({name, h5::text_attribute(data_->file, name, "units"),
                     h5::text_attribute(data_->file, name, "long_name"), h5::extent(data_->file, name).rows});
  return notes;
}

}  // namespace scree::io
