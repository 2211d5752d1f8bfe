#include "coupling/bodies/clocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::coupling {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr Tick kLate = std::numeric_limits<Tick>::max();
constexpr double kLongest = 9e6;  // [s]; later times are later than any run

/// Ticks of any time, also one that no run reaches. 0 for those before the start.
Tick bounded_ticks(double time) {
  if (time > kLongest) return kLate;
  return time > 0.0 ? ticks(time) : 0;
}

Tick sum(Tick a, Tick b) { return a > kLate - b ? kLate : a + b; }

Tick origin(StageId stage, std::span<const Tick> stage_begin) {
  if (!stage.valid()) return 0;
  return stage.index() < stage_begin.size() ? stage_begin[stage.index()] : kLate;
}

/// True at an end or after it; decimal sums may be a tick off.
bool reaches(Tick time, Tick end) { return time >= end - 1; }

/// True for a function that is zero again after its end.
bool fades(const TimeFunction& f) {
  using Shape = TimeFunction::Shape;
  return f.shape == Shape::half_sine || f.shape == Shape::sine_squared || f.shape == Shape::sine;
}

/// A motion or a function: when it acts, on its clock.
struct Timed {
  bool motion = false;
  std::size_t index = 0;
  StageId stage;
  double begin = 0.0, end = 0.0;  // [s]
  bool fades = false;
};

template <class See>
void for_all(const Model& model, See&& see) {
  for (std::size_t i = 0; i < model.motions.size(); ++i) {
    const GroundMotion& m = model.motions[i];
    const double start = m.setting().start;
    see(Timed{true, i, m.setting().stage, start, start + (m.times().back() - m.times().front()), false});
  }
  for (std::size_t i = 0; i < model.functions.size(); ++i) {
    const TimeFunction& f = model.functions[i];
    see(Timed{false, i, f.stage, f.begin(), f.end(), fades(f)});
  }
}

/// When stages begin: those that have not begun follow one another as planned.
struct Course {
  Course(const Plan& plan, std::span<const Tick> stage_begin, Tick stage_end)
      : begin(stage_begin.begin(), stage_begin.end()), end(begin.empty() ? 0 : stage_end) {
    for (std::size_t i = begin.size(); i < plan.stages.size(); ++i) {
      begin.push_back(end);
      end += plan.stages[i].duration;
    }
  }
  std::vector<Tick> begin;
  Tick end;
};

}  // namespace

Clocks clocks_of(const Model& model, std::span<const Tick> stage_begin, Tick stage_end) {
  Clocks out;
  out.stage = std::max(0, static_cast<std::int32_t>(stage_begin.size()) - 1);
  for (const GroundMotion& m : model.motions) {
    const Tick from = origin(m.setting().stage, stage_begin);
    out.motion.push_back(from == kLate ? kNever : seconds(from));
  }
  for (const TimeFunction& f : model.functions) {
    const Tick from = origin(f.stage, stage_begin);
    out.function.push_back(reaches(sum(from, bounded_ticks(f.begin())), stage_end) ? kNever : seconds(from));
  }
  return out;
}

std::vector<TimeFault> time_faults(const Model& model, const Plan& plan, std::span<const Tick> stage_begin,
                                   Tick stage_end) {
  const Course course(plan, stage_begin, stage_end);
  std::vector<TimeFault> out;
  for_all(model, [&](const Timed& t) {
    const Tick from = origin(t.stage, course.begin);
    TimeFault fault{TimeFault::Kind::missed, t.motion,           t.index, seconds(from) + t.begin,
                    seconds(from) + t.end,   seconds(course.end)};
    const bool missed = reaches(sum(from, bounded_ticks(t.begin)), course.end) || (t.fades && fault.end <= 0.0);
    if (!missed && (!std::isfinite(t.end) || sum(from, bounded_ticks(t.end)) <= course.end + 1)) return;
    if (!missed) fault.kind = TimeFault::Kind::outlasts;
    out.push_back(fault);
  });
  return out;
}

std::vector<StageId> stages_met(const Model& model, const Plan& plan, std::span<const Tick> stage_begin,
                                Tick stage_end) {
  const Course course(plan, stage_begin, stage_end);
  std::vector<StageId> out;
  for_all(model, [&](const Timed& t) {
    const Tick at = sum(origin(t.stage, course.begin), bounded_ticks(t.begin));
    StageId met;
    if (!reaches(at, course.end))
      for (std::size_t i = 0; i < course.begin.size(); ++i)
        if (reaches(at, course.begin[i])) met = StageId{static_cast<std::int32_t>(i)};
    out.push_back(met);
  });
  return out;
}

std::vector<char> acts_in(const Model& model, const Plan& plan, std::size_t stage, std::span<const Tick> stage_begin,
                          Tick stage_end) {
  const Course course(plan, stage_begin, stage_end);
  const Tick begin = course.begin[stage], end = stage + 1 < course.begin.size() ? course.begin[stage + 1] : course.end;
  std::vector<char> out;
  for_all(model, [&](const Timed& t) {
    const Tick from = origin(t.stage, course.begin);
    const bool to_come = reaches(sum(from, bounded_ticks(t.begin)), end),
               over = std::isfinite(t.end) && reaches(begin, sum(from, bounded_ticks(t.end)));
    out.push_back(to_come || over ? 0 : 1);
  });
  return out;
}

std::string text(const TimeFault& fault, const Model& model) {
  const std::string& name =
      fault.motion ? model.motions[fault.index].setting().name : model.functions[fault.index].name;
  const bool of_load = !fault.motion && model.functions[fault.index].of_load;
  const std::string what = fmt::format("the {} '{}'", fault.motion ? "motion" : of_load ? "load" : "function", name);
  if (fault.kind == TimeFault::Kind::outlasts)
    return fmt::format("{} goes on until {:.6g} s, but the run is over at {:.6g} s", what, fault.end, fault.run_end);
  if (fault.end <= 0.0) return fmt::format("{} is over at {:.6g} s, before the run begins", what, fault.end);
  return fmt::format("{} begins at {:.6g} s, but the run is over at {:.6g} s", what, fault.begin, fault.run_end);
}

}  // namespace scree::coupling
