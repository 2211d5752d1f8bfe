#include "app/fos/fos_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/sweep/csv_text.h"
#include "io/pictures/line_plot.h"
#include "io/pictures/snapshot.h"

namespace scree::app {
namespace {

using Json = nlohmann::ordered_json;
using Status = FosAnswer::Status;

constexpr double kDegree = std::numbers::pi / 180.0;

/// Strengths of a law divided by a factor, such as "phi 31.2 deg, c 12000 Pa".
std::string strengths(const JointLaw& law, const std::string& what, double factor) {
  const double f = what == "cohesion" ? 1.0 : factor, c = what == "friction" ? 1.0 : factor;
  return fmt::format("phi {:.4g} deg, c {:.6g} Pa", std::atan(std::tan(law.friction) / f) / kDegree, law.cohesion / c);
}

/// Mode of failure and number of blocks of each mode: "topples (9 of 16 blocks move; topples: 7, slides: 2)".
std::string told_mode(const TrialResult& run) {
  std::size_t moving = 0;
  std::map<Mode, int> count;
  for (const BlockMotion& m : run.motions)
    if (m.mode != Mode::stands) {
      ++moving;
      ++count[m.mode];
    }
  std::string each;
  for (const auto& [mode, n] : count) each += fmt::format("{0}{2}: {1}", each.empty() ? "" : ", ", n, name(mode));
  return fmt::format("{} ({} of {} blocks move; {})", name(run.mode()), moving, run.motions.size(), each);
}

std::string headline(const FosTitle& t, const FosAnswer& a) {
  switch (a.status) {
    case Status::found:
      return fmt::format("factor of safety {:.4g}: the slope stands at F = {:.6g} and fails at F = {:.6g}\n",
                         a.factor(), a.stands, a.fails);
    case Status::undecided: {
      double needed = 0.0;
      for (const auto& [factor, run] : a.runs)
        if (run.verdict == Verdict::undecided && factor > a.stands && factor < a.fails)
          needed = std::max(needed, run.needed);
      return fmt::format("undecided: the slope stands at F = {:.6g}{}{}\n", a.stands,
                         std::isinf(a.fails)
                             ? "; no run failed, and runs at larger factors have no verdict"
                             : fmt::format(" and fails at F = {:.6g}; runs between these have no verdict", a.fails),
                         needed > 0.0 ? fmt::format("; --time {:.3g} is estimated to suffice", 1.2 * needed) : "");
    }
    case Status::fails_at_least: {
      std::string out = fmt::format(
          "no bracket: the slope fails even at the smallest factor, F = {:g}; strength does not govern\n  {}\n",
          t.least, a.why);
      if (a.k_h)
        out += fmt::format("  load factor on k_h: the slope stands with {:.4g} g along x and fails with {:.4g} g\n",
                           *a.k_h, *a.k_h_fails);
      else
        out += "  the slope also fails with every horizontal acceleration that was tried, up to 1.6 g\n";
      return out;
    }
    case Status::stable_at_most:
      return fmt::format("stable at the largest factor: the factor of safety is above {:g}\n", a.stands);
    case Status::interrupted:
      return "interrupted\n";
  }
  return {};
}

/// Back-analysis: the strengths with which the slope is just stable.
std::string back_analysis(const FosTitle& t, const FosAnswer& a) {
  if (t.what == "all" || a.status != Status::found) return {};
  std::string out = fmt::format("back-analysis: with {} alone changed, the slope is just stable with\n",
                                t.what == "friction" ? "phi" : "c");
  for (const JointLaw& law : t.laws)
    out += fmt::format("  {:<16} {}   (stable with {}; fails with {})\n", law.name, strengths(law, t.what, a.factor()),
                       strengths(law, t.what, a.stands), strengths(law, t.what, a.fails));
  return out;
}

Json json_of(double factor, const TrialResult& r) {
  Json blocks = Json::array();
  for (const BlockMotion& m : r.motions)
    blocks.push_back({{"name", m.name},
                      {"mode", std::string(name(m.mode))},
                      {"displacement_m", {m.displacement.x(), m.displacement.y()}},
                      {"rotation_deg", m.rotation / kDegree},
                      {"slip_m", m.slip},
                      {"gap_m", m.gap},
                      {"speed_m_per_s", m.speed}});
  return {{"factor", factor},
          {"verdict", std::string(name(r.verdict))},
          {"why", r.why},
          {"displacement_m", r.displacement},
          {"acceleration_m_per_s2", r.acceleration},
          {"time_s", r.time},
          {"mode", std::string(name(r.mode()))},
          {"run", trial_name(factor)},
          {"blocks", std::move(blocks)}};
}

Json json_of(const std::vector<io::RockUse>& use) {
  Json out = Json::array();
  for (const io::RockUse& r : use)
    out.push_back({{"block", r.block},
                   {"material", r.material},
                   {"utilisation", r.utilisation},
                   {"at_m", {r.at.x(), r.at.y()}},
                   {"s1_pa", r.s1},
                   {"s3_pa", r.s3},
                   {"area_above_m2", r.area}});
  return out;
}

}  // namespace

std::string fos_text(const FosTitle& t, const FosAnswer& a) {
  std::string out =
      fmt::format("{}: {} strength, {}, {} steps{}\n", t.title.empty() ? t.case_file : t.title, t.strength, t.method,
                  t.integrator, t.k_h != 0.0 ? fmt::format(", k_h = {:g}", t.k_h) : "");
  out += headline(t, a);
  if (const TrialResult* failure = a.failure()) {
    out += "  mode of failure: " + told_mode(*failure) + "\n";
    if (a.status == Status::found && failure->verdict == Verdict::failed && a.fails > 0.0) {
      const double excess = 1.0 - a.stands / a.fails, scale = failure->acceleration / (9.81 * excess);
      out += fmt::format(
          "  at F = {:.6g} the fastest block, '{}', accelerates at {:.3g} m/s2; this is {:.2g} (1 - F_s) g, with F_s "
          "the lower end of the bracket over the upper one\n",
          a.fails, failure->fastest, failure->acceleration, scale);
    }
  }
  if (a.explicit_rest)
    out +=
        "  the run to rest used explicit steps: implicit steps found no balance, although no block moved as far as the "
        "displacement limit\n";
  if (a.inconsistent)
    out += "  warning: a run stood at a larger factor than one that failed; the lowest bracket is reported\n";
  out += back_analysis(t, a);
  if (!a.rock_at_rest.empty()) out += "  at rest, " + io::rock_use_text(a.rock_at_rest) + "\n";
  if (!a.rock_at_limit.empty())
    out += fmt::format("  at F = {:.6g}, {}\n", a.stands, io::rock_use_text(a.rock_at_limit));
  out += fmt::format("  {:>10}  {:<9} {:>12} {:>12} {:>8}  {}\n", "F", "verdict", "displ. [m]", "a [m/s2]", "time [s]",
                     "mode");
  for (const auto& [factor, r] : a.runs)
    out += fmt::format("  {:>10.6g}  {:<9} {:>12.4g} {:>12.4g} {:>8.3g}  {}\n", factor, name(r.verdict), r.displacement,
                       r.acceleration, r.time, r.verdict == Verdict::stable ? "" : name(r.mode()));
  return out;
}

std::string fos_json(const FosTitle& t, const FosAnswer& a) {
  Json out;
  out["format"] = 1;
  out["case"] = t.case_file;
  out["title"] = t.title;
  out["status"] = std::string(name(a.status));
  out["fos"] = a.status == Status::found ? Json(a.factor()) : Json();
  out["stands"] = a.stands > 0.0 ? Json(a.stands) : Json();
  out["fails"] = std::isfinite(a.fails) && a.fails > 0.0 ? Json(a.fails) : Json();
  out["tolerance"] = t.tolerance;
  out["strength"] = t.strength;
  out["what"] = t.what;
  out["method"] = t.method;
  out["integrator"] = t.integrator;
  out["explicit_rest"] = a.explicit_rest;
  out["k_h"] = t.k_h;
  out["limit_m"] = t.limit;
  out["hold_s"] = t.hold;
  out["mode"] = a.failure() != nullptr ? Json(std::string(name(a.failure()->mode()))) : Json();
  out["inconsistent"] = a.inconsistent;
  if (a.status == Status::fails_at_least) {
    out["why"] = a.why;
    out["load_factor_k_h"] = a.k_h ? Json{{"stands", *a.k_h}, {"fails", *a.k_h_fails}} : Json();
  }
  out["joints"] = Json::array();
  for (const JointLaw& law : t.laws) {
    Json& j = out["joints"].emplace_back(
        Json{{"name", law.name}, {"friction_deg", law.friction / kDegree}, {"cohesion_pa", law.cohesion}});
    if (a.status != Status::found) continue;
    const double f = t.what == "cohesion" ? 1.0 : a.factor(), c = t.what == "friction" ? 1.0 : a.factor();
    j["at_limit"] = {{"friction_deg", std::atan(std::tan(law.friction) / f) / kDegree},
                     {"cohesion_pa", law.cohesion / c}};
  }
  if (!a.rock_at_rest.empty()) out["rock_at_rest"] = json_of(a.rock_at_rest);
  if (!a.rock_at_limit.empty()) out["rock_at_limit"] = json_of(a.rock_at_limit);
  out["runs"] = Json::array();
  for (const auto& [factor, r] : a.runs) out["runs"].push_back(json_of(factor, r));
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string fos_csv(const FosAnswer& a) {
  std::string out = "factor,verdict,displacement_m,acceleration_m_per_s2,time_s,mode,run\n";
  for (const auto& [factor, r] : a.runs)
    out += fmt::format("{:.9g},{},{:.9g},{:.9g},{:.9g},{},{}\n", factor, name(r.verdict), r.displacement,
                       r.acceleration, r.time, csv_field(name(r.mode())), trial_name(factor));
  return out;
}

void draw_fos(const FosFolder& folder, const FosTitle& t, const FosAnswer& a) {
  io::LinePlot plot;
  plot.title = t.title.empty() ? "Largest displacement at each factor" : t.title;
  plot.x_label = "F [1]";
  plot.y_label = "displacement [m]";
  plot.log_y = true;
  io::PlotSeries line{"largest displacement", {}, {}, false, true};
  std::map<Verdict, io::PlotSeries> points;
  for (const auto& [factor, r] : a.runs) {
    io::PlotSeries& p = points[r.verdict];
    p.name = name(r.verdict);
    p.points = true;
    for (io::PlotSeries* s : {&line, &p}) {
      s->x.push_back(factor);
      s->y.push_back(r.displacement);
    }
  }
  if (!line.x.empty()) {
    plot.series.push_back(std::move(line));
    for (auto& [verdict, series] : points) plot.series.push_back(std::move(series));
    io::draw_line_plot(plot, folder.file("fos.svg"));
  }
  io::SnapshotOptions how;
  how.arrows = io::Arrows::displacement;
  const auto draw = [&](double factor, const char* file) {
    if (a.runs.contains(factor)) io::snapshot(folder.run(trial_name(factor)), how, folder.file(file));
  };
  draw(a.stands, "stable.png");
  draw(a.fails, "failed.png");
  if (a.rock_at_limit.empty()) return;
  how.arrows = io::Arrows::none;
  how.field = io::Field::utilisation;
  draw(a.stands, "rock-strength.png");
}

}  // namespace scree::app
