// Explicit steps of two sizes: the map of a step on two oscillators and its stability, momentum, energy, order.
#include "coupling/integrate/subcycled.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/Core>
#include <array>
#include <cstdio>

#include "coupling/bodies/partition.h"
#include "coupling/integrate/step_bound.h"
#include "coupling/transfer/transfer.h"
#include "model/dense_algebra.h"
#include "tests/support/schemes.h"
#include "tests/third_method/rigid_pool.h"

namespace scree::test::subcycled_test {
namespace {

using namespace scree::coupling;

/// Rigid blocks whose internal force pulls them back to their places in the model, along x: -young x.
class SprungPool final : public RigidPool {
 public:
  [[nodiscard]] std::string_view method() const override { return "sprung"; }
  void add(const Model& model, const BodyRecord& record) override {
    RigidPool::add(model, record);
    springs_.push_back(
        {model.material_of(record.block).young, moments(record.shape.origin).centroid.x(), record.shape.mass});
  }
  double internal_force(std::span<const double> q, std::span<double> f) const override {
    double energy = 0.0;
    for (std::size_t b = 0; b < springs_.size(); ++b) {
      const double x = q[6 * b] - springs_[b].at;
      f[6 * b] -= springs_[b].k * x;
      energy += 0.5 * springs_[b].k * x * x;
    }
    return energy;
  }
  [[nodiscard]] double frequency_bound(int body) const override {
    const Spring& s = springs_[static_cast<std::size_t>(body)];
    return s.k / s.mass;
  }

