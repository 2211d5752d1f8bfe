#include "coupling/ledger/ledger.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {
namespace {

constexpr bool kWatched = true;

constexpr std::array<ColumnInfo, kColumns> kInfo{{
    {"kinetic", Side::energy, "kinetic energy of the free bodies"},
    {"elastic", Side::energy, "elastic energy inside the bodies"},
    {"contact_springs", Side::energy, "energy of closed contact springs, normal and tangential"},
    {"support_springs", Side::energy, "energy of point supports"},
    {"bolts", Side::energy, "elastic energy of bolts, their grout, and liners"},
    {"reservoir", Side::energy, "energy that bodies could not take along into their present method"},
    {"shadow", Side::energy, "-(h^2/8) a.M.a: what central difference conserves beside the kinetic energy"},
    {"gravity", Side::work, "work of gravity"},
    {"loads", Side::work, "work of point loads, tractions and body accelerations"},
    {"water", Side::work, "work of the water in joints"},
    {"bolt_tension", Side::work, "work that gave bolts their pretension"},
    {"support_release", Side::work,
     "work of the forces that stand in for what was excavated, or for supports that left"},
    {"prescribed_motion", Side::work, "work of driven and fixed blocks on the free ones"},
    {"friction", Side::dissipated, "friction force times slip"},
    {"dilation", Side::dissipated, "part of it that opens the joint: less normal force times opening"},
    {"contact_damping", Side::dissipated, "damping of closed contacts"},
    {"mass_damping", Side::dissipated, "mass-proportional damping"},
    {"deformation_damping", Side::dissipated, "damping of the deformation of sliding blocks", kWatched},
    {"stiffness_damping", Side::dissipated, "Rayleigh damping proportional to stiffness"},
    {"local_damping", Side::dissipated, "local damping of explicit steps, a fraction of the unbalanced force"},
    {"viscous_edges", Side::dissipated, "energy that leaves through viscous edges"},
    {"rest_damping", Side::dissipated, "kinetic energy removed by stages that run to rest"},
    {"falling_asleep", Side::dissipated, "kinetic energy removed from blocks as they fall asleep"},
    {"newmark_damping", Side::dissipated, "damping of the implicit scheme, 1/2 d.K.d over every spring and body"},
    {"contact_closing", Side::dissipated,
     "energy taken by the implicit scheme while contacts close, open or start to slip"},
    {"springs_dropped", Side::dissipated, "springs deleted while stretched: contacts that opened or ended"},
    {"bonds_broken", Side::dissipated, "springs of bonded contacts that failed while they were pulled"},
    {"bolt_yield", Side::dissipated, "yield of bolts, in tension and shear, and liners, and slip of grout"},
    {"bolts_broken", Side::dissipated, "elastic energy of bolts and liners that broke"},
    {"excavated", Side::dissipated, "energy of what left the model: of blocks, of their contacts and supports"},
    {"elastic_trapezoid", Side::scheme, "elastic energy less the trapezoid work of the internal force", kWatched},
    {"contact_transition", Side::scheme, "trapezoid work across opening and closing", kWatched},
    {"contact_geometry", Side::scheme, "contact work on moving normals and edges, exact less linear", kWatched},
    {"contact_edges", Side::scheme, "contacts that change edge or end at a corner", kWatched},
    {"contact_tributary", Side::scheme, "contacts whose tributary length changes", kWatched},
    {"support_trapezoid", Side::scheme, "support energy less the trapezoid work of its springs", kWatched},
    {"bolt_trapezoid", Side::scheme,
     "energy and dissipation of bolts and liners less the trapezoid work of their forces", kWatched},
    {"update_kinetic", Side::scheme, "kinetic energy changed by the geometry update of implicit steps", kWatched},
    {"update_elastic", Side::scheme, "elastic energy changed by the geometry update of implicit steps", kWatched},
    {"update_contact", Side::scheme,
     "contact, support and bolt energy changed by the geometry update of implicit steps", kWatched},
    {"waveform", Side::scheme, "explicit and implicit bodies: what the iteration between them leaves, as a kick",
     kWatched},
    {"interface_constraints", Side::scheme,
     "explicit and implicit halves of a block: what the forces between them leave", kWatched},
    {"step_change", Side::scheme, "change of the shadow term with the step or the scheme"},
    {"transfer", Side::scheme, "cross terms booked when bodies change method"},
}};

/// The columns of a side, which stand together: first, and one after the last.
struct Columns {
  std::size_t begin = kInfo.size(), end = 0;
};
constexpr Columns columns_of(Side side) {
  Columns found;
  for (std::size_t i = 0; i < kInfo.size(); ++i) {
    if (kInfo[i].side != side) continue;
    found.begin = std::min(found.begin, i);
    found.end = i + 1;
  }
  return found;
}
constexpr Columns kEnergy = columns_of(Side::energy), kWork = columns_of(Side::work);
static_assert(kEnergy.end == kWork.begin && static_cast<std::size_t>(Column::shadow) + 1 == kEnergy.end);

}  // namespace

