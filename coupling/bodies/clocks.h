// Start times of motions and functions that are counted from a stage, whose own beginning only the run determines.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "coupling/plan.h"
#include "model/model.h"

namespace scree::coupling {

/// Origin of the times of each motion and function of the model, in one stage [s]; infinite: it has not begun, and does
/// not begin in this stage. Empty: all from t = 0.
struct Clocks {
  std::vector<double> motion, function;
  std::int32_t stage = 0;  // its number in the plan
};

/// The clocks of the last stage that has begun. A function that begins where this stage ends, or later, belongs to
/// another stage: the step that ends there does not include it.
/// @param stage_begin  State::stage_begin   @param stage_end  latest end of the last of these stages
[[nodiscard]] Clocks clocks_of(const Model& model, std::span<const Tick> stage_begin, Tick stage_end);

/// A motion or a function that begins in no stage of a run, or lasts beyond its end.
struct TimeFault {
  enum class Kind { missed, outlasts } kind = Kind::missed;
  bool motion = false;            // false: a function
  std::size_t index = 0;          // into the model's motions or functions
  double begin = 0.0, end = 0.0;  // of the motion or function [s]
  double run_end = 0.0;           // [s]
  /// The same fault of the same motion or function.
  [[nodiscard]] bool same(const TimeFault& other) const {
    return kind == other.kind && motion == other.motion && index == other.index;
  }
};

/// @param stage_begin  of the stages so far; empty: as planned   @param stage_end  latest end of the last of them
[[nodiscard]] std::vector<TimeFault> time_faults(const Model& model, const Plan& plan,
                                                 std::span<const Tick> stage_begin = {}, Tick stage_end = 0);

/// The stage in which each begins, motions first, then functions; invalid: none. Arguments as above.
[[nodiscard]] std::vector<StageId> stages_met(const Model& model, const Plan& plan,
                                              std::span<const Tick> stage_begin = {}, Tick stage_end = 0);

/// 1 for those that act in a stage: not over when it begins, and begun before it ends. Order and arguments as above.
[[nodiscard]] std::vector<char> acts_in(const Model& model, const Plan& plan, std::size_t stage,
                                        std::span<const Tick> stage_begin = {}, Tick stage_end = 0);

/// "the motion 'kobe' begins at 12 s, but the run is over at 10 s"
[[nodiscard]] std::string text(const TimeFault& fault, const Model& model);

}  // namespace scree::coupling
