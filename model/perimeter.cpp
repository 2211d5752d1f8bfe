#include "model/perimeter.h"

namespace scree {

double perimeter(const Polygon& p) {
  double sum = 0.0;
  for (std::size_t r = 0; r < p.rings(); ++r)
    for (std::size_t i = 0; i < p.ring(r).size(); ++i)
      sum += (p.ring(r)[(i + 1) % p.ring(r).size()] - p.ring(r)[i]).norm();
  return sum;
}

}  // namespace scree
