#include "app/slope/slope_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "app/sweep/csv_text.h"
#include "io/case/case_error.h"
#include "io/case/record.h"

namespace scree::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kFirstPeriod = 0.01, kLastPeriod = 10.0;  // of the response spectra [s]
constexpr std::size_t kPeriods = 121;                      // 40 per decade
constexpr double kDegree = std::numbers::pi / 180.0;

double median_step(const std::vector<double>& time) {
  std::vector<double> steps;
  for (std::size_t i = 0; i + 1 < time.size(); ++i) steps.push_back(time[i + 1] - time[i]);
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// Time in which the integral of a^2 grows from 5 to 95 % of its final value [s].
double significant_duration(const Samples& r) {
  std::vector<double> sum{0.0};
  for (std::size_t i = 0; i + 1 < r.time.size(); ++i) {
    const double a0 = r.acceleration[i], a1 = r.acceleration[i + 1];
    sum.push_back(sum.back() + 0.5 * (a0 * a0 + a1 * a1) * (r.time[i + 1] - r.time[i]));
  }
  const auto when = [&](double part) {
    const auto i = static_cast<std::size_t>(std::lower_bound(sum.begin(), sum.end(), part * sum.back()) - sum.begin());
    if (i == 0) return r.time.front();
    const double into = (part * sum.back() - sum[i - 1]) / (sum[i] - sum[i - 1]);
    return r.time[i - 1] + into * (r.time[i] - r.time[i - 1]);
  };
  return sum.back() > 0.0 ? when(0.95) - when(0.05) : 0.0;
}

NewmarkResult newmark(const Samples& record, double yield, double factor) {
  const double a_c = yield * kStandardGravity;
  return {yield, factor, slide_of(record, a_c, factor), slide_of(reversed(record), a_c, factor)};
}

RecordNumbers numbers_of(const std::filesystem::path& file, const SlopeQuestion& q, const SlopeNumbers& slope) {
  Samples r = record_in_si(file, q.unit);
  const double largest = peak(r);
  if (q.pga && !(largest > 0.0))
    throw std::invalid_argument(file.string() + ": all accelerations are zero and cannot be scaled to a peak");
  const double factor = q.pga ? *q.pga * kStandardGravity / largest : q.scale;
  for (double& a : r.acceleration) a *= factor;
  RecordNumbers out;
  out.file = file.string();
  out.points = r.time.size();
  out.step = median_step(r.time);
  out.facts = GroundMotion(r.time, r.acceleration, {1.0, 0.0}).facts();
  out.duration_5_95 = significant_duration(r);
  if (slope.yield && *slope.yield > 0.0) {
    out.along = newmark(r, *slope.yield, 1.0);
    out.regressions = jibson_2007({*slope.yield, out.facts.pga / kStandardGravity, q.magnitude, out.facts.arias});
  }
  if (slope.yield_k_h && *slope.yield_k_h > 0.0) out.level = newmark(r, *slope.yield_k_h, *slope.amplification);
  out.spectrum = response_spectrum(r, spectrum_periods(kFirstPeriod, kLastPeriod, kPeriods), q.damping);
  return out;
}

Json json_of(const NewmarkResult& n) {
  return {{"yield_g", n.yield},
          {"relative_acceleration_factor", n.factor},
          {"displacement_m",
           {{"forward", n.forward.displacement}, {"backward", n.backward.displacement}, {"mean", n.mean()}}},
          {"peak_velocity_m_per_s", {{"forward", n.forward.peak_velocity}, {"backward", n.backward.peak_velocity}}},
          {"slips", {{"forward", n.forward.slips}, {"backward", n.backward.slips}}},
          {"source", "Newmark 1965; Jibson 2007"}};
}

Json json_of(const std::vector<RegressionResult>& results) {
  Json out = Json::array();
  for (const RegressionResult& r : results)
    out.push_back({{"equation", r.equation},
                   {"of", r.form},
                   {"median_cm", r.median},
                   {"sigma_log10", r.sigma},
                   {"minus_sigma_cm", r.lower},
                   {"plus_sigma_cm", r.upper},
                   {"within_range", r.outside.empty()},
                   {"outside", r.outside},
                   {"source", "Jibson 2007"}});
  return out;
}

Json json_of(const std::vector<Response>& spectrum, double damping) {
  Json out{{"damping", damping}, {"source", "Nigam and Jennings 1969"}};
  for (const char* key : {"period_s", "sd_m", "sv_m_per_s", "sa_m_per_s2", "psv_m_per_s", "psa_m_per_s2"})
    out[key] = Json::array();
  for (const Response& r : spectrum) {
    out["period_s"].push_back(r.period);
    out["sd_m"].push_back(r.displacement);
    out["sv_m_per_s"].push_back(r.velocity);
    out["sa_m_per_s2"].push_back(r.acceleration);
    out["psv_m_per_s"].push_back(r.pseudo_velocity);
    out["psa_m_per_s2"].push_back(r.pseudo_acceleration);
  }
  return out;
}

std::string text_of(const std::vector<RegressionResult>& results) {
  std::string out;
  for (const RegressionResult& r : results)
    out += fmt::format("    {:<44} {:>10.3g} cm   {:.3g} to {:.3g} cm within one sigma ({:g} of log10 D){}\n",
                       fmt::format("Jibson (2007) eq. {}: {}", r.equation, r.form), r.median, r.lower, r.upper, r.sigma,
                       r.outside.empty() ? "" : "\n      outside the range of its data: " + r.outside);
  return out;
}

std::string text_of(const char* what, const NewmarkResult& n) {
  return fmt::format(
      "    {0:<44} {1:>10.4g} cm   mean of {2:.4g} cm forward ({4} slips) and {3:.4g} cm backward ({5} slips)\n",
      fmt::format("Newmark block, {} {:.4g} g", what, n.yield), 100.0 * n.mean(), 100.0 * n.forward.displacement,
      100.0 * n.backward.displacement, n.forward.slips, n.backward.slips);
}

std::string text_of(const RecordNumbers& r, double damping) {
  std::string out = fmt::format(
      "{}\n    {} points, {:.6g} s in steps of {:.4g} s; PGA {:.4g} g, PGV {:.4g} m/s, Arias intensity {:.4g} m/s, "
      "5 to 95 % of it in {:.4g} s\n",
      r.file, r.points, r.facts.duration, r.step, r.facts.pga / kStandardGravity, r.facts.pgv, r.facts.arias,
      r.duration_5_95);
  if (r.along) out += text_of("along the plane, a_c", *r.along);
  if (r.level) out += text_of("horizontal shaking, k_y", *r.level);
  out += text_of(r.regressions);
  const auto top = std::max_element(r.spectrum.begin(), r.spectrum.end(), [](const Response& a, const Response& b) {
    return a.pseudo_acceleration < b.pseudo_acceleration;
  });
  out +=
      fmt::format("    response spectrum, {:g} % of critical damping: largest PSA {:.4g} g at a period of {:.3g} s\n",
                  100.0 * damping, top->pseudo_acceleration / kStandardGravity, top->period);
  return out;
}

}  // namespace

