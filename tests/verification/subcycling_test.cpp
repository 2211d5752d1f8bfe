// Two rigid blocks on springs, one explicit in m substeps, one implicit, bonded to each other: amplification of a step
// of the real integrator, for 132 sets of parameters and m up to 50, against two naive schemes.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cstdio>

#include "coupling/integrate/partitioned.h"
#include "coupling/transfer/transfer.h"
#include "model/dense_algebra.h"
#include "tests/support/schemes.h"
#include "tests/third_method/rigid_pool.h"

namespace scree::test::subcycling_test {
namespace {

using namespace scree::coupling;

/// Masses and springs to the ground of both blocks, spring between them; the explicit block has mass 1.
struct Springs {
  double k_e, m_i, k_i, k;
  [[nodiscard]] double bound() const { return 2.0 / std::sqrt(k_e + k); }  // with the implicit block held
};
constexpr std::array kSubsteps{1, 2, 5, 10, 20, 50};

std::vector<Springs> grid() {
  std::vector<Springs> out;
  for (const double k_e : {0.0, 1.0, 100.0})
    for (const double m_i : {0.1, 1.0, 10.0, 100.0})
      for (const double k_i : {0.0, 1.0, 100.0, 1e4})
        for (const double k : {1.0, 100.0, 1e4})
          if (k_e > 0.0 || k_i > 0.0) out.push_back({k_e, m_i, k_i, k});
  return out;
}

const Methods& rigid() {
  static const Methods kRigid{{"rigid", [] { return std::make_unique<RigidPool>(); }}};
  return kRigid;
}

constexpr double kUnit = 0.01;  // displacements [m] and velocities [m/s]; rigid blocks make the problem linear

/// The pair, ready to be stepped from any displacements and velocities.
class Pair {
 public:
  explicit Pair(const Springs& springs, double together = 1e-13)
      : scene_(1e9, 0.2, 1.0), springs_(springs), together_(together) {
    scene_.model.gravity = Vec2(0.0, 0.0);
    JointLaw& law = scene_.model.joints[0];
    law.normal_stiffness = springs.k;
    law.tensile_strength = std::numeric_limits<double>::infinity();
    law.damping = 0.0;
    scene_.add("explicit", rectangle(-1.0, 0.0, 0.0, 1.0));
    scene_.add("implicit", rectangle(0.0, 0.0, 1.0, 1.0));
    scene_.model.materials.push_back({"heavy", springs.m_i, 1e9, 0.2});
    scene_.model.blocks[1].material = MaterialId{1};
    if (springs.k_e > 0.0)
      scene_.model.point_supports.push_back({BlockId{0}, Vec2(-0.5, 0.5), true, false, springs.k_e});
    if (springs.k_i > 0.0)
      scene_.model.point_supports.push_back({BlockId{1}, Vec2(0.5, 0.5), true, false, springs.k_i});
    Stage& stage = scene_.stage("rigid", Integrator::partitioned, 1.0, 1.0);
    stage.partition.explicit_blocks = {BlockId{0}};
    rest_.explicit_side = {1, 0};
    rest_.bodies = initial_records(scene_.model, body_requests(scene_.model, stage));
    setup_ = std::make_unique<Setup>(scene_.model, rigid(), rest_.bodies);
    rest_.q.assign(2 * static_cast<std::size_t>(setup_->nodes()), 0.0);
    rest_.v = rest_.q;
    for (const Body& b : setup_->bodies()) {
      AffineMotion still;
      still.c = b.centre;
      const auto p = static_cast<std::size_t>(b.pool);
      setup_->pool_of(b).place(b.index, still, setup_->part(std::span<double>(rest_.q), p),
                               setup_->part(std::span<double>(rest_.v), p));
    }
    // The bond is made in the position of contact without force.
    std::unique_ptr<TimeIntegrator> integrator = make(1);
    (void)integrator->enter(rest_);
    integrator->leave(rest_);
    rest_.step = 1;
    rest_.ledger = Ledger{};
  }
  /// x, v of the explicit block, then of the implicit one, after n steps of m substeps.
  struct Outcome {
    Eigen::Vector4d x;
    State state;
    double largest = 0.0;  // momentum of the explicit block, at the ends of steps [N s]
  };
  Outcome go(const Eigen::Vector4d& begin, double h, int m, int n) const {
    State state = rest_;
    for (std::size_t b = 0; b < 2; ++b) {
      state.q[6 * b] += begin[2 * static_cast<Eigen::Index>(b)];
      state.v[6 * b] = begin[2 * static_cast<Eigen::Index>(b) + 1];
    }
    std::unique_ptr<TimeIntegrator> integrator = make(m);
    const double energy = integrator->enter(state);
    integrator->update_ledger(state);
    Ledger& ledger = state.ledger;
    ledger.open(std::array{ledger[Column::kinetic], ledger[Column::elastic], energy, ledger[Column::support_springs]});
    integrator = make(m);  // the ledger of the run begins here
    state.a.clear();
    (void)integrator->enter(state);
    double largest = std::abs(state.v[0]);
    for (int i = 0; i < n; ++i) {
      const StepReport report = integrator->step(state, m * ticks(h));
      if (report.status != StepReport::Status::ok) return {Eigen::Vector4d::Constant(NAN), state, largest};
      largest = std::max(largest, std::abs(state.v[0]));
    }
    integrator->update_ledger(state);
    Eigen::Vector4d x;
    for (std::size_t b = 0; b < 2; ++b) {
      x[2 * static_cast<Eigen::Index>(b)] = state.q[6 * b] - rest_.q[6 * b];
      x[2 * static_cast<Eigen::Index>(b) + 1] = state.v[6 * b];
    }
    return {x, std::move(state), largest};
  }
  [[nodiscard]] Eigen::Matrix4d amplification(double h, int m) const {
    Eigen::Matrix4d a;
    for (Eigen::Index i = 0; i < 4; ++i) a.col(i) = go(kUnit * Eigen::Vector4d::Unit(i), h, m, 1).x / kUnit;
    return a;
  }

