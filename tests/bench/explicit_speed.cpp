// Speed of explicit NMM steps: Scree's whole step against a plain loop, interleaved in one run, and against itself on
// two cores. Prints element steps per second, ratios and memory; exit code 1 if a hash differs between thread counts.
//
//   usage: bench_explicit_speed [seconds a size]
#include <fmt/format.h>
#include <omp.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>

#include "nmm/nmm_pool.h"
#include "tests/bench/plain_loop.h"
#include "tests/support/by_hand.h"

namespace scree::bench {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// A number of kB from the system's account of this process [bytes].
double account(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(name + ":")) return 1024.0 * std::atof(line.substr(name.size() + 1).c_str());
  return 0.0;
}

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

/// One square block with all parts of a run: gravity, damping, affine-exact mass, ledger, detection of contacts.
struct Run {
  test::Scene scene{1e9, 0.25, 2000.0};
  std::unique_ptr<test::ByHand> hand;
  std::unique_ptr<coupling::CentralDifference> integrator;
  Tick h = 0;
  std::int64_t elements = 0;
  int threads;
  static constexpr int kOutput = 100;  // steps between two updates of the ledger

  Run(double side, int thread_count) : threads(thread_count) {
    omp_set_num_threads(threads);
    const BlockId id = scene.add("block", test::rectangle(0.0, 0.0, side, side));
    scene.model.gravity = Vec2(0.0, -1e-6);  // so small that the block hardly moves in a million steps
    scene.model.initial_velocities.push_back({id, {0.01, 0.0}, 1e-3});
    coupling::Stage& stage = scene.stage("nmm", coupling::Integrator::explicit_, 1.0, std::nullopt, 1.0);
    hand = std::make_unique<test::ByHand>(scene.model, stage);
    coupling::StepControl control;
    control.max_displacement = 0.1;
    coupling::ExplicitDamping damping;
    damping.mass = 1.0;
    integrator = std::make_unique<coupling::CentralDifference>(*hand->setup, control, 0.1, damping);
    integrator->enter(hand->state);
    h = ticks(0.8 * integrator->stable_step(hand->state, nullptr));
    elements = dynamic_cast<const nmm::NmmPool&>(hand->setup->pool(0)).elements().size();
  }
  /// Seconds that the steps take.
  double steps(int count) {
    omp_set_num_threads(threads);
    const double begin = now();
    for (int i = 0; i < count; ++i) {
      if (integrator->step(hand->state, h).status != coupling::StepReport::Status::ok) std::abort();
      if (hand->state.step % kOutput == 0) integrator->update_ledger(hand->state);
    }
    return now() - begin;
  }
};

bool compare(int n, double side, double seconds_a_size) {
  const double before = account("VmRSS");
  Run one(side, 1);
  one.steps(3);
  const double memory = (account("VmHWM") - before) / static_cast<double>(one.elements);
  Run two(side, 2);
  two.steps(3);
  PlainLoop plain(n);
  const auto rate = [](double elements, int count, double time) { return 1e-6 * elements * count / time; };
  const int burst = std::max(2, static_cast<int>(2e7 / static_cast<double>(one.elements)));
  std::vector<double> plain_rate, one_rate, two_rate, against_plain, speed_up;
  for (const double begin = now(); now() - begin < seconds_a_size || plain_rate.size() < 5;) {
    double start = now();
    for (int i = 0; i < burst; ++i) plain.step(0.1);
    plain_rate.push_back(rate(plain.elements(), burst, now() - start));
    one_rate.push_back(rate(static_cast<double>(one.elements), burst, one.steps(burst)));
    two_rate.push_back(rate(static_cast<double>(two.elements), burst, two.steps(burst)));
    against_plain.push_back(one_rate.back() / plain_rate.back());
    speed_up.push_back(two_rate.back() / one_rate.back());
  }
  const bool same = coupling::state_hash(one.hand->state) == coupling::state_hash(two.hand->state);
  fmt::print("{:>9} {:>10.1f} {:>10.1f} {:>8.2f} {:>10.1f} {:>8.2f} {:>8} {:>10}   ({} rounds, sum {:.6g})\n",
             one.elements, median(plain_rate), median(one_rate), median(against_plain), median(two_rate),
             median(speed_up), same ? "same" : "DIFFER", one.elements > 100000 ? fmt::format("{:.0f}", memory) : "-",
             plain_rate.size(), plain.sum());
  return same;
}

}  // namespace
}  // namespace scree::bench

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 5.0;
  fmt::print(
      "million element steps a second; medians of interleaved rounds, and medians of the ratios within a round\n");
  fmt::print("{:>9} {:>10} {:>10} {:>8} {:>10} {:>8} {:>8} {:>10}\n", "elements", "plain", "Scree 1", "ratio",
             "Scree 2", "speed-up", "hash", "B/element");
  bool same = true;
  // Sides in cover sizes that give about as many elements as the plain mesh; the largest first, for the peak of memory.
  for (const auto& [n, side] : {std::pair{707, 656.8}, {100, 92.1}, {18, 15.8}})
    same = scree::bench::compare(n, side, seconds) && same;
  return same ? 0 : 1;
}