Samples record_in_si(const std::filesystem::path& file, const std::string& unit) {
  io::Record r = io::read_record(file, io::Gaps::refuse);
  if (r.unit.empty() && unit.empty())
    throw io::CaseError(file.string(), {},
                        {"the file does not state the unit of its accelerations", "", "", "--unit g, m/s2 or cm/s2",
                         "add --unit g if they are in g"});
  if (!r.unit.empty() && !unit.empty() && r.unit != unit)
    throw io::CaseError(
        file.string(), {},
        {"the file states that its accelerations are in " + r.unit, "", unit, r.unit, "leave out --unit"});
  const std::string& in = r.unit.empty() ? unit : r.unit;
  const double factor = in == "g" ? kStandardGravity : in == "cm/s2" ? 0.01 : 1.0;
  for (double& a : r.acceleration) a *= factor;
  return {std::move(r.time), std::move(r.acceleration)};
}

SlopeNumbers slope_numbers(const SlopeQuestion& q) {
  SlopeNumbers out;
  if (q.slide) {
    out.fos = q.slide->factor();
    out.fos_shaken = q.slide->factor(q.k_h, q.k_v);
    out.yield_k_h = q.slide->yield(q.k_v);
    out.critical = q.slide->critical();
    out.amplification = q.slide->amplification();
  }
  out.yield = q.yield ? q.yield : out.critical;
  for (const std::filesystem::path& file : q.records) out.records.push_back(numbers_of(file, q, out));
  if (q.records.empty() && out.yield && *out.yield > 0.0)
    out.regressions = jibson_2007({*out.yield, q.pga, q.magnitude, q.arias});
  return out;
}

