// Damping of blocks that bounce on each other while they slide, and lose friction by it.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "coupling/contact/contact_energy.h"
#include "coupling/integrate/sliding_damping.h"

namespace scree::coupling {

/// A stack of blocks bounces on its own elasticity, mostly by the rigid motions of its blocks, which SlidingDamping
/// excludes. The dashpots at contacts are those of their corners: in a mesh they are small for a block, so the bounce
/// persists, and friction oscillates with the normal force. A stack that should rest then creeps down by some
/// millimetres per period. So where the check of friction has found a window of a slide that lost friction
/// (SlideMemory::lost), every closed contact k of the two blocks with other blocks has a dashpot until the slide ends,
///   c_k = 2 a m N_k/min(sum N of i, sum N of j),   1/m = 1/m_i + 1/m_j,
/// for the normal velocity at the contact of the rigid motions of its bodies i and j alone; a is the larger of their
/// rates of SlidingDamping, without what steep friction adds to them. A dashpot pulls by no more than N_k, and its
/// force is part of the normal force in the friction law: where the contact slips it acts along n + t T/N. Equal and
/// opposite, at one point: both momenta are kept. It acts on the masses of blocks, not of corners, and is taken at the
/// new velocity: the stable explicit step stays as it is. Exempt are bodies that SlidingDamping exempts, divided
/// ones, and joints that dilate.
/// @source docs/theory/contact-law.md, "Blocks that slide"
class StackDamping {
 public:
  /// @param setup  must outlive it
  StackDamping(const Setup& setup, const SlidingDamping& sliding);

  /// Finds the bodies that are damped, by the rates that `sliding` has found.   @return true if there is any
  bool find(const SlidingDamping& sliding, const Outlines& outlines, const ContactList& list);
  /// Finds the forces at the velocities that v becomes once these forces have acted for `time`.
  /// @pre find() with the same list
  /// @param q,v  of all nodes of the setup   @param time  [s]
  void act(const Outlines& outlines, const ContactList& list, std::span<const double> q, std::span<const double> v,
           double time);
  /// out += factor times the acceleration by these forces, on all nodes.
  void add_acceleration(double factor, std::span<double> out) const;
  /// out += the forces, on all nodes [N].
  void add_force(std::span<const double> q, std::span<double> out);
  /// Power of the forces at the mean velocity of the time of act(), and the part of it that is friction [W].
  [[nodiscard]] double power() const { return power_; }
  [[nodiscard]] double friction() const { return friction_; }

 private:
  struct Rigid {  // a rigid motion R = (x, y, turn) of a body
    Vec2 centre{0.0, 0.0};
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // [m/s, m/s, rad/s]
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();   // (R^T M R)^-1
    double mass = 0.0;                                   // [kg]
  };
  /// Makes the arrays below; few runs need them.
  void allocate();
  [[nodiscard]] bool damped(const ContactMemory& m, std::size_t i, std::size_t j) const;
  void find_motion(std::size_t body, std::span<const double> q, std::span<const double> v);
  /// out = M u on the nodes of a body.
  void mass_apply(const Body& body, std::span<const double> q, std::span<const double> u, std::span<double> out) const;

  const Setup* setup_;
  bool possible_ = false;              // at least two bodies are not exempt
  std::vector<char> exempt_, wanted_;  // per body, as all that follows
  std::vector<double> rate_;           // [1/s]
  std::vector<double> all_;            // normal forces of its contacts [N]
  std::vector<Rigid> rigid_;
  std::vector<Eigen::Vector3d> force_;       // resultant, and moment about the centre
  std::vector<double> x_, y_, turn_, work_;  // on nodes: rigid motions of the wanted bodies, and scratch
  double power_ = 0.0, friction_ = 0.0;
};

}  // namespace scree::coupling
