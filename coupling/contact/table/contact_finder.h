// All contact points of an instant: found, matched with their memory, ready for a law.
#pragma once

#include <span>
#include <vector>

#include "coupling/contact/table/quiet_points.h"
#include "coupling/contact/table/splice.h"

namespace scree::coupling {

/// Finds contact points: the pairs of ContactPairs, each with the nearest segment of its edge, and its memory.
/// Decisions depend on exact geometry and on the memory alone.
/// @source docs/theory/contact-geometry.md, "Edge-edge contact", "Angle-edge contact"; [Qu2013] 3.2.2, 2.4.3
class ContactFinder {
 public:
  /// @param detection  pairs nearer than this are listed, open or closed [m]
  ContactFinder(const Setup& setup, double detection);

  [[nodiscard]] double detection() const { return detection_; }
  /// Points of a state without geometry, for find() to start from.
  void restore(std::span<const ContactMemory> memory, ContactList& out) const;
  /// Lists the points at q. A point that was known before keeps its memory (with the anchor moved to a new segment so
  /// that the stretch does not jump), and `from` is its index; where a vertex leaves an overlap and one of the other
  /// side takes its place, or passes to the next edge in line, the memory passes as well. New points start open. Where
  /// a share changes and the kind of contact stays, gap and stretch stay, and with them the traction.
  /// @param at_start  t = 0: touching pairs are closed without stress, their gap becomes gap0
  void find(std::span<const double> q, const ContactList& known, bool at_start, ContactList& out);
  /// The same for the points of ghosts alone, at positions that a step may reach. They equal those of the whole list
  /// except for the effect of corners between two other bodies.   @pre index() or take_noted() for the list
  void find_of_ghosts(std::span<const double> q, ContactList& out);
  /// Moves the points of such a list to other positions, with the same segments, shares and dashpots.
  void follow(std::span<const double> q, ContactList& list);
  /// True if a list can be updated to q in place, with the same bits as by find(). Most points then stay, each with its
  /// memory; where points of a vertex appear, end or pass their memory on, all points of the vertex are made anew,
  /// outside the list, which has not changed yet. Next: splice() if any were made; move() of the points that others may
  /// depend on (moves_first()), settle(), and move() of the others, in any order; note() of every point once its new
  /// state is complete, then take_noted(). If false, find_again() does the same as find(), with the pairs already
  /// found.
  /// @pre index() or take_noted() for the list in its present state
  [[nodiscard]] bool keeps(std::span<const double> q, const ContactList& list);
  /// After keeps(): the vertices whose points are made anew.
  [[nodiscard]] const std::vector<Changed>& changed() const { return splice_.changed(); }
  /// True for a point of changed() whose memory no other point takes over.
  [[nodiscard]] bool gone(std::size_t i) const { return gone_[i] != 0; }
  /// Puts the new points of changed() into the list.
  void splice(ContactList& list);
  /// Before moves_first(), after splice() if any points are changed().
  void find_first();
  /// True for such a new point, which is not moved.
  [[nodiscard]] bool made(std::size_t i) const { return moving_[i].made; }
  /// True if its memory is from another vertex or edge.
  [[nodiscard]] bool passed(const ContactPoint& p) const {
    const auto from = static_cast<std::size_t>(p.from);
    return p.from >= 0 && (known_.vertex(from) != p.vertex || known_.edge(from) != p.edge);
  }
  [[gnu::flatten]] void move(std::size_t i, ContactList& list);
  /// Points on which others may depend, in order: settle() requires these alone to be moved.
  [[nodiscard]] std::span<const std::int32_t> moves_first() const { return first_; }
  void settle(ContactList& list);
  /// @param known  the list given to keeps()   @param out  another one
  void find_again(const ContactList& known, ContactList& out);
  void index(const ContactList& list, bool in_turn = false);  // in_turn: the list is that of the last keeps()
  void note(std::size_t i, const ContactMemory& m) { known_.note(i, m); }
  void take_noted(const ContactList& list);
  /// After find(): energy of springs that ended and that other closed points have taken over [J].
  [[nodiscard]] double merged() const { return merged_; }
  /// After find(): how far every node may move before find() can list a point [m]; 0 if there are candidates now.
  [[nodiscard]] double clearance() { return pairs_.clearance(x_) / largest_weights_; }
  /// Gives closed points that changed between edge-edge and angle-edge, and corners that passed to another edge, the
  /// stiffness of their new kind; force and state stay, gap0 and anchor move.
  /// @return f^2 (1/k' - 1/k)/2 summed, normal and tangential: the change of the springs' energy [J]
  [[nodiscard]] double adopt_kinds(ContactList& list) const;
  /// The same for one point.   @param change  the change is added to it [J]
  static void adopt_kind(const ContactPoint& p, ContactMemory& m, double& change);
  /// False if adopt_kind() certainly leaves the point as it is.
  [[nodiscard]] static bool may_adopt(const ContactPoint& p, const ContactMemory& m) {
    return m.status != ContactStatus::open && !(m.impact > 0.0) &&
           (m.edge_edge != static_cast<std::int32_t>(p.edge_edge) || m.kn != p.springs.kn || m.kt != p.springs.kt);
  }
  /// A point that closes fast on a joint without load keeps its springs, independent of changes of share, kind and
  /// edge, for four periods of its corner on its spring: an impact is over by then (face to face half a period of the
  /// block, sqrt(7/2) of the corner's, is the longest of two blocks), and points still closed are at rest. An overlap
  /// with a smaller stiffness than a corner begins with a corner's. Where the law has a force the gap is 0 still. Fast:
  /// with w = sqrt(k mu) the depth v/w exceeds what counts as touching, and v w ten times gravity. A loaded joint that
  /// oscillates, where a load is applied or a block beside it slides, is no impact and follows the geometry.
  /// @param speed  v at which the gap closes [m/s]
  void begin_impact(const ContactPoint& p, double speed, ContactMemory& m) const;

