// Writes the results of a run into its folder: run.vtkhdf, run.xmf, history.csv, energy.csv and, at the end,
// summary.json.
#pragma once

#include <memory>

#include "coupling/sink.h"
#include "io/results/provenance.h"
#include "io/results/run_folder.h"

namespace scree::io {

/// run.vtkhdf has the groups /VTKHDF (frames, vtkhdf_writer.h), /frames, /history, /energy (history_writer.h), /events,
/// /transfers (event_writer.h), /contacts where asked for (contact_writer.h), /xdmf (xdmf_writer.h), /blocks,
/// /materials, /joints (joints_writer.h), /stages and /provenance (provenance.h). Histories are buffered; a frame and
/// the end of the run bring everything to the operating system, so a run that is killed reads back as of its last
/// frame.
/// @throws FileError{path, reason} from every call: losing results ends a run
class ResultsSink : public coupling::Sink {
 public:
  /// Makes no file yet; begin() does.   @param folder  from RunFolder::create
  ResultsSink(RunFolder folder, Provenance provenance);
  ~ResultsSink() override;

  void begin(const Model& model, const coupling::Plan& plan) override;
  void topology(const coupling::MeshView& mesh) override;
  void frame(const coupling::FrameView& frame) override;
  void history(const coupling::HistoryView& history) override;
  void event(const coupling::Event& event) override;
  /// Stores the last instant too, unless it was a frame, closes the files and writes the summary.
  void end(const coupling::RunEnd& end, const coupling::FrameView& last) override;

  [[nodiscard]] const RunFolder& folder() const { return folder_; }

 private:
  struct Files;
  [[nodiscard]] Files& files();

  RunFolder folder_;
  Provenance provenance_;
  std::unique_ptr<Files> files_;  // from begin() to end()
};

}  // namespace scree::io
