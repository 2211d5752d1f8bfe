#include "app/fos/fos_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace scree::app {
namespace {

constexpr int kGuesses = 3;                    // rounds that use an estimate; later ones divide the bracket into thirds
constexpr double kAside = 0.4;                 // distance of the runs on either side of an estimate, over the tolerance
constexpr double kFirst = 1.4, kSecond = 2.2;  // next factors over the largest stable one, while no run has failed
constexpr double kGrid = 1e-6;                 // factors are rounded to this, since folders are named by them

double rounded(double factor) { return std::round(factor / kGrid) * kGrid; }

}  // namespace

std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::stable:
      return "stable";
    case Verdict::failed:
      return "failed";
    case Verdict::undecided:
      return "undecided";
  }
  return "unknown";
}

std::optional<double> zero_of(double factor_1, double acceleration_1, double factor_2, double acceleration_2) {
  // a = alpha - beta/F through both points is zero at F = beta/alpha
  const double x1 = 1.0 / factor_1, x2 = 1.0 / factor_2;
  if (x1 == x2) return std::nullopt;
  const double beta = (acceleration_2 - acceleration_1) / (x1 - x2), alpha = acceleration_1 + beta * x1;
  if (!(beta > 0.0) || !(alpha > 0.0)) return std::nullopt;
  return beta / alpha;
}

FosSearch::FosSearch(const Range& range, double start) : range_(range) { trials_[start] = {Verdict::stable, 0.0}; }

double FosSearch::fails() const {
  for (const auto& [factor, trial] : trials_)
    if (trial.verdict == Verdict::failed) return factor;
  return std::numeric_limits<double>::infinity();
}

double FosSearch::stands() const {
  const double end = fails();
  double best = 0.0;
  for (const auto& [factor, trial] : trials_)
    if (trial.verdict == Verdict::stable && factor < end) best = factor;
  return best;
}

bool FosSearch::inconsistent() const {
  const double end = fails();
  return std::any_of(trials_.begin(), trials_.end(),
                     [end](const auto& t) { return t.second.verdict == Verdict::stable && t.first > end; });
}

std::vector<double> FosSearch::gap() const {
  std::vector<double> out;
  const double low = stands(), high = fails();
  for (const auto& [factor, trial] : trials_)
    if (trial.verdict == Verdict::undecided && factor > low && factor < high) out.push_back(factor);
  return out;
}

FosSearch::State FosSearch::state() const {
  const double low = stands(), high = fails();
  if (high - low <= range_.tolerance * (1.0 + 1e-9)) return State::found;
  if (const std::vector<double> open = gap(); !open.empty()) {
    const double half = 0.5 * range_.tolerance * (1.0 + 1e-9);
    const bool below = open.front() - low <= half, above = std::min(high, range_.most) - open.back() <= half;
    return below && above ? State::undecided : State::searching;
  }
  return std::isinf(high) && low >= range_.most ? State::at_most : State::searching;
}

std::optional<double> FosSearch::guess() const {
  std::vector<std::pair<double, double>> failed;
  for (const auto& [factor, trial] : trials_)
    if (trial.verdict == Verdict::failed && trial.acceleration > 0.0) failed.emplace_back(factor, trial.acceleration);
  if (failed.size() < 2) return std::nullopt;
  return zero_of(failed[0].first, failed[0].second, failed[1].first, failed[1].second);
}

std::vector<double> FosSearch::next() const {
  if (state() != State::searching) return {};
  const double low = stands(), high = fails(), tolerance = range_.tolerance;
  std::vector<double> out;
  const auto add = [&](double factor) {
    factor = rounded(factor);
    if (!trials_.contains(factor) && std::find(out.begin(), out.end(), factor) == out.end()) out.push_back(factor);
  };
  if (const std::vector<double> open = gap(); !open.empty()) {
    const double top = std::min(high, range_.most), half = 0.5 * tolerance * (1.0 + 1e-9);
    if (open.front() - low > half) add(0.5 * (low + open.front()));
    if (top - open.back() > half)
      add(std::isinf(high) && open.back() * 1.2 < top ? open.back() * 1.2 : 0.5 * (open.back() + top));
    return out;
  }
  if (std::isinf(high)) {
    if (low < 1.0 && range_.most >= 1.0 && !trials_.contains(1.0)) {  // the slope did not come to rest at factor 1
      add(std::sqrt(low));
      add(1.0);
      return out;
    }
    for (const double ratio : {kFirst, kSecond}) add(std::min(low * ratio, range_.most));
    return out;
  }
  const double width = high - low;
  if (width <= 2.0 * tolerance) {
    add(0.5 * (low + high));
    return out;
  }
  if (const std::optional<double> zero = guess(); zero && rounds_<kGuesses&& * zero> low && *zero < high) {
    add(std::clamp(*zero - kAside * tolerance, low + 0.4 * tolerance, high - 1.2 * tolerance));
    add(std::clamp(*zero + kAside * tolerance, low + 1.2 * tolerance, high - 0.4 * tolerance));
    return out;
  }
  add(low + width / 3.0);
  add(high - width / 3.0);
  return out;
}

void FosSearch::take(const std::map<double, Trial>& results) {
  const std::vector<double> wanted = next();
  const std::optional<double> zero = guess();
  for (const double factor : wanted) {
    const auto found = results.find(factor);
    if (found == results.end()) throw std::invalid_argument("a requested factor has no result");
    trials_[factor] = found->second;
  }
  if (zero) ++rounds_;
}

}  // namespace scree::app