 private:
  struct Spring {
    double k, at, mass;
  };
  std::vector<Spring> springs_;
};

const Methods& sprung() {
  static const Methods kSprung{{"sprung", [] { return std::make_unique<SprungPool>(); }}};
  return kSprung;
}

/// Mass of the slow block (the fast one has mass 1), stiffnesses of both springs to the ground and of the one between.
struct Springs {
  double k_fast, mass, k_slow, k;
  [[nodiscard]] double fastest() const { return std::sqrt(k_fast + k * (1.0 + 1.0 / mass)); }
};

/// A step of m substeps, written independently of the code. Unknowns: x, v of the fast block, then of the slow one, and
/// the relative velocity of the previous half step, which damps a contact with the fraction xi of critical damping.
using Map = Eigen::Matrix<double, 5, 5>;
Map map_of(const Springs& s, double h, int m, double xi = 0.0) {
  const double c = 2.0 * xi * std::sqrt(s.k / (1.0 + 1.0 / s.mass));
  Map a;
  for (Eigen::Index column = 0; column < 5; ++column) {
    Eigen::Matrix<double, 5, 1> y = Eigen::Matrix<double, 5, 1>::Unit(column);
    const auto kick = [&](bool end) {
      const double f = s.k * (y[2] - y[0]) + c * y[4];
      y[1] += 0.5 * h * (f - s.k_fast * y[0]);
      y[3] += 0.5 * h * (-f - (end ? m * s.k_slow * y[2] : 0.0)) / s.mass;
    };
    for (int j = 0; j < m; ++j) {
      kick(j == 0);
      y[0] += h * y[1];
      y[2] += h * y[3];
      y[4] = y[3] - y[1];
      kick(j == m - 1);
    }
    a.col(column) = y;
  }
  return a;
}

double radius(const Map& a) { return eigenvalues(a).cwiseAbs().maxCoeff(); }

/// The pair as bonded blocks without damping.
Scene pair(const Springs& s, double dt, int substeps, double duration) {
  Scene scene(s.k_fast, 0.2, 1.0);
  scene.model.gravity = Vec2(0.0, 0.0);
  JointLaw& law = scene.model.joints[0];
  law.normal_stiffness = s.k;
  law.tensile_strength = std::numeric_limits<double>::infinity();
  law.damping = 0.0;
  const BlockId fast = scene.add("fast", rectangle(-1.0, 0.0, 0.0, 1.0));
  scene.add("slow", rectangle(0.0, 0.0, 1.0, 1.0));
  scene.model.materials.push_back({"other", s.mass, s.k_slow, 0.2});
  scene.model.blocks[1].material = MaterialId{1};
  Stage& stage = scene.stage("sprung", Integrator::partitioned, duration, dt);
  stage.control.max_displacement = 1.0;
  stage.force_dt = true;
  stage.partition.explicit_blocks = {fast};
  stage.partition.slow_explicit = true;
  stage.partition.substeps = substeps;
  return scene;
}

TEST(Subcycled, step_is_the_map_of_kicks_and_drifts) {
  double worst = 0.0;
  for (const Springs& s : {Springs{1.0, 10.0, 3.0, 100.0}, Springs{100.0, 0.1, 0.2, 5.0}})
    for (const int m : {1, 2, 7}) {
      const double h = 0.5 * 2.0 / s.fastest();
      Scene scene = pair(s, seconds(m * ticks(h)), m, seconds(20 * m * ticks(h)));
      const double v0 = 1e-3;
      scene.model.initial_velocities.push_back({BlockId{0}, Vec2(v0, 0.0), 0.0});
      scene.plan.detection = 2.0;
      Driver run(scene.model, scene.plan, sprung());
      ASSERT_EQ(run.run().status, RunEnd::Status::done);
      Eigen::Matrix<double, 5, 1> y = v0 * Eigen::Matrix<double, 5, 1>::Unit(1);
      const Map a = map_of(s, seconds(ticks(h)), m);
      for (int i = 0; i < 20; ++i) y = a * y;
      const BodyTotals fast = totals_of(run, BlockId{0}), slow = totals_of(run, BlockId{1});
      const double scale = v0 / s.fastest();
      worst = std::max({worst, std::abs(fast.centre.x() + 0.5 - y[0]) / scale,
                        std::abs(slow.centre.x() - 0.5 - y[2]) / scale, std::abs(fast.momentum.x() - y[1]) / v0,
                        std::abs(slow.momentum.x() / s.mass - y[3]) / v0});
      EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
    }
  std::printf("largest difference %.1e\n", worst);
  EXPECT_LT(worst, 1e-9);  // 140 substeps, round-off of the contact geometry of 1e-16 m over 1e-4 m
}

/// Number of unstable sets among the prototype's 640, and the largest growth per step.
struct Count {
  int unstable = 0, sets = 0;
  double largest = 0.0;
};
Count count(double step_and_frequency, double fraction, int m, double xi = 0.0) {
  Count out;
  for (const double k_fast : {0.0, 1.0, 100.0, 1e3})
    for (const double mass : {0.1, 1.0, 10.0, 100.0})
      for (int i = 0; i < 40; ++i) {
        Springs s{k_fast, mass, 0.0, std::pow(10.0, -1.0 + 5.0 * i / 39.0)};
        const double h = fraction * 2.0 / s.fastest();
        s.k_slow = std::pow(step_and_frequency / (m * h), 2) * mass;
        const double r = radius(map_of(s, h, m, xi));
        ++out.sets;
        out.unstable += r > 1.0 + 1e-5 ? 1 : 0;
        out.largest = std::max(out.largest, r);
      }
  return out;
}

TEST(Subcycled, resonances_are_few_and_weak_up_to_half_and_strong_above) {
  for (const double hw : {0.1, 0.25, 0.5, 1.0, 1.9}) {
    std::printf("H w %.2f:", hw);
    Count all;
    for (const int m : {1, 2, 3, 5, 10, 20, 50}) {
      const Count c = count(hw, 0.9, m);
      std::printf("  m %d: %d, %.3f", m, c.unstable, c.largest);
      all.unstable += c.unstable;
      all.sets += c.sets;
      all.largest = std::max(all.largest, c.largest);
      if (m == 1 && hw <= 0.5) {
        EXPECT_EQ(c.unstable, 0);
      }
    }
    std::printf("  of %d each\n", all.sets / 7);
    if (hw <= 0.5) {
      EXPECT_LT(all.unstable, 0.01 * all.sets);  // sets with a half-period of the contact that fits H very closely
      EXPECT_LT(all.largest, 1.05);
    }
    if (hw == 1.9) {
      EXPECT_GT(all.unstable, 0.2 * all.sets);
    }
  }
}

TEST(Subcycled, damped_contacts_have_broader_resonances) {
  for (const double xi : {0.02, 0.2, 0.5}) {
    Count all;
    for (const int m : {1, 2, 3, 5, 10, 20, 50}) {
      const double shrink = std::sqrt(1.0 + xi * xi) - xi;  // reduction of the step by the damping ([Qu2013] 5.3.2)
      const Count c = count(0.5, 0.8 * shrink, m, xi);
      all.unstable += c.unstable;
      all.sets += c.sets;
      all.largest = std::max(all.largest, c.largest);
      if (m == 1) {
        EXPECT_EQ(c.unstable, 0);
      }
    }
    std::printf("H w 0.50, contacts damped by %.2f: %d of %d, %.4f\n", xi, all.unstable, all.sets, all.largest);
    EXPECT_LT(all.largest, 1.05);
  }
}

struct EveryWarning final : Sink {
  std::vector<std::string> told;
  void event(const Event& e) override {
    if (e.kind == EventKind::warning) told.push_back(e.text);
  }
};

TEST(Subcycled, resonance_is_told_once) {
  // Among steps with H w = 1/2: the one with the largest growth, as half a period of the contact nearly fits H.
  Springs s{};
  double h = 0.0, growth = 0.0;
  for (int i = 0; i <= 400; ++i) {
    Springs other{20.0, 2.0, 0.0, 50.0};
    const double at = (0.3 + 0.0015 * i) * 2.0 / other.fastest();
    other.k_slow = other.mass * std::pow(0.5 / (3.0 * at), 2);
    const double r = radius(map_of(other, at, 3));
    if (r <= growth) continue;
    growth = r;
    h = at;
    s = other;
  }
  ASSERT_GT(growth, 1.005);
  Scene scene = pair(s, seconds(3 * ticks(h)), 3, seconds(3 * 300 * ticks(h)));
  scene.plan.detection = 2.0;
  scene.plan.max_gain = 0.0;  // the limit of energy gain would end the run
  scene.model.initial_velocities.push_back({BlockId{0}, Vec2(1e-6, 0.0), 0.0});
  Driver run(scene.model, scene.plan, sprung());
  EveryWarning warnings;
  run.add_sink(warnings);
  EXPECT_EQ(run.run().status, RunEnd::Status::done);
  int made = 0;
  for (const std::string& text : warnings.told) made += text.find("have created") != std::string::npos ? 1 : 0;
  EXPECT_EQ(made, 1);
  std::printf("growth %.4f a step; %s\n", growth, warnings.told.empty() ? "" : warnings.told.back().c_str());
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

/// Two blocks that collide and separate again, the left one small and fast.
Scene flying(const char* fast_method, const char* slow_method, double dt, double duration, int m) {
  Scene scene(1e9, 0.2, 2600.0, 20.0);
  scene.model.gravity = Vec2(0.0, 0.0);
  scene.model.joints[0].normal_stiffness = 2e13;
  scene.model.joints[0].damping = 0.2;
  const BlockId left = scene.add("left", rectangle(0.5, 0.4, 1.0, 0.9)),
                right = scene.add("right", rectangle(1.001, 0.0, 3.001, 2.0));
  scene.model.initial_velocities.push_back({left, Vec2(1.0, 0.0), 0.0});
  scene.model.initial_velocities.push_back({right, Vec2(-1.0, 0.2), 0.3});
  Stage& stage = scene.stage(slow_method, Integrator::partitioned, duration, dt, 0.8);
  stage.rules.push_back({{left}, fast_method, 0.25, false});
  stage.partition.explicit_blocks = {left};
  stage.partition.slow_explicit = true;
  stage.partition.substeps = m;
  return scene;
}

TEST(Subcycled, impact_keeps_momentum_and_closes_the_ledger) {
  for (const auto& [fast, slow] : {std::pair("nmm", "nmm"), std::pair("dda", "nmm"), std::pair("nmm", "dda")}) {
    const Scene scene = flying(fast, slow, 6e-5, 0.05, 0);
    Driver run(scene.model, scene.plan, methods());
    const RunEnd end = run.run();
    ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
    const BodyTotals a = totals_of(run, BlockId{0}), b = totals_of(run, BlockId{1});
    const Vec2 begin(a.mass - b.mass, 0.2 * b.mass);
    EXPECT_LT((a.momentum + b.momentum - begin).norm(), 1e-12 * begin.norm());
    EXPECT_LT(a.momentum.x(), 0.0) << "they have not hit each other";
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
    // The same scene with steps of one size, at the same fraction of the same bound.
    Scene one = scene;
    one.plan.stages[0].integrator = Integrator::explicit_;
    one.plan.stages[0].dt.reset();
    Driver plain(one.model, one.plan, methods());
    ASSERT_EQ(plain.run().status, RunEnd::Status::done);
    EXPECT_LT(run.stats().element_steps, (slow == std::string("nmm") ? 0.7 : 1.0) * plain.stats().element_steps);
    // The impact is short against the waves, which H resolves by a dozen steps.
    EXPECT_LT((totals_of(plain, BlockId{0}).momentum - a.momentum).norm(), 0.05 * a.momentum.norm());
    std::printf("%s %s: steps %ld of %ld closure %.1e momentum %.1e element steps %.2f of those of one size\n", fast,
                slow, static_cast<long>(run.stats().steps), static_cast<long>(plain.stats().steps),
                run.state().ledger.relative_closure(), (a.momentum + b.momentum - begin).norm() / begin.norm(),
                run.stats().element_steps / plain.stats().element_steps);
  }
}

TEST(Subcycled, one_substep_is_the_plain_explicit_stage) {
  Scene scene = flying("nmm", "nmm", 2e-6, 2e-3, 1);
  scene.plan.stages[0].damping = 20.0;
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  scene.plan.stages[0].integrator = Integrator::explicit_;
  Driver plain(scene.model, scene.plan, methods());
  ASSERT_EQ(plain.run().status, RunEnd::Status::done);
  double largest = 0.0;
  for (std::size_t b = 0; b < 2; ++b) {
    const Body &x = run.setup().bodies()[b], &y = plain.setup().bodies()[b];
    ASSERT_EQ(x.nodes, y.nodes);
    for (std::size_t k = 0; k < 2 * static_cast<std::size_t>(x.nodes); ++k) {
      const auto i = 2 * static_cast<std::size_t>(x.first_node) + k, j = 2 * static_cast<std::size_t>(y.first_node) + k;
      largest = std::max(largest, std::abs(run.state().v[i] - plain.state().v[j]));
    }
  }
  std::printf("velocities differ by %.1e m/s\n", largest);
  EXPECT_EQ(largest, 0.0);
}

TEST(Subcycled, order_is_two_in_the_long_step) {
  // Bonded blocks oscillate: the motion is smooth.
  std::array<double, 5> x{};
  const Springs s{30.0, 4.0, 20.0, 60.0};
  for (std::size_t level = 0; level < x.size(); ++level) {
    const double h = 0.004 / static_cast<double>(1 << level);
    Scene scene = pair(s, 4.0 * h, 4, 2.4);
    scene.plan.stages[0].force_dt = false;
    scene.plan.detection = 2.0;
    scene.model.initial_velocities.push_back({BlockId{0}, Vec2(1e-2, 0.0), 0.0});
    Driver run(scene.model, scene.plan, sprung());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    x[level] = totals_of(run, BlockId{1}).centre.x();
  }
  for (std::size_t i = 0; i + 2 < x.size(); ++i) {
    const double order = std::log2(std::abs((x[i] - x[i + 1]) / (x[i + 1] - x[i + 2])));
    std::printf("order %.3f\n", order);
    EXPECT_NEAR(order, 2.0, 0.1);
  }
}

/// A heap that falls on a base, contacts opening and closing at substeps; blocks change sides by their speed.
Scene heap(double duration) {
  Scene scene(1e8, 0.2, 2600.0, 25.0);
  scene.model.joints[0].normal_stiffness = 1e13;
  scene.add("base", rectangle(-3.0, -1.0, 3.0, 0.0), true);
  Stage& stage = scene.stage("nmm", Integrator::partitioned, duration, 6e-5, 0.7);
  stage.partition.slow_explicit = true;
  stage.partition.explicit_area = 0.4;
  stage.partition.speed = {1.5, 1.0};
  const double width[] = {1.6, 0.5, 1.2, 0.6, 1.0};
  double y = 0.0;
  for (int i = 0; i < 5; ++i) {
    const double w = width[i], x = 0.1 * (i % 2);
    const BlockId b = scene.add("b" + std::to_string(i), rectangle(x - 0.5 * w, y, x + 0.5 * w, y + 0.5 * w));
    scene.model.initial_velocities.push_back({b, Vec2(0.3 * (i % 3 - 1), 0.4 * i), 0.2 * (2 - i)});
    y += 0.5 * w;
  }
  stage.rules.push_back({{BlockId{3}}, "dda", 0.0, false});
  return scene;
}

TEST(Subcycled, ledger_closes_over_ten_thousand_steps_of_contacts) {
  Scene scene = heap(0.6);
  scene.plan.audit = true;
  Driver run(scene.model, scene.plan, methods());
  EveryWarning warnings;
  run.add_sink(warnings);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  EXPECT_GE(run.stats().steps, 10000);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
  const Ledger& l = run.state().ledger;
  std::printf(
      "steps %ld element steps %.2f of %.0f each cuts %ld closure %.1e trapezoid %.2e of %.2e J moved, %zu warnings\n",
      static_cast<long>(run.stats().steps), run.stats().element_steps / static_cast<double>(run.stats().steps),
      static_cast<double>(run.stats().elements), static_cast<long>(run.stats().cuts), l.relative_closure(),
      l[coupling::Column::elastic_trapezoid], l.moved(), warnings.told.size());
}

class EveryTenth final : public Keeper {
 public:
  bool due(std::int64_t step) override { return step % 10 == 0; }
  void keep(const Checkpoint& checkpoint) override { kept.push_back(checkpoint); }
  std::vector<Checkpoint> kept;
};

TEST(Subcycled, resumed_runs_and_runs_of_two_threads_end_in_the_same_bits) {
  const Scene scene = heap(0.05);
  const int most = omp_get_max_threads();
  omp_set_num_threads(1);
  EveryTenth keeper;
  Driver run(scene.model, scene.plan, methods());
  run.set_keeper(keeper);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const std::uint64_t hash = state_hash(run.state());
  omp_set_num_threads(2);
  Driver two(scene.model, scene.plan, methods());
  ASSERT_EQ(two.run().status, RunEnd::Status::done);
  EXPECT_EQ(state_hash(two.state()), hash);
  omp_set_num_threads(most);
  int changes = 0;
  for (std::size_t k = 1; k < keeper.kept.size(); ++k)
    changes += keeper.kept[k].state.explicit_side != keeper.kept[k - 1].state.explicit_side ? 1 : 0;
  EXPECT_GE(changes, 1);
  for (std::size_t k = 0; k < keeper.kept.size(); k += 7) {
    Driver rest(scene.model, scene.plan, methods());
    rest.continue_from(keeper.kept[k]);
    ASSERT_EQ(rest.run().status, RunEnd::Status::done);
    EXPECT_EQ(state_hash(rest.state()), hash) << k;
  }
  std::printf("%zu checkpoints, %d changes of sides\n", keeper.kept.size(), changes);
}

TEST(Subcycled, step_above_that_of_slow_forces_is_refused) {
  Scene scene = flying("nmm", "nmm", 1e-2, 0.05, 0);
  const auto told = [&] {
    try {
      Driver run(scene.model, scene.plan, methods());
      (void)run.run();
    } catch (const PlanError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const std::string text = told();
  EXPECT_NE(text.find("block 'right'"), std::string::npos) << text;
  EXPECT_NE(text.find("element"), std::string::npos) << text;
  // With force_dt the step is taken, and one warning states the step and what bounds it.
  scene.plan.stages[0].force_dt = true;
  scene.plan.stages[0].duration = ticks(2e-2);
  struct Warnings final : Sink {
    std::vector<std::string> texts;
    void event(const Event& e) override {
      if (e.kind == EventKind::warning) texts.push_back(e.text);
    }
  } warnings;
  const auto forced = [&] {
    warnings.texts.clear();
    Driver run(scene.model, scene.plan, methods());
    run.add_sink(warnings);
    (void)run.run();
    return std::count_if(warnings.texts.begin(), warnings.texts.end(), [](const std::string& t) {
      return t.find("dt 0.01 s is forced above what slow internal forces allow") != std::string::npos &&
             t.find("block 'right'") != std::string::npos;
    });
  };
  EXPECT_EQ(forced(), 1);
  scene.plan.stages[0].dt = 6e-5;
  scene.plan.stages[0].duration = ticks(6e-4);
  EXPECT_EQ(forced(), 0);
  EXPECT_TRUE(warnings.texts.empty()) << warnings.texts[0];
  scene.plan.stages[0].force_dt = false;
  EXPECT_EQ(told(), "");
  scene.plan.stages[0].local_damping = 0.1;
  EXPECT_NE(told().find("local damping"), std::string::npos);
}

}  // namespace
}  // namespace scree::test::subcycled_test
