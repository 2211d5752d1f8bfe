// Writes the results of a run into its folder: run.vtkhdf, run.xmf, history.csv, energy.csv and, at the end,
// summary.json.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "coupling/sink.h"
#include "io/results/provenance.h"
#include "io/results/results_mark.h"
#include "io/results/results_size.h"
#include "io/results/run_folder.h"

namespace scree::io {

/// run.vtkhdf has the groups /VTKHDF (frames, vtkhdf_writer.h), /frames, /history, /energy (history_writer.h), /events,
/// /transfers (event_writer.h), /progress (progress_writer.h), /contacts if requested (contact_writer.h), /xdmf
/// (xdmf_writer.h), /blocks, /materials, /joints (joints_writer.h), /supports (supports_writer.h), /stages,
/// /provenance (provenance.h), and in models that have them /water, /bolts, /liners and /bolt_nodes. Everything is
/// buffered, and passed to the operating system every second or at intervals of 50 times what it took, whichever is
/// longer, at the end of a stage, for a checkpoint and at the end of the run. The final content of the files does not
/// depend on these times.
/// @throws FileError{path, reason} from every call: a loss of results ends the run
class ResultsSink : public coupling::Sink {
 public:
  /// The point from which a run continues.
  struct GoOn {
    ResultsMark mark;
    std::vector<coupling::TransferRow> transfers;
    std::vector<coupling::StageTravel> travels;
    std::vector<coupling::Warning> warnings;
    std::string place;                             // "t = 0.5 s, step 120", for /provenance
    std::function<void(const std::string&)> warn;  // called for results that are lost
  };

  /// Makes no file; begin() makes them.   @param folder  from RunFolder::create
  /// @param go_on  begin() keeps the results up to the mark, and drops the later ones: run.vtkhdf is written anew from
  ///               the old file, which stays until this is done. A damaged old file is renamed to run.damaged.vtkhdf,
  ///               and the new file begins at the mark.
  ResultsSink(RunFolder folder, Provenance provenance, std::optional<GoOn> go_on = std::nullopt);
  ~ResultsSink() override;

  void begin(const Model& model, const coupling::Plan& plan) override;
  void topology(const coupling::MeshView& mesh) override;
  void frame(const coupling::FrameView& frame) override;
  void history(const coupling::HistoryView& history) override;
  void event(const coupling::Event& event) override;
  /// Stores the last instant too, unless it was a frame, closes the files and writes the summary.
  void end(const coupling::RunEnd& end, const coupling::FrameView& last) override;

  /// Writes everything so far to the disk and returns its amount. However the run ends afterwards, run.vtkhdf can be
  /// restored to this content (UndoLog).   @pre between begin() and end()
  [[nodiscard]] ResultsMark mark();

  [[nodiscard]] const RunFolder& folder() const { return folder_; }
  /// How the run ended, as stated in its summary (Summary::checked).   @pre after end()
  [[nodiscard]] const coupling::RunEnd& outcome() const { return outcome_; }

 private:
  struct Files;
  [[nodiscard]] Files& files();
  /// Makes the files, with the datasets that never change.
  void make_files(h5::File file, const std::array<TableMark, 2>& tables, const Model& model, const coupling::Plan& plan,
                  const ResultsSize& size);
  void take_up(const Model& model, const coupling::Plan& plan);

  RunFolder folder_;
  Provenance provenance_;
  std::optional<GoOn> go_on_;
  std::unique_ptr<Files> files_;  // from begin() to end()
  coupling::RunEnd outcome_;
};

}  // namespace scree::io
