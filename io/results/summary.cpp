#include "io/results/summary.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "coupling/contact/audit/audit.h"
#include "io/results/history_writer.h"
#include "io/results/json.h"
#include "model/check.h"

namespace scree::io {

using coupling::Column;
using coupling::Ledger;
using coupling::Side;

namespace {

double seconds_of(const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); }

rusage usage() {
  rusage use{};
  ::getrusage(RUSAGE_SELF, &use);  // fails for a wrong argument only
  return use;
}

void write_run(JsonWriter& json, const coupling::RunStats& stats, double wall, double cpu) {
  json.field("steps", stats.steps).field("cuts", stats.cuts).field("open_close_passes", stats.passes);
  json.field("newton_iterations", stats.iterations).field("contact_switches", stats.switches);
  json.field("factorisations", stats.factorisations).field("factor_updates", stats.updates);
  json.field("corrections", stats.corrections);
  if (stats.audit_checks > 0)
    json.open('{', "audit").field("checks", stats.audit_checks).field("worst", stats.audit_worst).close('}');
  json.open('{', "wall_seconds").field("explicit", stats.wall_explicit).field("implicit", stats.wall_implicit);
  json.field("output", stats.wall_output).field("total", wall).close('}');
  json.field("cpu_seconds", cpu);
  json.field("peak_memory_bytes", std::int64_t{1024} * usage().ru_maxrss);  // Linux counts in KiB
  json.field("blocks_count", stats.blocks).field("elements", stats.elements).field("unknowns", stats.unknowns);
  json.field("element_steps_per_second", stats.wall_explicit > 0.0 ? stats.element_steps / stats.wall_explicit : 0.0);
  json.field("contacts", stats.contacts);
}

void write_ledger(JsonWriter& json, const Ledger& ledger) {
  json.open('{', "ledger").open('{', "columns");
  double scheme = 0.0, watched = 0.0;
  for (const Side side : {Side::energy, Side::work, Side::dissipated, Side::scheme}) {
    json.open('{', side_name(side));
    for (int c = 0; c < coupling::kColumns; ++c) {
      const auto column = static_cast<Column>(c);
      if (info(column).side != side) continue;
      json.field(info(column).name, ledger[column]);
      if (side == Side::scheme) scheme = std::max(scheme, std::abs(ledger[column]));
      if (info(column).watched) watched = std::max(watched, std::abs(ledger[column]));
    }
    json.close('}');
  }
  json.close('}');
  json.field("energy", ledger.energy()).field("closure", ledger.closure()).field("moved", ledger.moved());
  json.field("relative_closure", ledger.relative_closure()).field("last_places", ledger.last_places());
  json.field("relative_closure_of", ledger.next_to_nothing(ledger.moved()) ? "next to nothing" : "the energy moved");
  json.field("passed", ledger.passed()).field("passed_closure", ledger.passed_closure()).field("gain", ledger.gain());
  json.field("scheme_share", ledger.moved() > 0.0 ? scheme / ledger.moved() : 0.0);
  json.field("scheme_passed_share", ledger.passed() > 0.0 ? watched / ledger.passed() : 0.0).close('}');
}

/// Of runs in which a contact has slid far enough.
void write_friction(JsonWriter& json, const Model& model, const coupling::RunStats& stats) {
  if (!std::isfinite(stats.friction_ratio)) return;
  json.open('{', "friction").field("worst_ratio", stats.friction_ratio);
  json.field("contact", coupling::contact_name(model, stats.friction_key)).close('}');
}

void write_stages(JsonWriter& json, const Model& model, const std::vector<coupling::StageTravel>& travels) {
  json.open('[', "stages");
  for (const coupling::StageTravel& t : travels) {
    json.open('{').field("name", t.stage).field("farthest_displacement", t.farthest);
    json.field("farthest_block", t.block.valid() ? model.blocks[t.block.index()].name : std::string()).close('}');
  }
  json.close(']');
}

void write_transfers(JsonWriter& json, const Model& model, const std::vector<coupling::TransferRow>& rows) {
  json.open('[', "transfers");
  for (const coupling::TransferRow& row : rows) {
    json.open('{').field("time", row.time).field("block", model.blocks[row.block.index()].name);
    json.field("from", row.from).field("to", row.to);
    json.field("mass_error", row.mass_error).field("momentum_error", row.momentum_error);
    json.field("angular_error", row.angular_error).field("energy_error", row.energy_error);
    json.field("kinetic_before", row.before.kinetic).field("kinetic_after", row.after.kinetic);
    json.field("elastic_before", row.before.elastic).field("elastic_after", row.after.elastic);
    json.field("reservoir_kinetic", row.reservoir_kinetic).field("reservoir_elastic", row.reservoir_elastic);
    json.field("booked", row.booked);
    if (row.by_rule) {
      const coupling::MethodMeasures& m = row.measures;
      json.open('{', "by_rule").field("kinetic", m.kinetic).field("elastic", m.elastic);
      json.field("inhomogeneity", m.inhomogeneity).field("strain_rate", m.strain_rate).field("stress", m.stress);
      json.field("acceleration", m.acceleration).field("cost_before", m.cost_before);
      json.field("cost_after", m.cost_after).close('}');
    }
    json.close('}');
  }
  json.close(']');
}

/// Where a block went: the mean over the points of its cells, each point once.
struct Travel {
  Vec2 sum{0.0, 0.0};
  int points = 0;
  std::int32_t method = -1;
};

std::vector<Travel> travels(std::size_t blocks, const coupling::FrameView& last) {
  const coupling::MeshView& mesh = *last.mesh;
  std::vector<Travel> travel(blocks);
  std::vector<std::int32_t> counted(mesh.origin.size() / 2, -1);  // block a point was last counted for
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

void write_blocks(JsonWriter& json, const Model& model, const coupling::FrameView& last) {
  const std::vector<Travel> travel = travels(model.blocks.size(), last);
  json.open('[', "blocks");
  for (std::size_t b = 0; b < travel.size(); ++b) {
    const Travel& t = travel[b];
    json.open('{').field("name", model.blocks[b].name);
    json.field("method", t.method < 0 ? std::string() : last.mesh->methods[static_cast<std::size_t>(t.method)]);
    json.field("displacement", t.points > 0 ? t.sum.norm() / t.points : 0.0).close('}');
  }
  json.close(']');
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

Summary::Summary(const Model& model, const Provenance& provenance) : model_(&model), provenance_(provenance) {}

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

std::string Summary::text(const coupling::RunEnd& end, const coupling::FrameView& last) const {
  return document(end, last).text();
}

coupling::RunEnd Summary::checked(const coupling::RunEnd& end, const coupling::FrameView& last) const {
  if (end.status != coupling::RunEnd::Status::done) return end;
  const std::string wrong = document(end, last).not_finite();
  if (wrong.empty()) return end;
  return {coupling::RunEnd::Status::non_finite,
          fmt::format("t = {:.6g} s, stage '{}': '{}' of the summary is not finite, although every step was made",
                      last.time, last.stage_name, wrong)};
}

JsonWriter Summary::document(const coupling::RunEnd& end, const coupling::FrameView& last) const {
  SCREE_ASSERT(last.mesh != nullptr && last.state != nullptr && last.stats != nullptr);
  JsonWriter json;
  json.open('{').field("version", provenance_.version).field("commit", provenance_.commit);
  json.field("case_sha256", case_hash(provenance_)).field("title", model_->title);
  json.open('[', "origin").field({}, model_->origin.x()).field({}, model_->origin.y()).close(']');
  json.field("status", status_name(end.status)).field("reason", end.reason);
  json.field("final_time", last.time).field("end_time", last.end_time).field("stage", last.stage_name);
  json.field("state_hash", fmt::format("{:016x}", coupling::state_hash(*last.state)));
  json.field("threads", provenance_.threads).field("command_line", provenance_.command_line);
  json.open('[', "set");
  for (const std::string& option : provenance_.overrides) json.item(option);
  json.close(']').open('[', "warnings");
  for (const coupling::Warning& w : warnings_) json.open('{').field("time", w.time).field("text", w.text).close('}');
  json.close(']');
  write_run(json, *last.stats, wall_seconds(), cpu_seconds());
  write_ledger(json, last.state->ledger);
  write_friction(json, *model_, *last.stats);
  write_stages(json, *model_, travels_);
  write_transfers(json, *model_, transfers_);
  write_blocks(json, *model_, last);
  return json.close('}');
}

}  // namespace scree::io
