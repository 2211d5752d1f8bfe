#include "model/record_processing.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/check.h"
#include "model/dense_algebra.h"

namespace scree {
namespace {

constexpr double kNothing = 1e-9;  // of the record; rounding leaves less

int terms_of(Baseline degree) { return static_cast<int>(degree); }  // none 0, constant 1, ...
/// With fewer samples little more than the polynomial would remain.
std::size_t least_samples(Baseline degree) { return static_cast<std::size_t>(terms_of(degree)) + 2; }

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<double>& v) {
  return {v.data(), static_cast<Eigen::Index>(v.size())};
}

struct TimeSpan {
  double from, until;
};

TimeSpan kept_part(const Samples& record, const RecordProcessing& how) {
  const double first = record.time.front(), last = record.time.back();
  const TimeSpan kept{how.from.value_or(first), how.until.value_or(last)};
  const char* hint = "times of the record count as in its file, not as in the simulation";
  if (!(kept.from >= first && kept.from < last))
    throw ProcessingError("from", "nothing of the record begins there", fmt::format("{} <= value < {} s", first, last),
                          hint);
  if (!(kept.until <= last && kept.until > kept.from))
    throw ProcessingError("until", "nothing of the record ends there",
                          fmt::format("{} < value <= {} s", kept.from, last), hint);
  return kept;
}

}  // namespace

ProcessingError::ProcessingError(const char* of, std::string wrong, std::string right, std::string advice)
    : std::invalid_argument(fmt::format("{}: {}; allowed: {}; {}", of, wrong, right, advice)),
      setting(of),
      problem(std::move(wrong)),
      allowed(std::move(right)),
      hint(std::move(advice)) {}

double acceleration_at(const Samples& record, double t, Between between) {
  const std::vector<double>&time = record.time, &a = record.acceleration;
  const auto after = std::upper_bound(time.begin(), time.end(), t);
  if (after == time.end()) return a.back();
  if (after == time.begin()) return a.front();
  const auto i = static_cast<std::size_t>(after - time.begin()) - 1;
  if (between == Between::constant) return a[i];
  return a[i] + (a[i + 1] - a[i]) * ((t - time[i]) / (time[i + 1] - time[i]));
}

Samples window(const Samples& record, double from, double until, Between between) {
  SCREE_ASSERT(record.time.front() <= from && from < until && until <= record.time.back());
  Samples out{{from}, {acceleration_at(record, from, between)}};
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    if (record.time[i] <= from || record.time[i] >= until) continue;
    out.time.push_back(record.time[i]);
    out.acceleration.push_back(record.acceleration[i]);
  }
  out.time.push_back(until);
  out.acceleration.push_back(acceleration_at(record, until, between));
  return out;
}

Samples resample(const Samples& record, double dt, Between between) {
  SCREE_ASSERT(dt > 0.0);
  const double begin = record.time.front(), duration = record.time.back() - begin;
  // 1e-9: a duration of 0.28 s holds 28 steps of 0.01 s although 0.28/0.01 is larger than 28.
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(duration / dt * (1.0 - 1e-9))));
  Samples out;
  out.time.reserve(steps + 1);
  out.acceleration.reserve(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = begin + duration * (static_cast<double>(i) / static_cast<double>(steps));
    out.time.push_back(i == steps ? record.time.back() : t);
    out.acceleration.push_back(acceleration_at(record, out.time.back(), between));
  }
  return out;
}

