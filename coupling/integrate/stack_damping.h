// Damping of sliding meshed blocks that move against each other along the normals of their contacts.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/contact/contact_energy.h"
#include "coupling/integrate/sliding_damping.h"

namespace scree::coupling {

/// A stack of blocks bounces on its own elasticity, mostly by the rigid motions of its blocks, which SlidingDamping
/// spares. The dashpots at contacts are those of their corners: in a mesh they are small against a block, so the bounce
/// lasts, and with the normal force the friction comes and goes. A stack that should rest then creeps down by some
/// millimetres a period. So every closed contact k between bodies i and j of which one slides has a dashpot
///   c_k = 2 a m N_k/min(sum N of i, sum N of j),   1/m = 1/m_i + 1/m_j,
/// for the normal velocity at the contact of the rigid motions of the bodies alone; a is the larger of their rates of
/// SlidingDamping, without what steep friction adds to them. One of the two has a mesh; bodies that are held or driven
/// have no mass in 1/m and no sum. A dashpot pulls by no more than N_k, and its force counts in the normal force that
/// friction sees: where the contact slips it acts along n + t T/N. Equal and opposite, at one point: both momenta stay.
/// It acts on the masses of blocks, not of corners, and is taken at the new velocity: the stable explicit step stays as
/// it is. Divided bodies, ghosts and those that SlidingDamping exempts are exempt, but for driven ones. Implicit steps
/// do not have it.
class StackDamping {
 public:
  StackDamping(const Setup& setup, const SlidingDamping& sliding);

  /// False where no body of the setup has a mesh.
  [[nodiscard]] bool used() const { return used_; }
  /// Finds the bodies whose rigid motion counts, by the rates that `sliding` has found; add() is then called for each.
  /// @return true if there is any
  bool find(const SlidingDamping& sliding, const Outlines& outlines, const ContactList& list);
  [[nodiscard]] bool wants(std::size_t body) const { return wanted_[body] != 0; }

  /// A rigid motion: velocity of its centre c and spin, the inverse of G = R^T M R of its mass about c.
  struct Rigid {
    Vec2 centre{0.0, 0.0};
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // [m/s, m/s, rad/s]
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
    double mass = 0.0;
  };
  void add(std::size_t body, const Rigid& motion) { rigid_[body] = motion; }
  /// Finds the forces, at velocities less what they take within half a step.
  /// @param half  half of the step that led here [s]   @param v  velocities of the nodes, of which driven ones count
  /// @param driven_force  += the forces on nodes of driven bodies [N]
  /// @return power of the part of the forces that is friction [W]
  double act(const Outlines& outlines, const ContactList& list, std::span<const double> q, std::span<const double> v,
             double half, std::span<double> driven_force);
  /// Acceleration of the rigid motion of a wanted body [m/s2, m/s2, rad/s2], after act().
  [[nodiscard]] Eigen::Vector3d acceleration(std::size_t body) const { return rigid_[body].inverse * force_[body]; }

 private:
  [[nodiscard]] bool damped(const ContactMemory& m, std::size_t i, std::size_t j) const;

  bool used_ = false;
  const Setup* setup_;
  std::vector<char> mesh_, exempt_, wanted_;  // per body, as all that follows
  std::vector<double> rate_;                  // [1/s]
  std::vector<double> all_;                   // normal forces of its contacts [N]
  std::vector<Rigid> rigid_;
  std::vector<Eigen::Vector3d> force_;  // resultant, and moment about the centre
};

}  // namespace scree::coupling
