#include "io/results/summary.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "coupling/contact/audit/audit.h"
#include "io/results/history_writer.h"
#include "io/text/printable.h"
#include "model/check.h"

namespace scree::io {

using coupling::Column;
using coupling::Ledger;
using coupling::Side;

using Json = nlohmann::ordered_json;

namespace {

double seconds_of(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

rusage usage() {
  rusage use{};
  ::getrusage(RUSAGE_SELF, &use);  // fails only for a wrong argument
  return use;
}

void add_run(Json& json, const coupling::RunStats& stats, double wall, double cpu) {
  json["steps"] = stats.steps;
  json["cuts"] = stats.cuts;
  json["open_close_passes"] = stats.passes;
  json["newton_iterations"] = stats.iterations;
  json["contact_switches"] = stats.switches;
  json["factorisations"] = stats.factorisations;
  json["factor_updates"] = stats.updates;
  json["corrections"] = stats.corrections;
  json["block_iterations"] = stats.block_iterations;
  json["incomplete_factors"] = stats.incomplete_factors;
  json["local_passes"] = stats.local_passes;
  json["fallbacks"] = stats.fallbacks;
  if (stats.audit_checks > 0) json["audit"] = {{"checks", stats.audit_checks}, {"worst", stats.audit_worst}};
  json["wall_seconds"] = {{"explicit", stats.wall_explicit},
                          {"implicit", stats.wall_implicit},
                          {"output", stats.wall_output},
                          {"total", wall}};
  json["cpu_seconds"] = cpu;
  json["cpu_seconds_of"] = {
      {"explicit", stats.cpu_explicit}, {"implicit", stats.cpu_implicit}, {"output", stats.cpu_output}};
  json["peak_memory_bytes"] = std::int64_t{1024} * usage().ru_maxrss;  // Linux counts in KiB
  json["blocks_count"] = stats.blocks;
  json["elements"] = stats.elements;
  json["unknowns"] = stats.unknowns;
  json["element_steps_per_second"] = stats.wall_explicit > 0.0 ? stats.element_steps / stats.wall_explicit : 0.0;
  json["contacts"] = stats.contacts;
  json["asleep"] = stats.asleep;
  json["sleep_momentum"] = stats.sleep_momentum;
}

Json ledger_json(const Ledger& ledger) {
  Json json, columns = Json::object();
  double scheme = 0.0, watched = 0.0;
  for (const Side side : {Side::energy, Side::work, Side::dissipated, Side::scheme}) {
    Json& of_side = columns[std::string(side_name(side))] = Json::object();
    for (int c = 0; c < coupling::kColumns; ++c) {
      const auto column = static_cast<Column>(c);
      if (info(column).side != side) continue;
      of_side[std::string(info(column).name)] = ledger[column];
      if (side == Side::scheme) scheme = std::max(scheme, std::abs(ledger[column]));
      if (info(column).watched) watched = std::max(watched, std::abs(ledger[column]));
    }
  }
  json["columns"] = std::move(columns);
  json["energy"] = ledger.energy();
  json["closure"] = ledger.closure();
  json["moved"] = ledger.moved();
  json["relative_closure"] = ledger.relative_closure();
  json["last_places"] = ledger.last_places();
  json["relative_closure_of"] = ledger.next_to_nothing(ledger.moved()) ? "next to nothing" : "the energy moved";
  json["passed"] = ledger.passed();
  json["passed_closure"] = ledger.passed_closure();
  json["gain"] = ledger.gain();
  json["scheme_share"] = ledger.moved() > 0.0 ? scheme / ledger.moved() : 0.0;
  json["scheme_passed_share"] = ledger.passed() > 0.0 ? watched / ledger.passed() : 0.0;
  return json;
}

Json stages_json(const Model& model, const std::vector<coupling::StageTravel>& travels) {
  Json list = Json::array();
  for (const coupling::StageTravel& t : travels)
    list.push_back(Json{{"name", t.stage},
                        {"farthest_displacement", t.farthest},
                        {"farthest_block", t.block.valid() ? model.blocks[t.block.index()].name : std::string()}});
  return list;
}

Json transfers_json(const Model& model, const std::vector<coupling::TransferRow>& rows) {
  Json list = Json::array();
  for (const coupling::TransferRow& row : rows) {
    Json& json = list.emplace_back(Json{{"time", row.time},
                                        {"block", model.blocks[row.block.index()].name},
                                        {"from", row.from},
                                        {"to", row.to},
                                        {"mass_error", row.mass_error},
                                        {"momentum_error", row.momentum_error},
                                        {"angular_error", row.angular_error},
                                        {"energy_error", row.energy_error},
                                        {"kinetic_before", row.before.kinetic},
                                        {"kinetic_after", row.after.kinetic},
                                        {"elastic_before", row.before.elastic},
                                        {"elastic_after", row.after.elastic},
                                        {"reservoir_kinetic", row.reservoir_kinetic},
                                        {"reservoir_elastic", row.reservoir_elastic},
                                        {"booked", row.booked}});
    const coupling::MethodMeasures& m = row.measures;
    if (row.by_rule)
      json["by_rule"] = {
          {"kinetic", m.kinetic},         {"elastic", m.elastic},      {"inhomogeneity", m.inhomogeneity},
          {"strain_rate", m.strain_rate}, {"stress", m.stress},        {"acceleration", m.acceleration},
          {"cost_before", m.cost_before}, {"cost_after", m.cost_after}};
  }
  return list;
}

/// Mean displacement of a block over the points of its cells, each point counted once.
struct Travel {
  Vec2 sum{0.0, 0.0};
  int points = 0;
  std::int32_t method = -1;
};

std::vector<Travel> travels(std::size_t blocks, const coupling::FrameView& last) {
  const coupling::MeshView& mesh = *last.mesh;
  std::vector<Travel> travel(blocks);
  std::vector<std::int32_t> counted(mesh.origin.size() / 2, -1);  // per point: block for which it was last counted
  for (std::size_t cell = 0; cell < mesh.cell_block.size(); ++cell) {
    Travel& t = travel[static_cast<std::size_t>(mesh.cell_block[cell])];
    t.method = mesh.cell_method[cell];
    for (std::int32_t i = mesh.offsets[cell]; i < mesh.offsets[cell + 1]; ++i) {
      const auto p = static_cast<std::size_t>(mesh.connectivity[static_cast<std::size_t>(i)]);
      if (std::exchange(counted[p], mesh.cell_block[cell]) == mesh.cell_block[cell]) continue;
      t.sum += Vec2(last.position[2 * p] - mesh.origin[2 * p], last.position[2 * p + 1] - mesh.origin[2 * p + 1]);
      ++t.points;
    }
  }
  return travel;
}

Json blocks_json(const Model& model, const coupling::FrameView& last) {
  const std::vector<Travel> travel = travels(model.blocks.size(), last);
  Json list = Json::array();
  for (std::size_t b = 0; b < travel.size(); ++b) {
    const Travel& t = travel[b];
    list.push_back(
        Json{{"name", model.blocks[b].name},
             {"method", t.method < 0 ? std::string() : last.mesh->methods[static_cast<std::size_t>(t.method)]},
             {"displacement", t.points > 0 ? t.sum.norm() / t.points : 0.0}});
  }
  return list;
}

/// Key of the first number that is not finite, which JSON writes as null; empty: all are finite.
std::string not_finite(const Json& json, const std::string& key) {
  if (json.is_number_float()) return std::isfinite(json.get<double>()) ? std::string() : key;
  if (!json.is_structured()) return {};
  for (const auto& [name, value] : json.items())
    if (std::string found = not_finite(value, json.is_object() ? name : key); !found.empty()) return found;
  return {};
}

}  // namespace

std::string status_name(coupling::RunEnd::Status status) {
  switch (status) {
    case coupling::RunEnd::Status::done:
      return "done";
    case coupling::RunEnd::Status::interrupted:
      return "interrupted";
    case coupling::RunEnd::Status::not_converged:
      return "not_converged";
    case coupling::RunEnd::Status::non_finite:
      return "non_finite";
  }
  return "";
}

Summary::Summary(const Model& model, const Provenance& provenance) : model_(&model), provenance_(&provenance) {}

void Summary::event(const coupling::Event& event) {
  if (event.transfer != nullptr) transfers_.push_back(*event.transfer);
  if (event.travel != nullptr) travels_.push_back(*event.travel);
  if (event.kind == coupling::EventKind::warning) warnings_.push_back({event.time, event.text});
}

double Summary::wall_seconds() const {
  return earlier_wall_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

double Summary::cpu_seconds() const {
  const rusage use = usage();
  return earlier_cpu_ + seconds_of(use.ru_utime) + seconds_of(use.ru_stime);
}

void Summary::go_on(std::vector<coupling::TransferRow> transfers, std::vector<coupling::StageTravel> travels,
                    std::vector<coupling::Warning> warnings, double wall_seconds, double cpu_seconds) {
  warnings_ = std::move(warnings);
  transfers_ = std::move(transfers);
  travels_ = std::move(travels);
  earlier_wall_ = wall_seconds;
  earlier_cpu_ = cpu_seconds;
}

/// Keeps the JSON library out of the header.
struct Summary::Document {
  Json json;
};

std::string Summary::text(const coupling::RunEnd& end, const coupling::FrameView& last) const {
  // Bytes that are not UTF-8 become U+FFFD. Control characters of a terminal (printable.h) occur in texts only, where
  // \u009B means the same in JSON.
  return printable(document(end, last).json.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

coupling::RunEnd Summary::checked(const coupling::RunEnd& end, const coupling::FrameView& last) const {
  if (end.status != coupling::RunEnd::Status::done) return end;
  const std::string wrong = not_finite(document(end, last).json, {});
  if (wrong.empty()) return end;
  return {coupling::RunEnd::Status::non_finite,
          fmt::format("t = {:.6g} s, stage '{}': '{}' of the summary is not finite, although every step was made",
                      last.time, last.stage_name, wrong)};
}

Summary::Document Summary::document(const coupling::RunEnd& end, const coupling::FrameView& last) const {
  SCREE_ASSERT(last.mesh != nullptr && last.state != nullptr && last.stats != nullptr);
  Json json;
  json["version"] = provenance_->version;
  json["commit"] = provenance_->commit;
  json["case_sha256"] = case_hash(*provenance_);
  json["title"] = model_->title;
  json["origin"] = {model_->origin.x(), model_->origin.y()};
  json["status"] = status_name(end.status);
  json["reason"] = end.reason;
  json["final_time"] = last.time;
  json["end_time"] = last.end_time;
  json["stage"] = last.stage_name;
  json["state_hash"] = fmt::format("{:016x}", coupling::state_hash(*last.state));
  json["threads"] = provenance_->threads;
  json["command_line"] = provenance_->command_line;
  json["set"] = provenance_->overrides;
  json["warnings"] = Json::array();
  for (const coupling::Warning& w : warnings_) json["warnings"].push_back(Json{{"time", w.time}, {"text", w.text}});
  add_run(json, *last.stats, wall_seconds(), cpu_seconds());
  json["ledger"] = ledger_json(last.state->ledger);
  if (std::isfinite(last.stats->friction_ratio))  // only if a contact has slid far enough
    json["friction"] = {{"worst_ratio", last.stats->friction_ratio},
                        {"contact", coupling::contact_name(*model_, last.stats->friction_key)}};
  json["stages"] = stages_json(*model_, travels_);
  json["transfers"] = transfers_json(*model_, transfers_);
  json["blocks"] = blocks_json(*model_, last);
  return {std::move(json)};
}

}  // namespace scree::io
