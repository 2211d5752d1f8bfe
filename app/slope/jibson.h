// Sliding of a slope by regression on many records.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace scree::app {

/// Input of the regressions. Equations whose input is missing are left out.
struct Shaking {
  double yield = 0.0;               // critical acceleration a_c [g]
  std::optional<double> pga;        // peak acceleration [g]
  std::optional<double> magnitude;  // moment magnitude
  std::optional<double> arias;      // Arias intensity of one component [m/s]
};

struct RegressionResult {
  int equation = 0;                 // of the source, 6 to 9
  std::string form;                 // with its units
  double median = 0.0;              // [cm]; the standard deviation of log10 is that of the equation
  double sigma = 0.0;               // of log10(D)
  double lower = 0.0, upper = 0.0;  // median times 10^-sigma and 10^sigma [cm]
  std::string outside;              // why it is beyond the range of the data; empty: within
};

/// The four equations, D in cm, a_c and a_max in g, I_a in m/s:
///   (6)  log D = 0.215 + log[(1 - r)^2.341 r^-1.438] +- 0.510,   r = a_c/a_max
///   (7)  log D = -2.710 + log[(1 - r)^2.335 r^-1.478] + 0.424 M +- 0.454
///   (8)  log D = 0.561 log I_a - 3.833 log r - 1.474 +- 0.616
///   (9)  log D = 2.401 log I_a - 3.481 log a_c - 3.230 +- 0.656
/// The data: 2270 components of 30 earthquakes of magnitude 5.3 to 7.6, a_c from 0.05 to 0.4 g. Where a_c >= a_max the
/// block does not slide: (6), (7) give 0.
/// @source [Jibson2007] eqs. 6 to 9
[[nodiscard]] std::vector<RegressionResult> jibson_2007(const Shaking& shaking);

}  // namespace scree::app
