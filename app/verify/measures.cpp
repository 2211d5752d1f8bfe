#include "app/verify/measures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "app/verify/reference.h"
#include "io/case/suggest.h"

namespace scree::app {
namespace {

using Kind = MeasureKey::Kind;
using Plots = std::vector<io::LinePlot>;

constexpr MeasureKey kMonitor{Kind::text, "of", true, ""};
constexpr MeasureKey kComponent{Kind::text, "component", true, ""};
constexpr MeasureKey kFrom{Kind::number, "from", false, ""}, kUntil{Kind::number, "until", false, ""};
const std::vector<std::string> kStatistics{"end", "peak", "max", "min"};
const std::string kImplicit = "implicit";
const std::vector<std::string> kParts{"transmitted", "reflected", "absorbed"};
// Periods between samples: the trapezoidal rule errs by (2 pi 0.05)^2/12, 0.8 %, at a jump.
constexpr double kMostPeriods = 0.05;

const char* unit_of(const std::string& component) {
  return component[0] == 's' ? "Pa" : component[0] == 'v' ? "m/s" : "m";
}

/// A component of a monitor in the window of the quantity.
struct Samples {
  std::vector<double> time, value;
};

Samples samples(const Quantity& q, const RunRecord& run, const std::string& monitor, const std::string& component) {
  const std::vector<double> all = run.monitor(monitor)->component(component);
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const double from = q.number("from").value_or(-kInf), until = q.number("until").value_or(kInf);
  Samples s;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (run.time[i] < from || run.time[i] > until) continue;
    if (!std::isfinite(all[i]))
      throw q.error("component", fmt::format("the run has no {} of monitor {}", component, io::in_quotes(monitor)),
                    "a component that the method of the block gives");
    s.time.push_back(run.time[i]);
    s.value.push_back(all[i]);
  }
  if (s.time.empty())
    throw q.error("from", "the run has no samples in the window", fmt::format("within 0 to {:g} s", run.time.back()));
  return s;
}

Samples samples(const Quantity& q, const RunRecord& run, const std::string& monitor) {
  return samples(q, run, monitor, q.text("component"));
}

double largest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

double statistic(const std::string& name, const std::vector<double>& values) {
  if (name == "end") return values.back();
  if (name == "peak") return largest(values);
  return name == "max" ? *std::max_element(values.begin(), values.end())
                       : *std::min_element(values.begin(), values.end());
}

std::filesystem::path beside(const Quantity& q, const std::string& file) {
  return std::filesystem::path(q.file).parent_path() / file;
}

/// Largest |found - wanted| over the largest |wanted|.
double curve_error(const std::vector<double>& found, const std::vector<double>& wanted) {
  double worst = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) worst = std::max(worst, std::abs(found[i] - wanted[i]));
  const double scale = largest(wanted);
  return scale > 0.0 ? worst / scale : worst;
}

double history_error(const Quantity& q, const std::string& variant, const RunRecords& runs, Plots& plots) {
  const std::string &monitor = q.text("of"), &component = q.text("component");
  const Samples found = samples(q, runs.at(variant), monitor);
  std::vector<double> wanted;
  std::string what;
  if (const std::string& against = q.text("against"); !against.empty()) {
    const Samples other = samples(q, runs.at(against), monitor);
    for (const double t : found.time) wanted.push_back(interpolated(other.time, other.value, t));
    what = against;
  } else {
    const ReferenceTable table = read_reference(beside(q, q.text("file")));
    const std::string column = q.text("column").empty() ? component : q.text("column");
    for (const double t : found.time) wanted.push_back(interpolated(table.column("time"), table.column(column), t));
    what = "reference";
  }
  plots.push_back({q.name,
                   "time [s]",
                   fmt::format("{} of {} [{}]", component, monitor, unit_of(component)),
                   {{what, found.time, wanted, false, true}, {variant, found.time, found.value}}});
  return curve_error(found.value, wanted);
}

