#include "io/serve/live_messages.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/report/chunk.h"

namespace scree::io {
namespace {

using Json = nlohmann::ordered_json;

/// @param chunk  null: none
SharedBytes message_of(const Json& head, const Chunk* chunk = nullptr) {
  const std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::vector<std::uint8_t> arrays = chunk == nullptr ? std::vector<std::uint8_t>() : chunk->bytes();
  auto out = std::make_shared<std::vector<std::uint8_t>>();
  out->reserve(4 + text.size() + arrays.size());
  for (unsigned byte = 0; byte < 4; ++byte)
    out->push_back(static_cast<std::uint8_t>(static_cast<std::uint32_t>(text.size()) >> 8U * byte));
  out->insert(out->end(), text.begin(), text.end());
  out->insert(out->end(), arrays.begin(), arrays.end());
  return out;
}

}  // namespace

SharedBytes run_message(const info_v1_t& info, const std::array<double, 2>& base, std::size_t blocks,
                        std::size_t materials, bool control) {
  Json bounds = Json::array();
  for (const std::size_t i : {0U, 1U, 2U, 3U}) bounds.push_back(info.bounds[i] - base[i % 2]);
  return message_of({{"kind", "run"},
                     {"session", info.header.session},
                     {"run", info.run},
                     {"title", info.title},
                     {"version", info.version},
                     {"field", info.field},
                     {"end_time", info.end_time},
                     {"origin", {info.origin[0] + base[0], info.origin[1] + base[1]}},
                     {"bounds", std::move(bounds)},
                     {"blocks", blocks},
                     {"materials", materials},
                     {"control", control}});
}

SharedBytes mesh_message(std::int64_t session, const LiveMesh& mesh, const std::array<double, 2>& base) {
  std::vector<float> origin;
  origin.reserve(2 * mesh.points());
  for (std::size_t p = 0; p < mesh.points(); ++p) {
    origin.push_back(static_cast<float>(mesh.base[0] + static_cast<double>(mesh.origin_x[p]) - base[0]));
    origin.push_back(static_cast<float>(mesh.base[1] + static_cast<double>(mesh.origin_y[p]) - base[1]));
  }
  Chunk chunk;
  chunk.add("origin", std::span<const float>(origin));
  chunk.add("offsets", std::span<const std::int32_t>(mesh.offsets));
  chunk.add("cells", std::span<const std::int32_t>(mesh.connectivity));
  chunk.add("block", std::span<const std::int32_t>(mesh.block));
  chunk.add("material", std::span<const std::int32_t>(mesh.material));
  chunk.add("method", std::span<const std::int32_t>(mesh.method));
  return message_of({{"kind", "mesh"}, {"session", session}, {"mesh", mesh.id}, {"methods", mesh.methods}}, &chunk);
}

SharedBytes frame_message(const LiveFrame& frame, const std::string& stage, const std::string& integrator) {
  const LiveMesh& mesh = *frame.mesh;
  std::vector<float> displacement;
  displacement.reserve(2 * mesh.points());
  for (std::size_t p = 0; p < mesh.points(); ++p) {
    displacement.push_back(
        static_cast<float>(frame.position[2 * p] - mesh.base[0] - static_cast<double>(mesh.origin_x[p])));
    displacement.push_back(
        static_cast<float>(frame.position[2 * p + 1] - mesh.base[1] - static_cast<double>(mesh.origin_y[p])));
  }
  Chunk chunk;
  chunk.add("displacement", std::span<const float>(displacement));
  chunk.add("scalar", std::span<const float>(frame.scalar));
  return message_of({{"kind", "frame"},
                     {"session", frame.header.session},
                     {"mesh", mesh.id},
                     {"time", frame.header.time},
                     {"step", frame.header.step},
                     {"stage", stage},
                     {"integrator", integrator},
                     {"field", frame.field}},
                    &chunk);
}

namespace {

Json float_json(double value) { return std::isfinite(value) ? Json(static_cast<float>(value)) : Json(nullptr); }

Json lines_json(const model_v1_t& m, bool cracks, const std::array<double, 2>& base) {
  Json out = Json::array();
  for (std::size_t i = 0; i < m.crack.size(); ++i)
    if ((m.crack[i] != 0) == cracks)
      out.push_back({static_cast<float>(m.line_x0[i] - base[0]), static_cast<float>(m.line_y0[i] - base[1]),
                     static_cast<float>(m.line_x1[i] - base[0]), static_cast<float>(m.line_y1[i] - base[1]),
                     m.line_law[i]});
  return out;
}

Json water_json(const model_v1_t& m, const std::array<double, 2>& base) {
  Json out = Json::array();
  for (std::size_t i = 0; i < m.water_line.size(); ++i) {
    if (i == 0 || m.water_line[i] != m.water_line[i - 1]) {
      Json joints = Json::array();
      for (std::size_t k = 0; k < m.water_law.size(); ++k)
        if (m.law_line[k] == m.water_line[i]) joints.push_back(m.water_law[k]);
      out.push_back({{"line", Json::array()}, {"joints", std::move(joints)}});
    }
    out.back()["line"].push_back(static_cast<float>(m.water_x[i] - base[0]));
    out.back()["line"].push_back(static_cast<float>(m.water_y[i] - base[1]));
  }
  return out;
}

/// Stress of the cells as xx, yy, xy per point: the mean of the cells that have it as a corner.
std::vector<float> point_stress(const detail_v1_t& d, const LiveMesh& mesh) {
  std::vector<float> sum(3 * mesh.points(), 0.0F), cells(mesh.points(), 0.0F);
  for (std::size_t c = 0; c < d.xx.size(); ++c)
    for (std::int32_t k = mesh.offsets[c]; k < mesh.offsets[c + 1]; ++k) {
      const auto p = static_cast<std::size_t>(mesh.connectivity[static_cast<std::size_t>(k)]);
      sum[3 * p] += d.xx[c], sum[3 * p + 1] += d.yy[c], sum[3 * p + 2] += d.xy[c];
      cells[p] += 1.0F;
    }
  for (std::size_t p = 0; p < cells.size(); ++p)
    for (std::size_t k = 0; k < 3; ++k) sum[3 * p + k] /= std::max(1.0F, cells[p]);
  return sum;
}

}  // namespace

SharedBytes model_message(std::int64_t session, const model_v1_t& m, const std::array<double, 2>& base) {
  Json blocks = Json::array(), materials = Json::array(), laws = Json::array(), supports = Json::array(),
       edges = Json::array();
  for (std::size_t i = 0; i < m.block.size(); ++i)
    blocks.push_back({{"name", m.block[i]}, {"material", m.block_material[i]}, {"held", m.held[i] != 0}});
  for (std::size_t i = 0; i < m.material.size(); ++i)
    materials.push_back(
        {{"name", m.material[i]}, {"density", m.density[i]}, {"young", m.young[i]}, {"poisson", m.poisson[i]}});
  for (std::size_t i = 0; i < m.law.size(); ++i)
    laws.push_back({{"name", m.law[i]},
                    {"friction_deg", m.friction_deg[i]},
                    {"cohesion", m.cohesion[i]},
                    {"tensile_strength", float_json(m.tensile_strength[i])}});
  for (std::size_t i = 0; i < m.fix_x.size(); ++i)
    supports.push_back({static_cast<float>(m.support_x[i] - base[0]), static_cast<float>(m.support_y[i] - base[1]),
                        m.fix_x[i] != 0, m.fix_y[i] != 0});
  for (std::size_t i = 0; i < m.edge_fixed.size(); ++i)
    edges.push_back({static_cast<float>(m.edge_x0[i] - base[0]), static_cast<float>(m.edge_y0[i] - base[1]),
                     static_cast<float>(m.edge_x1[i] - base[0]), static_cast<float>(m.edge_y1[i] - base[1]),
                     m.edge_fixed[i] != 0});
  return message_of(
      {{"kind", "model"},
       {"session", session},
       {"blocks", std::move(blocks)},
       {"materials", std::move(materials)},
       {"supports", std::move(supports)},
       {"edges", std::move(edges)},
       {"water", water_json(m, base)},
       {"joints",
        {{"laws", std::move(laws)}, {"lines", lines_json(m, false, base)}, {"cracks", lines_json(m, true, base)}}},
       {"bolts", m.bolts}});
}

SharedBytes detail_message(const LiveDetail& detail, const LiveMesh& mesh, const std::array<double, 2>& base) {
  const detail_v1_t& d = detail.data;
  std::vector<float> position, normal, force, node;
  std::vector<std::int32_t> blocks;
  const auto add = [&](std::vector<float>& out, float x, float y) {
    out.push_back(static_cast<float>(d.base[0] + static_cast<double>(x) - base[0]));
    out.push_back(static_cast<float>(d.base[1] + static_cast<double>(y) - base[1]));
  };
  for (std::size_t i = 0; i < d.state.size(); ++i) {
    add(position, d.x[i], d.y[i]);
    normal.insert(normal.end(), {d.nx[i], d.ny[i]});
    force.insert(force.end(), {d.fn[i], d.ft[i]});
    blocks.insert(blocks.end(), {d.corner[i], d.edge[i], d.law[i]});
  }
  for (std::size_t i = 0; i < d.bolt.size(); ++i) add(node, d.node_x[i], d.node_y[i]);
  Chunk chunk;
  chunk.add("c.position", std::span<const float>(position));
  chunk.add("c.normal", std::span<const float>(normal));
  chunk.add("c.force", std::span<const float>(force));
  chunk.add("c.slip", std::span<const float>(d.slip));
  chunk.add("c.blocks", std::span<const std::int32_t>(blocks));
  chunk.add("c.state", std::span<const std::uint8_t>(d.state));
  if (d.cells > 0) chunk.add("stress", std::span<const float>(point_stress(d, mesh)));
  chunk.add("b.position", std::span<const float>(node));
  chunk.add("b.force", std::span<const float>(d.node_force));
  chunk.add("b.bolt", std::span<const std::int32_t>(d.bolt));
  return message_of(
      {{"kind", "detail"}, {"session", detail.header.session}, {"mesh", mesh.id}, {"time", detail.header.time}},
      &chunk);
}

SharedBytes rows_message(std::int64_t session, const LiveHistory* history, const energy_v1_t* energy,
                         const std::array<double, 2>& base) {
  Json out{{"kind", "rows"}, {"session", session}};
  if (history != nullptr) {
    Json monitors = Json::array();
    for (std::size_t i = 0; i < history->names.size(); ++i) {
      const auto pair = [i](const std::vector<double>& values) { return Json{values[2 * i], values[2 * i + 1]}; };
      monitors.push_back({{"name", history->names[i]},
                          {"at",
                           {history->position[2 * i] - history->displacement[2 * i] - base[0],
                            history->position[2 * i + 1] - history->displacement[2 * i + 1] - base[1]}},
                          {"u", pair(history->displacement)},
                          {"v", pair(history->velocity)}});
    }
    out["monitors"] = {{"time", history->header.time}, {"list", std::move(monitors)}};
  }
  if (energy != nullptr) {
    Json columns = Json::array();
    for (std::size_t i = 0; i < energy->value.size(); ++i)
      columns.push_back({{"name", energy->name[i]}, {"side", energy->side[i]}, {"value", energy->value[i]}});
    out["ledger"] = {{"time", energy->header.time}, {"columns", std::move(columns)}, {"energy", energy->energy},
                     {"closure", energy->closure},  {"moved", energy->moved},        {"passed", energy->passed}};
  }
  return message_of(out);
}

SharedBytes status_message(const info_v1_t& info, double silent) {
  return message_of({{"kind", "status"},
                     {"session", info.header.session},
                     {"status", info.status},
                     {"reason", info.reason},
                     {"time", info.header.time},
                     {"end_time", info.end_time},
                     {"rate", info.simulated_per_wall},
                     {"time_left", info.time_left},
                     {"silent", silent},
                     {"steps", info.steps},
                     {"cuts", info.cuts},
                     {"passes", info.passes},
                     {"contacts", info.contacts},
                     {"blocks", info.blocks},
                     {"elements", info.elements},
                     {"unknowns", info.unknowns}});
}

SharedBytes waiting_message(const std::string& url, const std::string& run, const std::string& trouble) {
  return message_of(
      {{"kind", "status"}, {"session", -1}, {"status", "waiting"}, {"url", url}, {"run", run}, {"trouble", trouble}});
}

SharedBytes answer_message(const std::string& command, const std::string& result, const std::string& reason,
                           const std::string& state) {
  return message_of({{"kind", "answer"},
                     {"session", -1},
                     {"command", command},
                     {"result", result},
                     {"reason", reason},
                     {"state", state}});
}

SharedBytes events_message(std::int64_t session, const std::vector<event_v1_t>& events) {
  Json list = Json::array();
  for (const event_v1_t& e : events) list.push_back({e.header.time, e.kind, e.text});
  return message_of({{"kind", "events"}, {"session", session}, {"list", std::move(list)}});
}

}  // namespace scree::io
