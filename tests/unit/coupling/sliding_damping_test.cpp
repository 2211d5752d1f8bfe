// Damping of the deformation of sliding blocks: frequency, rates and matrix, against closed forms and dense algebra.
#include "coupling/integrate/sliding_damping.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "coupling/integrate/deformation_damping.h"
#include "coupling/transfer/transfer.h"
#include "model/dense_algebra.h"
#include "tests/support/scene.h"

namespace scree::coupling::sliding_damping_test {
namespace {

using test::rectangle;
using test::Scene;

TEST(SlidingDamping, lowest_frequency_of_a_square_is_that_of_its_shear) {
  // D = diag(d, -d) and D12 = D21 have the stiffness 2 mu A and the second moment m L^2/12 each: w^2 = 24 mu/(rho L^2).
  Scene scene(1e10, 0.25, 2500.0);
  const BlockId b = scene.add("square", rectangle(3, 4, 5, 6));
  const ReferenceShape shape = reference_shape(scene.model, b);
  const double mu = 1e10 / (2.0 * 1.25);
  EXPECT_NEAR(lowest_deformation_frequency(shape, scene.model.elasticity_of(b)), std::sqrt(24.0 * mu / (2500.0 * 4.0)),
              1e-9 * std::sqrt(24.0 * mu / 1e4));
}

TEST(SlidingDamping, lowest_frequency_of_a_triangle_is_that_of_six_unknowns) {
  // Independent reference: all six affine displacements by quadrature over the triangle, without the rigid motions.
  Scene scene(5e9, 0.2, 2600.0);
  const BlockId b = scene.add("wedge", {{{0, 0}, {34.8689, 0}, {20.9303, 9.7598}}, {}});
  const Ring& ring = scene.model.blocks[b.index()].polygon.outer;
  const double lambda = 5e9 * 0.2 / (1.2 * 0.6), mu = 5e9 / 2.4, area = 0.5 * 34.8689 * 9.7598;
  Eigen::Matrix<double, 6, 6> M = Eigen::Matrix<double, 6, 6>::Zero(), K = M;
  for (int i = 0; i < 3; ++i) {  // mid-sides: exact for quadratics
    const Vec2 x = 0.5 * (ring[static_cast<std::size_t>(i)] + ring[static_cast<std::size_t>((i + 1) % 3)]);
    Eigen::Matrix<double, 2, 6> N;
    N << 1, 0, x.x(), x.y(), 0, 0, 0, 1, 0, 0, x.x(), x.y();
    M += 2600.0 * area / 3.0 * N.transpose() * N;
  }
  Eigen::Matrix<double, 3, 6> B;
  B << 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0;
  const Eigen::Matrix3d C =
      (Eigen::Matrix3d() << lambda + 2 * mu, lambda, 0, lambda, lambda + 2 * mu, 0, 0, 0, mu).finished();
  K = area * B.transpose() * C * B;
  const double w2 = generalized_eigenvalues(K, M)(3);
  EXPECT_NEAR(lowest_deformation_frequency(reference_shape(scene.model, b), scene.model.elasticity_of(b)),
              std::sqrt(w2), 1e-6 * std::sqrt(w2));
}

/// The first outline node of a body.
coupling::OutlineNode first_node(const coupling::Outlines& outlines, BodyIndex body) {
  for (const coupling::OutlineNode n : outlines.nodes.indices())
    if (outlines.node_body[n] == body) return n;
  throw std::logic_error("no such body");
}

/// A block of DDA or NMM without contacts, slightly rotated and strained.
struct Fixture {
  Scene scene{1e9, 0.2, 2600.0};
  State state;
  std::unique_ptr<Setup> setup;

