#include "io/results/results_sink.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "io/results/atomic_file.h"
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

struct ResultsSink::Files {
  h5::File file;
  VtkhdfWriter frames;
  XdmfWriter xdmf;
  HistoryWriter histories;
  EventWriter events;
  ProgressWriter progress;
  std::optional<ContactWriter> contacts;  // where the plan asks for them
  CsvHistories tables;
  Summary summary;
  std::pair<Tick, std::int32_t> stored{-1, -1};  // tick and stage of the frame stored last

  Files(h5::File results, const RunFolder& folder, const std::array<TableMark, 2>& keep, const Provenance& provenance,
        const Model& model, bool with_contacts)
      : file(std::move(results)),
        frames(file),
        xdmf(file, folder.xdmf()),
        histories(file, model),
        events(file),
        progress(file, model),
        tables(folder.history(), folder.energy(), model, keep),
        summary(model, provenance) {
    if (with_contacts) contacts.emplace(file);
  }

  void frame(const coupling::FrameView& view) {
    xdmf.frame(view, frames.frame(view));
    if (contacts) contacts->frame(view);
    progress.frame(view);
    stored = {view.tick, view.stage};
    flush();
    file.flush();
    xdmf.flush();  // after what it refers to
  }

  /// Buffers to HDF5 and the tables.
  void flush() {
    frames.flush();
    histories.flush();
    events.flush();
    if (contacts) contacts->flush();
    progress.flush();
    tables.flush();
  }

  void take(const h5::File& from, const ResultsMark& mark) {
    frames.take(from, mark);
    histories.take(from, mark.histories);
    events.take(from, mark.events);
    if (contacts) contacts->take(from, mark.contacts);
    progress.take(from, mark.progress);
    xdmf.take(from, mark.frame_count);
    stored = {mark.stored_tick, static_cast<std::int32_t>(mark.stored_stage)};
  }

  void close() {
    frames.close();
    histories.close();
    events.close();
    if (contacts) contacts->close();
    progress.close();
    tables.close();
    file.flush();
    xdmf.close();
    file.close();
  }
};

ResultsSink::ResultsSink(RunFolder folder, Provenance provenance, std::optional<GoOn> go_on)
    : folder_(std::move(folder)), provenance_(std::move(provenance)), go_on_(std::move(go_on)) {}

ResultsSink::~ResultsSink() = default;

namespace {

struct BesideFile {  // goes, unless it was put in place
  std::filesystem::path path;
  explicit BesideFile(std::filesystem::path where) : path(std::move(where)) {}
  BesideFile(const BesideFile&) = delete;
  BesideFile& operator=(const BesideFile&) = delete;
  ~BesideFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

/// Puts a table aside that is not what it was; says so. Empty: it is.
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
    files_->file.keep();  // until the next checkpoint the run may come back to where it goes on
  } else {
    make_files(h5::File::create(folder_.results()), {}, model, plan);
    files_->file.flush();
  }
}

void ResultsSink::make_files(h5::File file, const std::array<TableMark, 2>& tables, const Model& model,
                             const coupling::Plan& plan) {
  files_ = std::make_unique<Files>(std::move(file), folder_, tables, provenance_, model, plan.output.contacts);
  write_provenance(files_->file, provenance_);
  write_model(files_->file, model);
  write_joints(files_->file, model);
  write_supports(files_->file, model);
  write_water(files_->file, model);
  write_stages(files_->file, plan);
}

void ResultsSink::take_up(const Model& model, const coupling::Plan& plan) {
  const ResultsMark& mark = go_on_->mark;
  std::array<TableMark, 2> tables = mark.tables;
  for (std::size_t i = 0; i < tables.size(); ++i)
    if (const std::string lost = set_aside_changed(i == 0 ? folder_.history() : folder_.energy(), tables[i]);
        !lost.empty()) {
      go_on_->warn(lost);
      tables[i] = {};
    }
  const auto begin = [&](h5::File file, const std::string& past) {
    make_files(std::move(file), tables, model, plan);
    files_->file.attribute("/provenance", "resumed", past + go_on_->place);
    files_->summary.go_on(go_on_->transfers, go_on_->travels, go_on_->warnings, mark.wall_seconds, mark.cpu_seconds);
  };
  BesideFile unfinished{h5::File::beside(folder_.results())};
  try {
    const h5::File old = h5::from_whole([&] { return h5::File::open(folder_.results()); });
    const std::string past = h5::from_whole([&] { return h5::text_attribute(old, "/provenance", "resumed"); });
    begin(h5::File::create_beside(folder_.results()), past.empty() ? past : past + "; ");
    files_->take(old, mark);
    files_->flush();
    files_->file.sync();
    files_->file.put_in_place();
  } catch (const DamagedFile& e) {
    files_.reset();
    const std::filesystem::path aside = RunFolder::set_aside(folder_.results());
    const std::string kept = aside.empty() ? "it is missing" : "what there was of it is now in " + aside.string();
    go_on_->warn(fmt::format("{}; {}, and run.vtkhdf begins anew at {}", e.what(), kept, go_on_->place));
    begin(h5::File::create(folder_.results()), "with what was before lost or put aside, ");
  }
}

ResultsMark ResultsSink::mark() {
  Files& f = files();
  f.flush();
  f.tables.sync();
  f.file.keep();
  ResultsMark mark;
  f.frames.mark(mark);
  mark.histories = f.histories.marks();
  mark.events = f.events.marks();
  if (f.contacts) mark.contacts = f.contacts->marks();
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
  files().histories.append(history);
  files().tables.append(history);
}

void ResultsSink::event(const coupling::Event& event) {
  files().events.append(event);
  files().summary.event(event);
}

void ResultsSink::end(const coupling::RunEnd& end, const coupling::FrameView& last) {
  if (files().stored != std::pair{last.tick, last.stage}) files().frame(last);
  outcome_ = files().summary.checked(end, last);
  files().file.attribute("/provenance", "status", status_name(outcome_.status));  // a run that was killed has none
  files().file.attribute("/provenance", "reason", outcome_.reason);
  files().close();
  write_atomically(folder_.summary(), files().summary.text(outcome_, last));
  files_.reset();
}

}  // namespace scree::io
