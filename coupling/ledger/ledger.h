// The energy ledger: every joule has a column, computed by itself; what is left over must be zero.
//   closure = E - E_0 - W + D - R
// E what the system holds, W what was done on it, D what it dissipated, R what the schemes and changes of definition
// add of their own. No column is computed as a remainder of others.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace scree::coupling {

enum class Column : int {
  // E: energy held
  kinetic,
  elastic,
  contact_springs,
  support_springs,
  reservoir,
  shadow,
  // W: work done on the system since the start
  gravity,
  loads,
  water,
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
  newmark_damping,
  contact_closing,
  springs_dropped,
  bonds_broken,
  // R: terms of the schemes themselves and of changes of definition since the start
  elastic_trapezoid,
  contact_transition,
  contact_geometry,
  contact_edges,
  contact_share,
  support_trapezoid,
  update_kinetic,
  update_elastic,
  update_contact,
  waveform,
  seams,
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
};
[[nodiscard]] const ColumnInfo& info(Column column);

/// Value type; part of the State.
class Ledger {
 public:
  /// Sets the energy columns of the starting state; the others begin at zero.
  void open(std::span<const double> energies);
  /// Replaces an energy column by its value now; its change counts as energy moved.
  void set(Column energy, double value);
  /// Adds an increment to a work, dissipation or scheme column.
  void book(Column column, double increment);

  /// Of a system in two parts: the energies are those of the parts (the reservoir's is the base's), what was done to
  /// them since they were opened comes on top of the base.
  [[nodiscard]] static Ledger joined(const Ledger& base, const Ledger& a, const Ledger& b);

  [[nodiscard]] double operator[](Column column) const { return value_[static_cast<std::size_t>(column)]; }
  [[nodiscard]] double energy() const;                   // sum of the energy columns [J]
  [[nodiscard]] double closure() const;                  // E - E_0 - W + D - R [J]
  [[nodiscard]] double moved() const { return moved_; }  // running sum of |increments| [J]
  [[nodiscard]] double largest() const;                  // |column|, of all [J]
  /// |closure| / moved, 0 while nothing has moved.
  [[nodiscard]] double relative_closure() const;

  template <class Visitor>
  void visit(Visitor&& see) {
    see("ledger.value", value_);
    see("ledger.initial", initial_);
    see("ledger.moved", moved_);
  }

 private:
  std::array<double, kColumns> value_{};
  double initial_ = 0.0, moved_ = 0.0;
};

}  // namespace scree::coupling