Samples correct_baseline(Samples record, Baseline degree, Between between) {
  const int terms = terms_of(degree);
  if (terms == 0) return record;
  const std::vector<double>& time = record.time;
  const auto n = static_cast<Eigen::Index>(time.size());
  SCREE_ASSERT(time.size() >= least_samples(degree));
  const double middle = 0.5 * (time.front() + time.back()), half = 0.5 * (time.back() - time.front());

  // Legendre polynomials of s in [-1, 1]: powers of t would be near dependent. Columns: accelerations, velocities.
  Eigen::MatrixXd A(n, terms), V(n, terms);
  for (int k = 0; k < terms; ++k) {
    std::vector<double> basis(time.size());
    for (std::size_t i = 0; i < time.size(); ++i) {
      const double s = (time[i] - middle) / half;
      basis[i] = k == 0 ? 1.0 : k == 1 ? s : 1.5 * s * s - 0.5;
    }
    V.col(k) = as_vector(integrate(time, basis, between).velocity);
    A.col(k) = as_vector(basis);
  }
  Eigen::VectorXd v = as_vector(integrate(time, record.acceleration, between).velocity);

  // The constant removes the end velocity from the motion and from the other terms, whose coefficients are then free.
  Eigen::VectorXd c = Eigen::VectorXd::Zero(terms);
  c[0] = v[n - 1] / V(n - 1, 0);
  v -= c[0] * V.col(0);
  if (terms > 1) {
    const Eigen::RowVectorXd share = V.row(n - 1).tail(terms - 1) / V(n - 1, 0);
    Eigen::VectorXd root_weight(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto j = static_cast<std::size_t>(i);
      root_weight[i] = std::sqrt(0.5 * (time[std::min(j + 1, time.size() - 1)] - time[j > 0 ? j - 1 : 0]));
    }
    const Eigen::MatrixXd free = V.rightCols(terms - 1) - V.col(0) * share;
    const Eigen::VectorXd x = least_squares(root_weight.asDiagonal() * free, root_weight.asDiagonal() * v);
    c.tail(terms - 1) = x;
    c[0] -= share.dot(x);
  }
  Eigen::Map<Eigen::VectorXd>(record.acceleration.data(), n) -= A * c;
  return record;
}

Samples taper(Samples record, double length) {
  if (length <= 0.0) return record;
  const double begin = record.time.front(), end = record.time.back();
  SCREE_ASSERT(2.0 * length <= (end - begin) * (1.0 + 1e-9));
  for (std::size_t i = 0; i < record.time.size(); ++i) {
    const double s = std::min({record.time[i] - begin, end - record.time[i], length});
    if (s < length) record.acceleration[i] *= 0.5 * (1.0 - std::cos(std::numbers::pi * s / length));
  }
  return record;
}

double peak(const Samples& record) { return as_vector(record.acceleration).lpNorm<Eigen::Infinity>(); }

Samples process(Samples record, const RecordProcessing& how) {
  if (how.from || how.until) {
    const TimeSpan kept = kept_part(record, how);
    record = window(record, kept.from, kept.until, how.between);
  }
  const double duration = record.time.back() - record.time.front();
  if (how.resample) {
    constexpr double kMostSteps = 1e7;  // 160 MB of samples
    if (!(*how.resample <= duration && *how.resample >= duration / kMostSteps))
      throw ProcessingError("resample", fmt::format("this step does not suit a record of {:.6g} s", duration),
                            fmt::format("{:.6g} to {:.6g} s", duration / kMostSteps, duration),
                            "give the step of the record, or a part of it");
    record = resample(record, *how.resample, how.between);
  }
  if (how.baseline != Baseline::none && record.time.size() < least_samples(how.baseline))
    throw ProcessingError("baseline", fmt::format("only {} samples are left", record.time.size()),
                          fmt::format("\"none\", or at least {} samples", least_samples(how.baseline)),
                          "keep more of the record");
  if (!(how.taper >= 0.0 && 2.0 * how.taper <= duration))
    throw ProcessingError("taper", fmt::format("the tapers at both ends overlap in a record of {:.6g} s", duration),
                          fmt::format("0 to {:.6g} s", 0.5 * duration), "usual are a few percent of the record");

  const double before = peak(record);
  record = correct_baseline(std::move(record), how.baseline, how.between);
  if (how.taper > 0.0) record = correct_baseline(taper(std::move(record), how.taper), how.baseline, how.between);
  if (how.pga && !(peak(record) > kNothing * before))
    throw ProcessingError("pga", "nothing is left of the record that could be scaled", "a record of a motion",
                          "see that the record is not zero, and not a drift alone that baseline takes off");
  const double factor = how.pga ? *how.pga / peak(record) : how.scale;
  if (factor != 1.0)
    for (double& a : record.acceleration) a *= factor;
  return record;
}

}  // namespace scree
