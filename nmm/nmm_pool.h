// All manifold blocks of a run: covers and elements in contiguous arrays, explicit dynamics.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "model/field_carrier.h"
#include "nmm/edge_holds.h"
#include "nmm/element_forces.h"
#include "nmm/implicit.h"
#include "nmm/lumped_mass.h"
#include "nmm/onefold.h"
#include "nmm/step_bound.h"

namespace scree::nmm {

/// Numerical manifold method. A node is a physical cover, its position that of the cover's star. Blocks share no cover.
/// @source docs/theory/kinematics-and-nmm.md, "Covers and elements"; [Qu2013] ch. 3, 4, 6
class NmmPool final : public Pool, public FieldCarrier {
 public:
  [[nodiscard]] std::string_view method() const override { return "nmm"; }
  void add(const Model& model, const BodyRecord& record) override { add_with(model, record, std::nullopt); }
  void add_again(const Model& model, const BodyRecord& record, const BodySet& earlier, int body) override;
  void finish() override;
  [[nodiscard]] int bodies() const override { return static_cast<int>(bodies_.size()); }
  [[nodiscard]] std::int32_t first_node(int body) const override { return first_[static_cast<std::size_t>(body)]; }
  [[nodiscard]] const Boundary& boundary(int body) const override { return of(body).mesh.boundary; }
  [[nodiscard]] std::span<const InterfaceConstraint> interface_constraints(int body) const override {
    return of(body).mesh.interface_constraints;
  }
  [[nodiscard]] std::span<const std::int32_t> undivided(int body) const override { return of(body).mesh.undivided; }
  void settle(int body, std::span<double> q, std::span<double> v) const override;
  [[nodiscard]] bool idle(std::int32_t node) const override { return idle_[static_cast<std::size_t>(node)] != 0; }
  [[nodiscard]] Row row_at(int body, const Vec2& X) const override;
  [[nodiscard]] std::span<const double> translation(int body) const override;

  void place(int body, const AffineMotion& motion, std::span<double> q, std::span<double> v) const override;
  [[nodiscard]] Release release(int body, std::span<const double> q, std::span<const double> v) const override;
  [[nodiscard]] BodyTotals totals(int body, std::span<const double> q, std::span<const double> v) const override;
  [[nodiscard]] bool holds_edges(int body) const override { return !of(body).onefold; }
  [[nodiscard]] Vec2 edge_reaction(int body, std::size_t support, double s, std::span<const double> q) const override;
  [[nodiscard]] double edge_energy(int body, std::span<const double> q) const override;
  void shift_edges(int body, std::span<const double> shift) override;
  [[nodiscard]] bool has_fields(int body) const override { return !of(body).onefold; }
  void project(int body, const FieldCarrier& from, int other, std::span<const double> q_from,
               std::span<const double> v_from, std::span<double> q, std::span<double> v) const override;

  double internal_force(std::span<const double> q, std::span<double> f) const override;
  [[nodiscard]] Fault find_fault(std::span<const double> q) const override;
  void fold_forces(std::span<double> f) const override { chart_.fold_forces(f); }
  void body_force(const Vec2& acceleration, std::span<double> f) const override;
  void mass_solve(std::span<const double> q, std::span<const double> f, std::span<double> a) const override;
  void mass_apply(int body, std::span<const double>, std::span<const double> v, std::span<double> p) const override {
    apply_mass(body, v, p);
  }
  [[nodiscard]] double kinetic_energy(std::span<const double> q, std::span<const double> v,
                                      std::span<const char> counted) const override;
  double damp(double factor, double rate, std::span<const double> along, std::span<double> v, std::span<double> f,
              std::span<double> a) const override;
  void stiffness_damping(std::span<const double> q, std::span<const double> v, double rate,
                         std::span<double> f) const override;
  [[nodiscard]] double frequency_bound(int body) const override { return of(body).frequency.lambda; }
  [[nodiscard]] double mass_ratio(int body) const override;
  [[nodiscard]] std::string binding(int body) const override;
  [[nodiscard]] double compliance(int body, const Row& row) const override;
  void bound_groups(int body, const Row& row, std::vector<std::int32_t>& groups) const override;

  [[nodiscard]] int dofs(int body) const override {
    return of(body).onefold ? AffineForm::kUnknowns : of(body).implicit.dofs();
  }
  [[nodiscard]] bool nonlinear(int body) const override { return of(body).form.kinematics == Kinematics::corotational; }
  [[nodiscard]] bool constant_chart(int) const override { return true; }
  [[nodiscard]] std::string implicit_obstacle(int body) const override;
  [[nodiscard]] ElementDofs element_dofs(int body) const override {
    return of(body).onefold ? AffineForm::element_dofs() : of(body).implicit.element_dofs();
  }
  [[nodiscard]] ChartRow chart_row(int body, const Row& row, std::span<const double> q) const override;
  void element_masses(int body, std::span<const double> q, std::span<double> mass) const override;
  void rates(int body, std::span<const double> q, std::span<const double> v, std::span<double> rate) const override;
  double linearise(int body, std::span<const double> q, Stiffness kind, std::span<double> stiffness,
                   std::span<double> force) const override;
  void retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
               std::span<double> v) const override;

