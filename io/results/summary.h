// Final values of a run, for scripts and users: summary.json.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "coupling/sink.h"
#include "io/results/provenance.h"

namespace scree::io {

/// done, interrupted, not_converged or non_finite.
[[nodiscard]] std::string status_name(coupling::RunEnd::Status status);

/// Collects the data of the summary during a run. The keys (units: s, m, J, bytes unless the name states another):
///   version, commit, case_sha256, title, origin [x, y] (positions in the results are relative to it), status,
///   reason, final_time, end_time, state_hash (16 hexadecimal digits), stage, steps, cuts, open_close_passes,
///   newton_iterations, contact_switches, factorisations, factor_updates (rank 1 each), corrections (solutions with a
///   factor of another matrix), block_iterations (those with an incomplete factor of blocks), incomplete_factors,
///   local_passes (of clusters of bodies), fallbacks (from blocks to a complete factor), asleep (blocks at
///   the end), sleep_momentum (of blocks as they fell asleep, summed [N s]), audit {checks, worst} (in
///   audited runs), wall_seconds {explicit, implicit, output, total}, cpu_seconds, threads, peak_memory_bytes,
///   blocks_count, elements, unknowns, element_steps_per_second, contacts, ledger {columns {energy {...}, work {...},
///   dissipated {...}, scheme {...}}, energy, closure, moved,
///           relative_closure (0 where what moved is next to nothing), last_places (Ledger::last_places),
///           relative_closure_of ("the energy moved" or "next to nothing"), passed, passed_closure, gain
///           (Ledger::passed and gain), scheme_share = max |scheme column| / moved, scheme_passed_share =
///           max |watched column| / passed},
///   friction {worst_ratio, contact} (FrictionCheck; in runs in which a contact slid far enough),
///   transfers [{time, block, from, to, mass_error, momentum_error, angular_error, energy_error, kinetic_before,
///               kinetic_after, elastic_before, elastic_after, reservoir_kinetic, reservoir_elastic, booked}],
///   warnings [{time, text}] (all warnings since the start), command_line, set [key=value],
///   blocks [{name, method, displacement = |mean displacement of the points of its cells|}]
class Summary {
 public:
  /// The clock of wall_seconds.total starts here.   @param model,provenance  must outlive the summary
  Summary(const Model& model, const Provenance& provenance);
  void event(const coupling::Event& event);
  /// Wall time and processor time that the run has used so far [s].
  [[nodiscard]] double wall_seconds() const;
  [[nodiscard]] double cpu_seconds() const;
  /// Continues from the values at which a run stopped.
  void go_on(std::vector<coupling::TransferRow> transfers, std::vector<coupling::StageTravel> travels,
             std::vector<coupling::Warning> warnings, double wall_seconds, double cpu_seconds);
  /// The document.   @pre last.mesh, last.state and last.stats are set
  [[nodiscard]] std::string text(const coupling::RunEnd& end, const coupling::FrameView& last) const;
  /// `end`, with non_finite in place of done if the document would contain a number that is not finite.
  /// @pre as for text()
  [[nodiscard]] coupling::RunEnd checked(const coupling::RunEnd& end, const coupling::FrameView& last) const;

 private:
  struct Document;
  [[nodiscard]] Document document(const coupling::RunEnd& end, const coupling::FrameView& last) const;

  const Model* model_;
  const Provenance* provenance_;
  std::vector<coupling::TransferRow> transfers_;
  std::vector<coupling::StageTravel> travels_;
  std::vector<coupling::Warning> warnings_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double earlier_wall_ = 0.0, earlier_cpu_ = 0.0;  // of the parts of the run before it was resumed [s]
};

}  // namespace scree::io
