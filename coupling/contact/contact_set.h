// All contact points of an instant: found, matched with what they remember, ready for a law.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coupling/contact/contact_point.h"
#include "coupling/contact/search.h"

namespace scree::coupling {

/// Penalty stiffness of a contact between two blocks under a law [N/m]; auto: K + 4G/3 of the softer block.
[[nodiscard]] double normal_stiffness(const Model& model, const JointLaw& law, BlockId a, BlockId b);
[[nodiscard]] double tangential_stiffness(const Model& model, const JointLaw& law, BlockId a, BlockId b);

/// Coulomb's limit of the tangential force [N]: c * contact length (until the first failure) + f_n tan phi.
[[nodiscard]] double friction_limit(const JointLaw& law, const ContactMemory& memory, double fn);

/// Points and memories in the order of their keys, one memory a point.
struct ContactList {
  std::vector<ContactPoint> points;
  std::vector<ContactMemory> memory;
};

/// Finds contact points. Every corner with an interior angle below pi is tried against every edge of other bodies;
/// the nearest segment of an edge carries the point. Decisions rest on exact geometry and on the memory alone.
class ContactFinder {
 public:
  /// @param detection  pairs nearer than this are listed, open or closed [m]
  ContactFinder(const Setup& setup, double detection);

  [[nodiscard]] double detection() const { return detection_; }
  /// Lists the points at q. Memory of known pairs is taken over (with the anchor carried to a new segment so that the
  /// stretch does not jump); new pairs start open. Gaps and stretches of the present geometry are written to the
  /// memory.
  /// @param at_start  t = 0: touching pairs are closed without stress, their gap becomes gap0
  void find(std::span<const double> q, std::span<const ContactMemory> known, bool at_start, ContactList& out);

 private:
  void set_range(ContactPoint& p, bool closed) const;
  [[nodiscard]] bool admissible(const ContactPoint& p) const;
  [[nodiscard]] std::int32_t law_of(const ContactPoint& p) const;
  void set_damping(const ContactPoint& p, ContactMemory& m) const;
  void pair_edges(ContactList& list) const;
  void suppress_second_edges(ContactList& list) const;

  const Setup* setup_;
  double detection_, touching_;
  Search search_;
  std::vector<Vec2> x_;  // outline nodes
};

}  // namespace scree::coupling
