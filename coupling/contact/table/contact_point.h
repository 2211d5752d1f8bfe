// What a contact point does to the outlines it lies on: rates and forces along its rows.
#pragma once

#include <span>

#include "coupling/bodies/setup.h"
#include "coupling/contact_list.h"

namespace scree::coupling {

/// Which of two edges that meet at a convex corner another corner inside leaves by: true for the edge that it is
/// `depth` deep in, the nearer one. Two tips that meet exactly are as deep in both: then the edge that ends at the
/// corner, for both tips, which faces the other's. Left to round-off, each might choose the way that the other stands
/// in.
/// @param depth,other  [m], > 0    @param ends  the edge of `depth` is the one that ends at the corner
/// @source [Qu2013] 2.4.3 (shortest path); the rule for equal depths is not from there
[[nodiscard]] bool leaves_by(double depth, double other, bool ends);

/// Rate of a contact scalar at outline node velocities taken from v.
[[nodiscard]] double row_rate(const Outlines& o, const ContactPoint& p, const ContactRow& row,
                              std::span<const double> v);
/// The same at velocities of the outline nodes.
[[nodiscard]] inline double row_rate(const ContactPoint& p, const ContactRow& row, OutlineVelocities v) {
  double rate = 0.0;
  for (std::size_t i = 0; i < 3; ++i) rate += row[i].dot(v[p.node[i]]);
  return rate;
}
/// f += force times the row.
void add_row_force(const Outlines& o, const ContactPoint& p, const ContactRow& row, double force, std::span<double> f);

}  // namespace scree::coupling
