#include "io/report/run_text.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/results/rock_use.h"
#include "io/results/run_folder.h"

namespace scree::io {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr std::size_t kMostRows = 4000;  // of histories and the ledger: more than a chart has pixels

/// The middle of the model in whole metres: float32 then resolves positions to 1e-7 of its extent.
Vec2 base_of(const RunReader& run) {
  Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
  for (const StoredBlock& block : run.blocks())
    for (const Vec2& p : block.polygon.outer) low = low.cwiseMin(p), high = high.cwiseMax(p);
  if (!(low.x() <= high.x())) return {0.0, 0.0};
  return {std::round(0.5 * (low.x() + high.x())), std::round(0.5 * (low.y() + high.y()))};
}

OrderedJson ring_json(const Ring& ring, const Vec2& base) {
  OrderedJson out = OrderedJson::array();
  for (const Vec2& p : ring) {
    out.push_back(static_cast<float>(p.x() - base.x()));
    out.push_back(static_cast<float>(p.y() - base.y()));
  }
  return out;
}

OrderedJson model_json(const RunReader& run, const Vec2& base) {
  OrderedJson blocks = OrderedJson::array(), materials = OrderedJson::array(), laws = OrderedJson::array();
  for (const StoredBlock& b : run.blocks()) {
    OrderedJson rings = OrderedJson::array({ring_json(b.polygon.outer, base)});
    for (const Ring& hole : b.polygon.holes) rings.push_back(ring_json(hole, base));
    blocks.push_back({{"name", b.name}, {"material", b.material}, {"held", b.held}, {"rings", std::move(rings)}});
  }
  for (const StoredMaterial& m : run.materials())
    materials.push_back({{"name", m.name}, {"density", m.density}, {"young", m.young}, {"poisson", m.poisson}});
  const StoredJoints joints = run.joints();
  for (const StoredJoints::Law& law : joints.laws)
    laws.push_back({{"name", law.name},
                    {"friction_deg", law.friction_deg},
                    {"cohesion", law.cohesion},
                    {"tensile_strength", law.tensile_strength}});
  const auto lines = [&](const std::vector<StoredJointLine>& pieces) {
    OrderedJson out = OrderedJson::array();
    for (const StoredJointLine& l : pieces)
      out.push_back({static_cast<float>(l.from.x() - base.x()), static_cast<float>(l.from.y() - base.y()),
                     static_cast<float>(l.to.x() - base.x()), static_cast<float>(l.to.y() - base.y()), l.law});
    return out;
  };
  OrderedJson supports = OrderedJson::array();
  for (const StoredSupport& s : run.supports())
    supports.push_back(
        {static_cast<float>(s.point.x() - base.x()), static_cast<float>(s.point.y() - base.y()), s.fix_x, s.fix_y});
  OrderedJson edges = OrderedJson::array();
  for (const StoredEdgeSupport& s : run.edge_supports()) {
    OrderedJson edge = OrderedJson::array();
    for (const Vec2& p : {s.from, s.to})
      for (const Eigen::Index axis : {0, 1}) edge.push_back(static_cast<float>(p[axis] - base[axis]));
    edge.push_back(s.held.trace() > 1.5);  // both directions
    edges.push_back(std::move(edge));
  }
  OrderedJson waters = OrderedJson::array();
  for (const StoredWater& w : run.waters())
    if (!w.line.empty()) waters.push_back({{"line", ring_json(w.line, base)}, {"joints", w.joints}});
  return {{"blocks", std::move(blocks)},
          {"supports", std::move(supports)},
          {"edges", std::move(edges)},
          {"water", std::move(waters)},
          {"materials", std::move(materials)},
          {"methods", run.methods()},
          {"joints", {{"laws", std::move(laws)}, {"lines", lines(joints.lines)}, {"cracks", lines(joints.cracks)}}}};
}

OrderedJson asked_json(const RunReader& run) {
  const std::vector<std::string> text = run.provenance_list("case"), names = run.provenance_list("library"),
                                 versions = run.provenance_list("library_version");
  OrderedJson libraries = OrderedJson::array();
  for (std::size_t i = 0; i < std::min(names.size(), versions.size()); ++i)
    libraries.push_back({names[i], versions[i]});
  OrderedJson out{{"case", text.empty() ? std::string() : text.front()},
                  {"set", run.provenance_list("set")},
                  {"libraries", std::move(libraries)}};
  for (const char* key : {"command_line", "case_sha256", "version", "commit", "compiler", "instruction_set", "status",
                          "reason", "resumed"})
    out[key] = run.provenance(key);
  return out;
}

/// summary.json of the run; null where there is none, as in a run that was killed, or none that can be read.
OrderedJson found_json(const std::filesystem::path& run_folder) {
  std::ifstream in(RunFolder::open(run_folder).summary(), std::ios::binary);
  if (!in) return nullptr;
  std::ostringstream text;
  text << in.rdbuf();
  OrderedJson found = OrderedJson::parse(text.str(), nullptr, false);
  return found.is_object() ? found : OrderedJson(nullptr);
}

/// Rows that a chart shows: all, or every k-th and the last.
std::vector<std::size_t> rows_of(std::size_t count) {
  const std::size_t stride = std::max<std::size_t>(1, (count + kMostRows - 1) / kMostRows);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < count; ++i)
    if (i % stride == 0 || i + 1 == count) rows.push_back(i);
  return rows;
}

