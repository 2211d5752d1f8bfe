// Contact in explicit steps: forces at an instant, friction by return mapping, ledger increments between instants.
#pragma once

#include <span>
#include <vector>

#include "coupling/contact/audit/audit.h"
#include "coupling/contact/audit/friction_check.h"
#include "coupling/contact/contact_energy.h"
#include "coupling/contact/law/friction_evolution.h"
#include "coupling/contact/node_forces.h"

namespace scree::coupling {

/// Advances the contact points of a state from instant to instant, in two halves per step: leave() with the velocity
/// after the first kick, arrive() with the new positions and the velocity that led to them.
class ExplicitContact {
 public:
  /// @param check_friction  true: sliding points are checked (FrictionCheck)
  ExplicitContact(const Setup& setup, double detection, bool check_friction = true);

  /// Finds the points of a state and the forces of their springs.
  /// @param goes_on  true: explicit steps of the same stage led to the state, and the memory has the forces, with
  /// damping
  void enter(State& state, bool at_start, bool goes_on);
  /// In place of enter(): continues with the points that an instance of the same stage has left in the state.
  void resume(State& state) {
    list_ = &state.contacts;
    list_->find_briefs();
    indexed_ = false;
  }
  /// Copies the points of an instant; go_back() returns to them.
  void mark(ContactList& out) const { out = *list_; }
  void go_back(const ContactList& points) {
    *list_ = points;
    clear_ = 0.0;
    indexed_ = false;
  }
  /// f += forces of the memory.
  void add(std::span<double> f) const;
  /// First half of a step's ledger increments, v the velocity of the step at its start.
  void leave(std::span<const double> v);
  /// Points at the new positions, return mapping, second half of the ledger increments.
  /// @param farthest  upper bound of the displacement of any node of the state in the step [m]
  void arrive(double h, double farthest, std::span<const double> q, std::span<const double> v, State& state);
  /// f += forces that contacts with ghost bodies would have at other positions, as arrive() would compute them.
  /// @param q,v  as for arrive()
  void foresee(double h, std::span<const double> q, std::span<const double> v, std::span<double> f);
  /// The same where only ghosts move otherwise than in the last foresee(), by little: the points are those of that
  /// call, with their shares.
  void foresee_again(double h, std::span<const double> q, std::span<const double> v, std::span<double> f);
  /// Checks the points of the present instant.
  void check(std::span<const double> q, Audit& audit) const;
  /// Called before arrive(): true where it may have to be undone. The points at the start of the step are then kept.
  void keep_for_undo(bool keep) {
    can_undo_ = keep;
    if (keep) left_list_ = *list_;
  }
  /// Returns to the start of the step, after keep_for_undo(true) and arrive().
  void undo();

  /// State::contacts of the state given last.
  [[nodiscard]] const ContactList& list() const { return *list_; }
  /// From now on every step lists its points anew, which changes no bit: the reference for steps in place.
  void list_always_anew() { always_anew_ = true; }
  /// Number of steps that updated the list in place.
  [[nodiscard]] std::int64_t steps_in_place() const { return steps_in_place_; }

 private:
  /// Half-step works of one contact.
  struct Half {
    double normal = 0.0, damping = 0.0, tangential = 0.0, water = 0.0;  // h/2 times force times rate [J]
  };
  /// A point that begins or completes a window of the check of friction, and its slip in the step [m].
  struct Slide {
    std::int32_t point;
    double way;
  };
  /// State of a point at the start of the step, as its ledger increments require it.
  struct Left {
    Half work;
    double gap = 0.0, stretch = 0.0, fn = 0.0, fd = 0.0, ft = 0.0, fdt = 0.0, kn = 0.0, kt = 0.0;
    double foot = 0.0;
    SegmentIndex segment;
    bool open = true, bonded = false;
    bool carries = false;  // no other edge or corner does

