// Numerical damping, by implicit steps, of the waves that drive a model.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coupling/integrate/newmark_theory.h"
#include "coupling/plan.h"
#include "model/model.h"

namespace scree::coupling {

/// A free oscillation under Newmark's steps (1/2, 1). Its amplitude is multiplied by the spectral radius r per step,
///   r = (1 + Omega^2/2)^-1/2 below Omega = w dt = 4;  per second 1 - r^(1/dt), about w^2 dt/4 while that is small.
struct NumericalDamping {
  double frequency = 0.0;   // [Hz]
  double per_second = 0.0;  // part of the amplitude lost per second
  double per_period = 0.0;  // part of the amplitude lost per period
};
/// @param frequency [Hz], > 0   @param dt [s], > 0
[[nodiscard]] NumericalDamping numerical_damping(double frequency, double dt);
/// The step length that removes this part of the amplitude per second [s].   @pre 0 < per_second < 1
[[nodiscard]] double step_that_damps(double frequency, double per_second);

/// The highest frequency that drives a model [Hz]; 0: no oscillating load or motion. For a motion, or a tabulated
/// function: the frequency below which 95 % of the energy of its accelerations, or of its slopes, lies; for sine its
/// frequency; for half_sine 1/(2 T), for sine_squared 1/T.
/// @param acts  per motion, then per function: not 0 where it counts (acts_in()); empty: all count
[[nodiscard]] double driven_frequency(const Model& model, std::span<const char> acts = {});

/// Numerical damping of a stage; empty for stages without implicit steps, with a scheme that damps nothing, or with
/// velocities that are not physical (rest, dynamics below 1).
struct StageDamping {
  std::string stage;
  double dt = 0.0;
  bool divided = false;                    // waves cross the border of an explicit region
  std::optional<NumericalDamping> driven;  // empty: nothing drives the model
  std::optional<NumericalDamping> wave;    // P wave with a length of ten covers of the finest mesh; empty: no mesh
};
/// @param acts  motions and functions that act in the stage, as above
[[nodiscard]] std::optional<StageDamping> stage_damping(const Model& model, const Stage& stage,
                                                        std::span<const char> acts = {});

/// True where implicit steps of the stage damp motion: Newmark's (1/2, 1), and velocity is physical.
[[nodiscard]] bool damps_motion(const Stage& stage);

inline constexpr double kDampsMuch = 0.05;  // part of the amplitude per second
/// True where the driven frequency, or in a divided block a wave of ten covers, loses more than kDampsMuch per second.
[[nodiscard]] bool damps_much(const StageDamping& damping);
/// One line; where damps_much(), it contains the step that would remove 5 % per second.
[[nodiscard]] std::string text(const StageDamping& damping);

}  // namespace scree::coupling
