#include "app/fos/fos_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/fos/trial_pool.h"
#include "app/sweep/run_results.h"

namespace scree::app {
namespace {

constexpr double kFirstTilt = 0.05, kLastTilt = 1.6, kTiltWidth = 0.01;  // |k_h|: first, largest, width of bracket

class Search {
 public:
  Search(const FosFolder& folder, const FosRecord& record, double limit, const Vec2& gravity, bool implicit_rest,
         const FosSettings& settings)
      : folder_(&folder),
        record_(&record),
        limit_(limit),
        gravity_(gravity),
        implicit_rest_(implicit_rest),
        settings_(&settings) {
    hooks_.stop = settings.stop;
  }

  FosAnswer run() {
    for (const double start : {1.0, record_->least}) {
      std::optional<bool> rests = rest(start);
      if (rests && !*rests && unsettled(start)) {
        note("no block moved as far as the displacement limit: the run to rest is repeated with explicit steps");
        answer_.explicit_rest = true;
        rests = rest(start);
        answer_.explicit_rest = rests.value_or(false);
      }
      if (!rests) return answer_;  // interrupted
      if (*rests) {
        bracket(rest_run(start).name, start);
        return answer_;
      }
    }
    answer_.status = FosAnswer::Status::fails_at_least;
    answer_.at_least = failure_to_rest(folder_->run(rest_run(record_->least).name), limit_, gravity_);
    if (!tilt()) answer_.status = FosAnswer::Status::interrupted;
    return answer_;
  }

 private:
  /// Makes the run to rest with the strengths divided by `start`.
  /// @return true if it came to rest; empty if the search was interrupted
  [[nodiscard]] std::optional<bool> rest(double start) {
    const WantedRun run = rest_run(start);
    if (!make({run})) return std::nullopt;
    const RunOutcome outcome = outcome_of(*folder_, *record_, run);
    answer_.cpu += run_costs(folder_->run(run.name)).cpu_seconds;
    answer_.start = start;
    const bool done = outcome.state == RunOutcome::State::done;
    if (!done) answer_.why = outcome.reason;
    note(fmt::format("{}at rest with the strengths divided by {:g}{}", done ? "" : "not ", start,
                     done ? "" : ": " + outcome.reason));
    return done;
  }
  /// True if implicit steps to rest ended without balance although no block moved as far as the limit. This happens
  /// with joints whose cohesion appears and vanishes with their contacts: static steps find no balance for them.
  [[nodiscard]] bool unsettled(double start) const {
    return implicit_rest_ &&
           failure_to_rest(folder_->run(rest_run(start).name), limit_, gravity_).displacement < limit_;
  }
  void note(const std::string& text) const {
    if (settings_->note) settings_->note(text);
  }
  [[nodiscard]] std::vector<std::string> options(double start) const {
    std::vector<std::string> set = record_->set;
    set.push_back(fmt::format("reduction.start={:.9g}", start));
    set.push_back(fmt::format("reduction.what=\"{}\"", record_->what));
    if (answer_.explicit_rest) set.emplace_back("reduction.rest_integrator=\"explicit\"");
    return set;
  }
  [[nodiscard]] WantedRun rest_run(double start) const {
    const std::string name = start == 1.0 ? "rest" : fmt::format("rest-{:g}", start);
    return {answer_.explicit_rest ? name + "-explicit" : name, options(start), {}};
  }
  [[nodiscard]] WantedRun trial(double factor, const std::string& rest, double start) const {
    WantedRun run{trial_name(factor), options(start), rest};
    run.set.push_back(fmt::format("reduction.factor={:.9g}", factor));
    return run;
  }
  /// Makes the given runs.   @return false if the search was interrupted
  [[nodiscard]] bool make(const std::vector<WantedRun>& runs) const {
    return make_trials(*folder_, *record_, runs, settings_->jobs, settings_->threads, hooks_);
  }

  TrialResult look_at(double factor, const std::string& run) {
    TrialResult r = trial_result(folder_->run(run), {limit_, record_->tolerance, factor, gravity_});
    answer_.cpu += r.cpu;
    note(fmt::format("F = {:<9.6g} {:<9} {}", factor, name(r.verdict), r.why));
    return r;
  }

