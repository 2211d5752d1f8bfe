// Forces on the bodies of an implicit step that depend on the way they take.
#pragma once

#include <array>
#include <span>

#include "coupling/integrate/mover.h"

namespace scree::coupling {

/// What bodies that are moved by somebody else, in steps of their own, do to those of an implicit step meanwhile.
class PathForce {
 public:
  PathForce() = default;
  PathForce(const PathForce&) = delete;
  PathForce& operator=(const PathForce&) = delete;
  virtual ~PathForce() = default;

  /// A spring k along sum c_i.u_i of outline nodes.
  struct Spring {
    std::size_t count = 0;
    std::array<std::int32_t, 3> node{};  // into Outlines::nodes
    std::array<Vec2, 3> direction;
    double k = 0.0;  // [N/m]
  };
  /// About how the mean force follows the end of the way, for Newton's method; none where it does not need it.
  [[nodiscard]] virtual std::span<const Spring> springs() const = 0;
  /// The mean force follows the end of the way by no more than this [N/m].
  [[nodiscard]] virtual double stiffness() const = 0;
  /// Force on the nodes where the step begins [N].
  [[nodiscard]] virtual std::span<const double> present() const = 0;
  /// What mean() would say, as far as that is known for little work, and without going along.
  /// @return false: it is not known, as where there are seams
  virtual bool foresee(std::span<const double> end, std::span<double> force) = 0;
  /// A node that a constant force through the step holds to a place of those who pull.
  struct Seam {
    std::int32_t body = -1;
    Row row;
  };
  [[nodiscard]] virtual std::span<const Seam> seams() const { return {}; }
  /// About how much more force it takes to keep nodes of seams further on by u: C C^T u, C lower triangular, column
  /// after column, in x and in y alike [N/m].
  [[nodiscard]] virtual std::span<const double> seam_factor() const { return {}; }
  /// Forces of the step before on the nodes of the seams, x, y a seam [N].
  [[nodiscard]] virtual std::span<const double> held() const { return {}; }
  /// Mean force over the step while nodes go to `end` along straight lines, each part weighted by its time.
  /// @param held   forces of the seams on their nodes, which those who pull feel reversed, x, y a seam [N]
  /// @param force  x, y a node, zero at first; without those of the seams
  /// @param apart  how much further nodes of seams are in the end than what they belong to, x, y a seam [m]
  /// @return not ok: the bodies that pull cannot go along
  virtual StepReport mean(std::span<const double> end, std::span<const double> held, std::span<double> force,
                          std::span<double> apart) = 0;
};

}  // namespace scree::coupling
