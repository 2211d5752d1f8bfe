// Contact in explicit steps: forces from the state at an instant, friction by return mapping, books between instants.
#pragma once

#include <span>
#include <vector>

#include "coupling/contact/audit/audit.h"
#include "coupling/contact/audit/friction_check.h"
#include "coupling/contact/contact_energy.h"
#include "coupling/contact/law/friction_evolution.h"

namespace scree::coupling {

/// Brings the contact points of a state from instant to instant. Two halves a step: leave() with the velocity after the first kick,
/// arrive() with the positions reached and the velocity that brought them there.
class ExplicitContact {
 public:
  /// @param check_friction  points that slide are followed (FrictionCheck)
  ExplicitContact(const Setup& setup, double detection, bool check_friction = true);

  /// Finds the points of a state and the forces of their springs.
  /// @param goes_on  the state is one that explicit steps of the same stage left: the memory has the forces, with
  /// damping
  void enter(State& state, bool at_start, bool goes_on);
  /// In place of enter(): goes on with the points of a state that an instance of the same stage has left.
  void resume(State& state) {
    list_ = &state.contacts;
    list_->find_briefs();
    indexed_ = false;
  }
  /// The points of an instant, and back to them.
  void mark(ContactList& out) const { out = *list_; }
  void go_back(const ContactList& points) {
    *list_ = points;
    clear_ = 0.0;
    indexed_ = false;
  }
  /// f += forces of the memory.
  void add(std::span<double> f) const;
  /// First half of a step's books, v the velocity of the step at the instant left.
  void leave(std::span<const double> v);
  /// Points at the new positions, return mapping, second half of the books.
  /// @param farthest  no node of the state has moved farther since the instant left [m]
  void arrive(double h, double farthest, std::span<const double> q, std::span<const double> v, State& state);
  /// f += forces that contacts with ghosts will have at other positions, as arrive() would find them.
  /// @param q,v  as arrive() has them
  void foresee(double h, std::span<const double> q, std::span<const double> v, std::span<double> f);
  /// Checks the points of the present instant.
  void check(std::span<const double> q, Audit& audit) const;
  /// Before an arrive(): whether it may have to be undone. Then the points of the instant left are kept.
  void keep_way_back(bool keep) {
    can_undo_ = keep;
    if (keep) left_list_ = *list_;
  }
  /// Goes back to the instant left, after keep_way_back(true) and arrive().
  void undo();

  /// State::contacts of the state that was last brought here.
  [[nodiscard]] const ContactList& list() const { return *list_; }
  /// From now on every step lists its points anew, which changes no bit: the reference that steps in place are held to.
  void list_always_anew() { always_anew_ = true; }
  /// Steps that left the list in place.
  [[nodiscard]] std::int64_t steps_in_place() const { return steps_in_place_; }

