// Forces on the bodies of an implicit step that depend on the path of these bodies during the step.
#pragma once

#include <array>
#include <span>

#include "coupling/bodies/setup.h"
#include "coupling/step_report.h"

namespace scree::coupling {

/// Force that the explicit side of a partitioned step exerts on the bodies of the implicit side: the mean of the
/// contact forces over the explicit substeps, as a function of where the implicit bodies end.
class InterfaceForce {
 public:
  InterfaceForce() = default;
  InterfaceForce(const InterfaceForce&) = delete;
  InterfaceForce& operator=(const InterfaceForce&) = delete;
  virtual ~InterfaceForce() = default;

  /// A spring of stiffness k along sum c_i.u_i of outline nodes.
  struct Spring {
    std::size_t count = 0;
    std::array<OutlineNode, 3> node{};
    std::array<Vec2, 3> direction{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
    double k = 0.0;  // [N/m]
    /// As State::visit().
    template <class Visitor>
    void visit(Visitor&& see) const {
      see("spring.count", count);
      for (const OutlineNode& n : node) see("spring.node", n.value);
      for (const Vec2& d : direction) see("spring.direction", d);
      see("spring.k", k);
    }
  };
  /// Approximate tangent of the mean force with respect to the end of the path, for Newton's method. Empty where the
  /// iteration converges without it.
  [[nodiscard]] virtual std::span<const Spring> springs() const = 0;
  /// Upper bound of that tangent [N/m].
  [[nodiscard]] virtual double stiffness() const = 0;
  /// The largest stiffness of a spring in it [N/m].
  [[nodiscard]] virtual double largest_stiffness() const = 0;
  /// Force on the nodes at the start of the step, x, y per node [N].
  [[nodiscard]] virtual std::span<const double> present() const = 0;
  /// Predicts mean() without repeating the explicit substeps.
  /// @param end    positions at the end of the step, x, y per node [m]
  /// @param force  x, y per node, zero at first [N]
  /// @return false: no prediction is available, as where interface constraints exist
  virtual bool foresee(std::span<const double> end, std::span<double> force) = 0;
  /// A node of the implicit side that coincides with a node of the explicit side of the same block. A force that is
  /// constant during the step makes both reach the same position.
  struct InterfaceConstraint {
    BodyIndex body;
    Row row;
  };
  [[nodiscard]] virtual std::span<const InterfaceConstraint> interface_constraints() const { return {}; }
  /// Cholesky factor C of the stiffness of the interface constraints: C C^T u is the approximate additional force that
  /// moves the constrained nodes of the explicit side by u. Lower triangular, column after column, the same for x and y
  /// [sqrt(N/m)].
  [[nodiscard]] virtual std::span<const double> constraint_factor() const { return {}; }
  /// Constraint forces of the preceding step, x, y per interface constraint [N].
  [[nodiscard]] virtual std::span<const double> held() const { return {}; }
  /// Mean force over the step while the nodes move along straight lines to `end`, each substep weighted by its time.
  /// @param held   constraint forces on the implicit side, x, y per interface constraint [N]; the explicit side
  /// receives
  ///               the opposite
  /// @param force  x, y per node, zero at first; without the constraint forces [N]
  /// @param apart  gap of each constraint at the end of the step, implicit node less explicit node, x, y per interface
  ///               constraint [m]
  /// @return a status other than ok where the explicit side cannot follow the path
  virtual StepReport mean(std::span<const double> end, std::span<const double> held, std::span<double> force,
                          std::span<double> apart) = 0;
};

}  // namespace scree::coupling