/// Values at several monitors against a table with columns monitor, x, and the component.
double profile_error(const Quantity& q, const std::string& variant, const RunRecords& runs, Plots& plots) {
  const std::string& component = q.text("component");
  const RunRecord& run = runs.at(variant);
  const ReferenceTable table = read_reference(beside(q, q.text("file")));
  const std::string column = q.text("column").empty() ? component : q.text("column");
  const std::vector<double>&wanted = table.column(column), &x = table.column("x");
  std::vector<double> found;
  for (const std::string& name : table.names) {
    if (run.monitor(name) == nullptr)
      throw q.error(
          "file", fmt::format("{} names the monitor {}, which the case does not have", table.file, io::in_quotes(name)),
          "monitors of the case");
    found.push_back(statistic(q.text("statistic"), samples(q, run, name).value));
  }
  if (found.size() != wanted.size())
    throw q.error("file", fmt::format("the first column of {} holds no names", table.file), "monitor, x, values");
  plots.push_back({q.name,
                   "x [m]",
                   fmt::format("{} [{}]", component, unit_of(component)),
                   {{"reference", x, wanted, false, true}, {variant, x, found, true}}});
  return curve_error(found, wanted);
}

/// |int x exp(-2 pi i f t) dt| over the window by the trapezoidal rule, x a component less that of another variant.
double harmonic(const Quantity& q, const std::string& variant, const RunRecords& runs) {
  const double frequency = *q.number("frequency");
  Samples s = samples(q, runs.at(variant), q.text("of"));
  if (const std::string& minus = q.text("minus"); !minus.empty()) {
    const Samples other = samples(q, runs.at(minus), q.text("of"));
    if (other.time.back() + kMostPeriods / frequency < s.time.back())
      throw q.error("minus", fmt::format("{} ends at {:g} s, before {}", minus, other.time.back(), variant),
                    fmt::format("a run to {:g} s", s.time.back()), "set until");
    for (std::size_t i = 0; i < s.time.size(); ++i) s.value[i] -= interpolated(other.time, other.value, s.time[i]);
  }
  std::complex<double> sum = 0.0, before;
  for (std::size_t i = 0; i < s.time.size(); ++i) {
    const std::complex<double> now = s.value[i] * std::polar(1.0, -2.0 * std::numbers::pi * frequency * s.time[i]);
    if (i > 0) {
      const double step = s.time[i] - s.time[i - 1];
      if (step * frequency > kMostPeriods)
        throw q.error("frequency", fmt::format("samples {:g} s apart are too few for {:g} Hz", step, frequency),
                      fmt::format("at least {:g} samples a period", 1.0 / kMostPeriods), "lower output.history_every");
      sum += 0.5 * step * (before + now);
    }
    before = now;
  }
  return std::abs(sum);
}

/// Energy of the waves that pass a monitor along and against the axis, over the impedance.
struct Passing {
  double along = 0.0, against = 0.0;
};

Passing passing(const Quantity& q, const RunRecord& run, const std::string& monitor) {
  const Samples v = samples(q, run, monitor), s = samples(q, run, monitor, q.text("stress"));
  const double impedance = *q.number("impedance");
  Passing sum;
  Vec2 before = Vec2::Zero();
  for (std::size_t i = 0; i < v.time.size(); ++i) {
    const double along = 0.5 * (v.value[i] - s.value[i] / impedance), against = v.value[i] - along;
    const Vec2 now(along * along, against * against);
    if (i > 0) {
      const Vec2 part = 0.5 * (v.time[i] - v.time[i - 1]) * (before + now);
      sum.along += part.x();
      sum.against += part.y();
    }
    before = now;
  }
  return sum;
}

/// Square root of the part of the energy arriving at an interface that is transmitted, reflected, or stays there. A
/// wave along the axis has v = -stress/z, a wave against it v = stress/z.
double crossing(const Quantity& q, const RunRecord& run) {
  const Passing near = passing(q, run, q.text("of")), far = passing(q, run, q.text("behind"));
  if (!(near.along > 0.0)) throw q.error("of", "no wave arrives there in the window", "a monitor before the interface");
  if (q.text("part") == "transmitted") return std::sqrt(far.along / near.along);
  if (q.text("part") == "reflected") return std::sqrt(near.against / near.along);
  return std::sqrt(std::max(0.0, 1.0 + (far.against - near.against - far.along) / near.along));
}

