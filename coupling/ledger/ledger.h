// The energy ledger: every joule has a column, computed by itself; what is left over must be zero.
//   closure = E - E_0 - W + D - R
// E what the system holds, W what was done on it, D what it dissipated, R what the schemes and changes of definition
// add of their own. No column is computed as a remainder of others.
// A closed ledger is necessary and not sufficient: a wrong force is booked as well as a right one, and a blow-up
// inflates the sum of increments that the closure is divided by. Therefore the ledger also reports the energy given to
// the system, and how much more than that it holds (gain()).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace scree::coupling {

enum class Column : int {
  // E: energy held
  kinetic,
  elastic,
  contact_springs,
  support_springs,
  bolts,
  reservoir,
  shadow,
  // W: work done on the system since the start
  gravity,
  loads,
  water,
  bolt_tension,
  support_release,
  prescribed_motion,
  // D: dissipated since the start
  friction,
  dilation,
  contact_damping,
  mass_damping,
  deformation_damping,
  stiffness_damping,
  local_damping,
  viscous_edges,
  rest_damping,
  falling_asleep,
  newmark_damping,
  contact_closing,
  springs_dropped,
  bonds_broken,
  bolt_yield,
  bolts_broken,
  excavated,
  // R: terms of the schemes themselves and of changes of definition since the start
  elastic_trapezoid,
  contact_transition,
  contact_geometry,
  contact_edges,
  contact_tributary,
  support_trapezoid,
  bolt_trapezoid,
  update_kinetic,
  update_elastic,
  update_contact,
  waveform,
  interface_constraints,
  step_change,
  transfer,
  count_
};
inline constexpr int kColumns = static_cast<int>(Column::count_);

enum class Side { energy, work, dissipated, scheme };

struct ColumnInfo {
  std::string_view name;
  Side side;
  std::string_view meaning;  // one line for tables and attributes
  // The column is an error or a regularisation of the scheme: a warning is due once it is above kSchemeShare of the
  // energy passed.
  bool watched = false;
};
[[nodiscard]] const ColumnInfo& info(Column column);

inline constexpr double kCloses = 1e-9;       // of the energy moved: largest closure of a closed ledger
inline constexpr double kSchemeShare = 0.01;  // of the energy passed: threshold of the warning about a watched column

/// Value type; part of the State.
class Ledger {
 public:
  /// Sets the energy columns of the starting state; the others begin at zero.
  void open(std::span<const double> energies);
  /// Replaces an energy column by its present value; its change counts as energy moved, except that of kinetic energy
  /// and shadow: explicit steps compute them for outputs, streams and monitors only, and their changes are those of
  /// other columns with the opposite sign.
  void set(Column energy, double value);
  /// Adds an increment to a work, dissipation or scheme column.
  void book(Column column, double increment) {
    value_[static_cast<std::size_t>(column)] += increment;
    moved_ += std::abs(increment);
  }
  /// Several increments, with the same bits as by book(); the sum of their amounts stays in a register.
  class Booking {
   public:
    explicit Booking(Ledger& ledger) : ledger_(&ledger), moved_(ledger.moved_) {}
    Booking(const Booking&) = delete;
    Booking& operator=(const Booking&) = delete;
    ~Booking() { ledger_->moved_ = moved_; }
    void book(Column column, double increment) {
      ledger_->value_[static_cast<std::size_t>(column)] += increment;
      moved_ += std::abs(increment);
    }

   private:
    Ledger* ledger_;
    double moved_;
  };
  /// The same ledger of more bodies (sign 1) or fewer (-1), which are at rest and whose energies are constant.
  /// @param held  their energies, in the order of the energy columns [J]
  [[nodiscard]] Ledger with_resting(std::span<const double> held, double sign) const;
  /// Adds the columns and the energy moved of another ledger, in which increments alone were booked.
  void add(const Ledger& booked);

  /// Ledger of a system in two parts: the energies are those of the parts (the reservoir is that of the base), and the
  /// increments since they were opened are added to those of the base.
  [[nodiscard]] static Ledger joined(const Ledger& base, const Ledger& a, const Ledger& b);

  [[nodiscard]] double operator[](Column column) const { return value_[static_cast<std::size_t>(column)]; }
  [[nodiscard]] double energy() const;                   // sum of the energy columns [J]
  [[nodiscard]] double closure() const;                  // E - E_0 - W + D - R [J]
  [[nodiscard]] double moved() const { return moved_; }  // running sum of |increments| [J]
  [[nodiscard]] double largest() const;                  // largest |column| [J]
  /// |closure| / moved, 0 where next_to_nothing(); not a number if one of them is none.
  [[nodiscard]] double relative_closure() const { return closure_of(moved_); }
  /// Energy in the last places of the run's numbers (round_off.h) [J].
  void set_last_places(double energy) { last_places_ = energy; }
  [[nodiscard]] double last_places() const { return last_places_; }
  /// True where an energy is so small that the closure is above kCloses of it, though not above the last places of the
  /// numbers: the relative closure has no meaning then.
  [[nodiscard]] bool next_to_nothing(double energy) const;
  /// The first number in the ledger that is not finite: a column, "moved" or "closure"; empty: all are.
  [[nodiscard]] std::string_view not_finite() const;

  /// Records the present instant in passed(). Called once per step, so that it is independent of outputs and monitors.
  void pass() { passed_ = std::max(passed_, passed_now()); }
  /// Takes over the record of another ledger of the same run.
  void pass(const Ledger& earlier) { passed_ = std::max(passed_, earlier.passed_); }
  /// Energy held: E without the shadow term, which belongs to the scheme [J].
  [[nodiscard]] double held() const;
  /// Energy given to the system: E_0 + W + the column `transfer` - the column `excavated`, each with its sign [J].
  [[nodiscard]] double given() const;
  /// Energy passed: the largest so far of E_0 + sum |W_c| + the energy that columns below zero (initial stress) have
  /// released, and of the energy held now [J].
  [[nodiscard]] double passed() const;
  /// The same without the energy held now: the energy that can have entered so far, independent of the scheme [J].
  [[nodiscard]] double passed_given() const { return std::max(passed_, passed_now()); }
  /// |closure| / passed, 0 where next_to_nothing().
  [[nodiscard]] double passed_closure() const { return closure_of(passed()); }
  /// Energy held beyond the energy given [J]. Only errors of the scheme make it positive, since dissipation removes
  /// energy. The shadow term counts up to the largest one of a stable step.   @pre the ledger is up to date
  ///   gain = held - min(-shadow, kMostShadow |held|) - given
  [[nodiscard]] double gain() const;
  /// A lower bound of gain() at any step, without the kinetic energy (which is computed only where required) [J].
  ///   (1 - kMostShadow) (held - kinetic) - given
  [[nodiscard]] double least_gain() const;

  template <class Visitor>
  void visit(Visitor&& see) const {
    see("ledger.value", value_);
    see("ledger.initial", initial_);
    see("ledger.moved", moved_);
    see("ledger.passed", passed_);
  }

 private:
  /// A step at 0.95 of its bound: a shadow of Omega^2/4 = 0.9 of the energy.
  static constexpr double kMostShadow = 0.9;

  [[nodiscard]] double passed_now() const;
  [[nodiscard]] double closure_of(double energy) const;

  std::array<double, kColumns> value_{};
  double initial_ = 0.0, moved_ = 0.0, passed_ = 0.0;
  double last_places_ = 0.0;  // of the model and the rest of the state: computed again where required
};

}  // namespace scree::coupling