 private:
  /// The nearest other point of the same edge-edge contact (unless `next_only`), else of one in line where the joint
  /// continues on another block; -1 if there is none. It may be open only for a new point.
  [[nodiscard]] [[gnu::noinline]] std::int32_t neighbour(const ContactPoint& p, bool next_only) const;
  /// Depth of a point below the joint in line beside it; its whole depth where there is none, independent of gap0 [m].
  [[nodiscard]] double entry_depth(const ContactPoint& p) const;
  /// The segment of an edge nearest to a point, its distance, and how far nodes may move before it can be another [m].
  struct Under {
    SegmentIndex segment;
    double distance = 0.0, room = std::numeric_limits<double>::infinity();
  };
  /// @param guess  the segment that it was last time, counted within the edge; -1: not known
  [[nodiscard]] Under segment_under(const Vec2& x, EdgeIndex edge, std::int32_t guess) const;
  [[nodiscard]] ContactGeometry geometry(VertexIndex vertex, SegmentIndex segment) const;
  [[nodiscard]] ContactKey key_of(VertexIndex vertex, EdgeIndex edge) const;
  [[nodiscard]] bool admissible(const ContactPoint& p) const;
  /// 1/m for a force on a contact: of corner and foot.
  [[nodiscard]] double compliance(const ContactPoint& p) const;
  struct Moving {  // by keeps(), for a point of the new list
    std::int32_t pair = -1, from = -1;
    SegmentIndex segment;
    bool made = false;
  };
  /// move() for a point that was closed in an edge-edge contact and stays over the same segment.
  /// @return false: it is not such a point; nothing has changed
  [[nodiscard]] bool move_along(const VertexEdge& pair, const Moving& moving, ContactPoint& p, ContactMemory& m) const;
  void place_nodes(std::span<const double> q);
  /// The points of pairs, in their order.
  void list_points(std::span<const VertexEdge> pairs, bool at_start, ContactList& out);
  /// Places a point that has its segment and `from`.   @return false: it is no contact point
  [[nodiscard]] bool touches(const VertexEdge& pair, const ContactMemory* was, bool closed, ContactPoint& p) const;
  /// Completes the point: springs, lengths of joint; and the part that depends on its own place alone.
  void describe(const VertexEdge& pair, const ContactMemory* was, bool closed, ContactPoint& p) const;
  void set_springs(const VertexEdge& pair, JointId law, ContactPoint& p) const;
  /// Result of keeps() for one chunk of vertices.
  struct Kept {
    bool anew = false;                    // find_again() is required
    std::vector<VertexIndex> changed;     // vertices whose points do not stay as they are
    std::vector<ContactPoint> of_vertex;  // scratch of passes_on()
  };
  /// For keeps(): true if a vertex, with points first to last, has a corner that passes to another edge.
  [[nodiscard]] [[gnu::noinline]] bool passes_on(std::size_t first, std::size_t last, const ContactList& list,
                                                 std::vector<ContactPoint>& of_vertex) const;
  /// For keeps(): true if the pair is a point, or none, as it was before.   @param row  its point in the list, or -1
  /// @param quiet  with the kind of before; receives the segment, and a room in meshes, for overlaps and for no point
  /// @param anew   becomes true where find_again() is required
  [[nodiscard]] bool stays(const VertexEdge& pair, std::int32_t row, const ContactList& list, QuietPoints::Quiet& quiet,
                           bool& anew) const;
  /// For keeps(): true if the pairs of a vertex are its points of the list; then moving_ contains them.
  [[nodiscard]] [[gnu::flatten]] bool stay(VertexIndex vertex, const ContactList& list, Kept& kept);
  /// For keeps(): no memory is without a point, as long as no vertex has changed.
  void forget_gone(std::size_t size);
  /// For keeps(): makes the points of changed vertices anew.
  void make_changed();
  /// Lists the points of one vertex.   @param old  the first known point that may belong to it
  void list_vertex(std::span<const VertexEdge> pairs, std::size_t old, bool at_start, ContactList& out);
  /// Completes the points that keeps() has made.   @return false: find_again() is required
  [[nodiscard]] bool complete_made(const ContactList& list);
  void set_range(ContactPoint& p, bool closed) const;
  void set_damping(ContactPoint& p, const ContactMemory& m) const;
  /// True for a point at a reentrant corner of its body: the two edges that meet there are two contacts.
  [[nodiscard]] bool reentrant(const ContactPoint& p) const;
  /// True if a closed corner has passed from one edge to another.
  [[nodiscard]] bool goes_over(const ContactPoint& from, const ContactPoint& to) const;
  /// The point of the same vertex that a closed corner passes to, if any.
  [[nodiscard]] ContactPoint* successor(const ContactPoint& from, std::span<ContactPoint> points) const;
  /// For one vertex: where closed corners passed to another edge, the points there take over the memory; those at the
  /// edges they left begin anew.
  void pass_corners(std::span<ContactPoint> points) const;
  /// True if two wedges that overlap separate over the side of `to`, the shorter way, where `from` is a closed corner P
  /// near the convex end V of an edge, and `to` that V against a side of P. False where a joint continues in line over
  /// either end: there the corner passes along it.
  [[nodiscard]] bool goes_over_tip(const ContactPoint& from, std::span<const ContactPoint> of_corner,
                                   const ContactPoint& to, std::span<const ContactPoint> of_tip) const;
  /// For corners in an impact that slide over the end of an edge: the tip there takes over their memory where the gaps
  /// of both are equal, so that the energy is kept, as over a convex corner (goes_over()).
  void pass_tips(bool at_start, ContactList& out) const;
  /// The vertex at the convex end of the edge that a closed corner in an impact is about to pass; not valid: none.
  [[nodiscard]] VertexIndex tip_beside(const ContactPoint& from) const;
  /// Where a point in an impact ends under load while its bodies overlap, the nearest point between the same bodies
  /// takes over its memory if it is open, and the energy of its spring if it is in an impact itself (merged()).
  void pass_energy_on(bool at_start, ContactList& out);
  /// Completes what concerns the points of one vertex alone, while they are in the cache (a second pass over a long
  /// list takes as long as making it); lists them for the later passes.
  /// @param first  of the vertex, whose points are the last of the list
  void settle_vertex(std::size_t first, bool at_start, ContactList& out);
  /// True if the point keeps the springs it closed with (ContactMemory::impact).
  [[nodiscard]] bool in_impact(const ContactPoint& p) const;
  [[nodiscard]] bool was_closed(const ContactPoint& p) const;
  /// Suppresses corners against edges whose end is pressed into the joint that continues beside the corner.
  void cover_corners(ContactList& out) const;
  void inherit(ContactList& out);
  /// A body was made anew, its edges a little elsewhere: no force comes from that. A point that has more of the joint
  /// than before carries what it was given of the vertices that went; one that has less leaves its traction to new
  /// ones, also of what it was given.
  static void keep_force(const ContactMemory& old, bool divided, const ContactPoint& p, ContactMemory& m);
  /// A contact closes where its gap passes zero, or the opening left by slip. A point found deep (a corner that entered
  /// from the side, or that another edge carried so far) begins without force at its present gap, and loses that depth
  /// as it moves out.   @param known  the point was in the list before
  void set_gap0(bool known, const ContactPoint& p, ContactMemory& m) const;
  /// True for a corner that meets the far end of an edge beside the point's: its depth is the length of that edge.
  [[nodiscard]] bool beside_next_corner(const ContactPoint& p) const;
  /// @param divided  true: new mesh vertices lie on its joint beside a remembered point of a body made anew
  void fill(const ContactMemory* old, bool at_start, bool divided, ContactPoint& p, ContactMemory& m) const;
  /// Gives a point with known `from` its memory, or its initial values.   @pre its memory in the list is as new
  void remember(std::size_t i, bool at_start, ContactList& out) const;
  /// True for a point that a mesh has added to a joint.
  [[nodiscard]] bool adds(const ContactPoint& p) const;
  /// A point's edge with the edge that leaves its vertex (`out`), or ends there.
  [[nodiscard]] EdgePair joint_of(const ContactPoint& p, bool out) const;
  /// Lists by joint the points that a mesh has added and the remembered ones, if any body was made anew.
  void index_divided(const ContactList& out);
  /// True for a remembered point if a mesh has added one to its joint.
  [[nodiscard]] bool is_divided(const ContactPoint& p) const;
  /// Bonds a point of known gap if its neighbour on the joint is bonded, and the bond bears the pull.
  void bond_like(const ContactMemory& beside, ContactMemory& m) const;
  /// Where a body was meshed anew its new vertices on a closed joint take gap and stretch, and with them the traction,
  /// from the remembered points on either side (gap0 where there is only one), and the bond of the nearest.
  void interpolate(ContactList& out) const;
  void pair_edges(std::size_t first, ContactList& list) const;
  void fill_with_water(const ContactPoint& p, ContactMemory& m) const;
  void suppress_second_edges(bool at_start, ContactList& list) const;
  /// Two points of a corner, against two edges that meet at a convex corner: at most one of them carries.
  void suppress_one(bool at_start, std::size_t i, std::size_t j, ContactList& list) const;