const ColumnInfo& info(Column column) { return kInfo[static_cast<std::size_t>(column)]; }

void Ledger::open(std::span<const double> energies) {
  *this = Ledger{};
  for (std::size_t i = 0; i < energies.size(); ++i) value_[i] = energies[i];
  initial_ = energy();
}

void Ledger::set(Column energy_column, double value) {
  double& now = value_[static_cast<std::size_t>(energy_column)];
  if (energy_column != Column::kinetic && energy_column != Column::shadow) moved_ += std::abs(value - now);
  now = value;
}

void Ledger::add(const Ledger& booked) {
  for (std::size_t i = 0; i < value_.size(); ++i) value_[i] += booked.value_[i];
  moved_ += booked.moved_;
}

Ledger Ledger::with_resting(std::span<const double> held, double sign) const {
  Ledger out = *this;
  for (std::size_t i = 0; i < held.size(); ++i) out.value_[kEnergy.begin + i] += sign * held[i];
  return out;
}

Ledger Ledger::joined(const Ledger& base, const Ledger& a, const Ledger& b) {
  Ledger out = base;
  for (std::size_t i = 0; i < kInfo.size(); ++i) {
    if (static_cast<Column>(i) == Column::reservoir) continue;
    out.value_[i] = (kInfo[i].side == Side::energy ? 0.0 : base.value_[i]) + a.value_[i] + b.value_[i];
  }
  out.moved_ = base.moved_ + a.moved_ + b.moved_;
  out.passed_ = std::max(base.passed_, out.passed_now());
  return out;
}

double Ledger::energy() const {
  double sum = 0.0;
  for (std::size_t i = 0; i < kInfo.size(); ++i)
    if (kInfo[i].side == Side::energy) sum += value_[i];
  return sum;
}

double Ledger::closure() const {
  double sum = energy() - initial_;
  for (std::size_t i = 0; i < kInfo.size(); ++i) {
    if (kInfo[i].side == Side::dissipated) sum += value_[i];
    if (kInfo[i].side == Side::work || kInfo[i].side == Side::scheme) sum -= value_[i];
  }
  return sum;
}

double Ledger::largest() const {
  double most = std::abs(initial_);
  for (const double value : value_) most = std::max(most, std::abs(value));
  return most;
}

bool Ledger::next_to_nothing(double energy) const {
  const double open = std::abs(closure());
  return open > kCloses * energy && open <= last_places_;
}

double Ledger::closure_of(double energy) const {
  return energy == 0.0 || next_to_nothing(energy) ? 0.0 : std::abs(closure()) / energy;
}

std::string_view Ledger::not_finite() const {
  for (std::size_t i = 0; i < kInfo.size(); ++i)
    if (!std::isfinite(value_[i])) return kInfo[i].name;
  if (!std::isfinite(moved_)) return "moved";
  return std::isfinite(closure()) ? "" : "closure";
}

double Ledger::held() const {
  double sum = 0.0;
  for (std::size_t i = kEnergy.begin; i + 1 < kEnergy.end; ++i) sum += value_[i];  // all but the shadow
  return sum;
}

double Ledger::given() const {
  double sum = initial_ + (*this)[Column::transfer] - (*this)[Column::excavated];
  for (std::size_t i = kWork.begin; i < kWork.end; ++i) sum += value_[i];
  return sum;
}

double Ledger::passed_now() const {
  double sum = std::abs(initial_);
  for (std::size_t i = kEnergy.begin; i + 1 < kEnergy.end; ++i) sum += std::max(0.0, -value_[i]);
  for (std::size_t i = kWork.begin; i < kWork.end; ++i) sum += std::abs(value_[i]);
  return sum;
}

double Ledger::passed() const { return std::max(passed_given(), held()); }

double Ledger::gain() const {
  const double all = held();
  return all - std::min(-(*this)[Column::shadow], kMostShadow * std::abs(all)) - given();
}

double Ledger::least_gain() const { return (1.0 - kMostShadow) * (held() - (*this)[Column::kinetic]) - given(); }

}  // namespace scree::coupling
