// What implicit steps take from the waves that a model is driven with.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/integrate/newmark_theory.h"
#include "coupling/plan.h"
#include "model/model.h"

namespace scree::coupling {

/// A free oscillation under Newmark's steps (1/2, 1). Its amplitude falls by the spectral radius r a step,
///   r = (1 + Omega^2/2)^-1/2 below Omega = w dt = 4;  per second 1 - r^(1/dt), about w^2 dt/4 while that is small.
struct NumericalDamping {
  double frequency = 0.0;   // [Hz]
  double per_second = 0.0;  // part of the amplitude that is lost in a second
  double per_period = 0.0;  // and in a period
};
/// @param frequency [Hz], > 0   @param dt [s], > 0
[[nodiscard]] NumericalDamping numerical_damping(double frequency, double dt);
/// The step that takes this part of the amplitude a second [s].   @pre 0 < per_second < 1
[[nodiscard]] double step_that_damps(double frequency, double per_second);

/// The highest frequency that drives a model [Hz]; 0: nothing that swings does. Of a motion, or a function that is a
/// table, that below which 95 % of the energy of its accelerations, or of its slopes, lies; of sine its frequency; of
/// half_sine 1/(2 T), of sine_squared 1/T.
/// @param acts  of motions, then functions, those that count (acts_in()); empty: all
[[nodiscard]] double driven_frequency(const Model& model, std::span<const char> acts = {});

/// What the implicit steps of a stage damp; empty for stages that have none, whose scheme damps nothing, or in which
/// velocity is not physical (rest, dynamics below 1).
struct StageDamping {
  std::string stage;
  double dt = 0.0;
  bool divided = false;                    // waves cross the border of an explicit region
  std::optional<NumericalDamping> driven;  // empty: nothing drives the model
  std::optional<NumericalDamping> wave;    // of ten covers of the finest mesh, as P wave; empty: no mesh
};
/// @param acts  what drives in the stage, as above
[[nodiscard]] std::optional<StageDamping> stage_damping(const Model& model, const Stage& stage,
                                                        std::span<const char> acts = {});

/// True where implicit steps of the stage damp what moves: Newmark's (1/2, 1), and velocity is physical.
[[nodiscard]] bool damps_motion(const Stage& stage);

inline constexpr double kDampsMuch = 0.05;  // a second
/// True where the driven frequency, or in a divided block a wave of ten covers, loses more than kDampsMuch a second.
[[nodiscard]] bool damps_much(const StageDamping& damping);
/// One line, which names the step that would take 5 % where damps_much().
[[nodiscard]] std::string text(const StageDamping& damping);

}  // namespace scree::coupling
