// Elastic response spectrum of a record.
#pragma once

#include <vector>

#include "model/record_processing.h"

namespace scree::app {

/// Largest response of a damped oscillator with a period.
struct Response {
  double period = 0.0;               // [s]
  double displacement = 0.0;         // spectral displacement Sd: of the mass over the ground [m]
  double velocity = 0.0;             // Sv likewise [m/s]
  double acceleration = 0.0;         // Sa, of the mass in space [m/s2]
  double pseudo_velocity = 0.0;      // PSV = w Sd [m/s]
  double pseudo_acceleration = 0.0;  // PSA = w^2 Sd [m/s2]
};

/// The oscillator u'' + 2 z w u' + w^2 u = -a(t), at rest before the record, which is straight between samples. Each
/// step is taken exactly; where a step is longer than a twentieth of the period the response is looked at within it
/// too. What comes after the record is free vibration: its first half period is looked at.
/// @param periods [s], above 0   @param damping  fraction of critical, 0 <= z < 1
/// @throws std::invalid_argument for others
/// @source [NigamJennings1969]
[[nodiscard]] std::vector<Response> response_spectrum(const Samples& record, const std::vector<double>& periods,
                                                      double damping);

/// Periods at equal ratios, both ends included.   @pre 0 < first < last, 2 <= count
[[nodiscard]] std::vector<double> spectrum_periods(double first, double last, std::size_t count);

}  // namespace scree::app
