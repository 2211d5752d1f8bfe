// Checks of a run beside the closure of its ledger: spurious energy, large columns of the scheme, lost friction.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "coupling/sink.h"
#include "coupling/state.h"
#include "model/model.h"

namespace scree::coupling {

/// Warnings already given: each column, each pair of blocks and each spin once. Not part of the State, whose hash is
/// independent of output, streams and monitors; part of the Checkpoint.
struct ReportedWarnings {
  std::vector<std::int32_t> columns;  // of the ledger
  std::vector<std::int32_t> pairs;    // two block numbers per pair, the smaller one first; equal: the block's spin

  [[nodiscard]] bool has(const std::array<std::int32_t, 2>& pair) const {
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
      if (pairs[i] == pair[0] && pairs[i + 1] == pair[1]) return true;
    return false;
  }
  void add(const std::array<std::int32_t, 2>& pair) { pairs.insert(pairs.end(), pair.begin(), pair.end()); }

  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const {
    see("reported.columns", columns);
    see("reported.pairs", pairs);
  }
};

/// Energy of negligible strains: 1e-14 E A (strains of 1e-7), summed over the blocks [J]. Smaller gains are not
/// significant: as a run begins, schemes hold such energies before work is booked.
[[nodiscard]] double energy_of_round_off(const Model& model);

/// Whether a run holds more energy than was supplied (Ledger::gain), by more than a fraction of the energy passed.
/// @param most      that fraction   @param round_off  energy_of_round_off() [J]
/// @param complete  the ledger's kinetic energy is that of the instant; false: a bound without it is used
/// @return the message: the amounts, the column with the gain, likely causes and remedies
[[nodiscard]] std::optional<std::string> energy_from_nowhere(const Ledger& ledger, double most, double round_off,
                                                             bool complete);

/// A line for every watched column (ColumnInfo::watched) above kSchemeShare of the energy passed.
/// @param reported  columns already reported are left out; new ones are added
[[nodiscard]] std::vector<std::string> large_scheme_columns(const Ledger& ledger, ReportedWarnings& reported);

/// A line for every pair of blocks with a contact that slid far and had less friction than by its law
/// (FrictionCheck::kLeast), for the worst of their contacts. Puts the worst ratio of the run into the statistics.
/// @param reported  pairs already reported are left out; new ones are added
[[nodiscard]] std::vector<std::string> lost_friction(const Model& model, const State& state, RunStats& stats,
                                                     ReportedWarnings& reported);

}  // namespace scree::coupling