 private:
  [[nodiscard]] std::unique_ptr<TimeIntegrator> make(int m) const {
    StepControl control;
    control.max_displacement = 1e3;
    Partitioned::Choice choice;
    choice.substeps = m;
    choice.implicit.together = together_;
    return std::make_unique<Partitioned>(*setup_, rigid(), rest_, control, 5.0, choice);
  }
  Scene scene_;
  Springs springs_;
  double together_;
  State rest_;
  std::unique_ptr<Setup> setup_;
};

/// Spectral radius; infinite if a step was refused.
double radius(const Eigen::Matrix4d& a) {
  return a.allFinite() ? eigenvalues(a).cwiseAbs().maxCoeff() : std::numeric_limits<double>::infinity();
}

/// Two naive schemes with the same parameters.
enum class Naive { predicted, implicit_first };
Eigen::Matrix4d naive(Naive scheme, const Springs& s, double h, int m) {
  const double H = m * h;
  Eigen::Matrix4d a;
  for (Eigen::Index column = 0; column < 4; ++column) {
    const Eigen::Vector4d b = Eigen::Vector4d::Unit(column);
    double x = b[0], v = b[1];
    const double xi = b[2], vi = b[3], inertia = 2.0 * s.m_i / (H * H);
    // Displacement of the implicit block that the explicit substeps assume: by its velocity, or by an implicit step for
    // which the explicit block moves with its velocity.
    double u = H * vi;
    if (scheme == Naive::implicit_first)
      u = (inertia * u - s.k_i * xi + s.k * (x + H * v - xi)) / (inertia + s.k_i + s.k);
    double f = -s.k * (x - xi), mean = 0.5 * f;
    double acceleration = f - s.k_e * x;
    for (int j = 1; j <= m; ++j) {
      const double half = v + 0.5 * h * acceleration;
      x += h * half;
      f = -s.k * (x - xi - u * j / m);
      mean += (j == m ? 0.5 : 1.0) * f;
      acceleration = f - s.k_e * x;
      v = half + 0.5 * h * acceleration;
    }
    mean /= m;
    if (scheme == Naive::predicted) u = (inertia * H * vi - s.k_i * xi - mean) / (inertia + s.k_i);
    a.col(column) << x, v, xi + u, 2.0 * u / H - vi;
  }
  return a;
}

TEST(Subcycling, is_stable_below_the_bound_of_the_explicit_side_alone_and_not_above) {
  const std::vector<Springs> sets = grid();
  ASSERT_EQ(sets.size(), 132);
  std::printf("unstable sets of %zu (largest amplification a step), by substeps m\n%-36s", sets.size(), "m");
  for (const int m : kSubsteps) std::printf("%18d", m);
  const auto row = [&](const char* name, auto&& matrix) {
    std::array<int, kSubsteps.size()> bad{};
    std::printf("\n%-36s", name);
    for (std::size_t i = 0; i < kSubsteps.size(); ++i) {
      double most = 0.0;
      for (const Springs& s : sets) {
        const double r = radius(matrix(s, kSubsteps[i]));
        bad[i] += r > 1.0 + 1e-6 ? 1 : 0;
        most = std::max(most, r);
      }
      std::printf("%6d (%9.4g)", bad[i], most);
    }
    return bad;
  };
  const auto predicted = row("explicit against a prediction",
                             [](const Springs& s, int m) { return naive(Naive::predicted, s, 0.5 * s.bound(), m); });
  const auto first = row("implicit first",
                         [](const Springs& s, int m) { return naive(Naive::implicit_first, s, 0.5 * s.bound(), m); });
  const auto ours = [](double fraction) {
    return [fraction](const Springs& s, int m) { return Pair(s).amplification(fraction * s.bound(), m); };
  };
  const auto half = row("waveform penalty at 0.5", ours(0.5)), below = row("waveform penalty at 0.999", ours(0.999)),
             above = row("waveform penalty at 1.001", ours(1.001));
  std::printf("\n");
  for (std::size_t i = 0; i < kSubsteps.size(); ++i) {
    EXPECT_EQ(half[i], 0);
    EXPECT_EQ(below[i], 0);
    EXPECT_GT(above[i], 0);
    EXPECT_GT(predicted[i] + first[i], 0);
  }
}

TEST(Subcycling, momentum_and_energy_are_exact_wherever_the_iteration_stops) {
  const Eigen::Vector4d begin = kUnit * Eigen::Vector4d(0.3, 0.2, -0.1, 0.5);
  for (const double together : {1e-13, 1e-9, 1e-6}) {
    double momentum = 0.0, energy = 0.0, kicks = 0.0;
    for (const Springs& s : grid())
      for (const int m : kSubsteps) {
        const Pair::Outcome end = Pair(s, together).go(begin, 0.9 * s.bound(), m, 20);
        ASSERT_TRUE(end.x.allFinite()) << "a step was refused";
        const Ledger& ledger = end.state.ledger;
        energy = std::max(energy, ledger.relative_closure());
        kicks = std::max(kicks, std::abs(ledger[Column::waveform]) / ledger.moved());
      }
    // Free in space.
    for (const double k : {1.0, 100.0, 1e4})
      for (const double m_i : {0.1, 1.0, 10.0, 100.0})
        for (const int m : kSubsteps) {
          const Springs s{0.0, m_i, 0.0, k};
          const Pair::Outcome end = Pair(s, together).go(begin, 0.9 * s.bound(), m, 20);
          const double before = begin[1] + m_i * begin[3], after = end.x[1] + m_i * end.x[3];
          // A substep transmits an impulse of about the momentum of the explicit block.
          momentum =
              std::max(momentum, std::abs(after - before) / (20 * m * std::max(end.largest, std::abs(begin[1]))));
        }
    std::printf("iterated to %.0e: momentum %.1e of the impulses, ledger %.1e, kicks %.1e of the energy moved\n",
                together, momentum, energy, kicks);
    EXPECT_LT(energy, 1e-13);
    EXPECT_LT(momentum, 1e-13);
    EXPECT_LT(kicks, std::max(10.0 * together, 1e-10));
  }
}

}  // namespace
}  // namespace scree::test::subcycling_test
