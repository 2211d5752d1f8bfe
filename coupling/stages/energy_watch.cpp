#include "coupling/stages/energy_watch.h"

#include <fmt/format.h>

namespace scree::coupling {
namespace {

double work(const Ledger& ledger) {
  return ledger[Column::gravity] + ledger[Column::loads] + ledger[Column::water] + ledger[Column::prescribed_motion];
}

}  // namespace

void begin_energy_watch(State& state) {
  const Ledger& l = state.ledger;
  state.rules.energy.held = l.energy() - l[Column::reservoir] - l[Column::shadow];
  state.rules.energy.work = work(l);
  state.rules.energy.made = l[Column::elastic_trapezoid];
  state.rules.energy.warned = 0;
}

std::optional<std::string> watch_energy(State& state) {
  RuleMemory::Energy& begin = state.rules.energy;
  if (begin.warned != 0) return std::nullopt;
  const double made = state.ledger[Column::elastic_trapezoid] - begin.made,
               there = begin.held + (work(state.ledger) - begin.work);
  if (!(made > kEnergyMade * there)) return std::nullopt;
  begin.warned = 1;
  return fmt::format(
      "the steps have created {:.3g} J of elastic energy, {:.2g} of the {:.3g} J present; internal forces "
      "evaluated once per dt may be in resonance with faster motion: choose another dt, or name the blocks in "
      "explicit_blocks",
      made, made / there, there);
}

}  // namespace scree::coupling
