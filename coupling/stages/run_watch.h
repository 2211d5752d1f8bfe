// What a run watches of itself beside the closure of its ledger: energy from nowhere, large columns of the scheme,
// friction that is lost.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "coupling/sink.h"
#include "coupling/state.h"
#include "model/model.h"

namespace scree::coupling {

/// What a run has warned of: each column, each pair of blocks and each spin once. Not part of the State, whose hash
/// does not depend on who looks when; part of the Checkpoint.
struct Told {
  std::vector<std::int32_t> columns;  // of the ledger
  std::vector<std::int32_t> pairs;    // two block numbers a pair, the smaller one first; one twice: the block's spin

  [[nodiscard]] bool has(const std::array<std::int32_t, 2>& pair) const {
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
      if (pairs[i] == pair[0] && pairs[i + 1] == pair[1]) return true;
    return false;
  }
  void add(const std::array<std::int32_t, 2>& pair) { pairs.insert(pairs.end(), pair.begin(), pair.end()); }

  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const {
    see("told.columns", columns);
    see("told.pairs", pairs);
  }
};

/// Energy that hardly strains anything: 1e-14 E A (strains of 1e-7), summed over the blocks [J]. Smaller gains mean
/// nothing: as a run begins, schemes hold such energies before work is booked.
[[nodiscard]] double energy_of_round_off(const Model& model);

/// Whether a run holds more energy than it was given (Ledger::gain), by more than a part of the energy passed.
/// @param most      that part   @param round_off  energy_of_round_off() [J]
/// @param complete  the ledger's kinetic energy is that of the instant; false: a bound without it is looked at
/// @return what to say: the amounts, what column has it, likely causes and remedies
[[nodiscard]] std::optional<std::string> energy_from_nowhere(const Ledger& ledger, double most, double round_off,
                                                             bool complete);

/// A line for every watched column (ColumnInfo::watched) above kSchemeShare of the energy passed.
/// @param told  columns that have had theirs are left out; new ones are added
[[nodiscard]] std::vector<std::string> large_scheme_columns(const Ledger& ledger, Told& told);

/// A line for every pair of blocks with a contact that slid far and had less friction than its law says
/// (FrictionCheck::kLeast), for the worst of their contacts. Brings the worst of the run into the statistics.
/// @param told  pairs that have had theirs are left out; new ones are added
[[nodiscard]] std::vector<std::string> lost_friction(const Model& model, const State& state, RunStats& stats,
                                                     Told& told);

}  // namespace scree::coupling
