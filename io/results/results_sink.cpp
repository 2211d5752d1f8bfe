#include "io/results/results_sink.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "io/results/atomic_file.h"
#include "io/results/bolt_writer.h"
#include "io/results/contact_writer.h"
#include "io/results/csv.h"
#include "io/results/event_writer.h"
#include "io/results/h5_read.h"
#include "io/results/history_writer.h"
#include "io/results/joints_writer.h"
#include "io/results/progress_writer.h"
#include "io/results/summary.h"
#include "io/results/supports_writer.h"
#include "io/results/vtkhdf_writer.h"
#include "io/results/water_writer.h"
#include "io/results/xdmf_writer.h"
#include "model/check.h"

namespace scree::io {

namespace {

using Clock = std::chrono::steady_clock;

// Other programs read the results of a run in progress up to a second late: bringing out takes longer than the rest of
// a small frame. The content of the file does not depend on when it is brought out.
constexpr std::chrono::milliseconds kBetween{1000};
constexpr int kShare = 50;              // bringing out may take 1/50 of the time
constexpr std::size_t kMostDue = 4096;  // windows that may wait: 40 bytes each

}  // namespace

struct ResultsSink::Files {
  h5::File file;
  VtkhdfWriter frames;
  XdmfWriter xdmf;
  HistoryWriter histories;
  EventWriter events;
  ProgressWriter progress;
  std::optional<ContactWriter> contacts;  // if the plan requires them
  std::optional<BoltWriter> bolts;        // if the model has any
  CsvHistories tables;
  Summary summary;
  std::pair<Tick, std::int32_t> stored{-1, -1};  // tick and stage of the frame stored last
  Clock::time_point next;                        // nothing is brought out earlier
  bool broken = false;                           // bringing out failed

  Files(h5::File results, const RunFolder& folder, const std::array<TableMark, 2>& keep, const Provenance& provenance,
        const Model& model, const coupling::Plan& plan, const ResultsSize& size)
      : file(std::move(results)),
        frames(file, size),
        xdmf(file, folder.xdmf()),
        histories({file, size.samples}, model),
        events({file, static_cast<double>(model.blocks.size() * (plan.stages.size() - 1))}),
        progress({file, size.frames}, model),
        tables(folder.history(), folder.energy(), model, keep),
        summary(model, provenance) {
    if (plan.output.contacts) contacts.emplace(h5::Growing(file, size.frames * size.contacts), size.frames);
    if (!model.bolts.empty()) bolts.emplace(file, model);
  }

  void frame(const coupling::FrameView& view) {
    const FrameRows rows = frames.frame(view);
    xdmf.frame(view, rows, frames.values());
    frames.forget_values();
    if (contacts) contacts->frame(view);
    if (bolts) bolts->frame(view);
    progress.frame(view);
    stored = {view.tick, view.stage};
    bring_out_if_due();
  }

  void bring_out_if_due() {
    if (Clock::now() >= next || xdmf.due() > kMostDue || xdmf.full()) bring_out();
  }

  /// Makes everything so far readable by other programs.
  void bring_out() {
    const Clock::time_point start = Clock::now();
    broken = true;
    file.hold(false);
    flush();
    file.flush();
    file.hold(true);
    xdmf.flush();  // after the data to which it refers
    broken = false;
    const Clock::time_point end = Clock::now();
    next = end + std::max<Clock::duration>(kBetween, kShare * (end - start));
  }

  /// Writes the buffers to HDF5 and the tables.
  void flush() {
    frames.flush();
    histories.flush();
    events.flush();
    if (contacts) contacts->flush();
    if (bolts) bolts->flush();
    progress.flush();
    xdmf.settle();
    tables.flush();
  }

  void take(const h5::File& from, const ResultsMark& mark) {
    frames.take(from, mark);
    histories.take(from, mark.histories);
    events.take(from, mark.events);
    if (contacts) contacts->take(from, mark.contacts);
    if (bolts) bolts->take(from, mark.bolts);
    progress.take(from, mark.progress);
    xdmf.take(from, mark.frame_count);
    stored = {mark.stored_tick, static_cast<std::int32_t>(mark.stored_stage)};
  }

