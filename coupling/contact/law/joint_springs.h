// Stiffness of contact points from joint laws and the blocks on either side.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "coupling/bodies/setup.h"
#include "coupling/contact_list.h"
#include "model/touching.h"

namespace scree::coupling {

/// Contains the width of every edge's block normal to the edge. Constant during a stage.
class JointSprings {
 public:
  explicit JointSprings(const Setup& setup);

  /// Law between two edges: that of the edge that names one; if both do, the one with the smaller friction angle; if
  /// neither does, the default joint of the model.
  [[nodiscard]] JointId law_of(EdgeIndex edge_a, EdgeIndex edge_b) const {
    const JointId a = joint_[edge_a], b = joint_[edge_b];
    if (a == b) return a.valid() ? a : setup_->model().default_joint;
    return law_between(setup_->model(), a, b);
  }
  /// True if the stiffness of a point is its tributary length times a stiffness per area; false if it is given per
  /// point.
  [[nodiscard]] bool per_area(JointId id) const { return !law(id).penalty; }
  /// Normal stiffness per area [Pa/m]; auto: (K + 4G/3)/d, the larger of both sides, d the width normal to the edge.
  /// @source [Qu2013] eq. 7.56 (there as an upper bound, ten times as stiff)
  [[nodiscard]] double normal_stiffness(JointId id, EdgeIndex edge_a, EdgeIndex edge_b) const {
    if (law(id).normal_stiffness) return *law(id).normal_stiffness;
    return std::max(modulus_over_width_[edge_a], modulus_over_width_[edge_b]);
  }
  /// Length of joint that a corner against an edge stands for, in stiffness and strength: `contact_length` of the
  /// joint, else a tenth of the square root of the smaller block's area [m].
  [[nodiscard]] double corner_length(JointId id, EdgeIndex edge_a, EdgeIndex edge_b) const;
  /// Extent of the edge's block in the model, normal to the edge [m].
  [[nodiscard]] double width(EdgeIndex edge) const { return width_[edge]; }
  /// Springs of a point with a length of overlap [m].
  [[nodiscard]] Springs springs(JointId id, EdgeIndex edge_a, EdgeIndex edge_b, double tributary) const {
    const JointLaw& j = law(id);
    if (j.penalty)
      return {j.contact_length > 0.0 ? j.contact_length : tributary, *j.penalty, j.shear_penalty.value_or(*j.penalty)};
    const double normal = normal_stiffness(id, edge_a, edge_b);
    return {tributary, tributary * normal, tributary * j.shear_stiffness.value_or(normal)};
  }

 private:
  [[nodiscard]] const JointLaw& law(JointId id) const { return setup_->model().joints[id.index()]; }

  const Setup* setup_;
  IndexedVector<EdgeIndex, JointId> joint_;              // that it names
  IndexedVector<EdgeIndex, double> width_;               // [m]
  IndexedVector<EdgeIndex, double> modulus_over_width_;  // [Pa/m]
  IndexedVector<EdgeIndex, double> root_area_;           // of its block [m]
};

}  // namespace scree::coupling
