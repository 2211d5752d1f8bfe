// All contact points of an instant: found, matched with what they remember, ready for a law.
#pragma once

#include <span>
#include <vector>

#include "coupling/contact/table/contact_pairs.h"

namespace scree::coupling {

/// Finds contact points: the pairs of ContactPairs, each with the nearest segment of its edge, and what it remembers.
/// Decisions rest on exact geometry and on the memory alone.
/// @source docs/theory/contact-geometry.md, "Edge-edge contact"; docs/theory/contact-geometry.md, "Angle-edge contact";
///         [Qu2013] 3.2.2, 2.4.3
class ContactFinder {
 public:
  /// @param detection  pairs nearer than this are listed, open or closed [m]
  ContactFinder(const Setup& setup, double detection);

  [[nodiscard]] double detection() const { return detection_; }
  /// Points of a state without geometry, for find() to start from.
  void restore(std::span<const ContactMemory> memory, ContactList& out) const;
  /// Lists the points at q. A point that was known before takes its memory over (with the anchor carried to a new
  /// segment so that the stretch does not jump) and says so in `from`; where a vertex leaves an overlap and one of the
  /// other side takes its place, or passes to the next edge in line, the memory passes as well. New points start open.
  /// A share that changes while a contact stays of its kind keeps gap and stretch, and with them the traction.
  /// @param at_start  t = 0: touching pairs are closed without stress, their gap becomes gap0
  /// @param of        which; points of ghosts alone are those of the whole list but for what a corner between two
  /// other bodies makes of them
  void find(std::span<const double> q, const ContactList& known, bool at_start, ContactList& out,
            ContactPairs::Of of = ContactPairs::Of::all);
  /// Whether a list can be brought to q in place, with what find() would leave to the last bit. Most points stay then,
  /// each with the memory it has; where points of a vertex come, go or pass something on, all of that vertex are made
  /// anew, beside the list, which has not changed yet. Next: splice() if any are; move() of the points that others may
  /// depend on (moves_first()), settle(), and move() of the others, in any order; note() of every one when it knows its
  /// new state, then take_noted(). If it cannot, find_again() does what find() would, with the pairs that are known.
  /// @pre index() or take_noted() for the list as it is
  [[nodiscard]] bool keeps(std::span<const double> q, const ContactList& list);
  /// Points of a vertex that are made anew: those of the list from `begin` to `end`, in place of which come others.
  struct Changed {
    std::int32_t begin, end;    // in the list
    std::int32_t first, count;  // of those that come, among all such
  };
  [[nodiscard]] std::span<const Changed> changed() const { return changed_; }
  /// True for a point of changed() that nothing takes its memory from.
  [[nodiscard]] bool gone(std::size_t i) const { return gone_[i] != 0; }
  /// Puts the points that come in their places.
  void splice(ContactList& list);
  /// Before moves_first(), after splice() if any points are changed().
  void find_first(const ContactList& list);
  /// True for a point that came so: not to be moved.
  [[nodiscard]] bool made(std::size_t i) const { return moving_[i].made; }
  /// True if it has the memory of another place.
  [[nodiscard]] bool passed(const ContactPoint& p) const {
    const auto from = static_cast<std::size_t>(p.from);
    return p.from >= 0 && (known_.vertex(from) != p.vertex || known_.edge(from) != p.edge);
  }
  void move(std::size_t i, ContactList& list);
  /// Points on which others may depend, in order: settle() waits for these alone.
  [[nodiscard]] std::span<const std::int32_t> moves_first() const { return first_; }
  void settle(ContactList& list);
  /// @param known  the list that keeps() was asked of   @param out  another one
  void find_again(const ContactList& known, ContactList& out);
  void index(const ContactList& list, bool in_turn = false);  // in_turn: it is that of the last keeps()
  void note(std::size_t i, const ContactMemory& m) { known_.note(i, m); }
  void take_noted(const ContactList& list);
  /// Of find(): energy of springs that ended and that other closed ones have taken over [J].
  [[nodiscard]] double merged() const { return merged_; }
  /// After find(): how far every node of the state may move before find() can list a point [m]; 0 if there are
  /// candidates now.
  [[nodiscard]] double clearance() { return pairs_.clearance(x_) / largest_weights_; }
  /// Gives closed points that changed between edge-edge and angle-edge, and corners that passed to another edge, the
  /// stiffness of their new kind; force and state stay, gap0 and anchor move.
  /// @return f^2 (1/k' - 1/k)/2 summed, normal and tangential: the change of the springs' energy [J]
  [[nodiscard]] double adopt_kinds(ContactList& list) const;
  /// The same of one point.   @param change  receives what it adds [J]
  static void adopt_kind(const ContactPoint& p, ContactMemory& m, double& change);
  /// False for a point that has nothing to change.
  [[nodiscard]] static bool may_adopt(const ContactPoint& p, const ContactMemory& m) {
    return m.status != ContactStatus::open && !(m.impact > 0.0) &&
           (m.edge_edge != static_cast<std::int32_t>(p.edge_edge) || m.kn != p.springs.kn || m.kt != p.springs.kt);
  }
  /// A point that closes fast where nothing rests on the joint yet keeps its springs, whatever becomes of share, kind
  /// and edge, for four periods of its corner on its spring: an impact is over by then (face to face half a period of
  /// the block, sqrt(7/2) of the corner's, is the longest of two blocks), and what is still closed rests. An overlap
  /// that is worth less than a corner begins as one. Where the law has a force the gap is 0 still. Fast: with w =
  /// sqrt(k mu) the depth v/w is above what counts as touching, and v w ten times gravity. A joint that rests and
  /// swings, where a load comes on or a block beside it slides, is no impact and follows the geometry.
  /// @param speed  v at which the gap closes [m/s]
  void begin_impact(const ContactPoint& p, double speed, ContactMemory& m) const;

