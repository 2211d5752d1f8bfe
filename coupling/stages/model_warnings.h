// Warnings about unlikely values in a model: stiffnesses, sizes or units that differ by orders of magnitude.
#pragma once

#include <string>
#include <vector>

#include "model/model.h"
#include "model/touching.h"

namespace scree::coupling {

/// Bounds of the warnings: density of half of pumice, of twice a heavy ore [kg/m3]; modulus of jelly [Pa].
inline constexpr double kLightest = 200.0, kHeaviest = 10000.0, kSoftest = 1e3;

/// Largest ratios of stiffnesses, and of sizes, without a warning.
inline constexpr double kFarStiffness = 1e6, kFarSizes = 1e3;

/// The largest and the smallest stiffness of a model, if their ratio is above kFarStiffness: moduli of the materials
/// in use [Pa], springs per area times the mean size of a block, springs at points [N/m for unit thickness].
[[nodiscard]] std::vector<std::string> stiffness_warnings(const Model& model);
/// The largest and the smallest block, by root of area, if their ratio is above kFarSizes.
[[nodiscard]] std::vector<std::string> size_warnings(const Model& model);

/// Materials of blocks whose density or modulus no rock has: most often a number in another unit.
[[nodiscard]] std::vector<std::string> unit_warnings(const Model& model);

/// Lasting accelerations of blocks that equal gravity: it acts on all blocks by default, and they would weigh twice.
[[nodiscard]] std::vector<std::string> weight_warnings(const Model& model);

/// Blocks that touch in a model whose case has no joint law: their faces are smooth. (Several laws without a default
/// are refused when the case is read.)
[[nodiscard]] std::vector<std::string> lawless_warnings(const Model& model, const std::vector<Touch>& touches);

}  // namespace scree::coupling
