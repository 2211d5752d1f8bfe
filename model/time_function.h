// A number that depends on time: the history of a load.
#pragma once

#include <string>
#include <vector>

#include "model/ids.h"

namespace scree {

/// value(t) = amplitude times a shape that begins at `start` [s]; zero before it.
///   constant   1
///   ramp       rises from 0 to 1 over `duration`, then 1
///   sine       sin(2 pi frequency (t - start)), for `duration` if that is given (> 0)
///   half_sine  sin(pi (t - start)/duration) for `duration`, then 0
///   sine_squared  sin^2(pi (t - start)/duration) for `duration`, then 0
///   table      straight lines through (time, value), times counted from `start`; then the last value
struct TimeFunction {
  enum class Shape { constant, ramp, sine, half_sine, sine_squared, table };
  std::string name;
  Shape shape = Shape::constant;
  double amplitude = 1.0;
  double start = 0.0;               // [s], on the clock below
  double duration = 0.0;            // [s]
  double frequency = 0.0;           // of sine [Hz]
  std::vector<double> time, table;  // of table, in equal number; times strictly increasing, the first >= 0 [s]
  StageId stage;                    // its clock begins with this stage of the plan; invalid: simulated time
  bool of_load = false;             // made for one load, which has a start of its own

  /// @param t  time of its clock [s]
  [[nodiscard]] double value(double t) const;
  /// Time before which the value is zero, according to the shape [s].
  [[nodiscard]] double begin() const;
  /// Time after which the value is constant, possibly zero; infinite: never [s].
  [[nodiscard]] double end() const;
};

}  // namespace scree
