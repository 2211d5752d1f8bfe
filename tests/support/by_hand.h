// A scene's first stage without the driver: the state at the start, for tests that step it themselves.
#pragma once

#include "coupling/integrate/central_difference.h"
#include "tests/support/scene.h"

namespace scree::test {

struct ByHand {
  coupling::Methods methods = coupling::standard_methods();
  coupling::State state;
  std::unique_ptr<coupling::Setup> setup;

  /// @param model  must outlive this
  explicit ByHand(const Model& model, const coupling::Stage& stage) {
    state.bodies = coupling::initial_records(model, coupling::body_requests(model, stage));
    setup = std::make_unique<coupling::Setup>(model, methods, state.bodies);
    state.q.assign(2 * static_cast<std::size_t>(setup->nodes()), 0.0);
    state.v = state.q;
    for (std::size_t b = 0; b < setup->bodies().size(); ++b) place(b, Vec2(0.0, 0.0), Mat2::Zero());
    for (const InitialVelocity& i : model.initial_velocities)
      place(i.block.index(), i.velocity, i.spin * quarter_turn());
    state.ledger.open(std::array{kinetic()});
  }
  /// Puts a body at its place in the model, with an affine velocity; the ledger begins anew.
  void move(std::size_t body, const Vec2& velocity, const Mat2& gradient) {
    place(body, velocity, gradient);
    state.ledger.open(std::array{kinetic()});
  }
  /// As move(), without a change of the ledger.
  void place(std::size_t body, const Vec2& velocity, const Mat2& gradient) {
    const coupling::Body& b = setup->bodies()[body];
    AffineMotion m;
    m.c = b.centre;
    m.vc = velocity;
    m.Fdot = gradient;
    const auto p = static_cast<std::size_t>(b.pool);
    setup->pool_of(b).place(b.index, m, setup->part(std::span<double>(state.q), p),
                            setup->part(std::span<double>(state.v), p));
  }
  [[nodiscard]] double kinetic() const {
    double sum = 0.0;
    for (const coupling::Body& b : setup->bodies())
      if (!b.driven) sum += totals(b).kinetic;
    return sum;
  }
  [[nodiscard]] BodyTotals totals(const coupling::Body& b) const { return totals_of(*setup, state, b); }
};

}  // namespace scree::test