    [[nodiscard]] double normal_energy() const { return carries ? NormalSpring{kn, bonded}.energy(gap) : 0.0; }
    [[nodiscard]] double tangential_energy() const { return open ? 0.0 : tangential_spring_energy(kt, stretch); }
  };
  /// Rates of gap and stretch, the latter about an anchor [m/s].
  struct Rates {
    double gap = 0.0, stretch = 0.0, anchor = 0.0;
    bool known = false;
  };
  [[nodiscard]] static Rates rates_of(const ContactPoint& p, double anchor, OutlineVelocities v);
  /// @param v  velocities of the outline nodes   @param rates  at these velocities, if they are known
  [[nodiscard]] Half half_work(double h, const ContactPoint& p, const ContactMemory& m, OutlineVelocities v,
                               const Rates& rates) const;
  void leave_point(double h, std::size_t i);
  [[nodiscard]] Left left_by(double h, const ContactPoint& p, const ContactMemory& m) const;
  /// Velocities of the outline nodes.
  void set_velocities(std::span<const double> v, IndexedVector<OutlineNode, Vec2>& out) const;
  /// True if another integrator moves one of the point's bodies, or a half of it.
  [[nodiscard]] bool on_ghost(const ContactPoint& p) const;
  /// In an impact a spring that passes to another edge or tip has there the energy that remains after the work of its
  /// force in the step, independent of the gap at which it passes:
  ///   k g^2/2 = E - h/2 f_n g'_n - h/2 f g',  f = -k g
  /// The direction of the force jumps within the step: an energy from the gap alone would have a first-order error.
  void transfer_impact_energy(double h, const ContactPoint& p, const Left& was, ContactMemory& m) const;
  /// Forces of the law for the points of a list at the velocities v_; sets trial_ and opened_ for this list.
  void respond(double h, ContactList& list);
  /// The same for one point.   @return its rates, known where the law depends on them
  Rates respond(double h, std::size_t i, ContactList& list);
  /// After respond(): signed slip of a point in the step, for the check of friction [m].
  /// @param was  the point at the start of the step
  [[nodiscard]] double slip_in_step(std::size_t i, const Left& was) const;
  /// After respond(): applies the check of friction to the points.
  void follow_slides(double h, double time);
  void book_pair(const Left& a, std::size_t after, const Half& arriving, Ledger& ledger) const;
  void book_new(std::size_t i, const Half& arriving, Ledger& ledger) const;
  void book_ended(std::size_t before, Ledger& ledger) const;
  /// Gives closed points the springs of their kind.   @param points  those that may have changed their kind
  void adopt_kinds(double h, std::span<const std::int32_t> points, Ledger& ledger);
  /// arrive() with all points listed anew.
  void arrive_anew(double h, State& state);
  /// arrive() with the list updated in place: only the points of vertices that changed are made anew.
  void arrive_in_place(double h, State& state);
  /// Results for a range of points: ledger increments, windows of the check of friction that begin or are complete,
  /// points that may take springs of another kind.
  struct Chunk {
    Ledger ledger;
    std::vector<Slide> slides;
    std::vector<std::int32_t> kinds;
  };
  /// Calls of_range(begin, end, chunk) for ranges of the points of the list, on threads; then adds the increments of
  /// the chunks to the ledger in their order, and lists slides_ and kinds_.
  template <class OfRange>
  void for_points(Ledger& ledger, OfRange&& of_range);
  /// Part of arrive_in_place() for one point alone.
  [[gnu::flatten]] void arrive_point(double h, std::size_t i, Chunk& chunk);
  /// The same for a point of moves_first(), which has moved.
  [[gnu::flatten]] void arrive_first(double h, std::size_t i, const Left& left, Chunk& chunk);
  /// For a point that has moved: its law, and its increments.
  void complete_point(double h, std::size_t i, const Left& left, Chunk& chunk);
  /// True for a point that has moved and on which no force acts, before or after.
  [[nodiscard]] bool stays_open(const Left& was, std::size_t i) const;
  /// Part of arrive_in_place(): points that appear or end, and those that others may depend on.
  void make_way(double h);
  /// f += forces of ahead_.
  void add_ahead(std::span<double> f);
  /// Part of arrive_in_place(): the check of friction for the points of slides_, and the laws of friction.
  void follow_some(double h, State& state);

  const Setup* setup_;
  ContactFinder finder_;
  FrictionCheck friction_check_;
  FrictionEvolution friction_evolution_;
  bool checks_friction_;
  ContactList* list_ = nullptr;  // of the state
  ContactList before_, ahead_, left_list_;
  std::vector<ContactMemory> ahead_found_;  // memories of ahead_ before the law acted
  bool indexed_ = false;                    // the finder has indexed the list
  bool in_place_ = false;                   // the last step was: before_ belongs to no instant
  bool always_anew_ = false;
  std::int64_t steps_in_place_ = 0;
  bool can_undo_ = false;  // left_list_ has the points at the start of the step
  double clear_ = 0.0;     // while there are no points: how far nodes may still move before there can be one [m]
  IndexedVector<OutlineNode, Vec2> v_left_, v_;  // of the step, at its start and at its end [m/s]
  std::vector<Left> left_;                       // per point at the start of the step
  std::vector<Left> left_first_;                 // of those that others may depend on
  struct Weakened {                              // data from which the step took a point's friction
    double slip, friction_change;
  };
  std::vector<Weakened> weakened_;  // per point at the start of the step
  std::vector<char> kept_;          // 1: the point of before_ continues in the list
  std::vector<double> trial_;       // stretch before return mapping, per point of the present list
  struct Anchor {                   // of a point, before it takes the stiffness of a new kind
    std::int32_t point;
    double before;
  };
  std::vector<Anchor> anchor_;
  std::vector<std::int32_t> kinds_;  // points that may take springs of another kind
  std::vector<Slide> slides_;        // windows that begin or are complete
  std::vector<double> energy_;       // of the springs, per point [J]
  std::vector<Chunk> chunks_;
  mutable NodeForces node_forces_;
  mutable bool forces_taken_ = false;       // they are those of the list
  IndexedVector<OutlineNode, char> ghost_;  // per node: 1 where another integrator moves its body, or half of it
  std::vector<double> opened_;              // by dilation in the step, per point of the present list [m]
};

}  // namespace scree::coupling
