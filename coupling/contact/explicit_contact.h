// Contact in explicit steps: forces from the state at an instant, friction by return mapping, books between instants.
#pragma once

#include <span>
#include <vector>

#include "coupling/contact/audit/audit.h"
#include "coupling/contact/audit/friction_check.h"
#include "coupling/contact/contact_energy.h"
#include "coupling/contact/law/friction_evolution.h"

namespace scree::coupling {

/// Owns the contact points of the present instant. Two halves a step: leave() with the velocity after the first kick,
/// arrive() with the positions reached and the velocity that brought them there.
class ExplicitContact {
 public:
  /// @param check_friction  points that slide are followed (FrictionCheck)
  ExplicitContact(const Setup& setup, double detection, bool check_friction = true);

  /// Finds the points of a state and the forces of their springs.
  /// @param goes_on  the state is one that explicit steps of the same stage left: the memory has the forces, with
  /// damping
  void enter(State& state, bool at_start, bool goes_on);
  /// In place of enter(): the points that an instance of the same stage had at this state.
  void resume(const State& state, const std::vector<ContactPoint>& points) { now_.restore(points, state.contacts); }
  /// The points of an instant, and back to them.
  void mark(ContactList& out) const { out = now_; }
  void go_back(const ContactList& points) {
    now_ = points;
    clear_ = 0.0;
  }
  /// f += forces of the memory.
  void add(std::span<double> f) const;
  /// First half of a step's books, v the velocity of the step at the instant left.
  void leave(double h, std::span<const double> v);
  /// Points at the new positions, return mapping, second half of the books.
  /// @param farthest  no node of the state has moved farther since the instant left [m]
  void arrive(double h, double farthest, std::span<const double> q, std::span<const double> v, State& state);
  /// f += forces that contacts with ghosts will have at other positions, as arrive() would find them.
  /// @param q,v  as arrive() has them
  void foresee(double h, std::span<const double> q, std::span<const double> v, std::span<double> f);
  /// Checks the points of the present instant.
  void check(std::span<const double> q, Audit& audit) const;
  /// Goes back to the instant left, after arrive().
  void undo(State& state);

  [[nodiscard]] const ContactList& list() const { return now_; }

 private:
  /// Half-step works of one contact, and the geometric changes they are compared with.
  struct Half {
    double normal = 0.0, damping = 0.0, tangential = 0.0, water = 0.0;  // h/2 times force times rate [J]
  };
  [[nodiscard]] Half half_work(double h, const ContactPoint& p, const ContactMemory& m,
                               std::span<const double> v) const;
  void add(const ContactList& list, std::span<double> f) const;
  /// True if another integrator moves one of its bodies, or a half of it.
  [[nodiscard]] bool on_ghost(const ContactPoint& p) const;
  /// In an impact a spring that passes to another edge or tip there holds what the work of its force in the step leaves
  /// of its energy, whatever the gap at which it passes:
  ///   k g^2/2 = E - h/2 f_n g'_n - h/2 f g',  f = -k g
  /// The direction of the force jumps within the step: the gap alone would be off by an error of first order.
  void transfer_impact_energy(double h, std::span<const double> v);
  /// Forces of the law where the points of a list are; trial_ and opened_ are of it afterwards.
  void respond(double h, std::span<const double> v, ContactList& list);
  /// After respond(): the check of friction sees the points.
  void follow_slides(double h);
  void book_pair(std::size_t before, std::size_t after, const Half& arriving, Ledger& ledger) const;

  const Setup* setup_;
  ContactFinder finder_;
  FrictionCheck friction_check_;
  FrictionEvolution friction_evolution_;
  bool checks_friction_;
  ContactList now_, before_, ahead_;
  double clear_ = 0.0;          // while nothing is near: how far nodes may still move before something can be [m]
  std::vector<Half> left_;      // a point of before_
  std::vector<char> kept_;      // 1: the point of before_ goes on in now_
  std::vector<double> trial_;   // stretch before return mapping, a point of the list at hand
  std::vector<double> anchor_;  // before closed points take the stiffness of a new kind
  std::vector<double> opened_;  // by dilation in the step, a point of the list at hand [m]
};

}  // namespace scree::coupling