double transfer_energy_error(const RunRecord& run) {
  // Summed over a whole hand-over: the error of a block with hardly any energy is only round-off of its positions.
  std::map<double, std::pair<double, double>> handed;  // time: errors and energies summed [J]
  for (const coupling::TransferRow& row : run.transfers) {
    const double energy = row.before.kinetic + row.before.elastic;
    handed[row.time].first += row.energy_error * energy;
    handed[row.time].second += energy;
  }
  double worst = 0.0;
  for (const auto& [time, sums] : handed)
    if (sums.second > 0.0) worst = std::max(worst, sums.first / sums.second);
  return worst;
}

double transfer_momentum_error(const RunRecord& run) {
  double worst = 0.0;
  for (const coupling::TransferRow& row : run.transfers)
    worst = std::max({worst, row.mass_error, row.momentum_error, row.angular_error});
  return worst;
}

/// Kinetic energy after the latest hand-over [J].
double kinetic_at_handover(const RunRecord& run) {
  double sum = 0.0;
  for (const coupling::TransferRow& row : run.transfers)
    if (row.time == run.transfers.back().time) sum += row.after.kinetic;
  return sum;
}

double scheme_share(const RunRecord& run) {
  double worst = 0.0;
  for (int i = 0; i < coupling::kColumns; ++i) {
    const auto column = static_cast<coupling::Column>(i);
    if (info(column).side == coupling::Side::scheme) worst = std::max(worst, std::abs(run.ledger[column]));
  }
  return run.ledger.moved() > 0.0 ? worst / run.ledger.moved() : worst;
}

double drift_in_stage(const Quantity& q, const RunRecord& run) {
  for (const coupling::StageTravel& t : run.travels)
    if (t.stage == q.text("of")) return t.farthest;
  throw q.error("of", fmt::format("the run did not reach the stage {}", io::in_quotes(q.text("of"))), "a stage");
}

/// Over the blocks that the other variant moves by at least "above" and less than "below".
double blocks_difference(const Quantity& q, const RunRecord& run, const RunRecords& runs) {
  const std::vector<Vec2>& other = runs.at(q.text("against")).moved;
  if (other.size() != run.moved.size())
    throw q.error("against",
                  fmt::format("{} has {} free blocks, not {}", q.text("against"), other.size(), run.moved.size()),
                  "a variant with the same blocks");
  const double above = q.number("above").value_or(0.0);
  const double below = q.number("below").value_or(std::numeric_limits<double>::infinity());
  double worst = 0.0, farthest = 0.0;
  for (std::size_t i = 0; i < other.size(); ++i) {
    if (other[i].norm() < above || other[i].norm() >= below) continue;
    worst = std::max(worst, (run.moved[i] - other[i]).norm());
    farthest = std::max(farthest, other[i].norm());
  }
  if (!(farthest > 0.0)) throw q.error("above", "no block of the other variant moved so far", "a smaller distance");
  return worst / farthest;
}

