// What a model seldom means to have: stiffness and sizes that are worlds apart.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "model/touching.h"

namespace scree::coupling {

/// Densities out of this range are told: half of pumice, twice a heavy ore [kg/m3]; and softer things than jelly [Pa].
inline constexpr double kLightest = 200.0, kHeaviest = 10000.0, kSoftest = 1e3;

/// Stiffnesses further apart than this, and sizes, are told.
inline constexpr double kFarStiffness = 1e6, kFarSizes = 1e3;

/// The stiffest and the softest thing of a model, where they are more than kFarStiffness apart: moduli of the materials
/// in use [Pa], springs per area times the mean size of a block, springs at points [N/m for unit thickness].
[[nodiscard]] std::vector<std::string> stiffness_warnings(const Model& model);
/// The largest and the smallest block, root of area, where they are more than kFarSizes apart.
[[nodiscard]] std::vector<std::string> size_warnings(const Model& model);

/// Materials of blocks whose density or modulus no rock has: most often a number in another unit.
[[nodiscard]] std::vector<std::string> unit_warnings(const Model& model);

/// Blocks touch in a model whose case names no joint law: their faces are smooth. (Several laws without a default are
/// refused when the case is read.)
[[nodiscard]] std::vector<std::string> lawless_warnings(const Model& model, const std::vector<Touch>& touches);

}  // namespace scree::coupling
