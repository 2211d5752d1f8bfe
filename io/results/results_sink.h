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
/// /transfers (event_writer.h), /progress (progress_writer.h), /contacts where asked for (contact_writer.h), /xdmf
/// (xdmf_writer.h), /blocks, /materials, /joints (joints_writer.h), /supports (supports_writer.h), /stages and
/// /provenance (provenance.h). Everything is buffered, and brought to the operating system every second, as a stage
/// ends, for a checkpoint and as the run ends. What is in the files at the end does not depend on when.
/// @throws FileError{path, reason} from every call: losing results ends a run
class ResultsSink : public coupling::Sink {
 public:
  /// Where a run goes on.
  struct GoOn {
    ResultsMark mark;
    std::vector<coupling::TransferRow> transfers;
    std::vector<coupling::StageTravel> travels;
    std::vector<coupling::Warning> warnings;
    std::string place;                             // "t = 0.5 s, step 120", for /provenance
    std::function<void(const std::string&)> warn;  // told of results that are lost
  };

  /// Makes no file yet; begin() does.   @param folder  from RunFolder::create
  /// @param go_on  begin() keeps what was there at the mark, and drops what came after: run.vtkhdf is written anew from
  ///               the old one, which stays until that is done. Where the old one is damaged it is put aside as
  ///               run.damaged.vtkhdf, and the new one begins at the mark.
  ResultsSink(RunFolder folder, Provenance provenance, std::optional<GoOn> go_on = std::nullopt);
  ~ResultsSink() override;

  void begin(const Model& model, const coupling::Plan& plan) override;
  void topology(const coupling::MeshView& mesh) override;
  void frame(const coupling::FrameView& frame) override;
  void history(const coupling::HistoryView& history) override;
  void event(const coupling::Event& event) override;
  /// Stores the last instant too, unless it was a frame, closes the files and writes the summary.
  void end(const coupling::RunEnd& end, const coupling::FrameView& last) override;

  /// Brings everything so far to the disk and says how much it is. Whatever becomes of the run from then on, run.vtkhdf
  /// can be brought back to it (UndoLog).   @pre between begin() and end()
  [[nodiscard]] ResultsMark mark();

  [[nodiscard]] const RunFolder& folder() const { return folder_; }
  /// How the run ended, as its summary has it (Summary::checked).   @pre after end()
  [[nodiscard]] const coupling::RunEnd& outcome() const { return outcome_; }

 private:
  struct Files;
  [[nodiscard]] Files& files();
  /// Makes the files, with the heads that never change.
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
