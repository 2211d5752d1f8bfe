// Bolts, cables and anchors: bars through the blocks, held at their ends or by grout. Liners: beams along outlines.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "model/geometry.h"
#include "model/ids.h"

namespace scree {

struct Model;

/// A straight bar from its head to its toe. A free length is tied to the rock at its ends alone; on a grouted length a
/// spring along the bar holds each piece until the bond slips. The bar has no mass. Forces and stiffnesses are for unit
/// thickness: those of one bolt divided by the out-of-plane spacing of the bolts.
/// A liner is a chain of such bars from node to node along the outlines of blocks, glued to them, that also resists
/// changes of the angle between neighbouring bars: a beam without shear. Its first bar begins at `head`.
/// @source docs/theory/bolts.md, "Nodes"; [StJohn1983]; docs/theory/liners.md, "Bars and turns"
struct Bolt {
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  std::string name;
  Vec2 head{0.0, 0.0}, toe{0.0, 0.0};  // [m], model coordinates, in or on blocks
  StageId stage;                       // installed at the start of this stage; invalid: the first
  double stiffness = 0.0;              // EA [N], > 0
  double yield = kNever;               // axial force [N], > 0
  double pretension = 0.0;             // axial force of the free length at installation [N], < yield
  double rupture_strain = kNever;      // plastic strain of a segment at which it breaks, > 0
  // The bond acts over this length from the toe; 0: an anchor holds the toe itself.
  double bond_length = 0.0;        // [m]
  double bond_stiffness = 0.0;     // force per length and slip [N/m2], > 0 if there is a bond
  double bond_strength = kNever;   // force per length [N/m], > 0
  double segment = 0.0;            // largest length of a piece of the bond [m]; 0: auto
  bool plate = true;               // the rock holds the head; else the head is free, for a bolt bonded all along
  double shear_stiffness = 0.0;    // at each joint that it crosses [N/m]; 0: none
  double shear_strength = kNever;  // [N], > 0
  double rupture_shear = kNever;   // plastic shear displacement at which it breaks [m], > 0

  // A liner. `stiffness` is E't, `segment` the largest length of a bar, `yield` its strength in tension.
  std::vector<Vec2> along;   // the line that it follows, with its corners [m]; closed: a ring; empty: a bolt
  double tolerance = 0.0;    // farthest distance of the line from the outlines, > 0 [m]
  double bending = 0.0;      // EI = E't^3/12 [N m2], >= 0
  double crushing = kNever;  // axial force in compression [N], > 0

  // Results of lay_out().
  struct Node {
    BlockId block;
    double at = 0.0;       // distance from the head [m]
    double length = 0.0;   // tributary length of the bond [m]; 0: a plate or an anchor holds the node
    Vec2 place{0.0, 0.0};  // of a liner: on the outline of its block [m], model coordinates
  };
  struct Crossing {
    std::int32_t segment = 0;  // from node `segment` to the next
    BlockId before, after;
    double leaves = 0.0, enters = 0.0;  // distances from the head: out of one block, into the next [m]
  };
  std::vector<Node> nodes;  // from the head on; a ring repeats its first node at the end
  std::vector<Crossing> crossings;

  [[nodiscard]] double length() const { return (toe - head).norm(); }
  [[nodiscard]] bool liner() const { return !along.empty(); }
  [[nodiscard]] bool ring() const { return along.size() > 3 && along.front() == along.back(); }
  /// Nodes at which a liner resists bending: turn c is at node c + 1, between segments c and segment_after(c).
  [[nodiscard]] std::size_t turns() const { return liner() ? nodes.size() - (ring() ? 1 : 2) : 0; }
  [[nodiscard]] std::size_t segment_after(std::size_t turn) const { return turn + 2 < nodes.size() ? turn + 1 : 0; }
  /// Turn stiffness of a liner: EI over the mean length of the two segments at a turn [N m].
  [[nodiscard]] double turn_stiffness(std::size_t turn) const {
    const std::size_t next = segment_after(turn);
    return 2.0 * bending / (nodes[turn + 1].at - nodes[turn].at + nodes[next + 1].at - nodes[next].at);
  }
  /// Position of a node in the model.
  [[nodiscard]] Vec2 place(const Node& n) const { return liner() ? n.place : point(n.at); }
  /// Position of a point of the bar in the model.
  [[nodiscard]] Vec2 point(double at) const { return head + at * (toe - head).normalized(); }
  /// Axial stiffness of a segment [N/m].
  [[nodiscard]] double segment_stiffness(std::size_t s) const { return stiffness / (nodes[s + 1].at - nodes[s].at); }
  /// True for the segment from the plate to the anchor or the bond: it carries tension and is slack in compression.
  [[nodiscard]] bool slack(std::size_t s) const { return plate && s == 0 && bond_length < (1.0 - 1e-9) * length(); }
};

/// The stretch of a line inside one block: distances from its start.
struct BoltPiece {
  BlockId block;
  double from = 0.0, to = 0.0;  // [m]
};
/// Pieces of a -> b inside the blocks of a model, along the line.
[[nodiscard]] std::vector<BoltPiece> pieces_in_blocks(const Model& model, const Vec2& a, const Vec2& b);

/// Places the nodes and crossings of a bolt. Pieces of the bond are at most `segment` long; auto is a third of
/// sqrt(stiffness/bond_stiffness), the length over which a bond transfers force, and at most a tenth of the bond.
/// @return what is wrong with the position of the bolt; empty: nothing. The properties are assumed valid.
[[nodiscard]] std::string lay_out(const Model& model, Bolt& bolt);

/// Places the nodes of a liner: at the corners of its line and between them, at most `segment` apart, each at the
/// nearest point of an outline within the tolerance. Where blocks touch, the first of them carries the node.
/// @param absent  per block: absent when the liner is installed; empty: none is
/// @return what is wrong with the position of the liner; empty: nothing. The properties are assumed valid.
[[nodiscard]] std::string lay_out_liner(const Model& model, std::span<const char> absent, Bolt& liner);

}  // namespace scree
