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