 private:
  /// Half-step works of one contact, and the geometric changes they are compared with.
  struct Half {
    double normal = 0.0, damping = 0.0, tangential = 0.0, water = 0.0;  // h/2 times force times rate [J]
  };
  /// A point that the check of friction follows, and its slip in the step [m].
  struct Slide {
    std::int32_t point;
    double way;
  };
  /// A point at the instant left, what the books of a step ask of it.
  struct Left {
    Half work;
    double gap = 0.0, stretch = 0.0, fn = 0.0, fd = 0.0, ft = 0.0, fdt = 0.0, kn = 0.0, kt = 0.0;
    double normal_energy = 0.0, tangential_energy = 0.0;
    double foot = 0.0;
    SegmentIndex segment;
    bool open = true, bonded = false;
  };
  /// Rates of gap and stretch, the latter about an anchor [m/s].
  struct Rates {
    double gap = 0.0, stretch = 0.0, anchor = 0.0;
    bool known = false;
  };
  /// @param v  of the outline nodes   @param rates  at these velocities, if they are known
  [[nodiscard]] Half half_work(double h, const ContactPoint& p, const ContactMemory& m, OutlineVelocities v,
                               const Rates& rates) const;
  void leave_point(double h, std::size_t i);
  [[nodiscard]] Left left_by(double h, const ContactPoint& p, const ContactMemory& m) const;
  /// Velocities of the outline nodes.
  void set_velocities(std::span<const double> v, IndexedVector<OutlineNode, Vec2>& out) const;
  void add(const ContactList& list, std::span<double> f) const;
  /// True if another integrator moves one of its bodies, or a half of it.
  [[nodiscard]] bool on_ghost(const ContactPoint& p) const;
  /// In an impact a spring that passes to another edge or tip there holds what the work of its force in the step leaves
  /// of its energy, whatever the gap at which it passes:
  ///   k g^2/2 = E - h/2 f_n g'_n - h/2 f g',  f = -k g
  /// The direction of the force jumps within the step: the gap alone would be off by an error of first order.
  void transfer_impact_energy(double h, const ContactPoint& p, const Left& was, ContactMemory& m) const;
  /// Forces of the law where the points of a list are; trial_ and opened_ are of it afterwards. v_ is theirs.
  void respond(double h, ContactList& list);
  /// The same of one point.   @return its rates, known where the law depends on them
  Rates respond(double h, std::size_t i, ContactList& list);
  /// After respond(), of a point and where it was: its slip in the step, with its sign, for the check of friction [m].
  [[nodiscard]] double way(std::size_t i, const Left& was) const;
  /// After respond(): the check of friction sees the points.
  void follow_slides(double h, double time);
  void book_pair(const Left& a, std::size_t after, const Half& arriving, Ledger& ledger) const;
  void book_new(std::size_t i, const Half& arriving, Ledger& ledger) const;
  void book_ended(std::size_t before, Ledger& ledger) const;
  /// Gives closed points the springs of their kind.   @param points  those that may have another kind
  void adopt_kinds(double h, std::span<const std::int32_t> points, Ledger& ledger);
  /// arrive() where points came or went, or one passed to another place.
  void arrive_anew(double h, State& state);
  /// arrive() where all points are still there: nothing is listed anew, nothing copied.
  void arrive_in_place(double h, State& state);
  /// Of a range of points: increments of the ledger, points that slide, points that may take springs of another kind.
  struct Chunk {
    Ledger ledger;
    std::vector<Slide> slides;
    std::vector<std::int32_t> kinds;
  };
  /// Calls of_range(begin, end, chunk) for ranges of the points of the list, on threads; then adds the increments of the
  /// chunks to the ledger in their order, and lists slides_ and kinds_.
  template <class OfRange>
  void for_points(Ledger& ledger, OfRange&& of_range);
  /// Of arrive_in_place(): what concerns one point alone.   @param first  of a point of moves_first(), else null
  void arrive_point(double h, std::size_t i, const Left* first, Chunk& chunk);
  /// Of arrive_in_place(): points that come and go, and those that others may depend on.
  void make_way(double h);
  /// Of arrive_in_place(): the check of friction sees the points that slide, their friction changes.
  void follow_some(double h, State& state);

  const Setup* setup_;
  ContactFinder finder_;
  FrictionCheck friction_check_;
  FrictionEvolution friction_evolution_;
  bool checks_friction_;
  ContactList* list_ = nullptr;  // of the state
  ContactList before_, ahead_, left_list_;
  bool indexed_ = false;   // the finder knows the list
  bool in_place_ = false;  // the last step was: before_ is of no instant
  bool always_anew_ = false;
  std::int64_t steps_in_place_ = 0;
  bool can_undo_ = false;  // left_list_ is of the instant left
  double clear_ = 0.0;     // while nothing is near: how far nodes may still move before something can be [m]
  IndexedVector<OutlineNode, Vec2> v_left_, v_;  // of the step at the instant left, and where it arrives [m/s]
  std::vector<Left> left_;                       // a point of the instant left
  std::vector<Left> left_first_;                 // of those that others may depend on
  struct Weakened {                              // what its friction was taken from
    double slip, friction_change;
  };
  std::vector<Weakened> weakened_;  // a point of the instant left
  std::vector<char> kept_;          // 1: the point of before_ goes on in the list
  std::vector<double> trial_;       // stretch before return mapping, a point of the list at hand
  struct Anchor {                   // of a point, before it takes the stiffness of a new kind
    std::int32_t point;
    double before;
  };
  std::vector<Anchor> anchor_;
  std::vector<std::int32_t> kinds_;  // points that may take it
  std::vector<Slide> slides_;        // points that the check of friction follows
  std::vector<double> energy_;       // of a point's springs [J]
  std::vector<Chunk> chunks_;
  mutable IndexedVector<OutlineNode, Vec2> forces_;  // on those that move, scratch of add() [N]
  IndexedVector<OutlineNode, char> rests_;           // per outline node: 1 where its body rests
  IndexedVector<OutlineNode, char> ghost_;  // likewise: 1 where another integrator moves its body, or a half of it
  std::vector<double> opened_;              // by dilation in the step, a point of the list at hand [m]
};

}  // namespace scree::coupling
