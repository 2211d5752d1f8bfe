// Blocks shared by the tests of the manifold method.
#pragma once

#include <optional>
#include <utility>

#include "tests/support/nmm_block.h"

namespace scree::nmm {

inline Polygon quadrilateral() { return {{{-1.1, -0.7}, {1.3, -0.6}, {1.0, 0.6}, {-0.8, 0.7}}, {}}; }

/// Density 2 kg/m3, Poisson's ratio 1/4.
inline Material rock(double young = 1.0, std::optional<InitialStress> in_situ = {}) {
  return {"rock", 2.0, young, 0.25, std::move(in_situ)};
}

/// A block in the standard form.
struct One : test::NmmBlock {
  explicit One(const Polygon& p, double cover, double young = 1.0) : NmmBlock(p, {.cover_size = cover}, rock(young)) {}
};

/// An in-situ stress that grows with depth.
inline InitialStress deviatoric() {
  InitialStress s;
  s.stress << -0.02, 0.01, 0.01, -0.05;
  s.gradient << -0.01, 0.0, 0.0, -0.03;
  s.level = 0.4;
  return s;
}

}  // namespace scree::nmm