  void topology(MeshPart& mesh) const override;
  void stress(std::span<const double> q, std::span<double> cells) const override;
  /// Least-squares planes through the stresses of each cover's elements, tied covers by their roots.
  /// @param nodes  xx, yy, xy per cover [Pa]
  /// @source [Zienkiewicz1992] (superconvergent patch recovery); deviation: areas as weights
  void recovered_stress(std::span<const double> q, std::span<const char> wanted,
                        std::span<double> nodes) const override;

  /// The mesh of a body, for tests and reports; covers and elements counted from the body's first.
  [[nodiscard]] const CoverMesh& mesh(int body) const { return of(body).mesh; }
  [[nodiscard]] const LumpedMass& mass() const { return mass_; }
  [[nodiscard]] const CoverChart& chart() const { return chart_; }
  [[nodiscard]] const ElementForces& elements() const { return elements_; }
  [[nodiscard]] const FrequencyBound& bound(int body) const { return of(body).frequency; }
  /// Null if the block has a mesh.
  [[nodiscard]] const OnefoldCover* onefold(int body) const { return of(body).onefold ? &*of(body).onefold : nullptr; }

 private:
  struct Body {
    CoverMesh mesh;  // elements that act; boundary rows and cells, and interface constraints, count within the pool
    // Of a divided block: the mesh of all elements, and the mesh whose mass is in mass_.
    std::unique_ptr<CoverMesh> whole, lumped;
    // Of a divided block: inverse masses of both halves, whichever is active: contacts on the other half are damped
    // by them too.
    CoverChart whole_chart;             // covers counted from the body's first
    std::vector<double> whole_inverse;  // row sums of the mass, inverted; 0 for tied covers [1/kg]
    ReferenceShape shape;
    Formulation form;
    ConsistentMass consistent;  // this and `implicit` are made if the form is not affine-exact
    ImplicitBody implicit;
    std::optional<OnefoldCover> onefold;  // with the block's exact mass for every form
    Elasticity law;
    double scale = 1.0;  // of the elements' areas
    std::vector<EdgeHold> holds;
    std::int32_t first_element = 0;
    FrequencyBound frequency;
    std::string name;
  };
  /// The triangle of onefold covers of the whole model, in the reference frame of a shape.
  [[nodiscard]] std::array<Vec2, 3> model_triangle(const Model& model, const AffineMotion& to_origin);
  /// True if mass_ carries some of the body, and if a consistent mass does.
  [[nodiscard]] static bool lumps(const Formulation& form);
  [[nodiscard]] static bool has_consistent(const Formulation& form);
  [[nodiscard]] static CoverMesh make_mesh(const Model& model, const BodyRecord& record, const AffineMotion& to_origin);
  /// The mesh of an earlier body, of both halves if it is divided, if make_mesh() would make the same for the record.
  [[nodiscard]] std::optional<CoverMesh> mesh_for(const BodyRecord& record, int body) const;
  /// @param made  what make_mesh() returns for the record, if that is known
  void add_with(const Model& model, const BodyRecord& record, std::optional<CoverMesh> made);
  /// Keeps only the elements of the active half.
  static void divide(Body& body);
  static void find_whole_inverse(Body& body);
  /// Applies the mass operator that the block's form requires.
  void apply_mass(int body, std::span<const double> v, std::span<double> p) const;
  void add_weight(int body, const Vec2& g, std::span<double> f) const;
  [[nodiscard]] double kinetic_of(int body, std::span<const double> v) const;
  [[nodiscard]] StiffElement element_of(const Body& body, std::size_t e) const;
  [[nodiscard]] std::array<Vec2, 3> covers_of(const Body& body, std::size_t e, std::span<const double> q) const;
  static void make_implicit(Body& body, std::int32_t first);
  /// Initial position of an element in the model, for messages.
  [[nodiscard]] std::string place_of(int body, std::size_t element) const;
  [[nodiscard]] const Body& of(int body) const { return *bodies_[static_cast<std::size_t>(body)]; }

  std::vector<std::unique_ptr<Body>> bodies_;
  std::vector<std::int32_t> first_{0};
  CoverChart chart_;
  LumpedMass mass_;
  ElementForces elements_;
  std::vector<double> ones_;
  std::vector<char> idle_;                             // per cover
  std::optional<std::array<Vec2, 3>> model_triangle_;  // at the model's initial position
  Vec2 model_origin_{0.0, 0.0};
};

}  // namespace scree::nmm
