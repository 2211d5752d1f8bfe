// Wedges driven into notches by implicit steps: friction is proportional to the normal forces, and its plain iteration
// would diverge. Reference: the unsymmetric equations as a dense system.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>

#include "coupling/integrate/newmark.h"
#include "model/dense_algebra.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::wedge_test {
namespace {

using namespace coupling;

constexpr double kFriction = 30.0, kDensity = 2500.0, kGravity = 9.81, kStiffness = 1e9;

/// Wedges side by side, each with its apex cut off, in a notch of its own between two held walls. The weight N of a
/// wedge with the half angle b drives it in; with T = tan(phi) N on both faces
///   2 N (sin b + tan phi cos b) = W,  by plain iteration N' = W/(2 sin b) - tan phi cot b N
struct Notches {
  Scene scene{1e10, 0.2, kDensity, kFriction};
  std::vector<double> factor;  // tan phi cot b of a wedge

  Notches() { scene.model.joints[0].damping = 0.0; }  // the references contain springs and friction only
  void add(double tan_phi_cot_b, double size) {
    const double t = std::tan(kFriction * kDegree) / tan_phi_cot_b;  // tan b
    const double x = 40.0 * static_cast<double>(factor.size()), s = size, far = 1.0 + 4.0 * t;
    const std::string name = std::to_string(factor.size());
    const auto at = [&](double dx, double y) { return Vec2(x + s * dx, s * y); };
    scene.add("right wall " + name, {{at(0.2 * t, 0.2), at(far, 0.2), at(far, 3.5), at(3.5 * t, 3.5)}, {}}, true);
    scene.add("left wall " + name, {{at(-0.2 * t, 0.2), at(-3.5 * t, 3.5), at(-far, 3.5), at(-far, 0.2)}, {}}, true);
    scene.add("wedge " + name, {{at(-t, 1.0), at(t, 1.0), at(2.0 * t, 2.0), at(-2.0 * t, 2.0)}, {}});
    factor.push_back(tan_phi_cot_b);
  }
};

/// The first step from rest, by Newmark and as dense equations with the contact states that Newmark found:
///   (2 M/h^2 + K + sum k h h^T) d = f - sum k g h,  for slipping points k_n (h_n + s tan phi h_t) h_n^T
/// with s the sign of the friction force. With dilation, the slip is -s (e + h_t.d) - tan phi f_n/k_t and the gap
/// changes by tan psi times the slip, so f_n = -k' (g + s tan psi e + h'.d), h' = h_n + s tan psi h_t,
/// k' = k_n/(1 + tan phi tan psi k_n/k_t).
struct FirstStep {
  int slipping = 0, sticking = 0, open = 0, passes = 0;
  double largest = 0.0, off = 0.0;  // normal force, difference to the dense solution [N]
  std::vector<double> held;         // sum of the normal forces per wedge [N]

