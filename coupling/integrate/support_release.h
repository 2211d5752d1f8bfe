// Forces that replace removed rock or supports, on the bodies of a stage.
#pragma once

#include <span>
#include <vector>

#include "coupling/integrate/force_term.h"

namespace scree::coupling {

/// The forces of State::support as nodal vectors. Their work is the column `support_release`.
class SupportRelease {
 public:
  SupportRelease() = default;
  /// From the forces that this setup applies.
  SupportRelease(const Setup& setup, const State& state);
  /// False if there are none.
  [[nodiscard]] bool acts() const { return !last_.empty(); }
  /// f += the forces at a time [s].
  void add(double time, std::span<double> f) const;

 private:
  double begin_ = 0.0, end_ = 0.0;      // of the release [s]
  std::vector<double> falling_, last_;  // x, y per node: part that falls to zero, and part that remains [N]
};

/// The release in explicit steps.
class SupportReleaseTerm final : public ForceTerm {
 public:
  explicit SupportReleaseTerm(SupportRelease release) : release_(std::move(release)) {}
  void add(const Instant& at, std::span<double> f) override;
  void leave(double h, std::span<const double> v) override { work_ = half_work(h, v); }
  void arrive(double h, std::span<const double> v, Ledger& ledger) override {
    ledger.book(Column::support_release, work_ + half_work(h, v));
  }

 private:
  [[nodiscard]] double half_work(double h, std::span<const double> v) const;

  SupportRelease release_;
  std::vector<double> force_;
  double work_ = 0.0;
};

}  // namespace scree::coupling
