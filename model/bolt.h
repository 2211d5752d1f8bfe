// Bolts, cables and anchors: bars through the blocks, held at their ends or by grout.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "model/geometry.h"
#include "model/ids.h"

namespace scree {

struct Model;

/// A straight bar from its head to its toe. Where it runs free it is tied to the rock at its ends alone; where it is
/// grouted, a spring along the bar holds each piece of it until the bond slips. It has no mass. Forces and stiffnesses
/// are for unit thickness: those of one bolt over the spacing of the bolts out of the plane.
/// @source docs/theory/bolts.md, "Nodes"; [StJohn1983]
struct Bolt {
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  std::string name;
  Vec2 head{0.0, 0.0}, toe{0.0, 0.0};  // [m], model coordinates, in or on blocks
  StageId stage;                       // it is installed as this stage begins; invalid: the first
  double stiffness = 0.0;              // EA [N], > 0
  double yield = kNever;               // axial force [N], > 0
  double pretension = 0.0;             // axial force of the free length as it is installed [N], < yield
  double rupture_strain = kNever;      // plastic strain of a segment at which it breaks, > 0
  // The bond acts over this length from the toe; 0: an anchor holds the toe itself.
  double bond_length = 0.0;        // [m]
  double bond_stiffness = 0.0;     // force a length and a slip [N/m2], > 0 where there is a bond
  double bond_strength = kNever;   // force a length [N/m], > 0
  double segment = 0.0;            // largest length of a piece of the bond [m]; 0: auto
  bool plate = true;               // the head is held by the rock; else it is free, of a bolt bonded all along
  double shear_stiffness = 0.0;    // at each joint that it crosses [N/m]; 0: none
  double shear_strength = kNever;  // [N], > 0
  double rupture_shear = kNever;   // plastic shear displacement at which it breaks [m], > 0

  // What lay_out() finds.
  struct Node {
    BlockId block;
    double at = 0.0;      // distance from the head [m]
    double length = 0.0;  // of the bond that it stands for [m]; 0: the node is held by a plate or an anchor
  };
  struct Crossing {
    std::int32_t segment = 0;  // from node `segment` to the next
    BlockId before, after;
    double leaves = 0.0, enters = 0.0;  // distances from the head: out of one block, into the next [m]
  };
  std::vector<Node> nodes;  // from the head on
  std::vector<Crossing> crossings;

  [[nodiscard]] double length() const { return (toe - head).norm(); }
  /// Where the model has a point of the bar.
  [[nodiscard]] Vec2 point(double at) const { return head + at * (toe - head).normalized(); }
  /// Axial stiffness of a segment [N/m].
  [[nodiscard]] double segment_stiffness(std::size_t s) const { return stiffness / (nodes[s + 1].at - nodes[s].at); }
  /// A segment that leads from the plate to the anchor or the bond: it pulls, and hangs slack rather than push.
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
/// sqrt(stiffness/bond_stiffness), over which a bond hands force over, and at most a tenth of the bond.
/// @return what is wrong with its place, empty: nothing. Its properties are taken to be right.
[[nodiscard]] std::string lay_out(const Model& model, Bolt& bolt);

}  // namespace scree