  FirstStep(Notches& notches, const std::string& method, double cover, double h) {
    for (JointLaw& law : notches.scene.model.joints) law.normal_stiffness = law.shear_stiffness = kStiffness;
    Stage& stage = notches.scene.stage(method, Integrator::implicit, h, h, cover);
    stage.kinematics = Kinematics::linear;
    ByHand hand(notches.scene.model, stage);
    StepControl control;
    control.max_displacement = 1.0;
    control.max_passes = 60;
    Newmark integrator(*hand.setup, control, 0.01, {});
    (void)integrator.enter(hand.state);
    ImplicitSystem system(*hand.setup);
    const State before = hand.state;
    const std::vector<double>& q = before.q;
    system.compute_masses(q, before.v);
    std::vector<double> K(system.pattern().size(), 0.0);
    const auto n = static_cast<Eigen::Index>(system.dofs());
    std::vector<double> force(static_cast<std::size_t>(n), 0.0), weight(q.size(), 0.0);
    (void)system.linearise(q, Stiffness::exact, true, K, force);
    EXPECT_FALSE(system.nonlinear());
    for (std::size_t p = 0; p < hand.setup->pools(); ++p)
      hand.setup->pool(p).body_force(notches.scene.model.gravity, hand.setup->part(std::span<double>(weight), p));
    system.add_forces(weight, q, force);

    const StepReport report = integrator.step(hand.state, ticks(h));
    EXPECT_EQ(report.status, StepReport::Status::ok) << report.cause;
    passes = report.passes;
    held.assign(notches.factor.size(), 0.0);
    if (report.status != StepReport::Status::ok) return;

    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    const SymmetricPattern& pattern = system.pattern();
    for (Eigen::Index c = 0; c < n; ++c)
      for (std::int32_t k = pattern.column_start[static_cast<std::size_t>(c)];
           k < pattern.column_start[static_cast<std::size_t>(c) + 1]; ++k) {
        const auto at = static_cast<std::size_t>(k);
        A(pattern.row[at], c) = A(c, pattern.row[at]) = 2.0 / (h * h) * system.mass()[at] + K[at];
      }
    Eigen::VectorXd rhs = Eigen::Map<const Eigen::VectorXd>(force.data(), n);
    const auto dense = [&](const DofRow& row) {
      Eigen::VectorXd out = Eigen::VectorXd::Zero(n);
      for (std::size_t j = 0; j < row.dof.size(); ++j) out[row.dof[j]] += row.h[j];
      return out;
    };
    const double mu = std::tan(kFriction * kDegree), tan_psi = std::tan(notches.scene.model.joints[0].dilation);
    struct Normal {  // f_n = -k (g + h.d)
      Eigen::VectorXd h;
      double k = 0.0, g = 0.0;
    };
    std::vector<Normal> normals;
    const auto& trials = integrator.contacts().trials();
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const OpenClose::Trial& t = trials[i];
      const ContactMemory& m = before.contacts[i];
      if (t.status == ContactStatus::open) {
        ++open;
        normals.push_back({Eigen::VectorXd::Zero(n), 0.0, 0.0});
        continue;
      }
      const Eigen::VectorXd along = dense(integrator.contacts().tangential(i));
      Normal normal{dense(integrator.contacts().normal(i)), m.kn, m.gap};
      Eigen::VectorXd works = normal.h;  // row on which f_n and its friction act
      if (t.status == ContactStatus::slip) {
        ++slipping;
        works += t.direction * mu * along;
        normal.h += t.direction * tan_psi * along;
        normal.g += t.direction * tan_psi * m.stretch;
        normal.k /= 1.0 + mu * tan_psi * m.kn / m.kt;
      } else {
        ++sticking;
        A += m.kt * along * along.transpose();
        rhs -= m.kt * m.stretch * along;
      }
      A += normal.k * works * normal.h.transpose();
      rhs -= normal.k * normal.g * works;
      normals.push_back(std::move(normal));
    }
    const Eigen::VectorXd d = solve_general(A, rhs);
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const OpenClose::Trial& t = trials[i];
      if (t.status == ContactStatus::open) continue;
      const ContactMemory& m = before.contacts[i];
      const double fn = -normals[i].k * (normals[i].g + normals[i].h.dot(d));
      largest = std::max(largest, t.fn);
      off = std::max(off, std::abs(fn - t.fn));
      held[static_cast<std::size_t>(std::max(m.key.block_p, m.key.block_e)) / 3] += t.fn;
    }
  }
};

/// Sum of the normal forces on both faces if friction is at its limit everywhere.
double normal_force(double factor, double size) {
  const double mu = std::tan(kFriction * kDegree), t = mu / factor, b = std::atan(t);
  const double weight = 3.0 * t * size * size * kDensity * kGravity;  // of the wedge between y = 1 and 2
  return weight / (std::sin(b) + mu * std::cos(b));
}

class Wedge : public testing::TestWithParam<double> {};

TEST_P(Wedge, of_six_unknowns_is_held_by_the_algebraic_forces) {
  Notches notches;
  notches.add(GetParam(), 1.0);
  const FirstStep step(notches, "dda", 1.0, 1e3);
  std::printf("tan(phi) cot(b) = %.2f: %d slip, %d stick, %d passes, N %.10f of the formula, off by %.1e of N\n",
              GetParam(), step.slipping, step.sticking, step.passes, step.held[0] / normal_force(GetParam(), 1.0),
              step.off / step.largest);
  EXPECT_EQ(step.slipping, 4);
  EXPECT_EQ(step.sticking, 0);
  EXPECT_NEAR(step.held[0], normal_force(GetParam(), 1.0), 1e-8 * step.held[0]);
  EXPECT_LT(step.off, 1e-8 * step.largest);
}

