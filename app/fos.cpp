// `scree fos`: the factor of safety of a case, by reduction of strength.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "app/commands.h"
#include "app/fos/fos_report.h"
#include "app/output.h"
#include "app/session.h"
#include "app/signals.h"
#include "app/sweep/emit.h"
#include "io/case/case_error.h"
#include "io/checkpoint/checkpoints.h"
#include "io/results/atomic_file.h"
#include "io/results/regular_file.h"
#include "io/results/sha256.h"

namespace scree::app {
namespace {

namespace fs = std::filesystem;

constexpr std::ptrdiff_t kAfterRest = 3;              // stages that [reduction] puts after those to rest
constexpr double kLeastHold = 0.5, kMostHold = 60.0;  // of the dynamic stage, unless it is set [s]

/// What is wrong with the options as a whole; empty: nothing.
std::string usage_error(const FosCommand& c) {
  if (!(c.least < 1.0) || !(c.most > 1.0)) return "--least is below 1, and --most above";
  return {};
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + io::in_quotes(name, 200);
  return "[" + out + "]";
}

/// The options of the command as --set of its runs.
std::vector<std::string> overrides(const FosCommand& c, const std::string& strength) {
  std::vector<std::string> set = c.set;
  set.push_back(fmt::format("reduction.strength=\"{}\"", strength));
  if (!c.joints.empty()) set.push_back("reduction.joints=" + quoted_list(c.joints));
  if (!c.method.empty()) set.push_back(fmt::format("reduction.method={}", io::in_quotes(c.method)));
  if (!c.integrator.empty()) set.push_back(fmt::format("reduction.integrator=\"{}\"", c.integrator));
  if (c.k_h != 0.0) set.push_back(fmt::format("reduction.k_h={:.9g}", c.k_h));
  if (c.limit) set.push_back(fmt::format("reduction.limit={:.9g}", *c.limit));
  return set;
}

/// A search with its case, read with the options of the runs.
struct Question {
  FosRecord record;
  FosTitle title;
  Vec2 gravity{0.0, -9.81};
  bool implicit_rest = false;  // of the stages to rest
  bool explicit_runs = false;  // runs at a factor are explicit, too, if these are, unless another integrator is set
  bool weakens = false;        // some law that is divided loses strength by failure or slip
};

bool weakens(const JointLaw& law) {
  return law.residual_friction || law.residual_cohesion < law.cohesion || law.friction_law != nullptr;
}

Question question(const FosCommand& c, const std::string& strength) {
  const auto read = [&](std::vector<std::string> set) {
    set.emplace_back("reduction.factor=1.1");
    return io::read_case(c.case_file, set, method_names(), complain_line);
  };
  std::vector<std::string> set = overrides(c, strength);
  const io::Case first = read(set);
  Question q;
  q.title.limit = first.plan.stages.back().end.displacement;
  q.gravity = first.model.gravity;
  const double g = q.gravity.norm() > 0.0 ? q.gravity.norm() : 9.81;
  q.title.hold = c.time.value_or(
      std::clamp(1.5 * std::sqrt(2.0 * q.title.limit / (0.1 * c.tolerance * g)), kLeastHold, kMostHold));
  set.push_back(fmt::format("reduction.hold={:.6g}", q.title.hold));
  const io::Case read_case = read(set);
  const coupling::Stage& last = read_case.plan.stages.back();
  q.record.case_file = fs::absolute(c.case_file).lexically_normal().string();
  q.record.case_sha256 = io::sha256(read_case.text);
  for (const fs::path& file : read_case.files) q.record.files[file.string()] = digest_of_file(file);
  q.record.set = set;
  for (const std::string& library : c.load) q.record.load.push_back(fs::absolute(library).lexically_normal().string());
  q.record.what = c.back == "phi" ? "friction" : c.back == "c" ? "cohesion" : "all";
  q.record.tolerance = c.tolerance;
  q.record.least = c.least;
  q.record.most = c.most;
  q.title.title = read_case.model.title;
  q.title.case_file = c.case_file.string();
  q.title.strength = strength;
  q.title.what = q.record.what;
  q.title.method = last.method;
  q.title.integrator = coupling::name(last.integrator);
  q.title.tolerance = c.tolerance;
  q.title.least = c.least;
  q.title.most = c.most;
  q.title.k_h = c.k_h;
  for (const JointId j : last.strength.joints) q.title.laws.push_back(read_case.model.joints[j.index()]);
  q.implicit_rest = (read_case.plan.stages.end() - kAfterRest - 1)->integrator == coupling::Integrator::implicit;
  q.explicit_runs = c.integrator.empty();
  q.weakens = std::any_of(q.title.laws.begin(), q.title.laws.end(), weakens);
  return q;
}

/// Carries out one search and writes its result; the title names the integrator that was used.
FosAnswer answer(Question& q, const fs::path& path, const FosCommand& c, Signals& signals) {
  const FosFolder folder = FosFolder::open(path, q.record);
  const io::FolderLock lock(path);
  FosSettings settings;
  settings.threads = c.threads;
  settings.jobs = c.jobs > 0 ? c.jobs : static_cast<std::size_t>(std::max(1, omp_get_num_procs() / c.threads));
  settings.stop = [&signals] { return signals.stop_requested(); };
  if (!c.quiet && c.json != "-") settings.note = [](const std::string& line) { say("  {}\n", line); };
  FosAnswer a = search_factor(folder, q.record, q.title.limit, q.gravity, q.implicit_rest, settings);
  if (a.explicit_rest && q.explicit_runs) q.title.integrator = "explicit";
  if (a.status == FosAnswer::Status::interrupted) return a;
  io::write_atomically(folder.file("fos.csv"), fos_csv(a));
  io::write_atomically(folder.file("result.json"), fos_json(q.title, a));
  draw_fos(folder, q.title, a);
  return a;
}

}  // namespace

int fos(const FosCommand& c) {
  take_signals_of_runs();
  if (const std::string wrong = usage_error(c); !wrong.empty()) {
    complain("error: {}\n", wrong);
    return kUsage;
  }
  fs::path path =
      fs::absolute(c.out.empty() ? fs::path("runs") / (case_name(c.case_file) + "-fos") : c.out).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  const bool both = c.strength.empty();
  Question main = question(c, both ? "peak" : c.strength);
  Signals signals(!c.quiet && c.json != "-");
  const auto interrupted = [&] {
    complain("interrupted; the same command continues the search:\n  {}\n", shell_words(c.words));
    return kInterrupted;
  };
  const FosAnswer first = answer(main, path, c, signals);
  if (first.status == FosAnswer::Status::interrupted) return interrupted();
  const std::string json = fos_json(main.title, first);
  say("{}", c.json == "-" ? json : fos_text(main.title, first));
  if (!c.json.empty() && c.json != "-") io::write_atomically(c.json, json);
  double cpu = first.cpu;
  if (both && c.json != "-") {
    Question other = question(c, "as-is");
    if (other.weakens) {
      const FosAnswer second = answer(other, path / "as-is", c, signals);
      if (second.status == FosAnswer::Status::interrupted) return interrupted();
      say("{}", fos_text(other.title, second));
      cpu += second.cpu;
    } else {
      say("as-is strength: the same result, since no joint law that is reduced loses strength\n");
    }
  }
  if (!c.quiet && c.json != "-")
    say("runs, pictures and result.json in {}; {:.4g} s of processor time\n", path.string(), cpu);
  return first.status == FosAnswer::Status::undecided ? kNotConverged : kDone;
}

}  // namespace scree::app