  void close() {
    file.hold(false);
    frames.close();
    histories.close();
    events.close();
    if (contacts) contacts->close();
    if (bolts) bolts->close();
    progress.close();
    xdmf.settle();
    tables.close();
    file.flush();
    xdmf.close();
    file.close();
  }
};

ResultsSink::ResultsSink(RunFolder folder, Provenance provenance, std::optional<GoOn> go_on)
    : folder_(std::move(folder)), provenance_(std::move(provenance)), go_on_(std::move(go_on)) {}

/// A run that is ended by an exception from elsewhere keeps its results so far.
ResultsSink::~ResultsSink() {
  if (!files_ || files_->broken) return;
  try {
    files_->bring_out();
  } catch (const std::exception&) {  // the first exception states why the run ended
    files_->broken = true;
  }
}

namespace {

struct BesideFile {  // removed, unless it was put in place
  std::filesystem::path path;
  explicit BesideFile(std::filesystem::path where) : path(std::move(where)) {}
  BesideFile(const BesideFile&) = delete;
  BesideFile& operator=(const BesideFile&) = delete;
  ~BesideFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

/// Renames a table that differs from its content at the mark, and returns a message. Empty: it does not differ.
std::string set_aside_changed(const std::filesystem::path& table, const TableMark& mark) {
  std::string lacks = CsvFile::lacks(table, mark);
  if (lacks.empty()) return lacks;
  const std::filesystem::path aside = RunFolder::set_aside(table);
  return table.string() + ": " + lacks + (aside.empty() ? "" : "; what there was of it is now in " + aside.string()) +
         "; its earlier rows are in run.vtkhdf";
}

}  // namespace

ResultsSink::Files& ResultsSink::files() {
  SCREE_ASSERT(files_ != nullptr);
  return *files_;
}

void ResultsSink::begin(const Model& model, const coupling::Plan& plan) {
  if (go_on_) {
    take_up(model, plan);
    files_->file.keep();  // until the next checkpoint the run may be resumed from the same point again
  } else {
    const ResultsSize size = results_size(model, plan);
    make_files(h5::File::create(folder_.results(), size.bytes()), {}, model, plan, size);
    files_->file.flush();
  }
  provenance_.case_sha256 = case_hash(provenance_);
  std::string().swap(provenance_.case_text);  // it is in the file; assignment would keep its memory
}

void ResultsSink::make_files(h5::File file, const std::array<TableMark, 2>& tables, const Model& model,
                             const coupling::Plan& plan, const ResultsSize& size) {
  files_ = std::make_unique<Files>(std::move(file), folder_, tables, provenance_, model, plan, size);
  write_provenance(files_->file, provenance_);
  write_model(files_->file, model);
  write_joints(files_->file, model);
  write_supports(files_->file, model);
  write_water(files_->file, model);
  write_stages(files_->file, plan);
}

void ResultsSink::take_up(const Model& model, const coupling::Plan& plan) {
  const ResultsMark& mark = go_on_->mark;
  const ResultsSize size = results_size(model, plan);
  std::array<TableMark, 2> tables = mark.tables;
  for (std::size_t i = 0; i < tables.size(); ++i)
    if (const std::string lost = set_aside_changed(i == 0 ? folder_.history() : folder_.energy(), tables[i]);
        !lost.empty()) {
      go_on_->warn(lost);
      tables[i] = {};
    }
  const auto begin = [&](h5::File file, const std::string& past) {
    make_files(std::move(file), tables, model, plan, size);
    files_->file.attribute("/provenance", "resumed", past + go_on_->place);
    files_->summary.go_on(go_on_->transfers, go_on_->travels, go_on_->warnings, mark.wall_seconds, mark.cpu_seconds);
  };
  BesideFile unfinished{h5::File::beside(folder_.results())};
  try {
    const h5::File old = h5::from_whole([&] { return h5::File::open(folder_.results()); });
    const std::string past = h5::from_whole([&] { return h5::text_attribute(old, "/provenance", "resumed"); });
    begin(h5::File::create_beside(folder_.results(), size.bytes()), past.empty() ? past : past + "; ");
    files_->take(old, mark);
    files_->flush();
    files_->file.sync();
    files_->file.put_in_place();
  } catch (const DamagedFile& e) {
    files_.reset();
    const std::filesystem::path aside = RunFolder::set_aside(folder_.results());
    const std::string kept = aside.empty() ? "it is missing" : "what there was of it is now in " + aside.string();
    go_on_->warn(fmt::format("{}; {}, and run.vtkhdf begins anew at {}", e.what(), kept, go_on_->place));
    begin(h5::File::create(folder_.results(), size.bytes()), "with what was before lost or put aside, ");
  }
}

ResultsMark ResultsSink::mark() {
  Files& f = files();
  f.bring_out();
  f.tables.sync();
  f.file.keep();
  ResultsMark mark;
  f.frames.mark(mark);
  mark.histories = f.histories.marks();
  mark.events = f.events.marks();
  if (f.contacts) mark.contacts = f.contacts->marks();
  if (f.bolts) mark.bolts = f.bolts->marks();
  mark.progress = f.progress.marks();
  mark.tables = f.tables.marks();
  mark.stored_tick = f.stored.first;
  mark.stored_stage = f.stored.second;
  mark.wall_seconds = f.summary.wall_seconds();
  mark.cpu_seconds = f.summary.cpu_seconds();
  return mark;
}

void ResultsSink::topology(const coupling::MeshView& mesh) { files().frames.topology(mesh); }

void ResultsSink::frame(const coupling::FrameView& frame) { files().frame(frame); }

void ResultsSink::history(const coupling::HistoryView& history) {
  Files& f = files();
  f.histories.append(history);
  if (f.bolts) f.bolts->append(history);
  f.tables.append(history);
  if (f.stored.first >= 0) f.bring_out_if_due();  // the first frame can be read at once
}

void ResultsSink::event(const coupling::Event& event) {
  Files& f = files();
  f.events.append(event);
  f.summary.event(event);
  if (event.kind == coupling::EventKind::stage_end || event.kind == coupling::EventKind::not_converged) f.bring_out();
}

void ResultsSink::end(const coupling::RunEnd& end, const coupling::FrameView& last) {
  if (files().stored != std::pair{last.tick, last.stage}) files().frame(last);
  files().broken = true;
  outcome_ = files().summary.checked(end, last);
  files().file.attribute("/provenance", "status", status_name(outcome_.status));  // a run that was killed has no status
  files().file.attribute("/provenance", "reason", outcome_.reason);
  files().close();
  write_atomically(folder_.summary(), files().summary.text(outcome_, last));
  files_.reset();
}

}  // namespace scree::io