void add_rows(Chunk& chunk, const std::string& name, const std::vector<double>& values, std::size_t width,
              const std::vector<std::size_t>& rows) {
  std::vector<float> out;
  for (const std::size_t row : rows)
    for (std::size_t k = 0; k < width; ++k) out.push_back(static_cast<float>(values[width * row + k]));
  chunk.add(name, std::span<const float>(out));
}

/// Monitors and the ledger: their description as JSON, their rows in the chunk.
OrderedJson history_json(const RunReader& run, const Vec2& base, Chunk& chunk) {
  OrderedJson monitors = OrderedJson::array(), columns = OrderedJson::array();
  bool all = true;
  const std::vector<StoredMonitor> stored = run.monitors();
  for (std::size_t i = 0; i < stored.size(); ++i) {
    const StoredMonitor& m = stored[i];
    const std::vector<std::size_t> rows = rows_of(m.time.size());
    all = all && rows.size() == m.time.size();
    const std::string at = "m" + std::to_string(i) + ".";
    add_rows(chunk, at + "time", m.time, 1, rows);
    add_rows(chunk, at + "u", m.displacement, 2, rows);
    add_rows(chunk, at + "v", m.velocity, 2, rows);
    if (!m.stress.empty()) add_rows(chunk, at + "s", m.stress, 3, rows);
    OrderedJson entry{{"name", m.name}, {"stress", !m.stress.empty()}};
    std::size_t first = 0;  // first sample in which its block exists
    while (first + 1 < m.position.size() && !std::isfinite(m.position[first])) first += 2;
    if (first + 1 < m.position.size())
      entry["at"] = {m.position[first] - m.displacement[first] - base.x(),
                     m.position[first + 1] - m.displacement[first + 1] - base.y()};
    monitors.push_back(std::move(entry));
  }
  const StoredLedger ledger = run.ledger();
  const std::vector<std::size_t> rows = rows_of(ledger.time.size());
  all = all && rows.size() == ledger.time.size();
  add_rows(chunk, "l.time", ledger.time, 1, rows);
  for (const auto& [name, values] : {std::pair{"l.energy", &ledger.energy},
                                     {"l.closure", &ledger.closure},
                                     {"l.moved", &ledger.moved},
                                     {"l.passed", &ledger.passed}})
    add_rows(chunk, name, *values, 1, rows);
  for (std::size_t c = 0; c < ledger.columns.size(); ++c) {
    const StoredLedger::Column& column = ledger.columns[c];
    columns.push_back({{"name", column.name}, {"side", column.side}, {"meaning", column.meaning}});
    add_rows(chunk, "l." + std::to_string(c), column.value, 1, rows);
  }
  return {{"monitors", std::move(monitors)}, {"ledger", std::move(columns)}, {"whole", all}};
}

OrderedJson stages_json(const RunReader& run) {
  OrderedJson out = OrderedJson::array();
  for (const StoredStage& s : run.stages()) {
    OrderedJson stage{{"name", s.name}, {"integrator", s.integrator}, {"duration", s.duration}};
    stage["start"] = s.start ? OrderedJson(*s.start) : OrderedJson(nullptr);
    out.push_back(std::move(stage));
  }
  return out;
}

OrderedJson frames_json(const ReportFrames& frames) {
  OrderedJson list = OrderedJson::array(), ranges = OrderedJson::object();
  for (const ReportFrame& f : frames.frames)
    list.push_back({{"index", f.index},
                    {"time", f.time},
                    {"step", f.step},
                    {"mesh", f.mesh},
                    {"stage", f.stage},
                    {"integrator", f.integrator}});
  for (const ReportRange& r : frames.ranges) ranges[r.field] = {r.low, r.high};
  return {{"list", std::move(list)},
          {"stored", frames.stored},
          {"meshes", frames.meshes.size()},
          {"ranges", std::move(ranges)},
          {"bounds", frames.bounds}};
}

}  // namespace

struct RunText::Data {
  OrderedJson page;
  Vec2 base;
  Chunk history;
};

RunText::RunText(const RunReader& run, const std::filesystem::path& run_folder, const std::string& version)
    : data_(std::make_unique<Data>()) {
  const Vec2 base = data_->base = base_of(run);
  data_->page = {{"format", 1},
                 {"written_by", version},
                 {"title", run.title()},
                 {"folder", std::filesystem::absolute(run_folder).lexically_normal().filename().string()},
                 {"origin", {run.origin().x() + base.x(), run.origin().y() + base.y()}},
                 {"model", model_json(run, base)},
                 {"stages", stages_json(run)},
                 {"history", history_json(run, base, data_->history)},
                 {"contacts", run.has_contacts()},
                 {"bolts", run.has_bolts()},
                 {"asked", asked_json(run)},
                 {"found", found_json(run_folder)}};
  data_->page["events"] = OrderedJson::array();
  for (const StoredEvent& e : run.events()) data_->page["events"].push_back({e.time, e.kind, e.text});
  if (run.times().empty()) return;
  if (const std::string rock = rock_use_text(rock_use(run, run.times().size() - 1)); !rock.empty())
    data_->page["events"].push_back({run.times().back(), "rock_strength", rock});
}

RunText::~RunText() = default;

const Vec2& RunText::base() const { return data_->base; }
const Chunk& RunText::history() const { return data_->history; }
void RunText::add_frames(const ReportFrames& frames) { data_->page["frames"] = frames_json(frames); }
std::string RunText::text() const { return data_->page.dump(-1, ' ', false, OrderedJson::error_handler_t::replace); }

}  // namespace scree::io