  explicit Fixture(const std::string& method) {
    scene.add("block", {{{0, 0}, {3, 0}, {3.5, 1.2}, {0.5, 1.7}}, {}});
    Stage& stage = scene.stage(method, Integrator::implicit, 1.0, 1e-3, 0.6);
    state.bodies = initial_records(scene.model, body_requests(scene.model, stage));
    setup = std::make_unique<Setup>(scene.model, standard_methods(), state.bodies);
    state.q.assign(2 * static_cast<std::size_t>(setup->nodes()), 0.0);
    state.v = state.q;
    AffineMotion m;
    m.c = Vec2(7.0, -3.0);
    m.F = rotation(0.3) * (Mat2() << 1.01, 0.02, 0.01, 0.98).finished();
    setup->pool(0).place(0, m, state.q, state.v);
  }
};

class Damper : public testing::TestWithParam<std::string> {};

TEST_P(Damper, matrix_is_the_mass_less_its_rigid_part) {
  Fixture f(GetParam());
  ImplicitSystem system(*f.setup);
  system.compute_masses(f.state.q, f.state.v);
  DeformationDamping damper(*f.setup, system);
  const double rate = 17.0, factor = 40.0;
  damper.find(f.state.q, std::vector<double>{rate}, factor);
  ASSERT_TRUE(damper.acts());
  const auto n = static_cast<Eigen::Index>(system.dofs());
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(n, n), A = M, forces(n, n), R(n, 3);
  std::vector<double> on_pattern(system.pattern().size(), 0.0);
  damper.add_matrix(on_pattern);
  for (Eigen::Index c = 0; c < n; ++c)
    for (auto k = system.pattern().column_start[static_cast<std::size_t>(c)];
         k < system.pattern().column_start[static_cast<std::size_t>(c) + 1]; ++k) {
      const auto r = static_cast<Eigen::Index>(system.pattern().row[static_cast<std::size_t>(k)]);
      M(r, c) = M(c, r) = system.mass()[static_cast<std::size_t>(k)];
      A(r, c) = A(c, r) = on_pattern[static_cast<std::size_t>(k)];
    }
  for (const LowRank& t : damper.terms()) {
    const Eigen::Map<const Eigen::MatrixX3d> Z(t.Z, static_cast<Eigen::Index>(t.count), 3);
    const auto first = static_cast<Eigen::Index>(t.first), count = static_cast<Eigen::Index>(t.count);
    A.block(first, first, count, count) -= Z * t.W * Z.transpose();
  }
  EXPECT_EQ(damper.terms().empty(), GetParam() == "dda");
  // Rigid motions from the positions of the outline, by least squares over its nodes: independent of rigid_motions().
  const Outlines& o = f.setup->outlines();
  Eigen::MatrixXd rows(2 * static_cast<Eigen::Index>(o.nodes.size()), n), fields(rows.rows(), 3);
  rows.setZero();
  for (const coupling::OutlineNode k : o.nodes.indices()) {
    const ChartRow row = system.chart(BodyIndex{0}, o.nodes[k], f.state.q);
    const auto at = 2 * static_cast<Eigen::Index>(k.index());
    for (std::size_t j = 0; j < static_cast<std::size_t>(row.n); ++j) {
      rows(at, row.dof[j]) += row.tx[j];
      rows(at + 1, row.dof[j]) += row.ty[j];
    }
    const Vec2 x = position(o.nodes[k], f.state.q);
    fields.row(at) << 1, 0, -x.y();
    fields.row(at + 1) << 0, 1, x.x();
  }
  std::vector<double> unit(static_cast<std::size_t>(n), 0.0), out(unit.size(), 0.0);
  for (Eigen::Index c = 0; c < n; ++c) {
    std::fill(unit.begin(), unit.end(), 0.0);
    std::fill(out.begin(), out.end(), 0.0);
    unit[static_cast<std::size_t>(c)] = 1.0;
    damper.add_force(2.0, unit, out);
    forces.col(c) = Eigen::Map<const Eigen::VectorXd>(out.data(), n);
  }
  const double size = factor * rate * M.cwiseAbs().maxCoeff();
  EXPECT_LT((A - A.transpose()).cwiseAbs().maxCoeff(), 1e-12 * size);
  EXPECT_LT((forces / 2.0 - A / factor).cwiseAbs().maxCoeff(), 1e-12 * size);
  EXPECT_GT(symmetric_eigenvalues(A)(0), -1e-12 * size);
  // The rank is that of the mass less three.
  const Eigen::VectorXd singular = singular_values(A);
  EXPECT_EQ((singular.array() > 1e-9 * singular[0]).count(), n - 3);
  if (GetParam() == "dda") {
    R = least_squares(rows, fields);
    const Eigen::MatrixXd Z = M * R, expected = M - Z * inverse_of(R.transpose() * Z) * Z.transpose();
    EXPECT_LT((A - factor * rate * expected).cwiseAbs().maxCoeff(), 1e-9 * size);
    // A rate of a stiff block is 100 times 1/h: round-off in the rows of its rigid motions would be work on a slide.
    EXPECT_EQ(A.topRows(3).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_EQ((forces * R).topRows(3).cwiseAbs().maxCoeff(), 0.0);
    EXPECT_LT((forces * R).cwiseAbs().maxCoeff(), 1e-14 * size);
  }
}
INSTANTIATE_TEST_SUITE_P(all, Damper, testing::Values("dda", "nmm"));

ContactMemory pressed(double fn, ContactStatus status) {
  ContactMemory m;
  m.fn = fn;
  m.status = status;
  m.joint = 0;
  m.kt = 1e3;
  if (status == ContactStatus::slip) m.slide.last.slip = 2.0F;  // it has slid in one direction for a period
  return m;
}

TEST(SlidingDamping, rate_follows_the_part_of_the_force_that_slips) {
  Scene scene(5e9, 0.2, 2600.0);
  scene.add("plane", rectangle(-5, -2, 9, 0), true);
  const BlockId b = scene.add("block", rectangle(0, 0, 2, 1));
  scene.add("held", rectangle(4, 0, 5, 1));
  PointSupport support;
  support.block = BlockId{2};
  scene.model.point_supports.push_back(support);
  const Stage& stage = scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  const std::vector<BodyRecord> records = initial_records(scene.model, body_requests(scene.model, stage));
  const coupling::Setup setup(scene.model, standard_methods(), records);
  SlidingDamping damping(setup, 0.7);
  ASSERT_TRUE(damping.used());
  const auto node_of = [&](std::int32_t body) { return first_node(setup.outlines(), BodyIndex{body}); };
  const double most =
      2.0 * 0.7 * lowest_deformation_frequency(reference_shape(scene.model, b), scene.model.elasticity_of(b));
  const auto rate_of = [&](SlidingDamping& of, std::vector<ContactMemory> memory, std::int32_t body) {
    ContactList list;
    list.memory = std::move(memory);
    list.points.resize(list.memory.size());
    for (ContactPoint& p : list.points) p.node = std::array{node_of(body), node_of(0), node_of(0)};
    of.begin();
    of.count(setup.outlines(), list);
    (void)of.find();
    EXPECT_EQ(of.rates()[0], 0.0);  // the plane is held
    return of.rates()[static_cast<std::size_t>(body)] / most;
  };
  const auto rate = [&](std::vector<ContactMemory> memory, std::int32_t body) {
    return rate_of(damping, std::move(memory), body);
  };
  using enum ContactStatus;
  EXPECT_EQ(rate({pressed(1.0, stick), pressed(1.0, stick)}, 1), 0.0);
  EXPECT_NEAR(rate({pressed(1.0, slip), pressed(3.0, slip)}, 1), 1.0, 1e-14);
  EXPECT_NEAR(rate({pressed(1.0, slip), pressed(1.0, stick), pressed(5.0, open)}, 1), 1.0, 1e-14);
  EXPECT_NEAR(rate({pressed(1.0, slip), pressed(99.0, stick)}, 1), std::pow(0.03, 1.5), 1e-14);
  EXPECT_EQ(rate({pressed(1.0, slip)}, 2), 0.0);  // exempt: on a point support
  EXPECT_FALSE(SlidingDamping(setup, 0.0).used());
  // It still counts as sliding after a return of less than the elastic stretch tan(30 deg)/1e3 m, not after more.
  ContactMemory back = pressed(1.0, slip);
  back.slide.slip = -0.5e-3;
  EXPECT_NEAR(rate({back}, 1), 1.0, 1e-14);
  back.slide.slip = -0.6e-3;
  EXPECT_EQ(rate({back}, 1), 0.0);
  back.slide.slip = 0.6e-3;
  EXPECT_NEAR(rate({back}, 1), 1.0, 1e-14);
  // With cohesion only the part of friction counts: tan(30 deg) out of 9 tan(30 deg) + tan(30 deg).
  scene.model.joints[0].cohesion = 9.0 * std::tan(30.0 * test::kDegree);
  const coupling::Setup with_cohesion(scene.model, standard_methods(), records);
  SlidingDamping cohesive(with_cohesion, 0.7);
  ContactMemory bound = pressed(1.0, slip);
  bound.tributary = 1.0;
  EXPECT_NEAR(rate_of(cohesive, {bound}, 1), std::pow(0.3, 1.5), 1e-14);
  bound.failed = 1;  // its cohesion is gone
  EXPECT_NEAR(rate_of(cohesive, {bound}, 1), 1.0, 1e-14);
}

TEST(SlidingDamping, rate_grows_with_the_cube_of_friction_on_steep_slopes) {
  Scene scene(5e9, 0.2, 2600.0);
  scene.add("plane", rectangle(-5, -2, 9, 0), true);
  const BlockId b = scene.add("block", rectangle(0, 0, 2, 1));
  const Stage& stage = scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  scene.model.joints.push_back(scene.model.joints[0]);
  const std::vector<BodyRecord> records = initial_records(scene.model, body_requests(scene.model, stage));
  // Half of the force slides under each of two laws.
  const auto rate = [&](double tan_first, double tan_second) {
    scene.model.joints[0].friction = std::atan(tan_first);
    scene.model.joints[1].friction = std::atan(tan_second);
    const coupling::Setup setup(scene.model, standard_methods(), records);
    SlidingDamping damping(setup, 1.0);
    const auto node_of = [&](std::int32_t body) { return first_node(setup.outlines(), BodyIndex{body}); };
    ContactList list;
    list.memory = {pressed(2.0, ContactStatus::slip), pressed(2.0, ContactStatus::slip)};
    list.memory[1].joint = 1;
    list.points.resize(2);
    for (ContactPoint& p : list.points) p.node = std::array{node_of(1), node_of(0), node_of(0)};
    damping.begin();
    damping.count(setup.outlines(), list);
    (void)damping.find();
    return damping.rates()[1] /
           (2.0 * lowest_deformation_frequency(reference_shape(scene.model, b), scene.model.elasticity_of(b)));
  };
  EXPECT_NEAR(rate(0.5, 0.5), 1.0, 1e-12);
  EXPECT_NEAR(rate(0.79, 0.79), 1.0, 1e-12);
  EXPECT_NEAR(rate(1.0, 1.0), 2.0, 1e-12);
  EXPECT_NEAR(rate(1.5, 1.5), 6.75, 1e-12);
  EXPECT_NEAR(rate(0.5, 1.5), 0.125 + 3.375, 1e-12);  // 2 (0.125 + 3.375)/2
}

TEST(SlidingDamping, cohesion_alone_brings_none) {
  Scene scene(5e9, 0.2, 2600.0, 0.0);
  scene.model.joints[0].cohesion = scene.model.joints[0].residual_cohesion = 1e5;
  scene.add("plane", rectangle(-5, -2, 9, 0), true);
  scene.add("block", rectangle(0, 0, 2, 1));
  const Stage& stage = scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  const std::vector<BodyRecord> records = initial_records(scene.model, body_requests(scene.model, stage));
  const coupling::Setup setup(scene.model, standard_methods(), records);
  SlidingDamping damping(setup, 1.0);
  ContactList list;
  list.memory = {pressed(1.0, ContactStatus::slip)};
  list.memory[0].tributary = 1.0;
  list.points.resize(1);
  list.points[0].node.fill(first_node(setup.outlines(), BodyIndex{1}));
  damping.begin();
  damping.count(setup.outlines(), list);
  EXPECT_FALSE(damping.find());
}

}  // namespace
}  // namespace scree::coupling::sliding_damping_test