 private:
  /// Calls see(i) for the known points between either edge and edges in line with the other, of any body.
  template <class See>
  void for_next_pairs(EdgeIndex a, EdgeIndex b, See&& see) const;
  /// The nearest other point of the same edge-edge contact, else of one in line where the joint goes on from another
  /// block; -1 if there is none. Only a new point may begin like an open one.
  /// @param next_only  leave out the point's own contact
  [[nodiscard]] std::int32_t neighbour(const ContactPoint& p, bool next_only) const;
  /// How much deeper a point is than the joint in line beside it; its depth where there is none, whatever gap0 [m].
  [[nodiscard]] double entry_depth(const ContactPoint& p) const;
  /// The segment of an edge nearest to a point, and its distance [m].
  struct Under {
    SegmentIndex segment;
    double distance = 0.0;
  };
  [[nodiscard]] Under segment_under(const Vec2& x, EdgeIndex edge) const;
  [[nodiscard]] ContactGeometry geometry(VertexIndex vertex, SegmentIndex segment) const;
  [[nodiscard]] ContactKey key_of(VertexIndex vertex, EdgeIndex edge) const;
  [[nodiscard]] bool admissible(const ContactPoint& p) const;
  /// 1/m that a force on a contact feels: of corner and foot.
  [[nodiscard]] double compliance(const ContactPoint& p) const;
  void place_nodes(std::span<const double> q);
  /// The points of pairs, in their order.
  void list_points(std::span<const VertexEdge> pairs, bool at_start, ContactList& out);
  /// Places a point that has its segment and `from`.   @return false: it is none
  [[nodiscard]] bool touches(const VertexEdge& pair, const ContactMemory* was, bool closed, ContactPoint& p) const;
  /// Completes it: springs, lengths of joint.
  void describe(const VertexEdge& pair, const ContactMemory* was, bool closed, ContactPoint& p) const;
  /// Of keeps(): the result for one chunk of vertices.
  struct Kept {
    bool anew = false;                    // find() must do it
    std::vector<VertexIndex> changed;     // vertices whose points do not stay as they are
    std::vector<ContactPoint> of_vertex;  // scratch of passes_on()
  };
  /// Of keeps(): whether a vertex has a corner that goes over to another edge.
  /// @param first,last  points of the vertex
  [[nodiscard]] bool passes_on(std::size_t first, std::size_t last, const ContactList& list,
                               std::vector<ContactPoint>& of_vertex) const;
  /// Of keeps(): whether the pair is a point just as it was before.
  /// @param row  its point in the list, or -1   @param segment  receives the one it is over
  /// @param anew  becomes true where find() must do it
  [[nodiscard]] bool stays(const VertexEdge& pair, std::int32_t row, const ContactList& list, SegmentIndex& segment,
                           bool& anew) const;
  /// Of keeps(): whether the pairs of a vertex are its points of the list; then moving_ has them.
  [[nodiscard]] bool stay(VertexIndex vertex, const ContactList& list, Kept& kept);
  /// Of keeps(): makes the points of changed vertices anew, and gives moving_ room for them.
  void make_changed();
  /// The points of one vertex.   @param old  the first of the known ones that may be of it
  void list_vertex(std::span<const VertexEdge> pairs, std::size_t old, bool at_start, ContactList& out);
  /// Completes what keeps() has made.   @return false: find() must do it
  [[nodiscard]] bool complete_made(const ContactList& list);
  void set_range(ContactPoint& p, bool closed) const;
  void set_damping(ContactPoint& p, const ContactMemory& m) const;
  /// True for a point at the reentrant corner of its body: the two edges that meet there are two contacts.
  [[nodiscard]] bool reentrant(const ContactPoint& p) const;
  /// True if a closed corner has passed from one edge to another.
  [[nodiscard]] bool goes_over(const ContactPoint& from, const ContactPoint& to) const;
  /// Of points of one vertex: the one that a closed corner passes to, if any.
  [[nodiscard]] ContactPoint* successor(const ContactPoint& from, std::span<ContactPoint> points) const;
  /// Of one vertex: gives the points of closed corners that went over to another edge what they remember; the edges
  /// they left begin anew.
  void pass_corners(std::span<ContactPoint> points) const;
  /// True if two wedges that overlap leave each other by the side of `to`, the shorter way, where `from` is a closed
  /// corner P near the convex end V of an edge, and `to` that V against a side of P. Not where a joint goes on over
  /// either end in line: there the corner passes along it.
  /// @param of_corner,of_tip  all points of P and of V
  [[nodiscard]] bool goes_over_tip(const ContactPoint& from, std::span<const ContactPoint> of_corner,
                                   const ContactPoint& to, std::span<const ContactPoint> of_tip) const;
  /// Corners in an impact that slide over the end of an edge: the tip there takes their memory where the gaps of both
  /// are equal, so that the energy goes on, as over a convex corner (goes_over()).
  void pass_tips(bool at_start, ContactList& out) const;
  /// The vertex at the convex end of the edge that a closed corner in an impact is about to pass; not valid: none.
  [[nodiscard]] VertexIndex tip_beside(const ContactPoint& from) const;
  /// A point of an impact that ends under load while its bodies overlap: the nearest point between the same bodies
  /// takes over its memory if it is open, and the energy of its spring if it is in an impact itself (merged()).
  void pass_energy_on(bool at_start, ContactList& out);
  /// All that concerns the points of one vertex alone, while they are at hand (to go through a long list again takes as
  /// long as to make it); lists them for what comes after.
  /// @param first  of the vertex, whose points are the last of the list
  void settle_vertex(std::size_t first, bool at_start, ContactList& out);
  /// True if it keeps the springs it closed with (ContactMemory::impact).
  [[nodiscard]] bool in_impact(const ContactPoint& p) const;
  [[nodiscard]] bool was_closed(const ContactPoint& p) const;
  /// Suppresses corners against edges whose end is pressed into the joint that goes on beside the corner.
  void cover_corners(ContactList& out) const;
  void inherit(ContactList& out);
  /// A body was made anew, its edges a little elsewhere: no force comes from that. A point that has more of the joint
  /// than before carries what it was given of the vertices that went; one that has less leaves its traction to new
  /// ones, also of what it was given (`share` counts the length that came with it).
  static void keep_force(const ContactMemory& old, bool divided, const ContactPoint& p, ContactMemory& m);
  /// A contact closes where its gap passes zero, or what slip has left open. One that is found deep (a corner that came
  /// in from the side, or whose other edge carried it so far) begins without force where it is, and forgets that depth
  /// as it comes out.   @param known  the point was in the list before
  void set_gap0(bool known, const ContactPoint& p, ContactMemory& m) const;
  /// True for a corner that meets the far end of an edge beside the point's: it stands there, as deep as that is long.
  [[nodiscard]] bool beside_next_corner(const ContactPoint& p) const;
  /// @param divided  of a remembered point of a body made anew: new mesh vertices stand beside it on its joint
  void fill(const ContactMemory* old, bool at_start, bool divided, ContactPoint& p, ContactMemory& m) const;
  /// Gives a point, once it has its `from`, what it remembers, or what it begins with.
  /// @pre its memory in the list is as new
  void remember(std::size_t i, bool at_start, ContactList& out) const;
  /// True for a point that a mesh has added to a joint.
  [[nodiscard]] bool adds(const ContactPoint& p) const;
  /// A point's edge with the one that leaves its vertex, or comes to it.
  [[nodiscard]] EdgePair joint_of(const ContactPoint& p, bool out) const;
  /// Lists by joint what a mesh has added and what is remembered, if any body was made anew.
  void index_divided(const ContactList& out);
  /// True for a remembered point if a mesh has added one to its joint.
  [[nodiscard]] bool is_divided(const ContactPoint& p) const;
  /// A point of known gap is bonded if its neighbour on the joint is, and it bears the pull.
  void bond_like(const ContactMemory& beside, ContactMemory& m) const;
  /// Where a body was meshed anew its new vertices on a closed joint take gap and stretch, and with them the traction,
  /// from the remembered points on either side (gap0 where there is but one), and the bond of the nearest.
  void interpolate(ContactList& out) const;
  void pair_edges(std::size_t first, ContactList& list) const;
  void fill_with_water(const ContactPoint& p, ContactMemory& m) const;
  void suppress_second_edges(bool at_start, ContactList& list) const;
  /// Of two points of a corner, against two edges that meet at a convex corner: at most one carries it.
  void suppress_one(bool at_start, std::size_t i, std::size_t j, ContactList& list) const;

