// Distinct id types and the integer time of a run.
#pragma once

#include <compare>
#include <cstdint>

namespace scree {

/// An index that cannot be mixed up with an index of another kind.
template <class Tag>
struct Id {
  std::int32_t value = -1;
  constexpr Id() = default;
  constexpr explicit Id(std::int32_t v) : value(v) {}
  /// Id of place i of an array.
  [[nodiscard]] static constexpr Id of(std::size_t i) { return Id(static_cast<std::int32_t>(i)); }
  [[nodiscard]] constexpr bool valid() const { return value >= 0; }
  [[nodiscard]] constexpr std::size_t index() const { return static_cast<std::size_t>(value); }
  constexpr auto operator<=>(const Id&) const = default;
};

using BlockId = Id<struct BlockTag>;        // per block of the model; never changes during a run
using BodyIndex = Id<struct BodyTag>;       // of a body among those of a stage
using MaterialId = Id<struct MaterialTag>;  // a material of the model
using JointId = Id<struct JointTag>;        // a joint law of the model
using MotionId = Id<struct MotionTag>;      // a ground motion of the model
using FunctionId = Id<struct FunctionTag>;  // a time function of the model
using StageId = Id<struct StageTag>;        // per stage of the plan, in their order

/// Simulated time in whole picoseconds: stages, substeps and output times are sums of integers, so nothing drifts.
using Tick = std::int64_t;
inline constexpr double kTicksPerSecond = 1e12;

[[nodiscard]] constexpr double seconds(Tick t) { return static_cast<double>(t) / kTicksPerSecond; }
/// Rounds down to a whole tick; a value within 1e-3 tick below a whole one counts as that one (0.1 s is 1e11 ticks).
[[nodiscard]] constexpr Tick ticks(double s) { return static_cast<Tick>(s * kTicksPerSecond + 1e-3); }

}  // namespace scree
