// Dead loads of a stage: forces whose direction and size do not depend on the motion.
#pragma once

#include <vector>

#include "coupling/integrate/force_term.h"

namespace scree::coupling {

/// A load that acts on all of some bodies: nodal forces times a factor of time.
struct BodyLoad {
  std::vector<double> force;  // x, y per node of the state; 0 on driven bodies [N]
  FunctionId function;        // invalid: constant
  Column column;              // where its work is booked
};
/// Gravity, then the model's body accelerations; those with the same time function are one load. Zero ones are left
/// out.
[[nodiscard]] std::vector<BodyLoad> body_loads(const Setup& setup);

/// A force on a point.
struct PointForce {
  static constexpr std::int32_t kWater = -1;
  Row row;                     // in the state's nodes
  Vec2 force{0.0, 0.0};        // at a factor of 1 [N]
  std::int32_t load = kWater;  // into the model's loads: point loads, then tractions; or the water in front of a slope
};
/// Point loads, and tractions as the consistent forces of their stretches: on straight segments, along which the
/// weights of a row are linear, the resultant at the middle of the stretch. None on driven bodies.
[[nodiscard]] std::vector<PointForce> point_forces(const Setup& setup, const State& state);
/// Time function of a load.   @param load  as in PointForce
[[nodiscard]] FunctionId load_function(const Model& model, std::int32_t load);

/// Point loads and tractions in explicit steps.
class PointLoads final : public ForceTerm {
 public:
  PointLoads(const Setup& setup, std::vector<PointForce> forces);
  void add(const Instant& at, std::span<double> f) override;
  void leave(double h, std::span<const double> v) override { work_ = half_work(h, v); }
  void arrive(double h, std::span<const double> v, Ledger& ledger) override {
    ledger.book(Column::loads, work_ + half_work(h, v));
  }

 private:
  [[nodiscard]] double half_work(double h, std::span<const double> v) const;
  [[nodiscard]] double factor_of(const PointForce& p) const {
    return p.load == PointForce::kWater ? 1.0 : factor_[static_cast<std::size_t>(p.load)];
  }

  const Setup* setup_;
  std::vector<PointForce> forces_;
  std::vector<double> factor_;  // per load
  double work_ = 0.0;
};

}  // namespace scree::coupling