double on_variant(const Quantity& q, const std::string& variant, const RunRecords& runs, Plots& plots) {
  const RunRecord& run = runs.at(variant);
  const std::string& m = q.measure;
  const auto count = [&](auto&& wanted) {
    return static_cast<double>(
        std::count_if(run.moved.begin(), run.moved.end(), [&](const Vec2& u) { return wanted(u.norm()); }));
  };
  if (m == "monitor") return statistic(q.text("statistic"), samples(q, run, q.text("of")).value);
  if (m == "history_error") return history_error(q, variant, runs, plots);
  if (m == "profile_error") return profile_error(q, variant, runs, plots);
  if (m == "harmonic") return harmonic(q, variant, runs);
  if (m == "crossing") return crossing(q, run);
  if (m == "blocks_moved_above") return count([&](double d) { return d > *q.number("of"); });
  if (m == "blocks_moved_below") return count([&](double d) { return d < *q.number("of"); });
  if (m == "blocks_difference") return blocks_difference(q, run, runs);
  if (m == "drift_in_stage") return drift_in_stage(q, run);
  if (m == "kinetic_at_handover") return kinetic_at_handover(run);
  if (m == "ledger_closure") return run.ledger.relative_closure();
  if (m == "scheme_share") return scheme_share(run);
  if (m == "transfer_momentum_error") return transfer_momentum_error(run);
  if (m == "transfer_energy_error") return transfer_energy_error(run);
  if (m == "stepping_time") return q.text("of") == kImplicit ? run.stepping_implicit : run.stepping;
  if (m == "wall_time") return run.least_wall;
  if (m == "same_state") return run.hash == runs.at(q.text("against")).hash ? 1.0 : 0.0;
  if (m == "steps") return static_cast<double>(run.stats.steps);
  return run.refused.empty() ? 0.0 : 1.0;  // refused
}

/// Slope of the straight line through (log size, log |value - exact|), least squares.
double observed_order(const Quantity& q, const RunRecords& runs, Plots& plots) {
  std::vector<double> error, x, y;
  for (const std::string& variant : q.variants) {
    error.push_back(std::abs(on_variant(q, variant, runs, plots) - q.exact));
    x.push_back(std::log(q.sizes[error.size() - 1]));
    y.push_back(std::log(error.back()));
  }
  plots.push_back({q.name, "size", "error", {{"error", q.sizes, error, true}, {"", q.sizes, error}}, true, true});
  const auto n = static_cast<double>(x.size());
  double mx = 0.0, my = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) mx += x[i] / n, my += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i) xx += (x[i] - mx) * (x[i] - mx), xy += (x[i] - mx) * (y[i] - my);
  return xy / xx;
}

}  // namespace

const std::vector<MeasureInfo>& measures() {
  static const std::vector<MeasureInfo> kAll{
      {"monitor",
       "a component of a monitor: at the end, its largest magnitude, largest or least value",
       {kMonitor, kComponent, {Kind::text, "statistic", false, "end"}, kFrom, kUntil}},
      {"history_error",
       "largest difference to a reference history, or to another variant, over the reference's peak",
       {kMonitor,
        kComponent,
        {Kind::text, "file", false, ""},
        {Kind::text, "column", false, ""},
        {Kind::text, "against", false, ""},
        kFrom,
        kUntil}},
      {"harmonic",
       "|int x exp(-2 pi i f t) dt|, x a component of a monitor; with minus, of its difference to another variant's, "
       "while over divides by that of the whole history",
       {kMonitor, kComponent, {Kind::number, "frequency", true, ""}, {Kind::text, "minus", false, ""}, kFrom, kUntil}},
      {"crossing",
       "of the wave that arrives at an interface between two monitors, the second farther along the axis: the root of "
       "the part of its energy that is transmitted, reflected or absorbed; v and stress are those of its motion",
       {kMonitor,
        {Kind::text, "behind", true, ""},
        {Kind::text, "part", true, ""},
        kComponent,
        {Kind::text, "stress", true, ""},
        {Kind::number, "impedance", true, ""},
        kFrom,
        kUntil}},
      {"profile_error",
       "largest difference to a table of values at monitors, over the largest of them",
       {kComponent,
        {Kind::text, "file", true, ""},
        {Kind::text, "column", false, ""},
        {Kind::text, "statistic", false, "end"},
        kFrom,
        kUntil}},
      {"blocks_moved_above", "free blocks that moved farther than a distance", {{Kind::number, "of", true, ""}}},
      {"blocks_moved_below", "free blocks that moved less than a distance", {{Kind::number, "of", true, ""}}},
      {"blocks_difference",
       "largest difference of the displacements of free blocks to those of another variant, over the farthest of these",
       {{Kind::text, "against", true, ""}, {Kind::number, "above", false, ""}, {Kind::number, "below", false, ""}}},
      {"drift_in_stage", "farthest displacement of a free block in a stage [m]", {{Kind::text, "of", true, ""}}},
      {"kinetic_at_handover", "kinetic energy after the latest hand-over [J]", {}},
      {"ledger_closure", "what the ledger leaves over, of the energy moved", {}},
      {"scheme_share", "largest scheme term of the ledger, of the energy moved", {}},
      {"transfer_momentum_error", "largest relative error of mass and momenta in hand-overs", {}},
      {"transfer_energy_error", "largest relative error of energy in hand-overs", {}},
      {"stepping_time",
       "processor time of the process, all its threads, in stages, the least of the repeats [s]: steps with their "
       "contact search, bounds, rules, checks and ledger, but neither set-up and hand-overs nor output; with of = "
       "\"implicit\" that of implicit and partitioned stages; meant for ratios",
       {{Kind::text, "of", false, ""}}},
      {"wall_time", "time on the clock of a run without output, the least of the repeats [s]; meant for ratios", {}},
      {"same_state",
       "1 where a run ended in the same state as another variant, to the last bit, else 0",
       {{Kind::text, "against", true, ""}}},
      {"steps", "steps made", {}},
      {"refused", "1 where the plan was refused before a step, else 0", {}},
      {"study", "a number that the study computed", {{Kind::text, "of", true, ""}}}};
  return kAll;
}

