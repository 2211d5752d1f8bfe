// The classical numbers of a slope and of records, computed and written down.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/slope/jibson.h"
#include "app/slope/plane_failure.h"
#include "app/slope/response_spectrum.h"
#include "app/slope/sliding_block.h"

namespace scree::app {

/// Input of `scree slope`. Angles in radians, SI units unless stated otherwise.
struct SlopeQuestion {
  std::optional<PlaneSlide> slide;  // the slope
  double k_h = 0.0, k_v = 0.0;      // pseudo-static coefficients
  std::optional<double> yield;      // critical acceleration, if it is not computed from the slope [g]
  std::vector<std::filesystem::path> records;
  std::string unit;                 // of records that do not state theirs; empty: none given
  double scale = 1.0;               // factor on the accelerations
  std::optional<double> pga;        // peak that records are scaled to; without records, peak for the regressions [g]
  std::optional<double> magnitude;  // for the regressions
  std::optional<double> arias;      // for the regressions, without records [m/s]
  double damping = 0.05;            // of the spectra
};

/// Newmark's block on one record.
struct NewmarkResult {
  double yield = 0.0, factor = 1.0;  // [g]; relative acceleration for each unit of excess
  BlockSlide forward, backward;      // the record as it is, and with the opposite sign
  [[nodiscard]] double mean() const { return 0.5 * (forward.displacement + backward.displacement); }
};

struct RecordNumbers {
  std::string file;
  std::size_t points = 0;
  double step = 0.0;  // median [s]
  MotionFacts facts;
  double duration_5_95 = 0.0;          // in which the Arias intensity grows from 5 to 95 % [s]
  std::optional<NewmarkResult> along;  // shaking along the plane, with the critical acceleration
  std::optional<NewmarkResult> level;  // horizontal shaking of the slope given, with its yield coefficient
  std::vector<RegressionResult> regressions;
  std::vector<Response> spectrum;
};

struct SlopeNumbers {
  std::optional<double> fos, fos_shaken, yield_k_h, critical, amplification;  // of the slope; [-], [-], [g], [g], [-]
  std::optional<double> yield;                                                // used for Newmark's block [g]
  std::vector<RecordNumbers> records;
  std::vector<RegressionResult> regressions;  // without records
};

/// @throws CaseError for a record that cannot be read or whose unit is not known, std::invalid_argument for numbers out
///         of their range
[[nodiscard]] SlopeNumbers slope_numbers(const SlopeQuestion& question);

/// Accelerations in m/s2, by the unit that the file states or else the one given.
/// @throws CaseError where neither gives a unit, or they differ
[[nodiscard]] Samples record_in_si(const std::filesystem::path& file, const std::string& unit);

[[nodiscard]] std::string slope_text(const SlopeQuestion& question, const SlopeNumbers& numbers);
[[nodiscard]] std::string slope_json(const SlopeQuestion& question, const SlopeNumbers& numbers);
/// Periods and spectral values of all records, one row per period and record.
[[nodiscard]] std::string spectrum_csv(const SlopeNumbers& numbers);

}  // namespace scree::app
