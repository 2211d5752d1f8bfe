// Checks that sliding contacts have the friction that their law states, which a closed ledger does not show.
#pragma once

#include <vector>

#include "coupling/contact/table/contact_finder.h"

namespace scree::coupling {

/// Compares, for every contact point that slides in one direction, the impulse of the tangential force against the slip
/// with that of Coulomb's limit at the present strength and normal force:
///   ratio = -s sum(h t) / sum(h (c A + N tan phi)),   s the direction of the net slip
/// Every step counts, also those in which the point is open, sticks or slips back. A block that slides steadily has the
/// ratio 1 to round-off. Where a block flutters, its points leave the edge and return, load their tangential springs
/// anew each time and reverse: the force obeys its law at every instant, the ledger closes, and yet the block has lost
/// friction. The ratio of the work of friction to tan(phi) N |slip| does not show that.
///
/// Points that really stop have less than the limit without any loss of friction. Therefore time is divided into
/// windows of one natural period of the block on its contacts, T^2 = 4 pi^2 m/sum(k_t) + T_s^2, T_s = 2 sqrt(A)/c_s its
/// own period in shear (the longer one of two free blocks). A stretch of windows continues while every window has a net
/// slip of at least kCreeps elastic stretches in the same direction; an elastic stretch is limit/k_t, or 2e-5 of the
/// block's size if that is more. The first window and the last, in which the point starts and stops, and windows with
/// less than one elastic stretch do not count. While a point hops, its tangential displacement counts as slip. Blocks
/// in a heap start and stop many times in a window without losing friction: their slip in a window is ten times that in
/// the window before, or a tenth of it. A block that flutters keeps its pace, and loses friction in almost every
/// window. Therefore only successive windows count, each with between 1/kPace and kPace times the net slip of the one
/// after it, which all keep their friction, or which lose it with at most kBetween among them that do not. The ratio is
/// that of these windows together, taken once they have more than kStretches elastic stretches and, where they lose
/// friction, once kLosing do.
///
/// Blocks of a stack oscillate together: their points stick and slip, or slide faster and slower, with the period of
/// the stack, which is longer than that of one block. Each window would count as a stop. Once the last motion and the
/// last function are over, only such oscillation makes stopped points slide on; from then on a window without slip, or
/// of another pace than the one before, makes the next windows twice as long instead of ending the stretch, up to
/// kLongest natural periods.
///
/// StackDamping acts on the blocks of a slide that has lost friction (SlideMemory::lost), until the stretch ends.
/// Friction is lost after one losing window where no motion and no function acts any more, else after kLosing of them:
/// a shock makes blocks hop, which is no fault.
///
/// The sums are part of the contact's memory: they are kept when a vertex passes to the next edge, in copies and at
/// restarts. Stages whose velocities are not physical (to rest, dynamics < 1) are not checked.
class FrictionCheck {
 public:
  static constexpr float kStretches = 100.0F;  // elastic stretches of net slip before a ratio is taken
  static constexpr float kCreeps = 0.005F;     // of an elastic stretch per window: least net slip of a slide
  static constexpr float kLeast = 0.99F;       // a smaller ratio is a loss of friction
  static constexpr float kPace =
      2.0F;  // net slip of a window over that of its neighbour: at most, and at least the inverse
  static constexpr std::int32_t kLosing = 6;   // windows that lose friction before the loss is reported
  static constexpr std::int32_t kBetween = 1;  // windows among them that do not
  static constexpr double kLongest = 16.0;     // natural periods in a window

  // Least elastic stretch over the block's size. Blocks that settle, bend and vibrate move their faces along each other
  // by some 1e-4 to 1e-3 of their size, back and forth, which is no slide.
  static constexpr double kStrain = 2e-5;

  explicit FrictionCheck(const Setup& setup);

  /// Begins the check of a step.
  /// @param list  contact points with their memory; must outlive the calls of see()
  /// @param time  at which the step begins [s]
  void begin(const ContactList& list, double time) {
    list_ = &list;
    summed_ = false;
    still_ = time >= last_change_;
  }
  /// Checks a point after a step.
  /// @param h     the step [s]   @param slip  signed slip of the point in it [m]
  /// @param m     forces and state at its end; its slide memory is brought up to date
  void see(double h, const ContactPoint& p, double slip, ContactMemory& m) {
    if (!goes_on(h, slip, m)) change_window(h, p, slip, m);
  }
  /// The part of see() that concerns the point alone: several threads may call it for different points.
  /// @return false: a window begins or is complete, which see() has to do; nothing has changed
  [[nodiscard]] bool goes_on(double h, double slip, ContactMemory& m) const;
  /// Ends all stretches, for a stage without the check.
  static void forget(ContactList& list);

  /// Natural period of the blocks of a point on the closed contacts of the list [s].
  [[nodiscard]] double period(const ContactPoint& p);
  /// Slip that the deformation of the smaller free block of a point may cause: kStrain of its size [m].
  [[nodiscard]] double deformation(const ContactPoint& p) const;

 private:
  /// Coulomb limit of a point [N].
  [[nodiscard]] double limit(const ContactMemory& m) const;
  /// Adds a step to the present window.
  void add_step(double h, double slip, double limit, ContactMemory& m) const;
  /// Begins or completes a window with a step.
  void change_window(double h, const ContactPoint& p, double slip, ContactMemory& m);

  struct Inertia {
    bool free = false;
    double mass = 0.0;    // [kg]
    double period = 0.0;  // natural period in shear [s]
    double size = 0.0;    // root of its area [m]
  };
  const Setup* setup_;
  double last_change_ = 0.0;  // end of the last motion and function of the stage [s]; infinite: one has no end
  bool still_ = false;        // the last motion and function are over
  const ContactList* list_ = nullptr;
  IndexedVector<BodyIndex, Inertia> bodies_;
  IndexedVector<BodyIndex, double> stiffness_;  // tangential, of closed contacts [N/m]
  bool summed_ = false;
};

}  // namespace scree::coupling
