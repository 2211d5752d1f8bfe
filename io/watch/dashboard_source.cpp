#include "io/watch/dashboard_source.h"

#include <algorithm>
#include <cmath>

#include "io/results/run_reader.h"

namespace scree::io {

LiveDashboard::LiveDashboard(std::unique_ptr<LiveReader> reader, std::string source, Clock::time_point start)
    : reader_(std::move(reader)), start_(start), heard_(Clock::now()) {
  now_.source = std::move(source);
  now_.received.emplace();
}

void LiveDashboard::take_events(std::int64_t session) {
  if (session != session_) events_.clear();
  session_ = session;
  for (event_v1_t& e : reader_->take_events())
    if (e.header.session == session) events_.push_back(std::move(e));
  // Events that are sent again for a late viewer arrive after newer ones.
  std::sort(events_.begin(), events_.end(),
            [](const event_v1_t& a, const event_v1_t& b) { return a.header.sequence < b.header.sequence; });
  if (events_.size() > LiveAssembly::kMaxEvents)
    events_.erase(events_.begin(), events_.end() - std::ptrdiff_t{LiveAssembly::kMaxEvents});
  now_.events.clear();
  for (const event_v1_t& e : events_) now_.events.push_back({e.header.time, e.kind, e.text});
}

const Dashboard& LiveDashboard::refresh() {
  const Clock::time_point now = Clock::now();
  const auto since = [now](Clock::time_point then) { return std::chrono::duration<double>(now - then).count(); };
  Dashboard::Received& received = *now_.received;
  const LiveCounts counts = reader_->counts();
  // Malformed messages and those of an older run do not show that the run is alive.
  const auto good = [](const Dashboard::Received& r) { return r.messages - r.malformed - r.other; };
  const std::int64_t before = good(received);
  received.messages = counts.messages;
  received.malformed = counts.malformed;
  received.other = counts.other;
  received.incomplete = counts.incomplete;
  received.frames = counts.frames;
  if (good(received) > before) heard_ = now;
  received.waited = since(start_);
  received.silent = since(heard_);

  const auto info = reader_->info();
  if (!info) return now_;
  const std::int64_t session = info->header.session;
  take_events(session);
  now_.run = info->run.empty() ? "run" : info->run;
  now_.title = info->title;
  now_.version = info->version;
  now_.status = info->status;
  now_.reason = info->reason;
  now_.stage = info->stage_name;
  now_.integrator = info->integrator;
  now_.time = info->header.time;
  now_.end_time = info->end_time;
  const bool measured = info->simulated_per_wall > 0.0;
  now_.rate = measured ? std::optional(info->simulated_per_wall) : std::nullopt;
  now_.step_rate = measured ? std::optional(info->steps_per_second) : std::nullopt;
  now_.time_left = info->time_left >= 0.0 ? std::optional(info->time_left) : std::nullopt;
  now_.steps = info->steps;
  now_.cuts = info->cuts;
  now_.passes = info->passes;
  now_.contacts = info->contacts;
  now_.blocks = info->blocks;
  now_.cells = info->elements;
  now_.unknowns = info->unknowns;
  received.events_lost = info->events_lost;
  now_.contact.reset();
  if (info->contact_time >= 0.0)
    now_.contact = {info->contact_depth, info->contact_force, info->contact_depth_at, info->contact_force_at};

  // INFO is sent once per second, the rest more often: the newest of them gives the progress of the run.
  const auto is_of_it = [session](const header_v1_t& header) { return header.session == session; };
  now_.ledger.reset();
  if (const auto energy = reader_->energy(); energy && is_of_it(energy->header)) {
    Dashboard::Ledger& ledger = now_.ledger.emplace();
    ledger.time = energy->header.time;
    for (std::size_t i = 0; i < energy->value.size(); ++i)
      ledger.terms.push_back({energy->name[i], energy->side[i], energy->value[i]});
    ledger.closure = energy->closure;
    ledger.moved = energy->moved;
    ledger.relative_closure = energy->relative_closure;
    ledger.passed = energy->passed;
    now_.time = std::max(now_.time, ledger.time);
    now_.steps = std::max(*now_.steps, energy->header.step);
  }
  now_.monitors.clear();
  if (const auto history = reader_->history(); history && is_of_it(history->header)) {
    now_.monitors_time = history->header.time;
    for (std::size_t i = 0; i < history->names.size(); ++i)
      now_.monitors.push_back({history->names[i], info->origin[0] + history->position[2 * i],
                               info->origin[1] + history->position[2 * i + 1], history->displacement[2 * i],
                               history->displacement[2 * i + 1], history->velocity[2 * i],
                               history->velocity[2 * i + 1]});
  }
  now_.frame_time.reset();
  if (const auto frame = reader_->frame(); frame && is_of_it(frame->header)) {
    now_.frame_time = frame->header.time;
    now_.time = std::max(now_.time, frame->header.time);
  }
  if (!received.mesh_after && reader_->mesh()) received.mesh_after = since(start_);
  return now_;
}

Dashboard stored_dashboard(const std::filesystem::path& run_folder) {
  const RunReader reader(run_folder);
  Dashboard run;
  run.source = run_folder.string();
  const std::filesystem::path full = std::filesystem::absolute(run_folder).lexically_normal();
  run.run = (full.has_filename() ? full : full.parent_path()).filename().string();
  run.title = reader.title();
  run.version = reader.provenance("version");
  run.status = reader.provenance("status");
  std::replace(run.status.begin(), run.status.end(), '_', ' ');
  if (run.status.empty()) run.status = "not ended";
  run.reason = reader.provenance("reason");
  run.end_time = reader.end_time();
  run.blocks = static_cast<std::int64_t>(reader.blocks().size());
  if (!reader.times().empty()) {
    const StoredFrame last = reader.frame(reader.times().size() - 1);
    run.time = last.time;
    run.frame_time = last.time;
    run.steps = last.step;
    run.stage = last.stage;
    run.integrator = last.integrator;
    run.cells = static_cast<std::int64_t>(last.cells());
    if (const auto progress = reader.progress(); progress.size() == reader.times().size()) {
      const StoredProgress& p = progress.back();
      run.cuts = p.cuts;
      run.passes = p.passes;
      run.contacts = p.contacts;
      run.unknowns = p.unknowns;
      run.contact = {p.contact.depth, p.contact.force, p.contact.depth_at, p.contact.force_at};
    }
  }
  const StoredLedger ledger = reader.ledger();
  if (!ledger.time.empty()) {
    Dashboard::Ledger& shown = run.ledger.emplace();
    shown.time = ledger.time.back();
    for (const StoredLedger::Column& c : ledger.columns) shown.terms.push_back({c.name, c.side, c.value.back()});
    shown.closure = ledger.closure.back();
    shown.moved = ledger.moved.back();
    shown.relative_closure = shown.moved > 0.0 ? std::abs(shown.closure) / shown.moved : 0.0;
    shown.passed = ledger.passed.back();
  }
  for (const StoredMonitor& m : reader.monitors()) {
    if (m.time.empty()) continue;
    const std::size_t i = 2 * (m.time.size() - 1);
    run.monitors_time = m.time.back();
    run.monitors.push_back({m.name, reader.origin().x() + m.position[i], reader.origin().y() + m.position[i + 1],
                            m.displacement[i], m.displacement[i + 1], m.velocity[i], m.velocity[i + 1]});
  }
  for (const StoredEvent& e : reader.events()) run.events.push_back({e.time, e.kind, e.text});
  return run;
}

}  // namespace scree::io
