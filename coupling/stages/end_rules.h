// Rules that end a stage before its duration is over.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/stages/force_balance.h"

namespace scree::coupling {

/// Records the initial values of the rules of a stage in the state.
void begin_rules(const EndRules& rules, State& state);

/// Evaluates after every step whether a rule is met. Constant between two changes of bodies.
/// @source docs/theory/time-integration.md, "Rest and statics"
class EndWatch {
 public:
  /// @pre rules.used(); rules and setup outlive it
  EndWatch(const EndRules& rules, const Setup& setup, const State& state);
  /// @param begin  centres of mass at the beginning of the stage, per block [m]
  /// @return the rule and its value, as text; empty: no rule is met
  [[nodiscard]] std::optional<std::string> evaluate(State& state, const TimeIntegrator& integrator,
                                                    std::span<const Vec2> begin);

 private:
  [[nodiscard]] std::optional<std::string> slow(State& state) const;
  [[nodiscard]] std::optional<std::string> balanced(State& state, const TimeIntegrator& integrator);
  [[nodiscard]] std::optional<std::string> slipped(const State& state) const;
  [[nodiscard]] std::optional<std::string> moved(const State& state, std::span<const Vec2> begin) const;
  /// Centre of mass of a body [m].
  [[nodiscard]] Vec2 centre(const Body& b, std::span<const double> q) const;

  const EndRules* rules_;
  const Setup* setup_;
  std::unique_ptr<ForceBalance> balance_;
  std::vector<double> mass_;  // x, y per node: weight of its position in the centre of mass [kg]
};

}  // namespace scree::coupling