  const Setup* setup_;
  double detection_, touching_;
  JointSprings springs_;
  ContactPairs pairs_;
  QuietPoints quiet_;
  KnownContacts known_;
  double merged_ = 0.0;           // see merged()
  double largest_weights_ = 1.0;  // sum |w| of a row: how much farther than a node an outline node may move
  IndexedVector<OutlineNode, double> compliance_;  // [1/kg]; 0 on bodies that nothing moves
  IndexedVector<OutlineNode, Vec2> x_;             // positions [m]
  IndexedVector<SegmentIndex, SegmentFrame> frames_;
  bool placed_ = false;                         // those of bodies at rest are set
  std::vector<std::int32_t> fresh_, gone_;      // points without memory; 1 for memory without a point
  bool listed_anew_ = false;                    // gone_ is that of list_points()
  std::vector<std::int32_t> corners_, paired_;  // points of corners that were open, and those with partners
  struct Kind {                                 // of a point, as the list has it
    bool partnered = false, corner = false;
  };
  std::vector<Kind> kind_;
  std::vector<Moving> moving_;
  Splice splice_;                                          // of changed()
  ContactList made_;                                       // its new points
  std::vector<Kept> kept_;                                 // per chunk of vertices
  std::vector<std::int32_t> first_;                        // see moves_first()
  std::vector<std::vector<std::int32_t>> first_by_chunk_;  // scratch
  std::vector<EdgePair> added_;                            // joints of points that a mesh has added, in order
  /// A remembered point and one of the joints that it may belong to.
  struct OnJoint {
    EdgePair joint;
    std::int32_t point = -1;
    auto operator<=>(const OnJoint&) const = default;
  };
  std::vector<OnJoint> remembered_;
};

}  // namespace scree::coupling
