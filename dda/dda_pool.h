// All DDA blocks of a run: affine bodies, explicit or implicit.
#pragma once

#include <optional>

#include "dda/affine_body.h"
#include "model/affine_form.h"

namespace scree::dda {

/// Discontinuous deformation analysis: three nodes per block, q = (c, F e1, F e2), so that a point is
/// x = c + X1 (F e1) + X2 (F e2). Implicit steps use Shi's six unknowns, mapped by their chart, and rotate exactly, or,
/// with BlockRotation::affine, move (c, F) by Newton's method; explicit steps move the nodes themselves. Blocks with
/// BlockRotation::first_order have two more nodes, which hold the strain summed over the steps, and take implicit steps
/// only.
/// @source docs/theory/dda.md, "Unknowns of a block"; [Shi1988]; [Shi1993]; [Sitar1997] 2.1
class DdaPool final : public Pool {
 public:
  [[nodiscard]] std::string_view method() const override { return "dda"; }
  void add(const Model& model, const BodyRecord& record) override;
  void finish() override { bodies_.shrink_to_fit(); }
  [[nodiscard]] int bodies() const override { return static_cast<int>(bodies_.size()); }
  [[nodiscard]] std::int32_t first_node(int body) const override { return first_[static_cast<std::size_t>(body)]; }
  [[nodiscard]] const Boundary& boundary(int body) const override { return of(body).boundary; }
  [[nodiscard]] Row row_at(int body, const Vec2& X) const override;
  [[nodiscard]] std::span<const double> translation(int body) const override;

  void place(int body, const AffineMotion& motion, std::span<double> q, std::span<double> v) const override;
  [[nodiscard]] Release release(int body, std::span<const double> q, std::span<const double> v) const override;
  [[nodiscard]] BodyTotals totals(int body, std::span<const double> q, std::span<const double> v) const override;

  double internal_force(std::span<const double> q, std::span<double> f) const override;
  void body_force(const Vec2& acceleration, std::span<double> f) const override;
  void mass_solve(std::span<const double> q, std::span<const double> f, std::span<double> a) const override;
  void mass_apply(int body, std::span<const double> q, std::span<const double> v, std::span<double> p) const override;
  [[nodiscard]] double kinetic_energy(std::span<const double> q, std::span<const double> v,
                                      std::span<const char> counted) const override;
  [[nodiscard]] Fault find_fault(std::span<const double> q) const override;
  void stiffness_damping(std::span<const double> q, std::span<const double> v, double rate,
                         std::span<double> f) const override;
  [[nodiscard]] double frequency_bound(int body) const override { return of(body).frequency; }
  [[nodiscard]] double mass_ratio(int) const override { return 1.0; }
  [[nodiscard]] double compliance(int body, const Row& row) const override;
  void bound_groups(int body, const Row& row, std::vector<std::int32_t>& groups) const override;

  [[nodiscard]] int dofs(int) const override { return kUnknowns; }
  [[nodiscard]] bool nonlinear(int body) const override { return of(body).affine.has_value(); }
  [[nodiscard]] bool constant_chart(int body) const override { return of(body).affine.has_value(); }
  [[nodiscard]] ChartRow chart_row(int body, const Row& row, std::span<const double> q) const override;
  [[nodiscard]] ElementDofs element_dofs(int body) const override;
  void element_masses(int body, std::span<const double> q, std::span<double> mass) const override;
  void rates(int body, std::span<const double> q, std::span<const double> v, std::span<double> rate) const override;
  double linearise(int body, std::span<const double> q, Stiffness kind, std::span<double> stiffness,
                   std::span<double> force) const override;
  void retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
               std::span<double> v) const override;

  void topology(MeshPart& mesh) const override;
  void stress(std::span<const double> q, std::span<double> cells) const override;
  void recovered_stress(std::span<const double> q, std::span<const char> wanted,
                        std::span<double> nodes) const override;

 private:
  struct Stressed {
    double energy = 0.0;  // per reference area [J/m2 for unit thickness]
    Mat2 P;               // first Piola-Kirchhoff stress [Pa]
  };
  /// Response to the stretch of a block, or to its summed strain.
  [[nodiscard]] Stressed stress_of(int body, std::span<const double> q) const;
  /// Cauchy stress of a block [Pa].
  [[nodiscard]] Mat2 cauchy(int body, std::span<const double> q) const;

  /// Sum of of_body(b), in chunks: the same bits for any number of threads.
  template <class Of>
  [[nodiscard]] double sum_of_bodies(Of&& of_body) const;

  struct Body {
    ReferenceShape shape;
    Elasticity law;
    Mat2 initial = Mat2::Zero();  // mean of the in-situ stress over the block, co-rotated [Pa]
    Boundary boundary;
    Mat2 second_inverse;
    std::optional<AffineForm> affine;  // of implicit steps; none: Shi's unknowns and an exact rotation
    bool summed = false;               // its strain is summed over the steps: C^-1 of its total stress, in fixed axes
    double frequency = 0.0;
    std::vector<Ring> cells;
  };
  [[nodiscard]] const Body& of(int body) const { return bodies_[static_cast<std::size_t>(body)]; }
  std::vector<Body> bodies_;
  std::vector<std::int32_t> first_{0};  // first node of each body, then the number of nodes
  mutable std::vector<double> sums_;    // scratch, of chunks of bodies
};

}  // namespace scree::dda
