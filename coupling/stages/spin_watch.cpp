#include "coupling/stages/spin_watch.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "model/elasticity.h"

namespace scree::coupling {

double spin_lost(double rate, double dt) {
  const double lost = rate * rate * dt;
  return lost / (1.0 + lost);
}

std::vector<std::string> damped_spins(const Model& model, const Setup& setup, const State& state,
                                      ReportedWarnings& reported) {
  std::vector<std::string> lines;
  const double h = seconds(state.last_step);
  for (std::size_t i = 0; i < setup.bodies().size(); ++i) {
    const Body& b = setup.bodies()[i];
    if (b.driven || !setup.pool_of(b).nonlinear(b.index)) continue;
    if (!state.explicit_side.empty() && state.explicit_side[i] != 0) continue;
    const auto block = static_cast<std::int32_t>(b.block.index());
    const std::array own{block, block};
    if (reported.has(own)) continue;
    const auto pool = static_cast<std::size_t>(b.pool);
    const AffineMotion m = setup.pool_of(b)
                               .release(b.index, setup.part(std::span<const double>(state.q), pool),
                                        setup.part(std::span<const double>(state.v), pool))
                               .motion;
    const Mat2 turn = polar_rotation(m.F), gradient = m.Fdot * m.F.inverse();
    const double rate = 0.5 * std::abs(gradient(1, 0) - gradient(0, 1));
    if (spin_lost(rate, h) <= kSpinLost || std::abs(std::atan2(turn(1, 0), turn(0, 0))) < kSpinTurned) continue;
    reported.add(own);
    lines.push_back(fmt::format(
        "block '{}' turns by {:.3g} rad/s: implicit steps of {:.3g} s of a divided block remove {:.2g} of the energy "
        "of a free spin per second (docs/theory/time-integration.md, \"Numerical damping\"); explicit steps and "
        "blocks of the DDA remove none of it, shorter steps less",
        model.blocks[b.block.index()].name, rate, h, spin_lost(rate, h)));
  }
  return lines;
}

}  // namespace scree::coupling