TEST_P(Wedge, with_a_mesh_has_more_slipping_points_than_the_residuals_remember) {
  Notches notches;
  notches.add(GetParam(), 1.0);
  const FirstStep step(notches, "nmm", 0.12, 1e3);
  std::printf(
      "tan(phi) cot(b) = %.2f: %d slip, %d stick, %d open, %d passes, N %.10f of the formula, off by %.1e of N\n",
      GetParam(), step.slipping, step.sticking, step.open, step.passes, step.held[0] / normal_force(GetParam(), 1.0),
      step.off / step.largest);
  EXPECT_GT(step.slipping, 20);
  if (step.sticking == 0) {
    EXPECT_NEAR(step.held[0], normal_force(GetParam(), 1.0), 1e-8 * step.held[0]);
  }
  EXPECT_LT(step.off, 1e-8 * step.largest);
}

TEST_P(Wedge, that_dilates_is_held_by_more) {
  for (const char* method : {"dda", "nmm"}) {
    Notches notches;
    notches.add(GetParam(), 1.0);
    notches.scene.model.joints[0].dilation = 8.0 * kDegree;
    const FirstStep step(notches, method, 0.12, 1e3);
    std::printf("%s, tan(phi) cot(b) = %.2f: %d slip, %d stick, %d open, %d passes, off by %.1e of N\n", method,
                GetParam(), step.slipping, step.sticking, step.open, step.passes, step.off / step.largest);
    EXPECT_GE(step.slipping, 4);
    EXPECT_LT(step.off, 1e-8 * step.largest);
  }
}

INSTANTIATE_TEST_SUITE_P(factors, Wedge, testing::Values(0.5, 0.9, 1.0, 1.1, 1.5, 2.0, 3.0));

TEST(Wedges, all_at_once_are_held_by_the_algebraic_forces) {
  Notches notches;
  std::vector<double> sizes;
  for (int i = 0; i < 16; ++i) {
    sizes.push_back(0.5 + 0.11 * ((7 * i) % 16));
    notches.add(0.5 + 2.5 * i / 15.0, sizes.back());
  }
  const FirstStep step(notches, "dda", 1.0, 1e3);
  std::printf("16 wedges: %d slip, %d stick, %d passes, off by %.1e of N\n", step.slipping, step.sticking, step.passes,
              step.off / step.largest);
  EXPECT_EQ(step.slipping, 64);
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double wanted = normal_force(notches.factor[i], sizes[i]);
    EXPECT_NEAR(step.held[i], wanted, 1e-8 * wanted) << i;
  }
  EXPECT_LT(step.off, 1e-8 * step.largest);
}

/// Some 700 contact points, tan(phi) cot(b) up to 15: many more than the directions that the conjugate residuals store.
TEST(Wedges, steep_ones_with_meshes_are_held_too) {
  Notches notches;
  for (int i = 0; i < 8; ++i) notches.add(0.5 + 14.5 * i / 7.0, 0.5 + 0.11 * ((3 * i) % 8));
  const FirstStep step(notches, "nmm", 0.1, 1e3);
  std::printf("8 meshed wedges: %d slip, %d stick, %d open, %d passes, off by %.1e of N\n", step.slipping,
              step.sticking, step.open, step.passes, step.off / step.largest);
  EXPECT_GT(step.slipping, 600);
  EXPECT_LT(step.off, 1e-8 * step.largest);
}

TEST(Wedges, steep_ones_that_dilate_are_held_too) {
  Notches notches;
  notches.scene.model.joints[0].dilation = 8.0 * kDegree;
  for (int i = 0; i < 8; ++i) notches.add(0.5 + 14.5 * i / 7.0, 0.5 + 0.11 * ((3 * i) % 8));
  const FirstStep step(notches, "nmm", 0.1, 1e3);
  std::printf("8 that dilate: %d slip, %d stick, %d open, %d passes, off by %.1e of N\n", step.slipping, step.sticking,
              step.open, step.passes, step.off / step.largest);
  EXPECT_GT(step.slipping, 400);
  EXPECT_LT(step.off, 1e-8 * step.largest);
}

}  // namespace
}  // namespace scree::test::wedge_test
