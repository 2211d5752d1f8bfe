#include "coupling/integrate/support_release.h"

#include <algorithm>
#include <array>

namespace scree::coupling {
namespace {

/// Calls see(row, weight) for the two rows at a point of an outline.
template <class See>
void rows_at(const Setup& setup, const Body& b, const SupportForce& force, See&& see) {
  const Boundary& boundary = setup.pool_of(b).boundary(b.index);
  const OutlineEdge edge{force.ring, force.edge};
  const Boundary::Segment* found = nullptr;
  for (const Boundary::Segment& s : boundary.segments)
    if (s.edge == edge && s.s0 <= force.s) found = &s;  // the last that begins before it
  if (found == nullptr) return;
  const double w = std::clamp((force.s - found->s0) / (found->s1 - found->s0), 0.0, 1.0);
  const auto row = [&](std::int32_t node) { return setup.global(b, boundary.nodes[static_cast<std::size_t>(node)]); };
  const std::array<Row, 2> rows{row(found->a), row(found->b)};
  if (!setup.applies(rows)) return;
  see(rows[0], 1.0 - w);
  see(rows[1], w);
}

}  // namespace

SupportRelease::SupportRelease(const Setup& setup, const State& state)
    : begin_(seconds(state.support.begin)), end_(seconds(state.support.end)) {
  const std::size_t n = 2 * static_cast<std::size_t>(setup.nodes());
  for (const SupportForce& force : state.support.forces) {
    const Body& b = setup.bodies()[force.block.index()];
    if (b.driven) continue;
    rows_at(setup, b, force, [&](const Row& row, double weight) {
      if (last_.empty()) {
        last_.assign(n, 0.0);
        falling_.assign(n, 0.0);
      }
      const Vec2 whole = weight * Vec2(force.x, force.y);
      add_force(row, force.last * whole, last_);
      add_force(row, (force.left - force.last) * whole, falling_);
    });
  }
}

void SupportRelease::add(double time, std::span<double> f) const {
  if (!acts()) return;
  const double r = time >= end_ ? 0.0 : (time <= begin_ ? 1.0 : (end_ - time) / (end_ - begin_));
  for (std::size_t i = 0; i < f.size(); ++i) f[i] += last_[i] + r * falling_[i];
}

void SupportReleaseTerm::add(const Instant& at, std::span<double> f) {
  force_.assign(f.size(), 0.0);
  release_.add(at.t, force_);
  for (std::size_t i = 0; i < f.size(); ++i) f[i] += force_[i];
}

double SupportReleaseTerm::half_work(double h, std::span<const double> v) const {
  double power = 0.0;
  for (std::size_t i = 0; i < force_.size(); ++i) power += force_[i] * v[i];
  return 0.5 * h * power;
}

}  // namespace scree::coupling
