#include "app/verify/run_record.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace scree::app {
namespace {

class Recorder final : public coupling::Sink {
 public:
  Recorder(const Model& model, RunRecord& record) : record_(&record), origin_(model.origin) {
    for (const Monitor& m : model.monitors) record.monitors.push_back({m.name, {}, {}, {}, {}});
  }
  void history(const coupling::HistoryView& view) override {
    // The end of a stage and the start of the next are one instant: the later sample counts.
    const bool again = !record_->time.empty() && record_->time.back() == view.time;
    if (!again) record_->time.push_back(view.time);
    for (std::size_t i = 0; i < record_->monitors.size(); ++i) {
      MonitorHistory& m = record_->monitors[i];
      const auto pair = [i](std::span<const double> all) { return Vec2(all[2 * i], all[2 * i + 1]); };
      put(m.position, Vec2(origin_ + pair(view.position)), again);
      put(m.displacement, pair(view.displacement), again);
      put(m.velocity, pair(view.velocity), again);
      Eigen::Vector3d stress = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
      if (view.stress.size() >= 3 * i + 3) stress << view.stress[3 * i], view.stress[3 * i + 1], view.stress[3 * i + 2];
      put(m.stress, stress, again);
    }
  }

 private:
  template <class T>
  static void put(std::vector<T>& values, const T& value, bool again) {
    if (again)
      values.back() = value;
    else
      values.push_back(value);
  }
  RunRecord* record_;
  Vec2 origin_;  // expectations are written in the coordinates of the case
};

std::vector<Vec2> displacements(const Model& model, const coupling::Driver& run) {
  std::vector<Vec2> moved;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const coupling::Body& b = run.setup().bodies()[i];
    if (b.driven) continue;
    const auto p = static_cast<std::size_t>(b.pool);
    const Vec2 now = run.setup()
                         .pool_of(b)
                         .totals(b.index, run.setup().part(std::span<const double>(run.state().q), p),
                                 run.setup().part(std::span<const double>(run.state().v), p))
                         .centre;
    moved.emplace_back(now - b.centre);
  }
  return moved;
}

template <class T, class Take>
std::vector<double> each(const std::vector<T>& values, Take&& take) {
  std::vector<double> out;
  out.reserve(values.size());
  for (const T& v : values) out.push_back(take(v));
  return out;
}

}  // namespace

const std::vector<std::string>& components() {
  static const std::vector<std::string> kAll{"x", "y", "ux", "uy", "u", "vx", "vy", "v", "sxx", "syy", "sxy"};
  return kAll;
}

std::vector<double> MonitorHistory::component(std::string_view wanted) const {
  const auto& all = wanted.starts_with('u') ? displacement : wanted.starts_with('v') ? velocity : position;
  if (wanted.starts_with('s')) {
    const Eigen::Index i = wanted == "sxx" ? 0 : wanted == "syy" ? 1 : 2;
    return each(stress, [i](const Eigen::Vector3d& s) { return s[i]; });
  }
  if (wanted == "u" || wanted == "v") return each(all, [](const Vec2& u) { return u.norm(); });
  const Eigen::Index i = wanted.back() == 'x' ? 0 : 1;
  return each(all, [i](const Vec2& u) { return u[i]; });
}

const MonitorHistory* RunRecord::monitor(std::string_view name) const {
  const auto at = std::find_if(monitors.begin(), monitors.end(), [&](const auto& m) { return m.name == name; });
  return at == monitors.end() ? nullptr : &*at;
}

RunRecord record_run(const Model& model, const coupling::Plan& plan) {
  RunRecord record;
  Recorder recorder(model, record);
  const coupling::Methods methods = coupling::methods_with(plan.constants);
  coupling::Driver run(model, plan, methods);
  run.add_sink(recorder);
  const int threads = omp_get_max_threads();
  if (plan.threads > 0) omp_set_num_threads(plan.threads);
  const auto start = std::chrono::steady_clock::now();
  try {
    record.end = run.run();
  } catch (const coupling::PlanError& e) {
    record.refused = e.what();
  }
  omp_set_num_threads(threads);
  if (!record.refused.empty()) return record;
  record.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.least_wall = record.wall;
  record.hash = coupling::state_hash(run.state());
  record.moved = displacements(model, run);
  record.travels = run.travels();
  record.transfers = run.transfers();
  record.ledger = run.state().ledger;
  record.stats = run.stats();
  record.stepping = record.stats.cpu_explicit + record.stats.cpu_implicit;
  record.stepping_implicit = record.stats.cpu_implicit;
  return record;
}

}  // namespace scree::app