double measure(const Quantity& q, const RunRecords& runs, std::vector<io::LinePlot>& plots) {
  if (q.is_order()) {
    std::vector<io::LinePlot> own;  // of each variant; one picture of the convergence replaces them
    const double order = observed_order(q, runs, own);
    plots.push_back(std::move(own.back()));
    return order;
  }
  const double value = on_variant(q, q.variants.front(), runs, plots);
  if (q.over.empty()) return value;
  Quantity divisor = q;  // the incoming quantity, not its difference from itself
  if (const auto minus = divisor.texts.find("minus"); minus != divisor.texts.end()) minus->second.clear();
  return value / on_variant(divisor, q.over, runs, plots);
}

void check_names(const Quantity& q, const Model& model, const coupling::Plan& plan) {
  const auto check = [&](const char* key, const char* kind, const std::vector<std::string>& known) {
    if (std::find(known.begin(), known.end(), q.text(key)) == known.end())
      throw q.error(key, fmt::format("unknown {} {}", kind, io::in_quotes(q.text(key))), io::listed(known),
                    io::did_you_mean(q.text(key), known, ""));
  };
  std::vector<std::string> monitors, stages;
  for (const Monitor& m : model.monitors) monitors.push_back(m.name);
  for (const coupling::Stage& s : plan.stages) stages.push_back(s.name);
  if (q.texts.count("component") > 0) check("component", "component", components());
  if (q.texts.count("statistic") > 0) check("statistic", "statistic", kStatistics);
  if (q.measure == "monitor" || q.measure == "history_error" || q.measure == "harmonic" || q.measure == "crossing")
    check("of", "monitor", monitors);
  if (q.measure == "crossing") {
    check("behind", "monitor", monitors);
    check("stress", "component", components());
    check("part", "part", kParts);
    if (!(*q.number("impedance") > 0.0))
      throw q.error("impedance", fmt::format("an impedance of {:g} Pa s/m", *q.number("impedance")), "> 0 Pa s/m");
  }
  if (q.measure == "harmonic" && !(*q.number("frequency") > 0.0))
    throw q.error("frequency", fmt::format("a frequency of {:g} Hz", *q.number("frequency")), "> 0 Hz");
  if (q.measure == "drift_in_stage") check("of", "stage", stages);
  if (q.measure == "stepping_time" && !q.text("of").empty()) check("of", "kind of steps", {kImplicit});
  if (q.measure == "history_error" && q.text("file").empty() == q.text("against").empty())
    throw q.error("file", "a history is compared with a file or with a variant", "file or against, one of the two");
}

}  // namespace scree::app
