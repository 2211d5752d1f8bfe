// Rates and forces of a contact point along its rows.
#pragma once

#include <span>

#include "coupling/bodies/setup.h"
#include "coupling/contact_list.h"

namespace scree::coupling {

/// Decides by which of two edges that meet at a convex corner another corner inside the body leaves: true for the edge
/// in which it is `depth` deep, if that is the nearer one. Two tips that meet exactly have equal depths in both edges:
/// then each leaves by the edge that ends at the corner, which faces that of the other tip. Left to round-off, each tip
/// might choose the direction that the other one blocks.
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
