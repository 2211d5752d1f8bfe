// Elastic response spectrum of a record.
#pragma once

#include <vector>

#include "model/record_processing.h"

namespace scree::app {

/// Largest response of a damped oscillator with a period.
struct Response {
  double period = 0.0;               // [s]
  double displacement = 0.0;         // spectral displacement Sd: of the mass relative to the ground [m]
  double velocity = 0.0;             // Sv, of the mass relative to the ground [m/s]
  double acceleration = 0.0;         // Sa, absolute, of the mass [m/s2]
  double pseudo_velocity = 0.0;      // PSV = w Sd [m/s]
  double pseudo_acceleration = 0.0;  // PSA = w^2 Sd [m/s2]
};

/// The oscillator u'' + 2 z w u' + w^2 u = -a(t), at rest before the record, which is linear between samples. Each
/// step is integrated exactly; if a step is longer than a twentieth of the period, the response is evaluated within it
/// too. The free vibration after the record is evaluated over its first half period.
/// @param periods [s], above 0   @param damping  fraction of critical, 0 <= z < 1
/// @throws std::invalid_argument for other values
/// @source [NigamJennings1969]
[[nodiscard]] std::vector<Response> response_spectrum(const Samples& record, const std::vector<double>& periods,
                                                      double damping);

/// Periods at equal ratios, both ends included.   @pre 0 < first < last, 2 <= count
[[nodiscard]] std::vector<double> spectrum_periods(double first, double last, std::size_t count);

}  // namespace scree::app
