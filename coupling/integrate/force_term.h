// A force in explicit steps, with its place in the ledger. There is no other way to apply one.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coupling/integrate/point_springs.h"
#include "coupling/ledger/ledger.h"

namespace scree::coupling {

class ForceTerm {
 public:
  ForceTerm() = default;
  ForceTerm(const ForceTerm&) = delete;
  ForceTerm& operator=(const ForceTerm&) = delete;
  virtual ~ForceTerm() = default;
  /// f += force at the positions q and time t [s]; keeps the energy of the instant if it has one.
  virtual void add(std::span<const double> q, double t, std::span<double> f) = 0;
  /// Books a step: `free` and `driven` are the trapezoid works 1/2 u.(f_n + f_{n+1}) on free and on driven nodes [J].
  virtual void book(double free, double driven, Ledger& ledger) = 0;
  /// Writes the energy of the last add() where no step led to it.
  virtual void start(Ledger& ledger) { (void)ledger; }
};

/// Stress inside the bodies.
class InternalForce final : public ForceTerm {
 public:
  explicit InternalForce(const Setup& setup) : setup_(&setup) {}
  void add(std::span<const double> q, double t, std::span<double> f) override;
  void book(double free, double driven, Ledger& ledger) override;
  void start(Ledger& ledger) override { ledger.set(Column::elastic, energy_); }

 private:
  const Setup* setup_;
  double energy_ = 0.0;
};

class Gravity final : public ForceTerm {
 public:
  explicit Gravity(const Setup& setup);
  void add(std::span<const double> q, double t, std::span<double> f) override;
  void book(double free, double driven, Ledger& ledger) override;

 private:
  std::vector<double> weight_;
};

class PointSupports final : public ForceTerm {
 public:
  explicit PointSupports(std::vector<PointSpring> springs) : springs_(std::move(springs)) {}
  void add(std::span<const double> q, double t, std::span<double> f) override;
  void book(double free, double driven, Ledger& ledger) override;
  void start(Ledger& ledger) override { ledger.set(Column::support_springs, energy_); }
  [[nodiscard]] const std::vector<PointSpring>& springs() const { return springs_; }

 private:
  std::vector<PointSpring> springs_;
  double energy_ = 0.0;
};

}  // namespace scree::coupling
