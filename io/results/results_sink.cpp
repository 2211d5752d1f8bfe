#include "io/results/results_sink.h"

#include <optional>
#include <utility>

#include "io/results/contact_writer.h"
#include "io/results/csv.h"
#include "io/results/event_writer.h"
#include "io/results/history_writer.h"
#include "io/results/joints_writer.h"
#include "io/results/summary.h"
#include "io/results/vtkhdf_writer.h"
#include "io/results/xdmf_writer.h"
#include "model/check.h"

namespace scree::io {

struct ResultsSink::Files {
  h5::File file;
  VtkhdfWriter frames;
  XdmfWriter xdmf;
  HistoryWriter histories;
  EventWriter events;
  std::optional<ContactWriter> contacts;  // where the plan asks for them
  CsvHistories tables;
  Summary summary;
  std::pair<Tick, std::int32_t> stored{-1, -1};  // tick and stage of the frame stored last

  Files(const RunFolder& folder, const Provenance& provenance, const Model& model, bool with_contacts)
      : file(h5::File::create(folder.results())),
        frames(file),
        xdmf(file, folder.xdmf()),
        histories(file, model),
        events(file),
        tables(folder.history(), folder.energy(), model),
        summary(model, provenance) {
    if (with_contacts) contacts.emplace(file);
  }

  void frame(const coupling::FrameView& view) {
    xdmf.frame(view, frames.frame(view));
    if (contacts) contacts->frame(view);
    stored = {view.tick, view.stage};
    frames.flush();
    histories.flush();
    events.flush();
    if (contacts) contacts->flush();
    tables.flush();
    file.flush();
    xdmf.flush();  // after what it refers to
  }

  void close() {
    frames.close();
    histories.close();
    events.close();
    if (contacts) contacts->close();
    tables.close();
    file.flush();
    xdmf.close();
    file.close();
  }
};

ResultsSink::ResultsSink(RunFolder folder, Provenance provenance)
    : folder_(std::move(folder)), provenance_(std::move(provenance)) {}

ResultsSink::~ResultsSink() = default;

ResultsSink::Files& ResultsSink::files() {
  SCREE_ASSERT(files_ != nullptr);
  return *files_;
}

void ResultsSink::begin(const Model& model, const coupling::Plan& plan) {
  files_ = std::make_unique<Files>(folder_, provenance_, model, plan.output.contacts);
  write_provenance(files_->file, provenance_);
  write_model(files_->file, model);
  write_joints(files_->file, model);
  write_stages(files_->file, plan);
  files_->file.flush();
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
  files().file.attribute("/provenance", "status", status_name(end.status));  // a run that was killed has none
  files().file.attribute("/provenance", "reason", end.reason);
  files().close();
  write_atomically(folder_.summary(), files().summary.text(end, last));
  files_.reset();
}

}  // namespace scree::io
