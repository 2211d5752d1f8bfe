// A recorded acceleration as a motion of the base: integrated once, exactly, evaluated at any time.
#pragma once

#include <string>
#include <vector>

#include "model/geometry.h"
#include "model/ids.h"

namespace scree {

constexpr double kStandardGravity = 9.80665;  // [m/s2]

/// Interpolation of the acceleration between samples.
enum class Between {
  linear,   // straight to the next sample: v += (a0 + a1) h/2, d += v h + (2 a0 + a1) h^2/6
  constant  // constant until the next sample: v += a0 h, d += v h + a0 h^2/2 ([Qu2013] eq. 8.1)
};

/// Characteristic values of a record. The Arias intensity is the sum over the samples, as printed in catalogues. For a
/// record without content above its Nyquist frequency that sum is the integral itself; the integral over straight lines
/// between the samples is smaller (by 1.5 % for El Centro 1940 at 0.01 s).
struct MotionFacts {
  double duration = 0.0;            // from the first sample to the last [s]
  double pga = 0.0;                 // peak |acceleration| [m/s2]
  double pgv = 0.0;                 // peak |velocity| [m/s], within the steps too
  double final_velocity = 0.0;      // [m/s]
  double final_displacement = 0.0;  // at the last sample [m]
  double arias = 0.0;               // pi/(2 g) sum (a0^2 + a1^2) h/2 [m/s], g = kStandardGravity; a1 = a0 if constant
};

/// A motion along a straight line: at rest before the first sample, moving on at the final velocity after the last
/// (zero acceleration). Displacement and velocity are functions of the time alone, independent of the steps.
/// @source [Qu2013] eq. 8.1 is Between::constant; deviation: Between::linear is the meaning of a record
class GroundMotion {
 public:
  /// Start, interpolation between samples, name and clock of the motion.
  struct Setting {
    double start = 0.0;  // time of the first sample, on the clock below [s]
    Between between = Between::linear;
    std::string name{};
    StageId stage{};  // its clock begins with this stage of the plan; invalid: simulated time
  };

  GroundMotion() = default;
  /// @param time [s], strictly increasing, at least two   @param acceleration [m/s2], as many
  /// @param direction  of positive accelerations, of length 1
  /// @throws std::invalid_argument for other samples
  GroundMotion(std::vector<double> time, std::vector<double> acceleration, const Vec2& direction)
      : GroundMotion(std::move(time), std::move(acceleration), direction, Setting()) {}
  GroundMotion(std::vector<double> time, std::vector<double> acceleration, const Vec2& direction, Setting setting);

  /// @param t  time of its clock [s]
  [[nodiscard]] Vec2 displacement(double t) const;  // [m]
  [[nodiscard]] Vec2 velocity(double t) const;      // [m/s]
  [[nodiscard]] Vec2 acceleration(double t) const;  // [m/s2]
  [[nodiscard]] MotionFacts facts() const;
  [[nodiscard]] const std::vector<double>& times() const { return time_; }  // of the record [s]
  [[nodiscard]] const std::vector<double>& accelerations() const { return a_; }
  [[nodiscard]] Vec2 direction() const { return direction_; }
  [[nodiscard]] const Setting& setting() const { return setting_; }

 private:
  struct Scalar {
    double a, v, d;
  };
  [[nodiscard]] Scalar at(double t) const;

  std::vector<double> time_, a_, v_, d_;
  Vec2 direction_{1.0, 0.0};
  Setting setting_;
};

/// Velocity [m/s] and displacement [m] at every sample of a motion that begins at rest.
/// @param time [s], acceleration [m/s2]: as many
struct Integrals {
  std::vector<double> velocity, displacement;
};
[[nodiscard]] Integrals integrate(const std::vector<double>& time, const std::vector<double>& acceleration,
                                  Between between);

}  // namespace scree
