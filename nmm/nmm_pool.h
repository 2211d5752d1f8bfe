// All manifold blocks of a run: covers and elements in contiguous arrays, explicit dynamics.
#pragma once

#include <memory>

#include "model/pool.h"
#include "nmm/affine_mass.h"
#include "nmm/implicit.h"

namespace scree::nmm {

/// Numerical manifold method, co-rotational stress, affine-exact lumped mass. A node is a physical cover, its position
/// that of the cover's star. Blocks share no cover.
/// @source nmm.md; Qu 2013 ch. 3, 4, 6
class NmmPool final : public Pool {
 public:
  [[nodiscard]] std::string_view method() const override { return "nmm"; }
  void add(const Model& model, const BodyRecord& record) override;
  void finish() override;
  [[nodiscard]] int bodies() const override { return static_cast<int>(bodies_.size()); }
  [[nodiscard]] std::int32_t first_node(int body) const override { return first_[static_cast<std::size_t>(body)]; }
  [[nodiscard]] const Boundary& boundary(int body) const override { return of(body).mesh.boundary; }
  [[nodiscard]] Row row_at(int body, const Vec2& X) const override;
  [[nodiscard]] std::span<const double> translation(int body) const override;

  void place(int body, const AffineMotion& motion, std::span<double> q, std::span<double> v) const override;
  [[nodiscard]] Release release(int body, std::span<const double> q, std::span<const double> v) const override;
  [[nodiscard]] BodyTotals totals(int body, std::span<const double> q, std::span<const double> v) const override;

  double internal_force(std::span<const double> q, std::span<double> f) const override;
  void body_force(const Vec2& acceleration, std::span<double> f) const override;
  void mass_solve(std::span<const double> q, std::span<const double> f, std::span<double> a) const override;
  [[nodiscard]] double kinetic_energy(std::span<const double> q, std::span<const double> v,
                                      std::span<const char> counted) const override;
  void damp(double factor, double rate, std::span<double> v, std::span<double> f, std::span<double> a) const override;
  [[nodiscard]] double frequency_bound(int body) const override { return of(body).frequency; }
  [[nodiscard]] double mass_ratio(int body) const override { return of(body).mass.theta(); }
  [[nodiscard]] double compliance(int body, const Row& row) const override;
  void bound_groups(int body, const Row& row, std::vector<std::int32_t>& groups) const override;

  void gather(std::span<double> f) const override;
  [[nodiscard]] int dofs(int body) const override { return of(body).implicit.dofs(); }
  [[nodiscard]] bool nonlinear(int body) const override { return of(body).form.kinematics == Kinematics::corotational; }
  [[nodiscard]] bool constant_chart(int) const override { return true; }
  [[nodiscard]] std::string implicit_obstacle(int body) const override;
  [[nodiscard]] ElementDofs element_dofs(int body) const override { return of(body).implicit.element_dofs(); }
  [[nodiscard]] ChartRow chart_row(int body, const Row& row, std::span<const double> q) const override;
  void element_masses(int body, std::span<const double> q, std::span<double> mass) const override;
  void rates(int body, std::span<const double> q, std::span<const double> v, std::span<double> rate) const override;
  double linearise(int body, std::span<const double> q, Stiffness kind, std::span<double> stiffness,
                   std::span<double> force) const override;
  void retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
               std::span<double> v) const override;

  void topology(MeshPart& mesh) const override;
  void stress(std::span<const double> q, std::span<double> cells) const override;

  /// The mesh of a body, for tests and reports; covers and elements counted from the body's first.
  [[nodiscard]] const CoverMesh& mesh(int body) const { return of(body).mesh; }
  [[nodiscard]] const AffineMass& mass(int body) const { return of(body).mass; }
  [[nodiscard]] std::int64_t elements() const { return static_cast<std::int64_t>(area_.size()); }

 private:
  struct Body {
    CoverMesh mesh;  // boundary rows and cells count within the pool
    AffineMass mass;
    bool consistent_mass = false;
    ConsistentMass consistent;  // and what implicit steps need, where the form asks for either
    ImplicitBody implicit;
    Formulation form;
    ReferenceShape shape;
    std::int32_t first_element = 0;
    double frequency = 0.0;
  };
  [[nodiscard]] const Body& of(int body) const { return *bodies_[static_cast<std::size_t>(body)]; }
  static void make_implicit(Body& body, std::int32_t first);
  [[nodiscard]] static double kinetic_of(const Body& b, std::span<const double> v);
  static void apply(const Body& b, std::span<const double> v, std::span<double> p);
  [[nodiscard]] ElasticResponse respond(std::size_t element, const Mat2& F) const;
  [[nodiscard]] Mat2 gradient(std::size_t element, std::span<const double> q) const;  // F

  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<std::int32_t> first_{0};
  // A place an element, all bodies.
  std::vector<std::array<std::int32_t, 3>> cover_;
  std::vector<Eigen::Matrix<double, 2, 3>> gradient_;
  std::vector<double> area_;
  std::vector<Elasticity> law_;
  std::vector<char> linear_;
  std::vector<std::int32_t> drawn_;  // output cells of the element
  // Corner forces of each element, gathered by cover in a fixed order: the same bits for any number of threads.
  std::vector<std::int32_t> gather_start_, gather_;
  std::vector<double> ones_;
  mutable std::vector<Vec2> corner_force_;
  mutable std::vector<double> partial_;
};

}  // namespace scree::nmm
