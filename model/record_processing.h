// From a measured record to the motion applied to a model: window, resampling, baseline, taper, scale.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/ground_motion.h"

namespace scree {

/// Acceleration [m/s2] at times [s] that strictly increase; equal numbers of both, at least two.
struct Samples {
  std::vector<double> time, acceleration;
};

/// Degree of the polynomial that a baseline correction subtracts from the acceleration.
enum class Baseline { none, constant, linear, quadratic };

/// Processing steps of a record, in this order. The defaults change nothing.
struct RecordProcessing {
  std::optional<double> from, until;  // part that is kept, in the time of the record [s]
  std::optional<double> resample;     // required time step [s]
  Baseline baseline = Baseline::none;
  double taper = 0.0;         // length of the taper at either end [s]
  std::optional<double> pga;  // required peak |acceleration| [m/s2]
  double scale = 1.0;         // factor on the accelerations, applied if there is no pga
  Between between = Between::linear;
};

/// A record that cannot be processed with the given settings.
struct ProcessingError : std::invalid_argument {
  ProcessingError(const char* of, std::string wrong, std::string right, std::string advice);
  const char* setting;  // the member of RecordProcessing that is at fault
  std::string problem, allowed, hint;
};

/// All steps below, in the order of RecordProcessing; the baseline is corrected again after the taper, which would
/// otherwise leave the ground moving. Scaling commutes with the rest, so it comes last.
/// @pre finite accelerations
/// @throws ProcessingError  times outside the record, nothing kept, a step longer than the record or ten million times
///         shorter, tapers that overlap, too few samples for the baseline, nothing left to scale to the peak
[[nodiscard]] Samples process(Samples record, const RecordProcessing& how);

/// Acceleration at a time of the record, between two samples as they are joined.
/// @pre t within the record
[[nodiscard]] double acceleration_at(const Samples& record, double t, Between between);

/// The part from one time to another; its ends lie between samples if the times do.
/// @pre first time <= from < until <= last time
[[nodiscard]] Samples window(const Samples& record, double from, double until, Between between);

/// Samples at equal steps from the first time to the last, interpolated between the old ones. The step is the largest
/// that divides the duration and does not exceed dt (up to rounding). Steps that divide the old ones keep a piecewise
/// linear motion exactly; longer ones lose peaks and alias content above the new Nyquist frequency into the motion.
/// @pre 0 < dt
[[nodiscard]] Samples resample(const Samples& record, double dt, Between between);

/// Subtracts the polynomial p of the given degree in time from the acceleration. p leaves the ground at rest at the end
/// and minimises the mean square of the velocity:
///   v(T) = 0,   sum_i w_i v_i^2 -> min,   v the velocity of a - p from rest,   w_i half the steps beside sample i
/// so that for a constant p = v_0(T)/T. The integration is that of the motion, so a polynomial drift of this degree
/// added to the samples does not change the result.
/// @pre at least three samples more than the degree
/// @source [BergHousner1961] (parabolic base line, least mean square of the velocity); deviation: v(T) = 0 is imposed,
///         since otherwise a base would keep moving after the record
[[nodiscard]] Samples correct_baseline(Samples record, Baseline degree, Between between);

/// Multiplies by half a cosine bell over the given length at either end: (1 - cos(pi s/length))/2 at the distance s
/// from the end.
/// @pre 0 <= length <= half the duration
[[nodiscard]] Samples taper(Samples record, double length);

/// Largest |acceleration| of the samples [m/s2].
[[nodiscard]] double peak(const Samples& record);

}  // namespace scree
