// Steps of the bodies that are awake, while others are asleep.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "coupling/integrate/time_integrator.h"

namespace scree::coupling {

/// Moves the bodies of a state that are awake (SleepMemory) by an integrator of their own, in a setup in which the
/// others are at rest and have no contacts. Those keep their positions, stresses, contacts and bolts, with velocities
/// of zero; their energies stay in the ledger.   @pre no body that is awake is in contact with one that is asleep
/// @source docs/theory/time-integration.md, "Sleep"
class AwakeSide final : public TimeIntegrator {
 public:
  using Make = std::function<std::unique_ptr<TimeIntegrator>(const Setup&)>;
  /// @param whole  the setup whose states are moved   @param state  the one that enter() or resume() gets
  /// @param make   makes the integrator of the bodies that are awake
  AwakeSide(const Setup& whole, const Methods& methods, const State& state, const StrengthPlan& strength, double factor,
            const Make& make);

  double enter(State& state) override;
  void resume(State& state, const IntegratorMemory& memory) override;
  [[nodiscard]] IntegratorMemory lend() override;
  void take_back(IntegratorMemory& memory) override;
  StepReport step(State& state, Tick ticks_of_step) override;
  void leave(State& state) override;
  void update_ledger(State& state) override;
  double stable_step(const State&, std::string* binding) override { return integrator_->stable_step(side_, binding); }
  void contact_forces(const State& state, std::span<double> f) const override;
  void set_control(Control* control) override { integrator_->set_control(control); }
  [[nodiscard]] bool step_still_stable() const override { return integrator_->step_still_stable(); }

 private:
  /// Node values that are contiguous in both orders.
  struct Run {
    std::size_t whole, side, count;
  };
  void find_runs();
  /// Copies the state to the side, and finds the energies of what is asleep.
  void split(const State& state);
  /// Takes the ledger of the side from the state's until the first step, since callers of enter() book what it changed.
  void open(const State& state);
  /// Copies what steps change to the state.
  void join(State& state);
  void join_contacts(ContactList& contacts);
  void join_ledger(State& state);
  /// Energy of the bodies that are asleep, by column.
  [[nodiscard]] double& held(Column energy) { return held_[static_cast<std::size_t>(energy)]; }
  [[nodiscard]] bool is_awake(const ContactMemory& m) const;

  const Setup* whole_;
  std::vector<char> asleep_;  // per body
  Setup setup_;
  State side_;
  std::unique_ptr<TimeIntegrator> integrator_;
  std::vector<Run> all_, moving_;      // of all nodes, and of those that do not rest
  std::vector<ContactMemory> parked_;  // contacts of bodies that are asleep
  std::vector<std::size_t> place_;     // per contact of the side: its index in the state
  std::vector<std::size_t> bolts_;     // that act on bodies that are awake
  std::array<double, static_cast<std::size_t>(Column::bolts) + 1> held_{};  // [J]
  bool opened_ = false;
};

}  // namespace scree::coupling
