#include "model/pool.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "model/parallel.h"

namespace scree {

AffineMotion affine_fit(const Polygon& from, const Polygon& to) {
  Vec2 mean_from = Vec2::Zero(), mean_to = Vec2::Zero();
  double count = 0.0;
  for (std::size_t r = 0; r < from.rings(); ++r)
    for (std::size_t i = 0; i < from.ring(r).size(); ++i, count += 1.0) {
      mean_from += from.ring(r)[i];
      mean_to += to.ring(r)[i];
    }
  mean_from /= count;
  mean_to /= count;
  Mat2 square = Mat2::Zero(), mixed = Mat2::Zero();
  for (std::size_t r = 0; r < from.rings(); ++r)
    for (std::size_t i = 0; i < from.ring(r).size(); ++i) {
      const Vec2 X = from.ring(r)[i] - mean_from;
      square += X * X.transpose();
      mixed += (to.ring(r)[i] - mean_to) * X.transpose();
    }
  AffineMotion map;
  map.F = mixed * square.inverse();
  map.c = mean_to - map.F * mean_from;
  return map;
}

InSituStress::InSituStress(const Model& model, const BodyRecord& record) {
  const auto& stress = model.material_of(record.block).initial_stress;
  if (!stress) return;
  stress_ = &*stress;
  centroid_ = moments(record.shape.outline).centroid;
  origin_ = affine_fit(record.shape.outline, record.shape.origin);
  turn_ = polar_rotation(origin_.F);
}

Mat2 InSituStress::at(const Vec2& X) const {
  if (none()) return Mat2::Zero();
  return turn_.transpose() * stress_->at(origin_.c + origin_.F * X) * turn_;
}

void Pool::turn(double, std::span<const double>, std::span<double>, std::span<double>) const {}

double Pool::damp(double, double, std::span<const double>, std::span<double>, std::span<double> f,
                  std::span<double>) const {
  std::fill(f.begin(), f.end(), 0.0);
  return 0.0;
}
std::string Pool::binding(int) const { return {}; }
std::span<const Pool::Seam> Pool::seams(int) const { return {}; }

std::span<const std::int32_t> Pool::undivided(int) const { return {}; }

void Pool::settle(int, std::span<double>, std::span<double>) const {}

bool Pool::idle(std::int32_t) const { return false; }

Fault Pool::find_fault(std::span<const double> q) const {
  for (int b = 0; b < bodies(); ++b)
    for (std::int32_t k = first_node(b); k < first_node(b + 1); ++k) {
      const auto i = 2 * static_cast<std::size_t>(k);
      if (!std::isfinite(q[i]) || !std::isfinite(q[i + 1])) return {b, "a position is not finite"};
    }
  return {};
}
void Pool::stiffness_damping(std::span<const double>, std::span<const double>, double, std::span<double>) const {}
void Pool::recovered_stress(std::span<const double>, std::span<double> nodes) const {
  std::fill(nodes.begin(), nodes.end(), 0.0);
}
int Pool::dofs(int) const { return 0; }
bool Pool::nonlinear(int) const { return false; }
bool Pool::constant_chart(int) const { return false; }
std::string Pool::implicit_obstacle(int) const { return {}; }
ElementDofs Pool::element_dofs(int) const { return {}; }
ChartRow Pool::chart_row(int, const Row&, std::span<const double>) const { return {}; }
void Pool::element_masses(int, std::span<const double>, std::span<double>) const {}
void Pool::rates(int, std::span<const double>, std::span<const double>, std::span<double>) const {}
double Pool::linearise(int, std::span<const double>, Stiffness, std::span<double>, std::span<double>) const {
  return 0.0;
}
void Pool::retract(int, std::span<const double>, std::span<const double>, std::span<double>, std::span<double>) const {}

}  // namespace scree
