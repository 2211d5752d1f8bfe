// Certified bound of the explicit step with contacts, supports and damping.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "coupling/contact/table/contact_finder.h"
#include "coupling/integrate/bolt_forces.h"
#include "coupling/integrate/point_springs.h"
#include "coupling/integrate/viscous_edges.h"
#include "model/parallel.h"

namespace scree::coupling {

/// Damping of explicit steps.
struct ExplicitDamping {
  double mass = 0.0;       // proportional to mass [1/s]
  bool rigid = false;      // mass damping acts on the whole velocity, not only on its non-affine part
  double stiffness = 0.0;  // Rayleigh damping proportional to stiffness [s]
  double local = 0.0;      // fraction of the unbalanced force, 0 <= alpha < 1
  double sliding = 0.0;    // of the deformation of sliding blocks, a fraction of critical
};

/// What an explicit step has to resolve, beside the bodies themselves.
struct StepParts {
  const ContactList& contacts;  // every point in the list counts as closed
  std::vector<PointSpring> springs;
  std::vector<Dashpot> dashpots;
  ExplicitDamping damping;
  std::vector<BoltSpring> bolts{};
};

/// h^2 lambda + 2 h gamma <= 4, which is 4 M - 2 h C - h^2 K >= 0 for damping that lags half a step:
///   h = (sqrt(gamma^2 + 4 lambda) - gamma)/lambda
///   lambda <= theta [lambda_body + max over groups of sum_{c touching it} k_c (mu_c + mu_c')]
///   gamma  <= theta [max over groups of sum_{d touching it} c_d mu_d + rate lambda_body]
/// with the groups of the method (covers, whole bodies), mu the compliance of a row in the method's diagonal mass (none
/// for driven bodies), k_c the larger of the two stiffnesses of a point, c_d the larger coefficient of a dashpot.
/// Mass-proportional damping is taken at the new velocity and leaves the bound as it is. Local damping makes a force up
/// to 1 + alpha times as large: lambda (1 + alpha), an estimate, since it is not linear.
/// @source docs/theory/time-integration.md, "Certified step bound"; [Qu2013] 5.3.2
class StepBound {
 public:
  /// @param setup  must outlive it
  explicit StepBound(const Setup& setup);

  /// @param binding  receives the block that binds the step and the shares of the causes, if given
  /// @return the bound [s]; infinite if nothing is stiff
  [[nodiscard]] double certified_step(const StepParts& parts, std::string* binding);

 private:
  enum class Kind { contact, support, bolt, viscous };
  struct Part {  // one spring or dashpot of a body
    Kind kind = Kind::contact;
    BodyIndex other;                     // the body on the other side of a contact
    double size = 0.0;                   // k mu [1/s2], c mu of a dashpot [1/s]
    std::int32_t first = 0, groups = 0;  // in groups_
  };

  struct Size {  // of a contact point
    double size = 0.0;
    OutlineNode corner;
    SegmentIndex foot;
  };
  struct Least {  // bound of some bodies
    double h = std::numeric_limits<double>::infinity();
    const Body* body = nullptr;
  };

  [[nodiscard]] double compliance(BodyIndex body, const Row& row) const;
  /// Lists of groups, one per index, each in order.
  template <class Index>
  struct GroupLists {
    IndexedVector<Index, std::int32_t> first;  // its first one in `groups`, and the end
    std::vector<std::int32_t> groups;

    [[nodiscard]] std::span<const std::int32_t> operator[](Index i) const {
      return {groups.data() + first[i], groups.data() + first[i + 1]};
    }
    void push_back(std::span<const std::int32_t> list) {
      if (first.values().empty()) first.push_back(0);
      groups.insert(groups.end(), list.begin(), list.end());
      first.push_back(static_cast<std::int32_t>(groups.size()));
    }
  };
  /// Appends the groups of any row to touched_.
  void touch_row(BodyIndex body, const Row& row);
  /// Adds a spring or dashpot to the sums of groups; no group is given twice.
  void add(Kind kind, BodyIndex other, double size, std::span<const std::int32_t> groups);
  /// add() for the groups in touched_, which is emptied.
  void add_touched(Kind kind, double size);
  void collect(const StepParts& in);
  void collect_contacts(const StepParts& in);
  void find_sizes(const ContactList& list);
  [[nodiscard]] double of_body(const Body& b, const ExplicitDamping& damping) const;
  [[nodiscard]] std::int32_t worst(const Body& b, bool viscous) const;
  [[nodiscard]] double sum(std::int32_t group, bool viscous) const;
  [[nodiscard]] std::string shares(const Body& b, const ExplicitDamping& damping, double h) const;

  const Setup* setup_;
  std::vector<double> shortens_;  // per joint law: square of the factor by which damping shortens h
  IndexedVector<OutlineNode, double> node_compliance_;  // [1/kg]
  GroupLists<OutlineNode> of_node_;                     // groups, by the first node of each
  GroupLists<SegmentIndex> of_segment_;                 // of either end
  std::vector<double> stiff_, viscous_;                 // sums, by the first node of a group
  std::vector<Size> sizes_;                             // of the contact points
  std::vector<Reach> reach_;                            // of every chunk of them, on groups
  std::vector<Least> least_;                            // of every chunk of bodies
  std::vector<std::int32_t> touched_;
  bool listed_ = false;  // each part is recorded, for the message about what binds the step
  std::vector<Part> list_;
  std::vector<std::int32_t> groups_;  // of the parts
  std::vector<std::int32_t> found_;   // scratch of touch_row()
};

/// Longest step between two evaluations of slow internal forces, w = sqrt(theta lambda_body) of the stiffest slow body:
///   H w <= 1/2
/// An estimate: faster motion of the same bodies can be in resonance with the kicks at H, more weakly for smaller H w.
/// @param binding  receives the block and its element, if given   @return [s]; infinite if no slow body is free
/// @source docs/theory/explicit-implicit-coupling.md, "Explicit steps of two sizes"
[[nodiscard]] double slow_step(const Setup& setup, std::string* binding);

}  // namespace scree::coupling