std::string slope_text(const SlopeQuestion& q, const SlopeNumbers& n) {
  std::string out;
  if (q.slide) {
    const PlaneSlide& s = *q.slide;
    out += fmt::format(
        "plane with a dip of {:.4g} deg and a length of {:.6g} m; block of {:.6g} N/m; phi {:.4g} deg, c {:.6g} Pa; "
        "uplift {:.6g} N/m, thrust {:.6g} N/m\n",
        s.dip / kDegree, s.length, s.weight, s.friction / kDegree, s.cohesion, s.uplift, s.thrust);
    out += fmt::format("    factor of safety, static                     {:>10.4f}      Hoek and Bray 1981, eq. 7.3\n",
                       *n.fos);
    out += fmt::format("    with k_h = {:g}, k_v = {:g}{:{}}{:>10.4f}\n", q.k_h, q.k_v, "",
                       std::max(1, 29 - static_cast<int>(fmt::format("{:g}{:g}", q.k_h, q.k_v).size())), *n.fos_shaken);
    out += fmt::format("    yield coefficient k_y (horizontal)           {:>10.4f} g{}\n", *n.yield_k_h,
                       *n.yield_k_h <= 0.0 ? "    the block slides without shaking" : "");
    out += fmt::format("    critical acceleration a_c = (F - 1) sin dip  {:>10.4f} g    Newmark 1965\n", *n.critical);
  }
  for (const RecordNumbers& r : n.records) out += text_of(r, q.damping);
  if (!n.regressions.empty()) out += "regressions\n" + text_of(n.regressions);
  return out;
}

std::string slope_json(const SlopeQuestion& q, const SlopeNumbers& n) {
  Json out;
  out["format"] = 1;
  if (q.slide) {
    const PlaneSlide& s = *q.slide;
    out["slope"] = {{"dip_deg", s.dip / kDegree},
                    {"weight_n_per_m", s.weight},
                    {"length_m", s.length},
                    {"friction_deg", s.friction / kDegree},
                    {"cohesion_pa", s.cohesion},
                    {"uplift_n_per_m", s.uplift},
                    {"thrust_n_per_m", s.thrust},
                    {"fos", *n.fos},
                    {"pseudo_static", {{"k_h", q.k_h}, {"k_v", q.k_v}, {"fos", *n.fos_shaken}}},
                    {"yield_k_h_g", *n.yield_k_h},
                    {"critical_acceleration_g", *n.critical},
                    {"relative_acceleration_factor", *n.amplification},
                    {"source", "Hoek and Bray 1981 eq. 7.3; Newmark 1965"}};
  }
  out["yield_g"] = n.yield ? Json(*n.yield) : Json();
  out["records"] = Json::array();
  for (const RecordNumbers& r : n.records) {
    Json& j = out["records"].emplace_back(Json{{"file", r.file},
                                               {"points", r.points},
                                               {"step_s", r.step},
                                               {"duration_s", r.facts.duration},
                                               {"pga_g", r.facts.pga / kStandardGravity},
                                               {"pgv_m_per_s", r.facts.pgv},
                                               {"arias_m_per_s", r.facts.arias},
                                               {"duration_5_95_s", r.duration_5_95}});
    if (r.along) j["newmark"] = json_of(*r.along);
    if (r.level) j["newmark_horizontal"] = json_of(*r.level);
    j["regressions"] = json_of(r.regressions);
    j["spectrum"] = json_of(r.spectrum, q.damping);
  }
  if (!n.regressions.empty()) out["regressions"] = json_of(n.regressions);
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string spectrum_csv(const SlopeNumbers& n) {
  std::string out = "file,period_s,sd_m,sv_m_per_s,sa_m_per_s2,psv_m_per_s,psa_m_per_s2\n";
  for (const RecordNumbers& r : n.records)
    for (const Response& s : r.spectrum)
      out += fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", csv_field(r.file), s.period, s.displacement,
                         s.velocity, s.acceleration, s.pseudo_velocity, s.pseudo_acceleration);
  return out;
}

}  // namespace scree::app