  const Setup* setup_;
  double detection_, touching_;
  JointSprings springs_;
  ContactPairs pairs_;
  KnownContacts known_;
  double merged_ = 0.0;           // see merged()
  double largest_weights_ = 1.0;  // sum |w| of a row: how much farther than a node an outline node may move
  IndexedVector<OutlineNode, double> compliance_;  // [1/kg]; 0 on bodies that nothing moves
  IndexedVector<OutlineNode, Vec2> x_;             // where they are [m]
  IndexedVector<SegmentIndex, SegmentFrame> frames_;
  bool placed_ = false;                         // those of bodies that rest
  std::vector<std::int32_t> fresh_, gone_;      // points without memory; 1 for memory without a point
  std::vector<std::int32_t> corners_, paired_;  // points of corners that were open, and those with partners
  struct Kind {                                 // of a point, as the list has it
    bool partnered = false, corner = false;
  };
  std::vector<Kind> kind_, next_kind_;
  struct Moving {  // of keeps(), for a point of the list to be
    std::int32_t pair = -1, from = -1;
    SegmentIndex segment;
    bool made = false;
  };
  std::vector<Moving> moving_, unchanged_;  // the latter scratch of make_changed()
  std::vector<Changed> changed_;
  ContactList made_;                   // of changed()
  std::vector<Kept> kept_;             // a chunk of vertices
  std::vector<std::ptrdiff_t> shift_;  // scratch of splice()
  std::vector<std::int32_t> first_;    // see moves_first()
  std::vector<EdgePair> added_;        // joints of points that a mesh has added, in order
  /// A remembered point by the edges that its joint may be of.
  struct OnJoint {
    EdgePair joint;
    std::int32_t point = -1;
    auto operator<=>(const OnJoint&) const = default;
  };
  std::vector<OnJoint> remembered_;
};

}  // namespace scree::coupling