  void bracket(const std::string& rest, double start) {
    FosSearch search({record_->least, record_->most, record_->tolerance}, start);
    for (;;) {
      const std::vector<double> factors = search.next();
      if (factors.empty()) break;
      std::vector<WantedRun> runs;
      runs.reserve(factors.size());
      for (const double f : factors) runs.push_back(trial(f, rest, start));
      if (!make(runs)) return;  // interrupted
      std::map<double, Trial> results;
      for (std::size_t i = 0; i < factors.size(); ++i) {
        TrialResult r = look_at(factors[i], runs[i].name);
        results[factors[i]] = {r.verdict, r.acceleration};
        answer_.runs[factors[i]] = std::move(r);
      }
      search.take(results);
    }
    answer_.stands = search.stands();
    answer_.fails = search.fails();
    answer_.inconsistent = search.inconsistent();
    answer_.status = search.state() == FosSearch::State::found     ? FosAnswer::Status::found
                     : search.state() == FosSearch::State::at_most ? FosAnswer::Status::stable_at_most
                                                                   : FosAnswer::Status::undecided;
    answer_.rock_at_rest = rock_at_end(rest);
    if (answer_.runs.contains(answer_.stands)) answer_.rock_at_limit = rock_at_end(trial_name(answer_.stands));
  }

  [[nodiscard]] std::vector<io::RockUse> rock_at_end(const std::string& run) const {
    const io::RunReader reader(folder_->run(run));
    return reader.times().empty() ? std::vector<io::RockUse>{} : io::rock_use(reader, reader.times().size() - 1);
  }

  /// Direction along x of the mean displacement of the failing slope, weighted by area: +1 or -1.
  [[nodiscard]] double direction() const {
    double sum = 0.0;
    for (const BlockMotion& m : answer_.at_least->motions) sum += m.area * m.displacement.x();
    return sum < 0.0 ? -1.0 : 1.0;
  }

  /// Finds the horizontal acceleration with which a slope stands that fails at the least factor.
  /// @return false if the search was interrupted
  [[nodiscard]] bool tilt() {
    const double against = -direction();
    double fails = 0.0, stands = std::numeric_limits<double>::infinity();
    const auto try_all = [&](const std::vector<double>& tilts) {
      std::vector<WantedRun> runs;
      for (const double k : tilts) {
        runs.push_back({fmt::format("k-{:.6g}", k), options(1.0), {}});
        runs.back().set.push_back(fmt::format("reduction.k_h={:.9g}", against * k));
      }
      if (!make(runs)) return false;
      for (std::size_t i = 0; i < tilts.size(); ++i) {
        const bool rests = outcome_of(*folder_, *record_, runs[i]).state == RunOutcome::State::done;
        answer_.cpu += run_costs(folder_->run(runs[i].name)).cpu_seconds;
        note(fmt::format("k_h = {:<9.6g} {}", against * tilts[i], rests ? "stands" : "fails"));
        (rests ? stands : fails) = rests ? std::min(stands, tilts[i]) : std::max(fails, tilts[i]);
      }
      return true;
    };
    for (double k = kFirstTilt; std::isinf(stands) && k <= kLastTilt; k *= 4.0)
      if (!try_all({k, 2.0 * k})) return false;
    if (std::isinf(stands)) return true;
    if (fails > stands) fails = 0.0;  // too large an acceleration makes the slope fail in the other direction
    while (stands - fails > kTiltWidth)
      if (const double w = (stands - fails) / 3.0; !try_all({fails + w, stands - w})) return false;
    answer_.k_h = against * stands;
    answer_.k_h_fails = against * fails;
    return true;
  }

  const FosFolder* folder_;
  const FosRecord* record_;
  double limit_;
  Vec2 gravity_;
  bool implicit_rest_;
  const FosSettings* settings_;
  TrialPoolHooks hooks_;
  FosAnswer answer_;
};

}  // namespace

const TrialResult* FosAnswer::failure() const {
  if (at_least) return &*at_least;
  const auto found = runs.find(fails);
  return found == runs.end() ? nullptr : &found->second;
}

std::string_view name(FosAnswer::Status status) {
  switch (status) {
    case FosAnswer::Status::found:
      return "found";
    case FosAnswer::Status::undecided:
      return "undecided";
    case FosAnswer::Status::fails_at_least:
      return "fails at the least factor";
    case FosAnswer::Status::stable_at_most:
      return "stable at the largest factor";
    case FosAnswer::Status::interrupted:
      return "interrupted";
  }
  return "unknown";
}

FosAnswer search_factor(const FosFolder& folder, const FosRecord& record, double limit, const Vec2& gravity,
                        bool implicit_rest, const FosSettings& settings) {
  return Search(folder, record, limit, gravity, implicit_rest, settings).run();
}

}  // namespace scree::app
