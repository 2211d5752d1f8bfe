// A recorded acceleration as a motion of the base: integrated once, exactly, evaluated at any time.
#pragma once

#include <string>
#include <vector>

#include "model/geometry.h"

namespace scree {

/// Facts that an engineer reads off a record.
struct MotionFacts {
  double duration = 0.0;            // [s]
  double pga = 0.0;                 // peak |acceleration| [m/s2]
  double pgv = 0.0;                 // peak |velocity| at the samples [m/s]
  double final_velocity = 0.0;      // [m/s]
  double final_displacement = 0.0;  // [m]
  double arias = 0.0;               // pi/(2 g) int a^2 dt [m/s], g = 9.80665
};

/// Acceleration that is linear between samples; at rest before the first sample, moving on at the final velocity
/// after the last (zero acceleration).
///   v += (a0 + a1) h/2,  d += v h + (2 a0 + a1) h^2/6
/// @source thesis eq. 8.1 is the piecewise-constant form; deviation: piecewise linear, exact at any t
class GroundMotion {
 public:
  GroundMotion() = default;
  /// @param time [s], strictly increasing, at least two   @param acceleration [m/s2], as many
  GroundMotion(std::vector<double> time, std::vector<double> acceleration, Vec2 direction);

  [[nodiscard]] Vec2 displacement(double t) const;  // [m]
  [[nodiscard]] Vec2 velocity(double t) const;      // [m/s]
  [[nodiscard]] Vec2 acceleration(double t) const;  // [m/s2]
  [[nodiscard]] MotionFacts facts() const;
  [[nodiscard]] const std::vector<double>& times() const { return time_; }
  [[nodiscard]] const std::vector<double>& accelerations() const { return a_; }
  [[nodiscard]] Vec2 direction() const { return direction_; }

  /// Removes the straight line from the velocity that leaves it zero at the end (a constant from the acceleration).
  void correct_baseline();

 private:
  void integrate();
  struct Scalar {
    double a, v, d;
  };
  [[nodiscard]] Scalar at(double t) const;

  std::vector<double> time_, a_, v_, d_;
  Vec2 direction_{1.0, 0.0};
};

}  // namespace scree
