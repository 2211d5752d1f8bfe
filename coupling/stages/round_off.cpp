#include "coupling/stages/round_off.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scree::coupling {
namespace {

constexpr double kOfLargest = 1e-13;  // fraction of the largest column
constexpr double kPlaces = 8.0;       // last places of a position lost to round-off in one step

/// Masses and largest stiffness of the moving part of a model.
struct Moving {
  double mass = 0.0, lightest = std::numeric_limits<double>::infinity();  // [kg for unit thickness]
  double stiffest = 0.0;                                                  // [N/m for unit thickness]
};

Moving moving_part(const Model& model, const State& state) {
  Moving out;
  std::vector<char> held(model.blocks.size(), 0);
  for (const BlockSupport& s : model.block_supports) held[s.block.index()] = 1;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    if (held[b] != 0) continue;
    const BlockId id{static_cast<std::int32_t>(b)};
    const double mass = model.material_of(id).density * moments(model.blocks[b].polygon).area;
    out.mass += mass;
    out.lightest = std::min(out.lightest, mass);
    out.stiffest = std::max(out.stiffest, model.elasticity_of(id).p_modulus());
  }
  for (const ContactMemory& m : state.contacts) out.stiffest = std::max({out.stiffest, m.kn, m.kt});
  for (const PointSupport& s : model.point_supports) out.stiffest = std::max(out.stiffest, s.stiffness.value_or(0.0));
  return out;
}

}  // namespace

double energy_of_last_places(const Model& model, const State& state) {
  const Moving moving = moving_part(model, state);
  double farthest = 0.0;
  for (const double x : state.q) farthest = std::max(farthest, std::abs(x));
  const Ledger& ledger = state.ledger;
  const double k = moving.stiffest, u = kPlaces * std::numeric_limits<double>::epsilon() * farthest,
               steps = static_cast<double>(std::max<std::int64_t>(state.step, 1)),
               way = seconds(state.time) * std::sqrt(2.0 * ledger.passed() / moving.lightest),
               held = std::abs(ledger[Column::elastic]) + ledger[Column::contact_springs] +
                      ledger[Column::support_springs],
               force = moving.mass * model.gravity.norm() + std::sqrt(2.0 * k * held);
  return kOfLargest * ledger.largest() + k * u * way / std::sqrt(steps) + force * u * std::sqrt(steps) +
         k * u * u * steps;
}

}  // namespace scree::coupling
