// Role of a method: unknowns, element matrices and the update of implicit steps.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "model/body.h"

namespace scree {

/// A row expressed in the unknowns d of an implicit step, counted from the body's first: dx = T d. At most three nodes,
/// each following three others that have two unknowns each.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): what is beyond n has no meaning, and takes long to set
struct ChartRow {
  static constexpr int kMax = 18;
  int n = 0;                           // unknowns
  std::array<std::int32_t, kMax> dof;  // each once
  std::array<double, kMax> tx, ty;
};

/// Unknowns of the element matrices whose sum is the body's system, counted from the body's first. Values are stored as
/// lower triangles, element after element, each column after column: n (n + 1)/2 numbers for n unknowns.
struct ElementDofs {
  std::vector<std::int32_t> start{0};  // into dof; elements + 1
  std::vector<std::int32_t> dof;
  [[nodiscard]] std::size_t size() const { return start.size() - 1; }
  /// Total count of values in all lower triangles.
  [[nodiscard]] std::size_t values() const {
    std::size_t sum = 0;
    for (std::size_t e = 0; e + 1 < start.size(); ++e) {
      const auto n = static_cast<std::size_t>(start[e + 1] - start[e]);
      sum += n * (n + 1) / 2;
    }
    return sum;
  }
};

/// Kind of stiffness that an implicit step requires.
enum class Stiffness {
  exact,     // second derivative of the elastic energy: Newton's method converges quadratically
  definite,  // its nearest positive semi-definite neighbour, element by element
  material   // without the part of the stress that turns with the rock: rigid motion has no force, always definite
};

/// What an implicit step needs; a method without implicit steps has no dofs and overrides nothing.
/// Spans of dofs count from the body's first.
class ImplicitOperator {
 public:
  ImplicitOperator() = default;
  ImplicitOperator(const ImplicitOperator&) = delete;
  ImplicitOperator& operator=(const ImplicitOperator&) = delete;
  virtual ~ImplicitOperator() = default;

  /// Number of unknowns of a body; 0: explicit only.
  [[nodiscard]] virtual int dofs(int body) const;
  /// True where the internal force is not linear in the unknowns of a step: Newton's method continues at new iterates.
  [[nodiscard]] virtual bool nonlinear(int body) const;
  /// True where the chart is a constant matrix, so that accelerations are those of the nodes.
  [[nodiscard]] virtual bool constant_chart(int body) const;
  /// Why the body cannot take implicit steps although its method can; empty: it can.
  [[nodiscard]] virtual std::string implicit_obstacle(int body) const;
  /// Unknowns of the body's elements; the same during a stage.
  [[nodiscard]] virtual ElementDofs element_dofs(int body) const;
  [[nodiscard]] virtual ChartRow chart_row(int body, const Row& row, std::span<const double> q) const;
  /// Mass of the elements at q, lower triangles in the order of element_dofs().
  virtual void element_masses(int body, std::span<const double> q, std::span<double> mass) const;
  /// Velocity in the unknowns.
  virtual void rates(int body, std::span<const double> q, std::span<const double> v, std::span<double> rate) const;
  /// Tangent stiffness of the elements at q and internal force -dU/dd of the body.
  /// @param stiffness  lower triangles; empty: only the force is computed
  /// @return elastic energy [J]
  virtual double linearise(int body, std::span<const double> q, Stiffness kind, std::span<double> stiffness,
                           std::span<double> force) const;
  /// q, v of a body from the step's unknowns d and the new rates.
  virtual void retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
                       std::span<double> v) const;
};

}  // namespace scree
