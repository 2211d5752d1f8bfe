// Whether contacts that slide have the friction that their law says: what a closed ledger cannot see.
#pragma once

#include <vector>

#include "coupling/contact/table/contact_finder.h"

namespace scree::coupling {

/// Compares, for every contact point that slides one way, the impulse of the tangential force against the slip with
/// that of Coulomb's limit at the present strength and normal force:
///   ratio = -s sum(h t) / sum(h (c A + N tan phi)),   s the direction of the net slip
/// Every step counts, those too in which the point is open, sticks or slips back. A block that slides steadily has 1 to
/// round-off. Where it flutters, its points leave the edge and come back, load their tangential springs anew each time
/// and turn round: the force obeys its law at every instant, the ledger closes, and yet the block has lost friction.
/// The work of friction over tan(phi) N |slip| does not show that.
///
/// Points that really stop have less than the limit, and that is no loss. So time is taken in windows of one natural
/// period of the block on its contacts, T^2 = 4 pi^2 m/sum(k_t) + T_s^2, T_s = 2 sqrt(A)/c_s its own in shear (of two
/// free blocks the longer). A stretch goes on while every window brings at least kCreeps elastic stretches of net slip
/// in the same direction, limit/k_t or 2e-5 of the block's size if that is more; its first window and its last, in
/// which it starts and stops, and those with less than one elastic stretch do not count. While a point hops its way
/// counts as slip. Blocks in a heap start and stop many times in a window, and have lost nothing: their way in a window
/// is now ten times, now a tenth of that in the window before. A block that flutters keeps its pace, and loses in
/// almost every window. So windows count in succession, each with between 1/kPace and kPace times the net slip of the
/// one after it, that keep their friction, or that lose it with at most kBetween among them that do not. The ratio is
/// theirs, taken once they have more than kStretches elastic stretches and, where they lose, kLosing of them do.
///
/// Blocks of a stack swing together: their points stick and slip, or slide faster and slower, with the period of the
/// stack, which is longer than that of one block. Each window would be a stop. Once the last motion and the last
/// function are over nothing but such swinging makes points that stopped slide on; so there a window without slip, or
/// of another pace than the one before, makes the next windows twice as long instead of ending the stretch, up to
/// kLongest natural periods.
///
/// StackDamping acts on the blocks of a slide that has lost friction (SlideMemory::lost), until the stretch ends: in
/// one window where no motion and no function acts any more, else in kLosing. A shock makes blocks hop, and that is no
/// fault.
///
/// The sums are part of the contact's memory: they go with a vertex that passes to the next edge, with copies and
/// restarts. Stages whose velocities are not physical (to rest, dynamics < 1) have no check.
class FrictionCheck {
 public:
  static constexpr float kStretches = 100.0F;  // elastic stretches of net slip before a ratio is taken
  static constexpr float kCreeps = 0.005F;     // of an elastic stretch in a window: the point still goes one way
  static constexpr float kLeast = 0.99F;       // a smaller ratio is a loss of friction
  static constexpr float kPace =
      2.0F;  // net slip of a window over that of its neighbour: at most, and at least the inverse
  static constexpr std::int32_t kLosing = 6;   // windows that lose friction before they are told
  static constexpr std::int32_t kBetween = 1;  // windows among them that do not
  static constexpr double kLongest = 16.0;     // natural periods in a window

  // Of a block's size: a shorter stretch is not counted as one. Blocks that settle, bend and ring move their faces on
  // each other by some 1e-4 to 1e-3 of their size, to and fro, and that is no slide.
  static constexpr double kStrain = 2e-5;

  explicit FrictionCheck(const Setup& setup);

  /// Begins with the points of a step.
  /// @param list  with what they remember; must outlive the calls of see()
  /// @param time  at which the step begins [s]
  void begin(const ContactList& list, double time) {
    list_ = &list;
    summed_ = false;
    still_ = time >= last_change_;
  }
  /// A point after a step.
  /// @param h     the step [s]   @param slip  of the point in it, with its sign [m]
  /// @param m     forces and state at its end; its slide memory is brought up to date
  void see(double h, const ContactPoint& p, double slip, ContactMemory& m) {
    if (slip != 0.0 || m.slide.length > 0.0F) follow(h, p, slip, m);
  }
  /// Ends all stretches: of a stage without the check.
  static void forget(ContactList& list);

  /// Natural period of the blocks of a point on their contacts, as the list has them [s].
  [[nodiscard]] double period(const ContactPoint& p);
  /// Slip that the deformation of the smaller free block of a point may bring: kStrain of its size [m].
  [[nodiscard]] double deformation(const ContactPoint& p) const;

 private:
  void follow(double h, const ContactPoint& p, double slip, ContactMemory& m);

  struct Inertia {
    bool free = false;
    double mass = 0.0;    // [kg]
    double period = 0.0;  // of its own in shear [s]
    double size = 0.0;    // root of its area [m]
  };
  const Setup* setup_;
  double last_change_ = 0.0;  // when the last motion and function of the stage are over [s]; infinite: never
  bool still_ = false;        // they are
  const ContactList* list_ = nullptr;
  IndexedVector<BodyIndex, Inertia> bodies_;
  IndexedVector<BodyIndex, double> stiffness_;  // tangential, of closed contacts [N/m]
  bool summed_ = false;
};

}  // namespace scree::coupling
