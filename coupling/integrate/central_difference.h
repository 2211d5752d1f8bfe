// Explicit central difference for every method at once: kick, drift, kick.
#pragma once

#include <memory>

#include "coupling/contact/explicit_contact.h"
#include "coupling/integrate/force_term.h"
#include "coupling/integrate/mover.h"

namespace scree::coupling {

///   v_{n+1/2} = v_n + h/2 M^-1 F(x_n),  x_{n+1} = x_n + h v_{n+1/2},  v_{n+1} = v_{n+1/2} + h/2 M^-1 F(x_{n+1})
/// The stored velocity is the synchronised one, so the step may change; the ledger books (h'^2 - h^2)/8 a.M.a.
/// Every force comes through a ForceTerm or the contacts, and each books its own work.
/// Mass-proportional damping at the rate a acts on w = v minus its affine part: w_n = w*/(1 + a h/2), force -a M w_n,
/// which is the thesis's [(1 - a h/2) w_{n-1/2} + h M^-1 F]/(1 + a h/2) (eq. in 4.3.3) on synchronised velocities.
/// @source thesis 4.3, 6.5; nmm.md "Time integration"
class CentralDifference final : public Mover {
 public:
  /// @param damping  a [1/s]
  /// @param rest     kinetic damping: all velocities are dropped when the kinetic energy has passed a peak
  CentralDifference(const Setup& setup, const StepControl& control, double detection, double damping,
                    bool rest = false);

  double enter(State& state) override;
  StepReport step(State& state, Tick ticks_of_step) override;
  void leave(State& state) override;
  void update_ledger(State& state) override;
  double stable_step(const State& state, std::string* binding) override;
  [[nodiscard]] bool step_still_stable() const override;

  /// Adds a force beside the standard ones (internal, gravity, point supports).
  void add_term(std::unique_ptr<ForceTerm> term);

 private:
  void evaluate(const State& state, std::vector<std::vector<double>>& forces, std::vector<double>& total);
  [[nodiscard]] double work(std::span<const double> v, std::span<const double> f, bool free) const;
  static void kick(State& state, double h);
  void accelerate(State& state) const;
  void damp(State& state, double factor);
  [[nodiscard]] double acceleration_energy(const State& state) const;  // a.M.a of the free bodies
  [[nodiscard]] double kinetic_energy(const State& state) const;
  void relax(State& state) const;
  void change_step(State& state, double h);  // books (h^2 - h_last^2)/8 a.M.a

  const Setup* setup_;
  StepControl control_;
  double damping_;
  bool rest_;
  ExplicitContact contact_;
  std::vector<std::unique_ptr<ForceTerm>> terms_;
  std::vector<std::vector<double>> force_;  // a term: its forces at the present instant
  std::vector<double> contact_force_, damping_force_, total_, v_before_;
  std::vector<std::size_t> farthest_;
  std::vector<double> half_free_, half_driven_;  // a term: half works of the step so far
  mutable std::vector<double> partial_;
  struct Bound {
    ContactKey key;
    double stiffness = 0.0;  // [N/m]
  };
  std::vector<Bound> bound_;  // contacts as stable_step() saw them, with the margin it took
};

}  // namespace scree::coupling
