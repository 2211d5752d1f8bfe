// A time integration scheme.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "coupling/bodies/setup.h"
#include "coupling/contact/audit/audit.h"
#include "coupling/interface/interface_force.h"
#include "coupling/linear/fixed_point.h"
#include "coupling/plan.h"
#include "coupling/state.h"
#include "coupling/step_report.h"

namespace scree::coupling {

class Control;

/// Results of the last step that cannot be recomputed from the state to the last bit, since forces were summed and
/// contacts found before driven bodies were put exactly in place. A checkpoint holds them beside the state.
struct IntegratorMemory {
  /// Contact stiffness that a step bound allowed for.
  struct Bound {
    ContactKey key;
    double stiffness = 0.0;  // [N/m]
  };
  std::vector<ContactPoint> points;                     // partitioned: of a side, State::contacts has only memories
  std::vector<double> stress, total, stiffness, local;  // forces on the nodes, explicit: CentralDifference [N]
  std::vector<double> held;                             // explicit: held forces [N]
  std::vector<Bound> bound;                             // explicit: of the last stable_step()
  double slow_weight = 1.0, slow_energy = 0.0;          // explicit: weight of slow internal forces, energy [J]
  // Partitioned: of the explicit and the implicit side; their ledgers, and that of the run before the first step.
  std::vector<IntegratorMemory> sides;
  std::vector<Ledger> ledgers;
  double step_bound = 0.0;  // of the substeps [s]
  std::vector<double>
      apart;  // nodes of interface constraints at the start of the stage: implicit less explicit position [m]

  std::vector<InterfaceForce::Spring> springs;  // partitioned: of the tangent
  /// What the implicit side of partitioned steps keeps for the next one: Newmark.
  struct Tangent {
    Tick step = 0;                  // length of the steps that it is for; 0: there is none
    std::int32_t least = 0;         // fewest iterations of a step with it
    std::int32_t excess = 0;        // sum over its steps of the iterations beyond `least`
    std::vector<double> stiffness;  // of the bodies, on the pattern of the unknowns
  };
  Tangent tangent;
  /// First guess of the iteration of those steps: the differences between solution and uncorrected first guess in the
  /// last step and the one before, and the factors with which the next step adds them.
  struct Start {
    Tick step = 0;  // length of the last step; 0: there is none
    std::array<double, 2> part{};
    std::array<std::vector<double>, 2> lacked;  // per unknown; the last step first
  };
  Start start;
  FixedPoint::Kept iterates;  // of that iteration

  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const;
};

/// Advances a state by whole steps. On any status but ok the state is unchanged to the last bit.
class TimeIntegrator {
 public:
  TimeIntegrator() = default;
  TimeIntegrator(const TimeIntegrator&) = delete;
  TimeIntegrator& operator=(const TimeIntegrator&) = delete;
  virtual ~TimeIntegrator() = default;
  /// Takes over a state: fills what the scheme needs (contacts, accelerations).
  /// @return energy of the contact springs as found on the present outlines [J]
  virtual double enter(State& state) = 0;
  /// Continues a stage after the last step of another integrator of its kind. Called instead of enter().
  virtual void resume(State& state, const IntegratorMemory& memory) = 0;
  /// What resume() needs, lent rather than copied: it is as large as the model. No other member is called
  /// before take_back().
  [[nodiscard]] virtual IntegratorMemory lend() = 0;
  /// @param memory  as returned by lend(); empty afterwards
  virtual void take_back(IntegratorMemory& memory) = 0;
  virtual StepReport step(State& state, Tick ticks_of_step) = 0;
  /// Leaves a state synchronised: energies that only this scheme has are closed and booked.
  virtual void leave(State& state) = 0;
  /// Brings the ledger's energy columns up to date (some are costly, and needed only where the state is sampled).
  virtual void update_ledger(State& state) = 0;
  /// Largest stable step [s] and what binds it; infinite for implicit schemes.
  virtual double stable_step(const State& state, std::string* binding) = 0;
  /// f += forces of the contacts on the nodes at the present instant (for the balance of forces).
  virtual void contact_forces(const State& state, std::span<double> f) const = 0;
  /// From now on every accepted step is checked; null: no longer. The audit must outlive the steps.
  void watch(Audit* audit) { audit_ = audit; }
  /// Controller that long steps poll for a request to stop; null: none. It must outlive the steps.
  virtual void set_control(Control* control) { (void)control; }
  /// False once contacts have changed by more than the last stable_step() allowed for.
  [[nodiscard]] virtual bool step_still_stable() const { return true; }

 protected:
  Audit* audit_ = nullptr;
};

// ---------------------------------------------------------------------------------------------------------------

template <class Visitor>
void IntegratorMemory::visit(Visitor&& see) const {
  see.size("points", points);
  for (const ContactPoint& p : points) p.visit(see);
  see("stress", stress);
  see("total", total);
  see("stiffness", stiffness);
  see("local", local);
  see("held", held);
  see.size("bound", bound);
  for (const Bound& b : bound) {
    b.key.visit(see);
    see("bound.stiffness", b.stiffness);
  }
  see("slow_weight", slow_weight);
  see("slow_energy", slow_energy);
  see.size("sides", sides);
  for (const IntegratorMemory& side : sides) side.visit(see);
  see.size("ledgers", ledgers);
  for (const Ledger& ledger : ledgers) ledger.visit(see);
  see("step_bound", step_bound);
  see("apart", apart);
  see.size("springs", springs);
  for (const InterfaceForce::Spring& s : springs) s.visit(see);
  see("tangent.step", tangent.step);
  see("tangent.least", tangent.least);
  see("tangent.excess", tangent.excess);
  see("tangent.stiffness", tangent.stiffness);
  see("start.step", start.step);
  see("start.part", start.part);
  for (const std::vector<double>& lacked : start.lacked) see("start.lacked", lacked);
  iterates.visit(see);
}

}  // namespace scree::coupling
