#include "coupling/contact/table/contact_point.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {

bool leaves_by(double depth, double other, bool ends) {
  constexpr double kAsDeep = 1e-6;
  return std::abs(depth - other) <= kAsDeep * std::max(depth, other) ? ends : depth < other;
}

double row_rate(const Outlines& o, const ContactPoint& p, const ContactRow& row, std::span<const double> v) {
  double rate = 0.0;
  for (std::size_t i = 0; i < 3; ++i) rate += row[i].dot(position(o.nodes[p.node[i]], v));
  return rate;
}

void add_row_force(const Outlines& o, const ContactPoint& p, const ContactRow& row, double force, std::span<double> f) {
  for (std::size_t i = 0; i < 3; ++i) add_force(o.nodes[p.node[i]], force * row[i], f);
}

}  // namespace scree::coupling
